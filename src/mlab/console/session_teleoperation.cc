#include <algorithm>

#include <fmt/core.h>

#include "mlab/console/overview.h"
#include "mlab/console/session_parts.h"

namespace mlab::console {
namespace {

mission::UnitCommand teleoperate(const fleet::MissionRun& run, std::uint32_t unit) {
  mission::UnitCommand command;
  command.unit = unit;
  command.task = percept::Task::kTeleoperate;
  const mission::Unit& meant = run.mission().units[unit];
  if (const fleet::FleetRobot* leader = run.fleet().find(meant.members.front()))
    command.goal = run.fleet().pose(*leader).position;
  return command;
}

bool shares_robots(const mission::Unit& a, const mission::Unit& b) {
  return std::ranges::any_of(
      a.members, [&](base::RobotId id) { return std::ranges::find(b.members, id) != b.members.end(); });
}

bool has_running_robot(const fleet::MissionRun& run, const mission::Unit& unit) {
  return std::ranges::any_of(unit.members, [&](base::RobotId id) {
    const fleet::FleetRobot* robot = run.fleet().find(id);
    return robot != nullptr && robot->life == fleet::RobotLife::kRunning;
  });
}

}  // namespace

Session::Parts::Answered Session::Parts::start_teleoperation(const std::string& who,
                                                             const StartTeleoperation& start) {
  if (auto refused = why_not_now()) return refused;
  std::uint32_t unit = 0;
  if (start.robot() != 0) {
    if (live_->run().fleet().find({start.robot()}) == nullptr)
      return fmt::format("there is no robot {}", start.robot());
    const auto made = single_unit({start.robot()});
    if (!made) return "the mission is still being made ready";
    unit = *made;
  } else {
    const auto& units = live_->run().mission().units;
    const auto at = std::ranges::find(units, start.unit(), &mission::Unit::name);
    if (start.unit().empty() || at == units.end())
      return fmt::format("there is no unit `{}`", clean(start.unit()));
    unit = static_cast<std::uint32_t>(at - units.begin());
  }
  const fleet::MissionRun& run = live_->run();
  const mission::Unit& meant = run.mission().units[unit];
  if (teleoperations_.is_open(meant.name)) return std::nullopt;
  if (!has_running_robot(run, meant)) return fmt::format("no robot of {} runs", clean(meant.name));
  // A typed command ends the one before, so those that are steered already are named again.
  std::vector<mission::Command> commands;
  for (std::uint32_t i = 0; i < run.mission().units.size(); ++i) {
    const mission::Unit& other = run.mission().units[i];
    if (teleoperations_.is_open(other.name) && !shares_robots(other, meant))
      commands.emplace_back(teleoperate(run, i));
  }
  commands.emplace_back(teleoperate(run, unit));
  note(who, fmt::format("teleoperate {}", clean(meant.name)));
  post(mission::event::Typed{std::move(commands)});
  if (run.state().paused) post(mission::event::Resume{});
  update_teleoperations();
  return std::nullopt;
}

Session::Parts::Answered Session::Parts::end_teleoperation(const std::string& who,
                                                           const EndTeleoperation& end) {
  if (!live_) return "there is no mission that could run";
  const mission::State& state = live_->run().state();
  for (const mission::Run& command : state.runs) {
    if (command.phase != mission::Run::Phase::kTeleoperation) continue;
    if (state.commands[command.record].unit != end.unit()) continue;
    note(who, fmt::format("end the teleoperation of {}", clean(end.unit())));
    post(mission::event::TeleoperationComplete{command.unit});
    update_teleoperations();
    return std::nullopt;
  }
  return fmt::format("{} is not under teleoperation", clean(end.unit()));
}

std::optional<std::uint32_t> Session::Parts::single_unit(base::RobotId robot) {
  auto at = std::ranges::find(singles_, robot);
  if (at == singles_.end()) {
    singles_.push_back(robot);
    if (!change_mission(plain_)) return std::nullopt;
    at = singles_.end() - 1;
  }
  return static_cast<std::uint32_t>(named_units_ + static_cast<std::size_t>(at - singles_.begin()));
}

void Session::Parts::update_teleoperations() {
  if (!live_) return;
  const bool changed = teleoperations_.update(live_->run());
  if (teleoperations_.relax(live_->run(), now()) || changed) ++version_;
  if (changed) changes_.status = true;
}

}  // namespace mlab::console
