#include "mlab/mission/wording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mlab/base/counted.h"
#include "mlab/mission/clock.h"
#include "mlab/mission/command.h"
#include "mlab/mission/maneuver.h"
#include "mlab/mission/tasks.h"
#include "mlab/mission/turn.h"

namespace mlab::mission {
namespace {

// So many robots are named one by one; the rest is counted.
constexpr std::size_t kMaxNamed = 8;

std::string_view option_name(BooleanOption option) {
  switch (option) {
    case BooleanOption::kUseMilitaryStyle:
      return "USE-MILITARY-STYLE";
    case BooleanOption::kShowTrails:
      return "SHOW-TRAILS";
    case BooleanOption::kHighlightRepellingObstacles:
      return "HIGHLIGHT-REPELLING-OBSTACLES";
    case BooleanOption::kShowMovementVectors:
      return "SHOW-MOVEMENT-VECTORS";
    case BooleanOption::kShowColormap:
      return "SHOW-COLORMAP";
    case BooleanOption::kDebugRobots:
      return "DEBUG-ROBOTS";
    case BooleanOption::kDebugSimulator:
      return "DEBUG-SIMULATOR";
    case BooleanOption::kDebugScheduler:
      return "DEBUG-SCHEDULER";
    case BooleanOption::kScaleRobots:
      return "SCALE-ROBOTS";
    case BooleanOption::kPlanWays:
    case BooleanOption::kAssignStations:
      return maneuver(option)->word;
  }
  return "";
}

std::string_view option_name(NumberOption option) {
  switch (option) {
    case NumberOption::kSeed:
      return "SEED";
    case NumberOption::kRobotLength:
      return "ROBOT-LENGTH";
    case NumberOption::kObstacleCoverage:
      return "OBSTACLE-COVERAGE";
    case NumberOption::kMinObstacleRadius:
      return "MIN-OBSTACLE-RADIUS";
    case NumberOption::kMaxObstacleRadius:
      return "MAX-OBSTACLE-RADIUS";
    case NumberOption::kZoomFactor:
      return "ZOOM-FACTOR";
    case NumberOption::kCycleDuration:
      return "CYCLE-DURATION";
    case NumberOption::kFailingRobots:
      return "FAILING-ROBOTS";
    case NumberOption::kFailuresWithin:
      return "FAILURES-WITHIN";
    case NumberOption::kCohesion:
      return maneuver(option)->word;
  }
  return "";
}

std::string_view technique_text(Technique technique) {
  switch (technique) {
    case Technique::kTraveling:
      return "";
    case Technique::kTravelingOverwatch:
      return "traveling overwatch";
    case Technique::kBoundingOverwatch:
      return "bounding overwatch";
  }
  return "";
}

struct TextOf {
  const Mission& mission;

  std::string operator()(const UnitCommand& c) const {
    std::string text =
        fmt::format("{}{} {}", c.unit == kNoUnit ? "" : "unit ", addressee(mission, c), task_name(c.task));
    if (!c.place_name.empty()) text += " " + c.place_name;
    const percept::Formation formation = formation_of(c);
    const std::string_view technique = technique_text(c.technique);
    if (formation != percept::Formation::kNone) text += fmt::format(" ({}", percept::name(formation));
    if (!technique.empty())
      text += fmt::format("{}{}", formation != percept::Formation::kNone ? ", " : " (", technique);
    if (formation != percept::Formation::kNone || !technique.empty()) text += ")";
    return text;
  }
  std::string operator()(const SetBoolean& c) const {
    const ManeuverInfo* const named = maneuver(c.option);
    const std::string_view value =
        named != nullptr ? (c.value ? named->on : named->off) : (c.value ? "ON" : "OFF");
    return fmt::format("SET {} {}", option_name(c.option), value);
  }
  std::string operator()(const SetNumber& c) const {
    return fmt::format("SET {} {}", option_name(c.option), c.value);
  }
  std::string operator()(const Print& c) const {
    return c.robot_info ? "PRINT ROBOT-INFO" : "PRINT CONSOLE-DATABASE";
  }
  std::string operator()(const Quit&) const { return "QUIT"; }
};

// Why a robot is not done with the run's command.
std::string reason(const State& state, const Run& run, const RobotState& robot) {
  const bool starts = run.command->task == Task::kStart;
  if (run.command->task == Task::kStop) return "does not stop";
  if (robot.life == RobotState::Life::kStopped) return "stopped";
  if (robot.seen == 0) return starts ? "does not start" : "not started";
  if (!in_sight(state, robot)) return "lost, it no longer reports";
  if (!robot.is_running) return "not running, stopped by a fault or a failsafe";
  if (robot.reported == 0) return "its program does not report on orders";
  if (robot.reported != robot.sequence) return "it has not taken up the order";
  if (info(run.command->task).is_shared && can_do_no_more(robot))
    return "it can come to nothing that is left";
  if (robot.has_given_up) return "no way leads farther";
  const Group* group = find_group(state, robot.sequence);
  if (group != nullptr && group->halted) return "halted while another part of the unit moves";
  return "no progress";
}

std::string robot_text(const State& state, const Run& run, const RobotState& robot) {
  std::string text = fmt::format("robot {}", robot.id.value);
  if (robot.seen != 0)
    text += fmt::format(" at ({:.1f}, {:.1f})", robot.pose.position.x, robot.pose.position.y);
  if (std::isfinite(robot.remaining)) text += fmt::format(", {:.1f} m to go", robot.remaining);
  return text + ": " + reason(state, run, robot);
}

// The orders of the operator that a command of the plan waits for.
std::string held_text(const State& state, const Run& run) {
  for (const base::RobotId id : run.needed) {
    if (const Run* order = order_of_robot(state, id))
      return fmt::format("the order `{}`", state.commands[order->record].text);
  }
  return "nothing";
}

bool is_done(const State& state, const Run& run, const RobotState& robot) {
  return robot.done && robot.run == index_of(state, run);
}

}  // namespace

std::string_view task_name(Task task) {
  return info(task).word;
}

std::string unit_name(const Mission& mission, std::uint32_t unit) {
  if (unit >= mission.units.size()) return "(unknown)";
  const Unit& u = mission.units[unit];
  return u.name.empty() ? "of " + robots_text(u.members) : u.name;
}

std::string robots_name(const std::vector<base::RobotId>& robots) {
  std::string text = robots.size() == 1 ? "robot " : "robots ";
  for (std::size_t i = 0; i < robots.size();) {
    std::size_t last = i;
    while (last + 1 < robots.size() && robots[last + 1].value == robots[last].value + 1) ++last;
    if (last == i + 1) last = i;  // two of them are named, not a range
    text += fmt::format("{}{}", i > 0 ? ", " : "", robots[i].value);
    if (last > i) text += fmt::format("-{}", robots[last].value);
    i = last + 1;
  }
  return text;
}

std::string addressee(const Mission& mission, const UnitCommand& command) {
  return command.unit == kNoUnit ? robots_name(command.robots) : unit_name(mission, command.unit);
}

std::string addressee(const State& state, const Run& run) {
  const std::string name =
      run.unit == kNoUnit ? robots_name(run.command->robots) : unit_name(*state.mission, run.unit);
  return run.unit == kNoUnit ? name : "unit " + name;
}

bool is_one(const Run& run) {
  return run.unit != kNoUnit || run.command->robots.size() == 1;
}

std::string command_text(const Mission& mission, const Command& command) {
  return std::visit(TextOf{mission}, command);
}

CommandRecord record_of(const Mission& mission, const Command& command, double time) {
  CommandRecord record;
  record.text = command_text(mission, command);
  record.start = record.end = time;
  const auto* c = std::get_if<UnitCommand>(&command);
  if (c == nullptr) {
    record.task = record.text.substr(0, record.text.find(' '));
    return record;
  }
  record.unit = addressee(mission, *c);
  record.task = task_name(c->task);
  record.place = c->place_name;
  if (formation_of(*c) != percept::Formation::kNone) record.formation = percept::name(formation_of(*c));
  return record;
}

std::string robots_text(const std::vector<base::RobotId>& robots) {
  if (robots.empty()) return "no robots";
  std::string text = robots.size() == 1 ? "robot " : "robots ";
  const std::size_t named = std::min(robots.size(), kMaxNamed);
  for (std::size_t i = 0; i < named; ++i) {
    if (i > 0) text += i + 1 == robots.size() ? " and " : ", ";
    text += fmt::format("{}", robots[i].value);
  }
  if (named < robots.size()) text += fmt::format(" and {} more", robots.size() - named);
  return text;
}

std::string undone_text(const State& state, const Run& run) {
  std::string text;
  std::size_t count = 0;
  for (const base::RobotId id : run.needed) {
    const RobotState* robot = find_robot(state, id);
    if (robot == nullptr || is_done(state, run, *robot)) continue;
    if (++count > kMaxNamed) continue;
    if (!text.empty()) text += "; ";
    text += robot_text(state, run, *robot);
  }
  if (count > kMaxNamed) text += fmt::format("; and {} more", count - kMaxNamed);
  return text;
}

std::string waiting_text(const State& state, const Run& run) {
  switch (run.phase) {
    case Run::Phase::kHeld:
      return held_text(state, run);
    case Run::Phase::kProceed:
      return "the operator's clearance";
    case Run::Phase::kTeleoperation:
      return "the end of teleoperation";
    case Run::Phase::kEnded:
      return "nothing";
    case Run::Phase::kRobots:
      break;
  }
  for (std::size_t i = 0; i < run.lines.size(); ++i) {
    const LineState& line = run.lines[i];
    if (line.phase != LineState::Phase::kHolding) continue;
    const PhaseLine& said = run.command->phase_lines[i];
    const bool early = line.not_before && *line.not_before > state.time;
    const bool unacknowledged = said.waits && !line.acknowledged;
    std::string what = early ? clock_text(*line.not_before, state.options) : "";
    if (unacknowledged) what += early ? " and the acknowledgement" : "the acknowledgement";
    return fmt::format("{} at phase line {}", what, said.name);
  }
  if (info(run.command->task).is_shared) return "what its robots share";
  return fmt::format("{} of {}", run.missing, base::counted(run.needed.size(), "robot"));
}

}  // namespace mlab::mission
