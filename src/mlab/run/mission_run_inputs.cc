#include <utility>
#include <variant>

#include "mlab/base/overloaded.h"
#include "mlab/run/mission_run.h"
#include "mlab/run/places.h"

namespace mlab::run {
void MissionRun::note(const Input& input) {
  if (input_observer_) input_observer_(moment(), input);
  now_.has_looked = false;
}

void MissionRun::take(const Input& input) {
  std::visit(base::Overloaded{
                 [&](const input::Posted& posted) { post(posted.event); },
                 [&](const input::Exchanged& exchanged) {
                   // What was refused then is refused again, and was told then.
                   if (!exchanged.takes_over)
                     edit(exchanged.crew);
                   else if (const auto taken = take_over(exchanged.crew); !taken)
                     return;
                 },
                 [&](const input::EmergencyStop& stop) { set_emergency_stop(stop.is_engaged); },
                 [&](const input::Steered& steered) {
                   if (steered.is_held)
                     set_joystick(steered.robot, steered.stick);
                   else
                     let_go_of_stick(steered.robot);
                 },
                 [&](const input::ParameterSet& set) { set_parameter(set.robot, set.port, set.value); },
                 [&](const input::StandStill& still) { set_stands_still_for_operator(still.stands_still); },
                 [&](const input::Heard& heard) { hear(heard.heard); },
                 [&](const input::Intervened& one) {
                   switch (one.kind) {
                     case InterventionRecord::Kind::kForce:
                       force_state(one.robot, one.path, one.value);
                       break;
                     case InterventionRecord::Kind::kHold:
                       hold_value(one.robot, one.path, one.value);
                       break;
                     case InterventionRecord::Kind::kRelease:
                       release_value(one.robot, one.path);
                       break;
                     case InterventionRecord::Kind::kReplace:
                       replace_robot(one.robot);
                       break;
                   }
                 },
             },
             input);
}

void MissionRun::hear(const binding::Heard& heard) {
  note(input::Heard{heard});
  binding_->take(heard);
}

void MissionRun::hear_bodies() {
  heard_.clear();
  binding_->hear(heard_);
  for (const binding::Heard& one : heard_) hear(one);
}

void MissionRun::set_emergency_stop(bool stopped) {
  if (stopped == now_.is_stopped) return;
  note(input::EmergencyStop{stopped});
  if (stopped) now_.has_braked = false;
  now_.is_stopped = stopped;
}

void MissionRun::set_joystick(base::RobotId robot, const percept::Joystick& joystick) {
  const fleet::FleetRobot* const steered = fleet_->find(robot);
  if (steered == nullptr || (steered->is_stick_held && steered->joystick == joystick)) return;
  note(input::Steered{robot, joystick, true});
  fleet_->set_joystick(robot, joystick);
}

void MissionRun::let_go_of_stick(base::RobotId robot) {
  const fleet::FleetRobot* const steered = fleet_->find(robot);
  if (steered == nullptr || (!steered->is_stick_held && steered->joystick == percept::Joystick{})) return;
  note(input::Steered{robot, {}, false});
  fleet_->let_go_of_stick(robot);
}

void MissionRun::set_stands_still_for_operator(bool stands_still) {
  if (stands_still == now_.stands_still_for_operator) return;
  note(input::StandStill{stands_still});
  now_.stands_still_for_operator = stands_still;
}

std::optional<std::string> MissionRun::set_parameter(base::RobotId robot, std::string_view port,
                                                     const std::string& value) {
  note(input::ParameterSet{robot, std::string(port), value});
  const fleet::FleetRobot* found = fleet_->find(robot);
  const flow::Program* program =
      found == nullptr || found->runner == nullptr ? nullptr : found->workings().program;
  const flow::Port* parameter = program == nullptr ? nullptr : program->find(port);
  if (parameter == nullptr || parameter->type->kind != flow::TypeKind::kPoint)
    return fleet_->set_parameter(robot, port, value);
  return fleet_->set_parameter(
      robot, port, robot::in_coordinates(*parameter, value, MissionPlaces(*now_.crews.back()->mission)));
}

}  // namespace mlab::run
