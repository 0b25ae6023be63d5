#include "mlab/mission/dispatch.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "mlab/mission/claim.h"
#include "mlab/mission/clock.h"
#include "mlab/mission/command.h"
#include "mlab/mission/parts.h"
#include "mlab/mission/question.h"
#include "mlab/mission/step.h"
#include "mlab/mission/tasks.h"
#include "mlab/mission/wording.h"

namespace mlab::mission {
namespace {

void leave_order(Turn& turn, RobotState& robot) {
  if (robot.sequence == 0) return;
  if (turn.shrunk.empty() || turn.shrunk.back() != robot.sequence) turn.shrunk.push_back(robot.sequence);
  robot.sequence = 0;
}

// Who of the unit runs already keeps the place of its rank.
void start_robots(Turn& turn, Run& run, const std::vector<base::RobotId>& unit) {
  std::size_t rank = 0;
  auto next = run.needed.begin();
  for (const base::RobotId id : unit) {
    if (next == run.needed.end()) return;
    if (find_robot(turn.state, id) == nullptr) continue;
    const geom::Pose pose = start_pose(*turn.state.mission, *run.command, rank++);
    if (id != *next) continue;
    ++next;
    RobotState& robot = *find_robot(turn.state, id);
    leave_order(turn, robot);
    robot.life = RobotState::Life::kStarted;
    robot.seen = 0;
    emit(turn, effect::Start{id, pose});
  }
}

void stop_robots(Turn& turn, Run& run) {
  for (const base::RobotId id : run.needed) {
    RobotState& robot = *find_robot(turn.state, id);
    stop_robot(turn, robot);
    if (robot.is_running) continue;
    robot.done = true;
    --run.missing;
  }
}

void order_robots(Turn& turn, Run& run) {
  run.lines.resize(run.command->phase_lines.size());
  for (PlannedPart& planned : plan_parts(turn.state, run)) {
    if (!planned.warning.empty())
      warn(turn, fmt::format("{}{}", owner_prefix(turn.state, run.owner), planned.warning), run.owner);
    Part part;
    part.goal = planned.end;
    part.ahead = planned.ahead;
    part.halted = planned.halted;
    part.sequence = give_order(turn, {.sequence = 0,
                                      .members = std::move(planned.members),
                                      .command = planned.command,
                                      .task = info(run.command->task).told,
                                      .goal = planned.goal,
                                      .halted = planned.halted});
    run.parts.push_back(part);
  }
  const State& s = turn.state;
  if (run.command->until && run.command->task != Task::kOccupy)
    run.ends = run_time_of(*run.command->until, s.options, s.time);
  if (run.command->task != Task::kTeleoperate) return;
  run.phase = Run::Phase::kTeleoperation;
  if (!s.options.proceed_all) emit(turn, effect::OpenTeleoperation{run.record});
}

// As the unit has them.
void sort_by_rank(const State& state, const Run& run, std::vector<base::RobotId>& robots) {
  const std::vector<base::RobotId> ranks = members_of(*state.mission, *run.command);
  std::ranges::sort(robots, {}, [&](base::RobotId id) { return std::ranges::find(ranks, id); });
}

// Under the order of the run's last part, or, in a RALLY, under one of its own.
void order_too(Turn& turn, Run& run, RobotState& robot) {
  State& s = turn.state;
  Part& last = run.parts.back();
  Group* const group = find_group(s, last.sequence);
  if (run.command->task == Task::kRally) {
    Group own = *group;
    own.members = {robot.id};
    Part part = last;
    part.done = false;
    part.sequence = give_order(turn, std::move(own));
    run.parts.push_back(part);
    return;
  }
  leave_order(turn, robot);
  robot.sequence = group->sequence;
  group->members.push_back(robot.id);
  sort_by_rank(s, run, group->members);
  emit(turn, order_of(*group));
}

// The command goes out to its robots, which leave whatever they did.
void carry_out(Turn& turn, Run& run) {
  run.phase = Run::Phase::kRobots;
  const std::vector<base::RobotId> unit = run.needed;
  if (!claim(turn, run)) return;
  if (run.command->task == Task::kStart)
    start_robots(turn, run, unit);
  else if (run.command->task == Task::kStop)
    stop_robots(turn, run);
  else
    order_robots(turn, run);
}

struct Begin {
  Turn& turn;
  const std::shared_ptr<const void>& keeper;
  std::uint32_t owner;
  std::uint32_t record;

  void operator()(const UnitCommand& command) const {
    State& s = turn.state;
    Run& run = s.runs.emplace_back();
    run.record = record;
    run.owner = owner;
    run.unit = command.unit;
    run.command = CommandRef{std::shared_ptr<const UnitCommand>(keeper, &command)};
    run.needed = members_of(*s.mission, command);
    run.missing = static_cast<std::uint32_t>(run.needed.size());
    if (is_free(s, run))
      carry_out(turn, run);
    else
      message(turn,
              fmt::format("{}{} waits for {}", owner_prefix(s, owner), s.commands[record].text,
                          waiting_text(s, run)),
              owner);
  }
  void operator()(const SetBoolean& option) const { at_once(effect::Set{option}); }
  void operator()(const SetNumber& option) const { at_once(effect::Set{option}); }
  void operator()(const Print& print) const { at_once(effect::Print{print.robot_info}); }
  void operator()(const Quit&) const {
    end_command(turn, owner, record, Outcome::kDone, {});
    quit(turn);
  }

  template <class T>
  void at_once(T effect) const {
    emit(turn, std::move(effect));
    end_command(turn, owner, record, Outcome::kDone, {});
  }
};

}  // namespace

void begin_commands(Turn& turn, const std::vector<Command>& commands,
                    const std::shared_ptr<const void>& keeper, std::uint32_t owner) {
  State& s = turn.state;
  s.runs.reserve(s.runs.size() + commands.size());
  for (const Command& command : commands) {
    const auto record = static_cast<std::uint32_t>(s.commands.size());
    s.commands.push_back(record_of(*s.mission, command, s.time));
    ++s.steps[owner].command_count;
    tell(turn, effect::Tell::Kind::kCommandStarted, owner_prefix(s, owner) + s.commands.back().text, owner,
         record);
    std::visit(Begin{turn, keeper, owner, record}, command);
    if (s.mode == State::Mode::kQuit) return;
  }
}

bool begin_held(Turn& turn) {
  State& s = turn.state;
  bool any = false;
  for (Run& run : s.runs) {
    if (run.phase != Run::Phase::kHeld || !is_free(s, run)) continue;
    carry_out(turn, run);
    any = true;
  }
  return any;
}

void take_in(Turn& turn, Run& run) {
  State& s = turn.state;
  if (run.left_out.empty() || run.phase != Run::Phase::kRobots || run.parts.empty()) return;
  if (find_group(s, run.parts.back().sequence) == nullptr) return;  // all of it went to other orders
  std::vector<base::RobotId> back;
  for (const base::RobotId id : run.left_out) {
    const RobotState* robot = find_robot(s, id);
    if (robot == nullptr || robot->run != kNoRun || !in_sight(s, *robot) || !robot->is_running) continue;
    back.push_back(id);
  }
  if (back.empty()) return;
  std::erase_if(run.left_out, [&](base::RobotId id) { return std::ranges::find(back, id) != back.end(); });
  for (const base::RobotId id : back) {
    RobotState& robot = *find_robot(s, id);
    order_too(turn, run, robot);
    robot.run = index_of(s, run);
    robot.done = robot.warned = robot.has_given_up = false;
    robot.remaining = robot.best = std::numeric_limits<double>::infinity();
    run.needed.push_back(id);
    ++run.missing;
  }
  sort_by_rank(s, run, run.needed);
  run.stalled = 0.0;
  message(turn,
          fmt::format("{}{} {} again and {} part in `{}`", owner_prefix(s, run.owner), robots_text(back),
                      back.size() == 1 ? "runs" : "run", back.size() == 1 ? "takes" : "take",
                      s.commands[run.record].text),
          run.owner);
}

std::uint32_t give_order(Turn& turn, Group group) {
  State& s = turn.state;
  group.sequence = ++s.last_sequence;
  for (const base::RobotId id : group.members) {
    RobotState& robot = *find_robot(s, id);
    leave_order(turn, robot);
    robot.sequence = group.sequence;
    robot.done = robot.has_given_up = false;
    robot.remaining = robot.best = std::numeric_limits<double>::infinity();
  }
  emit(turn, order_of(group));
  s.groups.push_back(std::move(group));
  return s.last_sequence;
}

void set_halted(Turn& turn, Group& group, bool halted) {
  if (group.halted == halted) return;
  group.halted = halted;
  emit(turn, order_of(group));
}

void halt(Turn& turn, Run& run) {
  for (Part& part : run.parts) {
    part.halted = true;
    if (Group* group = find_group(turn.state, part.sequence)) set_halted(turn, *group, true);
  }
}

effect::Order order_of(const Group& group) {
  const UnitCommand& c = *group.command;
  percept::Order order;
  order.sequence = group.sequence;
  order.task = group.task;
  order.goal = group.goal;
  if (percept::has_route(group.task)) order.route = c.route;
  order.formation = formation_of(c);
  order.heading = c.heading.value_or(0.0);
  order.has_heading = c.heading.has_value();
  order.speed = c.speed;
  order.halted = group.halted;
  order.swath = c.swath;
  order.margin = c.margin;
  return {group.members, order, group.command.value};
}

void stop_robot(Turn& turn, RobotState& robot) {
  leave_order(turn, robot);
  withdraw_of(turn, robot.id);
  if (robot.life == RobotState::Life::kStopped && !robot.is_running) return;
  if (robot.life == RobotState::Life::kNotStarted && robot.seen == 0) return;
  robot.life = RobotState::Life::kStopped;
  emit(turn, effect::Stop{robot.id});
}

void repair_groups(Turn& turn) {
  if (turn.shrunk.empty()) return;
  State& s = turn.state;
  std::ranges::sort(turn.shrunk);
  const auto repeated = std::ranges::unique(turn.shrunk);
  turn.shrunk.erase(repeated.begin(), repeated.end());
  for (const std::uint32_t sequence : turn.shrunk) {
    Group* group = find_group(s, sequence);
    if (group == nullptr) continue;
    const auto left = [&](base::RobotId id) {
      const RobotState* robot = find_robot(s, id);
      return robot == nullptr || robot->sequence != sequence;
    };
    std::erase_if(group->members, left);
    if (!group->members.empty()) emit(turn, order_of(*group));
  }
  std::erase_if(s.groups, [](const Group& group) { return group.members.empty(); });
}

}  // namespace mlab::mission
