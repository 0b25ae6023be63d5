#include "mlab/console/run/targets.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/published/overview.h"
#include "mlab/mission/command.h"
#include "mlab/mission/wording.h"

namespace mlab::console {
namespace {

using fleet::FleetRobot;
using fleet::RobotLife;
using mission::UnitCommand;

// Why the command would do nothing to this robot; nothing where it would.
std::optional<std::string> why_skipped(const run::MissionRun& run, const UnitCommand& command,
                                       base::RobotId id) {
  const FleetRobot* robot = run.fleet().find(id);
  const bool starts = command.task == mission::Task::kStart;
  if (robot == nullptr || robot->life == RobotLife::kNotStarted)
    return starts ? std::nullopt : std::optional<std::string>("not started");
  switch (robot->life) {
    case RobotLife::kRunning:
      return starts ? std::optional<std::string>("runs already") : std::nullopt;
    case RobotLife::kParked:
      if (starts) return "stands parked already";
      if (command.task == mission::Task::kStop) return std::nullopt;
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

std::string short_text(const UnitCommand& command) {
  std::string text(mission::task_name(command.task));
  if (!command.place_name.empty()) text += " " + command.place_name;
  if (mission::formation_of(command) != percept::Formation::kNone)
    text += fmt::format(", {}", percept::name(mission::formation_of(command)));
  return text;
}

// The units of the new command that its robots go to.
void name_replaced(const std::string& text, const Targets::Standing& ended, Targets& out) {
  for (Targets::Unit& unit : *out.mutable_units()) {
    const bool takes = std::ranges::any_of(unit.robots(), [&](std::uint32_t robot) {
      return std::ranges::find(ended.leaving(), robot) != ended.leaving().end();
    });
    if (takes) unit.set_replaces(clean(unit.replaces().empty() ? text : unit.replaces() + "; " + text));
  }
}

// What becomes of a command that is under way.
void encode_standing(const mission::State& state, const mission::Run& run,
                     const std::set<base::RobotId>& taken, Targets& out) {
  Targets::Standing& told = *out.add_standing();
  told.set_unit(clean(state.commands[run.record].unit));
  told.set_command(clean(short_text(*run.command)));
  const bool is_held = run.phase == mission::Run::Phase::kHeld;
  for (const base::RobotId id : run.needed) {
    if (!is_held && taken.contains(id)) told.add_leaving(id.value);
  }
  told.set_staying(static_cast<std::uint32_t>(run.needed.size()) -
                   static_cast<std::uint32_t>(told.leaving_size()));
  if (told.leaving_size() == 0) return;
  told.set_fate(told.staying() > 0 ? Targets::Standing::GOES_ON_WITHOUT : Targets::Standing::ENDS);
  if (told.fate() == Targets::Standing::ENDS) name_replaced(state.commands[run.record].text, told, out);
}

// Units nobody of which has or gets a command; of units inside of each other the outermost.
void encode_idle(const mission::Mission& mission, std::set<base::RobotId> busy, Targets& out) {
  for (const mission::Unit& unit : mission.units) {
    const bool is_idle = !unit.name.empty() && std::ranges::none_of(unit.members, [&](base::RobotId id) {
      return busy.contains(id);
    });
    if (!is_idle) continue;
    busy.insert(unit.members.begin(), unit.members.end());
    Targets::Standing& told = *out.add_standing();
    told.set_unit(clean(unit.name));
    told.set_fate(Targets::Standing::IDLE);
    told.set_staying(static_cast<std::uint32_t>(unit.members.size()));
  }
}

}  // namespace

void encode_targets(const run::MissionRun& run, const mission::Mission& mission,
                    const std::vector<mission::Command>& commands, Targets& out) {
  std::map<base::RobotId, std::size_t> last;  // the command that gets a robot that several name
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const auto* command = std::get_if<UnitCommand>(&commands[i]);
    if (command == nullptr) continue;
    for (const base::RobotId id : mission::members_of(mission, *command)) last[id] = i;
  }
  std::set<base::RobotId> taken;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const auto* command = std::get_if<UnitCommand>(&commands[i]);
    if (command == nullptr) continue;
    Targets::Unit& unit = *out.add_units();
    unit.set_name(clean(mission::addressee(mission, *command)));
    unit.set_command(clean(short_text(*command)));
    for (const base::RobotId id : mission::members_of(mission, *command)) {
      std::optional<std::string> reason = why_skipped(run, *command, id);
      if (!reason && last[id] != i) reason = "a later command of this line takes it";
      if (reason) {
        Targets::Skipped& skipped = *unit.add_skipped();
        skipped.set_robot(id.value);
        skipped.set_reason(clean(*reason));
        continue;
      }
      unit.add_robots(id.value);
      taken.insert(id);
    }
  }
  if (taken.empty()) return;
  std::set<base::RobotId> busy = taken;
  for (const mission::Run& under_way : run.state().runs) {
    if (under_way.phase == mission::Run::Phase::kEnded) continue;
    encode_standing(run.state(), under_way, taken, out);
    busy.insert(under_way.needed.begin(), under_way.needed.end());
  }
  encode_idle(mission, std::move(busy), out);
}

}  // namespace mlab::console
