#include <algorithm>

#include <fmt/core.h>

#include "mlab/console/overview.h"
#include "mlab/console/session_parts.h"
#include "mlab/mission/command.h"
#include "mlab/mission/wording.h"

namespace mlab::console {
namespace {

// Where they are is where the stick takes over.
void teleoperate(const fleet::MissionRun& run, mission::UnitCommand& command) {
  command.task = mission::Task::kTeleoperate;
  const auto& members = mission::members_of(run.mission(), command);
  const fleet::FleetRobot* leader = members.empty() ? nullptr : run.fleet().find(members.front());
  if (leader != nullptr) command.goal = run.fleet().pose(*leader).position;
}

bool has_running_robot(const fleet::MissionRun& run, const mission::UnitCommand& command) {
  return std::ranges::any_of(mission::members_of(run.mission(), command), [&](base::RobotId id) {
    const fleet::FleetRobot* robot = run.fleet().find(id);
    return robot != nullptr && robot->life == fleet::RobotLife::kRunning;
  });
}

}  // namespace

Session::Parts::Answered Session::Parts::start_teleoperation(const std::string& who,
                                                             const StartTeleoperation& start) {
  if (auto refused = why_not_now()) return refused;
  const fleet::MissionRun& run = live_->run();
  mission::UnitCommand command;
  if (start.robot() != 0) {
    if (run.fleet().find({start.robot()}) == nullptr)
      return fmt::format("there is no robot {}", start.robot());
    command.unit = mission::kNoUnit;
    command.robots = {{start.robot()}};
  } else {
    const auto& units = run.mission().units;
    const auto at = std::ranges::find(units, start.unit(), &mission::Unit::name);
    if (start.unit().empty() || at == units.end())
      return fmt::format("there is no unit `{}`", clean(start.unit()));
    command.unit = static_cast<std::uint32_t>(at - units.begin());
  }
  const std::string name = mission::addressee(run.mission(), command);
  if (teleoperations_.is_open(name)) return std::nullopt;
  if (!has_running_robot(run, command)) return fmt::format("no robot of {} runs", clean(name));
  teleoperate(run, command);
  note(who, fmt::format("teleoperate {}", clean(name)));
  post(mission::event::Typed{{std::move(command)}});
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
    post(mission::event::TeleoperationComplete{command.record});
    update_teleoperations();
    return std::nullopt;
  }
  return fmt::format("{} is not under teleoperation", clean(end.unit()));
}

void Session::Parts::update_teleoperations() {
  if (!live_) return;
  const bool changed = teleoperations_.update(live_->run());
  if (teleoperations_.relax(live_->run(), now()) || changed) ++version_;
  if (changed) changes_.status = true;
}

}  // namespace mlab::console
