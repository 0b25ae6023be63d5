#include "mlab/mission/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "mlab/mission/dispatch.h"
#include "mlab/mission/known_map.h"
#include "mlab/mission/phase_line.h"
#include "mlab/mission/question.h"
#include "mlab/mission/step.h"
#include "mlab/mission/technique.h"
#include "mlab/mission/wording.h"

namespace mlab::mission {
namespace {

// Nearer to done by less than this is no progress [m].
constexpr double kProgress = 0.01;

void mark_done(State& state, RobotState& robot) {
  Run& run = state.runs[robot.run];
  robot.done = true;
  --run.missing;
  run.stalled = 0.0;
}

// What robots share is done for all of them when one says so: the others may be lost.
void mark_done_for_all(State& state, std::uint32_t run) {
  for (const base::RobotId id : std::vector(state.runs[run].needed)) {
    RobotState* robot = find_robot(state, id);
    if (robot != nullptr && robot->run == run && !robot->done) mark_done(state, *robot);
  }
}

// That no way leads farther, whoever has come nearer before.
void take_giving_up(Run& run, RobotState& robot, const RobotReport& report) {
  const bool had_given_up = robot.has_given_up;
  robot.has_given_up =
      std::isinf(report.remaining) && report.remaining > 0.0 && (had_given_up || std::isfinite(robot.best));
  if (had_given_up && !robot.has_given_up) run.stalled = 0.0;
}

void take_order_report(State& state, RobotState& robot, const RobotReport& report) {
  if (report.sequence != robot.sequence || robot.sequence == 0) return;
  take_giving_up(state.runs[robot.run], robot, report);
  if (std::isfinite(report.remaining) && report.remaining >= 0.0) robot.remaining = report.remaining;
  // Where robots share something, what is left for one of them may grow; it gives up by itself what it comes
  // no nearer to.
  const bool is_shared = info(state.runs[robot.run].command->task).is_shared;
  if (report.remaining < robot.best - kProgress || (is_shared && report.remaining > robot.best + kProgress)) {
    robot.best = report.remaining;
    state.runs[robot.run].stalled = 0.0;
  }
  if (!report.done) return;
  if (is_shared)
    mark_done_for_all(state, robot.run);
  else
    mark_done(state, robot);
}

// Whether a robot is at the place of a RALLY, which it may leave again as long as others are under way.
void take_arrival(Run& run, RobotState& robot, const RobotReport& report) {
  if (run.phase != Run::Phase::kRobots) return;
  if (report.sequence == robot.sequence) take_giving_up(run, robot, report);
  const double to_go = geom::distance(robot.pose.position, run.command->goal) - run.command->radius;
  robot.remaining = std::max(0.0, to_go);
  if (to_go < robot.best - kProgress) {
    robot.best = to_go;
    if (!robot.done && !robot.has_given_up) run.stalled = 0.0;
  }
  if (to_go <= 0.0 && !robot.done) {
    robot.done = true;
    --run.missing;
  } else if (to_go > 0.0 && robot.done) {
    robot.done = false;
    ++run.missing;
  }
}

// A pose that is no number leaves the robot where it was.
void take_pose(const State& state, RobotState& robot, const geom::Pose& pose) {
  const bool was_in_sight = robot.seen != 0 && robot.seen + 1 == state.cycle;
  robot.step = {};
  if (!std::isfinite(pose.position.x) || !std::isfinite(pose.position.y) || !std::isfinite(pose.heading))
    return;
  if (was_in_sight) robot.step = pose.position - robot.pose.position;
  robot.pose = pose;
}

void take_report(State& state, const RobotReport& report) {
  RobotState* robot = find_robot(state, report.id);
  if (robot == nullptr) return;
  take_pose(state, *robot, report.pose);
  robot->radius = report.radius;
  robot->is_running = report.is_running;
  if (report.is_running) robot->warned = false;
  robot->reported = report.sequence;
  robot->seen = state.cycle;
  if (robot->run == kNoRun) return;
  const Task task = state.runs[robot->run].command->task;
  if (robot->done && task != Task::kRally) return;
  switch (task) {
    case Task::kStart:
      if (report.is_running) mark_done(state, *robot);
      break;
    case Task::kStop:
      if (!report.is_running) mark_done(state, *robot);
      break;
    case Task::kRally:
      if (report.is_running) take_arrival(state.runs[robot->run], *robot, report);
      break;
    case Task::kMoveTo:
    case Task::kOccupy:
    case Task::kFollow:
    case Task::kSweepTo:
    case Task::kTeleoperate:
    case Task::kVisit:
    case Task::kSearch:
    case Task::kPatrol:
      if (report.is_running) take_order_report(state, *robot, report);
  }
}

// Robots that don't report, or say that they don't run. @return the ones to warn about
std::vector<base::RobotId> look_for_silent_robots(State& state) {
  std::vector<base::RobotId> silent;
  for (RobotState& robot : state.robots) {
    const bool seen = in_sight(state, robot);
    if (seen && robot.is_running) continue;
    if (!seen) robot.is_running = false;
    if (robot.run == kNoRun || robot.done) continue;
    const Task task = state.runs[robot.run].command->task;
    if (task == Task::kStop) {
      mark_done(state, robot);
    } else if (task != Task::kStart && !robot.warned) {
      robot.warned = true;
      silent.push_back(robot.id);
    }
  }
  return silent;
}

void warn_of_silent_robots(Turn& turn, const std::vector<base::RobotId>& silent) {
  const State& s = turn.state;
  std::map<std::uint32_t, std::vector<base::RobotId>> by_run;
  for (const base::RobotId id : silent) by_run[find_robot(s, id)->run].push_back(id);
  for (const auto& [run, robots] : by_run) {
    const bool one = robots.size() == 1;
    const std::uint32_t owner = s.runs[run].owner;
    const std::string_view consequence = info(s.runs[run].command->task).is_shared
                                             ? (one ? "goes on without it" : "goes on without them")
                                             : (one ? "waits for it" : "waits for them");
    const std::string_view but = info(s.runs[run].command->task).is_shared ? "" : "but ";
    warn(turn,
         fmt::format("{}{} {} running, {}`{}` {}", owner_prefix(s, owner), robots_text(robots),
                     one ? "is not" : "are not", but, s.commands[s.runs[run].record].text, consequence),
         owner);
  }
}

void take_time(Turn& turn, double time) {
  State& s = turn.state;
  if (!(time > s.time) || !std::isfinite(time)) return;
  turn.elapsed = time - s.time;
  s.time = time;
}

// A command that ends by itself at a time is not waited for in vain.
bool needs_patience(const Run& run) {
  return run.phase == Run::Phase::kRobots && run.missing > 0 && !run.ends && !holds_at_line(run);
}

// Whether nobody can be at the place of a RALLY, since something that the map shows stands there, or the area
// ends before.
bool is_taken(const State& state, const Run& run) {
  const geom::Point place = run.command->goal;
  return !state.mission->overlay.mission_area().contains(place) ||
         std::ranges::any_of(known_things(state.mission->overlay).discs, [&](const ways::Round& disc) {
           return distance(disc.center, place) < disc.radius;
         });
}

// RALLYs at such places whose robots come no nearer, and say of themselves that they are there, are done.
void settle_rallies(Turn& turn, std::span<const RobotReport> reports) {
  constexpr double kSettles = 5.0;  // so long nobody came nearer [s]
  constexpr double kBeside = 5.0;   // who was so much nearer has left again [m]
  State& s = turn.state;
  const auto is_beside = [&](const RobotReport& report, std::uint32_t run) {
    const RobotState* robot = find_robot(s, report.id);
    if (robot == nullptr || robot->run != run || robot->done || report.sequence != robot->sequence)
      return false;
    const UnitCommand& command = *s.runs[run].command;
    const double to_go = geom::distance(robot->pose.position, command.goal) - command.radius;
    return report.is_running && report.done && to_go <= std::max(robot->best, 0.0) + kBeside;
  };
  for (std::uint32_t i = 0; i < s.runs.size(); ++i) {
    const Run& run = s.runs[i];
    if (run.command->task != Task::kRally || !needs_patience(run) || run.stalled < kSettles) continue;
    const auto beside =
        std::ranges::count_if(reports, [&](const RobotReport& report) { return is_beside(report, i); });
    if (static_cast<std::uint32_t>(beside) < run.missing || !is_taken(s, run)) continue;
    message(turn,
            fmt::format("{}: {} the place; its robots are as near to it as they come",
                        s.commands[run.record].text,
                        s.mission->overlay.mission_area().contains(run.command->goal)
                            ? "something stands at"
                            : "the mission area ends before"),
            run.owner);
    mark_done_for_all(s, i);
  }
}

// Robots of START commands that were started, and say that they don't run: nothing comes of waiting for them.
// How many, by the record of their command.
std::map<std::uint32_t, std::uint32_t> failed_starts(const State& state,
                                                     std::span<const RobotReport> reports) {
  std::map<std::uint32_t, std::uint32_t> out;
  for (const RobotReport& report : reports) {
    if (report.is_running) continue;
    const RobotState* robot = find_robot(state, report.id);
    if (robot == nullptr || robot->run == kNoRun || robot->done) continue;
    const Run& run = state.runs[robot->run];
    if (run.command->task == Task::kStart) ++out[run.record];
  }
  return out;
}

// Fails START commands of which only such robots are missing; of a step the first one.
void fail_starts(Turn& turn, const std::map<std::uint32_t, std::uint32_t>& failed) {
  State& s = turn.state;
  bool has_failed = false;
  for (std::size_t i = 0; i < s.runs.size() && !failed.empty(); ++i) {
    Run& run = s.runs[i];
    const auto at = failed.find(run.record);
    if (run.phase != Run::Phase::kRobots || at == failed.end() || at->second < run.missing) continue;
    has_failed = true;
    const bool of_step = is_step(s, run.owner);
    fail(turn, run, Failure::kNotStarted, undone_text(s, run));
    if (of_step) break;  // its runs are gone
  }
  if (has_failed) go_on(turn);
}

// Of those that it waits for, some do not run and will not by themselves.
bool has_lost_robots(const State& state, const Run& run) {
  return std::ranges::any_of(run.needed, [&](base::RobotId id) {
    const RobotState* robot = find_robot(state, id);
    return robot != nullptr && !robot->done && robot->seen != 0 && !robot->is_running;
  });
}

// All that it is for were lost or stopped: nobody is left who could come nearer to being done.
bool has_nobody_left(const State& state, const Run& run) {
  return std::ranges::all_of(run.needed, [&](base::RobotId id) {
    const RobotState* robot = find_robot(state, id);
    return robot != nullptr && robot->life != RobotState::Life::kNotStarted && robot->seen != 0 &&
           !robot->is_running;
  });
}

// All that share it, as far as they run, can do no more of it.
bool is_given_up(const State& state, const Run& run) {
  if (!info(run.command->task).is_shared) return false;
  bool has_some = false;
  for (const base::RobotId id : run.needed) {
    const RobotState* robot = find_robot(state, id);
    if (robot == nullptr || !robot->is_running) continue;
    if (robot->run != index_of(state, run) || !can_do_no_more(*robot)) return false;
    has_some = true;
  }
  return has_some;
}

// No way leads those of its robots farther that run and are not done; who halts meanwhile waits for them.
bool is_closed_off(const State& state, const Run& run) {
  bool has_some = false;
  for (const base::RobotId id : run.needed) {
    const RobotState* robot = find_robot(state, id);
    if (robot == nullptr || !robot->is_running || robot->done) continue;
    if (const Group* group = find_group(state, robot->sequence); group != nullptr && group->halted) continue;
    if (!robot->has_given_up) return false;
    has_some = true;
  }
  return has_some;
}

struct Verdict {
  Failure failure = Failure::kNone;  // none: it goes on
  std::string why;
};

// Whether a command that has made no progress for so long has failed.
Verdict judge(const State& state, const Run& run) {
  // Time to replace a robot, for an operator who looks on.
  constexpr double kNobodyCame = 30.0;   // [s]
  constexpr double kNoneOpened = 180.0;  // or to clear a way [s]
  if (state.options.patience <= 0.0) return {};
  if (is_given_up(state, run))
    return {has_lost_robots(state, run) ? Failure::kRobotsLost : Failure::kNoProgress,
            "its robots can do no more of it"};
  if (run.stalled >= state.options.patience)
    return {has_lost_robots(state, run) ? Failure::kRobotsLost : Failure::kNoProgress,
            fmt::format("no progress for {:.0f} s", run.stalled)};
  if (run.stalled >= kNoneOpened && !info(run.command->task).is_shared && is_closed_off(state, run))
    return {Failure::kNoWay,
            fmt::format("no way leads there, and none was opened for {:.0f} s", kNoneOpened)};
  if (run.stalled >= kNobodyCame && has_nobody_left(state, run))
    return {Failure::kNobodyLeft,
            fmt::format("none of its robots runs, and nobody replaced one for {:.0f} s", kNobodyCame)};
  return {};
}

// Fails commands that made no progress for too long; of a step the first one, with which the step fails.
void check_patience(Turn& turn) {
  State& s = turn.state;
  bool has_failed = false;
  for (std::size_t i = 0; i < s.runs.size(); ++i) {
    Run& run = s.runs[i];
    if (!needs_patience(run)) continue;
    run.stalled += turn.elapsed;
    const Verdict verdict = judge(s, run);
    if (verdict.failure == Failure::kNone) continue;
    has_failed = true;
    const bool of_step = is_step(s, run.owner);
    fail(turn, run, verdict.failure, fmt::format("{}; {}", verdict.why, undone_text(s, run)));
    if (of_step) break;  // its runs are gone
  }
  if (has_failed) go_on(turn);
}

}  // namespace

void take_cycle(Turn& turn, const event::Cycle& cycle) {
  State& s = turn.state;
  ++s.cycle;
  take_time(turn, cycle.time);
  for (const RobotReport& report : cycle.robots) take_report(s, report);
  const std::vector<base::RobotId> silent = look_for_silent_robots(s);
  if (!silent.empty()) warn_of_silent_robots(turn, silent);
  if (s.paused || s.mode != State::Mode::kRunning) return;
  const auto failed = failed_starts(s, cycle.robots);
  for (Run& run : s.runs) take_in(turn, run);
  for (Run& run : s.runs) {
    if (run.phase == Run::Phase::kRobots) steer_parts(turn, run);
  }
  watch_phase_lines(turn);
  for (const Run& run : s.runs) apply_halts(turn, run);
  expire_questions(turn);
  settle_rallies(turn, cycle.robots);
  go_on(turn);
  fail_starts(turn, failed);
  check_patience(turn);
}

}  // namespace mlab::mission
