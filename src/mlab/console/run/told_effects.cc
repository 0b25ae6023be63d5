#include "mlab/console/run/told_effects.h"

#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mlab/base/angle.h"
#include "mlab/mission/command.h"

namespace mlab::console {
namespace {

using mission::effect::Tell;

void tell(const run::MissionRun& run, const Tell& told, EventLog& log) {
  constexpr Log::Kind kKinds[] = {Log::STEP,    Log::STEP,    Log::COMMAND, Log::COMMAND,
                                  Log::MESSAGE, Log::WARNING, Log::MISSION};
  EventLog::Entry entry;
  entry.kind = kKinds[static_cast<std::size_t>(told.kind)];
  entry.text = told.text;
  entry.is_alert = told.kind == Tell::Kind::kWarning;
  const mission::State& state = run.state();
  const bool of_command = told.kind == Tell::Kind::kCommandStarted || told.kind == Tell::Kind::kCommandEnded;
  if (of_command && told.command < state.commands.size()) {
    const mission::CommandRecord& record = state.commands[told.command];
    entry.unit = record.unit;
    entry.is_alert = record.outcome == mission::Outcome::kFailed;
    for (const mission::Run& carried : state.runs) {
      if (carried.record == told.command && !carried.command->place_name.empty())
        entry.place = mission::goal_of(*carried.command);
    }
  }
  log.add(run.time(), std::move(entry));
}

void ask(const run::MissionRun& run, const mission::effect::Ask& asked, EventLog& log) {
  const bool is_robots = asked.robot.value != 0;
  log.add(run.time(), {Log::MESSAGE,
                       asked.text,
                       asked.robot.value,
                       is_robots ? std::string() : run.state().commands[asked.command].unit,
                       {},
                       false});
}

}  // namespace

void tell_effect(const run::MissionRun& run, const mission::Effect& effect, EventLog& log) {
  if (const auto* told = std::get_if<Tell>(&effect)) tell(run, *told, log);
  if (const auto* asked = std::get_if<mission::effect::Ask>(&effect)) ask(run, *asked, log);
  if (const auto* wanted = std::get_if<mission::effect::Print>(&effect))
    tell_print(run, wanted->robot_info, log);
}

void tell_print(const run::MissionRun& run, bool robot_info, EventLog& log) {
  const auto say = [&](std::string text) {
    log.add(run.time(), {Log::MESSAGE, std::move(text), 0, "", {}, false});
  };
  if (robot_info) {
    for (const fleet::FleetRobot& robot : run.fleet().robots()) {
      const geom::Pose pose = run.fleet().pose(robot);
      log.add(run.time(), {Log::MESSAGE,
                           fmt::format("robot {}: {}, {}, at ({:.2f}, {:.2f}), heading {:.1f} deg",
                                       robot.id.value, robot.type, name(robot.life), pose.position.x,
                                       pose.position.y, base::degrees(pose.heading)),
                           robot.id.value, "", pose.position, false});
    }
    return;
  }
  for (const overlay::ControlMeasure& measure : run.mission().overlay.measures) {
    const geom::Point at = measure.center();
    log.add(run.time(),
            {Log::MESSAGE,
             fmt::format("{} {} at ({:.2f}, {:.2f})", keyword(measure.kind), measure.name, at.x, at.y), 0, "",
             at, false});
  }
  for (const mission::Unit& unit : run.mission().units) {
    if (unit.name.empty()) continue;
    std::vector<std::uint32_t> ids;
    for (const base::RobotId id : unit.members) ids.push_back(id.value);
    say(fmt::format("unit {}: robots {}", unit.name, fmt::join(ids, " ")));
  }
}

}  // namespace mlab::console
