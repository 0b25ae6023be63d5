#include "mlab/console/targets.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <fmt/core.h>

#include "mlab/console/overview.h"
#include "mlab/mission/command.h"
#include "mlab/mission/wording.h"

namespace mlab::console {
namespace {

using fleet::FleetRobot;
using fleet::RobotLife;
using mission::UnitCommand;

// Why the command would do nothing to this robot; nothing where it would.
std::optional<std::string> why_skipped(const fleet::MissionRun& run, const UnitCommand& command,
                                       base::RobotId id) {
  const FleetRobot* robot = run.fleet().find(id);
  const bool starts = command.task == percept::Task::kStart;
  if (robot == nullptr || robot->life == RobotLife::kNotStarted)
    return starts ? std::nullopt : std::optional<std::string>("not started");
  switch (robot->life) {
    case RobotLife::kRunning:
      return starts ? std::optional<std::string>("runs already") : std::nullopt;
    case RobotLife::kParked:
      if (starts) return "stands parked already";
      if (command.task == percept::Task::kStop) return std::nullopt;
      return fmt::format("parked: nothing here answers to its program `{}`", robot->program->name);
    case RobotLife::kStopped:
      return starts ? std::nullopt : std::optional<std::string>("stopped");
    case RobotLife::kFaulted:
      return starts ? std::nullopt : std::optional(fmt::format("faulted at `{}`", robot->fault));
    case RobotLife::kNotStarted:
      break;
  }
  return std::nullopt;
}

// The command that the robot is under and not done with; empty: none.
std::string current_command(const fleet::MissionRun& run, base::RobotId id) {
  const mission::State& state = run.state();
  const auto robot = std::ranges::lower_bound(state.robots, id, {}, &mission::RobotState::id);
  if (robot == state.robots.end() || robot->id != id || robot->run >= state.runs.size()) return "";
  const mission::Run& command = state.runs[robot->run];
  return command.phase == mission::Run::Phase::kEnded ? "" : state.commands[command.record].text;
}

std::string short_text(const UnitCommand& command) {
  std::string text(mission::task_name(command.task));
  if (!command.place_name.empty()) text += " " + command.place_name;
  if (mission::formation_of(command) != percept::Formation::kNone)
    text += fmt::format(", {}", percept::name(mission::formation_of(command)));
  return text;
}

}  // namespace

void encode_targets(const fleet::MissionRun& run, const mission::Mission& mission,
                    const std::vector<mission::Command>& commands, Targets& out) {
  std::map<base::RobotId, std::size_t> last;  // the command that gets a robot that several name
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const auto* command = std::get_if<UnitCommand>(&commands[i]);
    if (command == nullptr || command->unit >= mission.units.size()) continue;
    for (const base::RobotId id : mission.units[command->unit].members) last[id] = i;
  }
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const auto* command = std::get_if<UnitCommand>(&commands[i]);
    if (command == nullptr || command->unit >= mission.units.size()) continue;
    Targets::Unit& unit = *out.add_units();
    unit.set_name(clean(mission::unit_name(mission, command->unit)));
    unit.set_command(clean(short_text(*command)));
    std::set<std::string> replaced;
    for (const base::RobotId id : mission.units[command->unit].members) {
      std::optional<std::string> reason = why_skipped(run, *command, id);
      if (!reason && last[id] != i) reason = "a later command of this line takes it";
      if (reason) {
        Targets::Skipped& skipped = *unit.add_skipped();
        skipped.set_robot(id.value);
        skipped.set_reason(clean(*reason));
        continue;
      }
      unit.add_robots(id.value);
      if (std::string text = current_command(run, id); !text.empty()) replaced.insert(std::move(text));
    }
    std::string text;
    for (const std::string& one : replaced) text += (text.empty() ? "" : "; ") + one;
    unit.set_replaces(clean(text));
  }
}

}  // namespace mlab::console
