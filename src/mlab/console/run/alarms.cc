#include "mlab/console/run/alarms.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace mlab::console {
namespace {

using fleet::FleetRobot;
using fleet::RobotLife;

EventLog::Entry entry(Log::Kind kind, std::string text, const FleetRobot& robot, geom::Point place,
                      bool is_alert) {
  return {kind, std::move(text), robot.id.value, "", place, is_alert};
}

// What a program counts down that knows no way is no distance.
std::string what_remains(double remaining) {
  if (std::isinf(remaining)) return ", and no way leads farther";
  return remaining < 0.0 ? "" : fmt::format(", {:.1f} m remain", remaining);
}

}  // namespace

void Alarms::match(const std::vector<FleetRobot>& fleet) {
  const bool matches =
      robots_.size() == fleet.size() &&
      std::equal(robots_.begin(), robots_.end(), fleet.begin(),
                 [](const Robot& known, const FleetRobot& robot) { return known.id == robot.id.value; });
  if (matches) return;
  std::map<std::uint32_t, Robot> before;
  for (const Robot& known : robots_) before[known.id] = known;
  robots_.clear();
  for (const FleetRobot& robot : fleet) {
    Robot& known = robots_.emplace_back(before[robot.id.value]);
    known.id = robot.id.value;
  }
}

void Alarms::look(const run::MissionRun& run, EventLog& log) {
  const std::vector<FleetRobot>& fleet = run.fleet().robots();
  match(fleet);
  const bool all_states = fleet.size() <= kMostRobots;
  for (Robot& known : robots_) known.is_watched = all_states;
  for (const std::uint32_t id : watched_) {
    const auto at = std::ranges::lower_bound(robots_, id, {}, &Robot::id);
    if (at != robots_.end() && at->id == id) at->is_watched = true;
  }
  contacts_now_ = stuck_now_ = states_now_ = 0;
  for (std::size_t i = 0; i < fleet.size(); ++i) look_at(run, fleet[i], robots_[i], log);
  if (contacts_now_ > kMostAtOnce) {
    log.add(run.time(), {Log::CONTACT,
                         fmt::format("{} more robots in contact", contacts_now_ - kMostAtOnce),
                         0,
                         "",
                         {},
                         true});
  }
  if (stuck_now_ > kMostAtOnce) {
    log.add(run.time(),
            {Log::STUCK, fmt::format("{} more robots are stuck", stuck_now_ - kMostAtOnce), 0, "", {}, true});
  }
}

void Alarms::look_at(const run::MissionRun& run, const FleetRobot& robot, Robot& known, EventLog& log) {
  if (robot.life == RobotLife::kNotStarted) return;
  if (robot.life != known.life) {
    if (robot.life == RobotLife::kFaulted) {
      log.add(run.time(),
              entry(Log::LOST, fmt::format("robot {} stands: {}", robot.id.value, fleet::failure_of(robot)),
                    robot, run.fleet().pose(robot).position, true));
    }
    if (known.life == RobotLife::kNotStarted || known.life == RobotLife::kStopped) known.contacts = 0;
    known.life = robot.life;
    known.knows_states = false;
  }
  look_for_contact(run, robot, known, log);
  look_for_silence(run, robot, known, log);
  if (robot.life != RobotLife::kRunning) {
    known.is_stuck = false;
    return;
  }
  look_for_progress(run, robot, known, log);
  look_for_states(run, robot, known, log);
}

void Alarms::look_for_contact(const run::MissionRun& run, const FleetRobot& robot, Robot& known,
                              EventLog& log) {
  const std::uint32_t contacts = run.world().body(robot.body).contacts;
  if (contacts == known.contacts) return;
  const bool is_new = contacts > known.contacts;
  known.contacts = contacts;
  if (!is_new || run.time() - known.contact_told < kContactsApart) return;
  known.contact_told = run.time();
  if (++contacts_now_ > kMostAtOnce) return;
  const geom::Point at = run.fleet().pose(robot).position;
  log.add(run.time(), entry(Log::CONTACT,
                            fmt::format("robot {} touched something at ({:.1f}, {:.1f}), for the {}. time",
                                        robot.id.value, at.x, at.y, contacts),
                            robot, at, true));
}

void Alarms::look_for_progress(const run::MissionRun& run, const FleetRobot& robot, Robot& known,
                               EventLog& log) {
  const percept::OrderStatus& status = robot.action.status;
  const fleet::Group* group = run.fleet().group(robot);
  // Who shares something may have nothing to do, and gives up by itself what it comes no nearer to.
  const bool is_shared = group != nullptr && group->command && mission::info(group->command->task).is_shared;
  // Infinitely much remains where no way leads farther, and always where a program does not tell.
  const bool has_told =
      std::isfinite(status.remaining) || (status.sequence == known.sequence && std::isfinite(known.best));
  const bool should_move = group != nullptr && !is_shared && !group->order.halted &&
                           status.sequence == group->order.sequence && !status.done &&
                           group->order.task != percept::Task::kTeleoperate && has_told &&
                           run.state().mode == mission::State::Mode::kRunning;
  if (!should_move || status.sequence != known.sequence || status.remaining < known.best - kProgress) {
    known.sequence = status.sequence;
    known.best = should_move ? status.remaining : std::numeric_limits<double>::infinity();
    known.since = run.time();
    known.is_stuck = false;
    return;
  }
  if (known.is_stuck || run.time() - known.since < kStuckAfter) return;
  known.is_stuck = true;
  if (++stuck_now_ > kMostAtOnce) return;
  log.add(run.time(), entry(Log::STUCK,
                            fmt::format("robot {} is stuck: no nearer to done for {:.0f} s{}", robot.id.value,
                                        kStuckAfter, what_remains(status.remaining)),
                            robot, run.fleet().pose(robot).position, true));
}

void Alarms::look_for_silence(const run::MissionRun& run, const FleetRobot& robot, Robot& known,
                              EventLog& log) {
  const mission::RobotState* const state = mission::find_robot(run.state(), robot.id);
  if (state == nullptr) return;
  const bool is_lost = state->seen != 0 && state->seen != run.state().cycle;
  if (is_lost && !known.is_lost) {
    log.add(run.time(), entry(Log::LOST, fmt::format("robot {} no longer reports", robot.id.value), robot,
                              run.fleet().pose(robot).position, true));
  }
  known.is_lost = is_lost;
}

void Alarms::look_for_states(const run::MissionRun& run, const FleetRobot& robot, Robot& known,
                             EventLog& log) {
  if (!known.is_watched || !robot.workings().program) {
    known.knows_states = false;
    return;
  }
  const flow::Program& program = *robot.workings().program;
  const std::uint64_t states = program.states_key(robot.workings().frame);
  const bool changed = known.knows_states && states != known.states;
  known.states = states;
  known.knows_states = true;
  if (!changed || ++states_now_ > kMostAtOnce) return;
  log.add(run.time(), entry(Log::STATE,
                            fmt::format("robot {} is in {}", robot.id.value,
                                        fmt::join(program.active_states(robot.workings().frame), ", ")),
                            robot, run.fleet().pose(robot).position, false));
}

}  // namespace mlab::console
