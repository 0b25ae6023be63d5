#include "mlab/console/published/vehicle_encoder.h"

#include <algorithm>
#include <string>
#include <vector>

#include "mlab/console/published/overview.h"

namespace mlab::console {
namespace {

using binding::VehicleState;

// The enumerations count alike.
Status::Vehicle::Readiness readiness_of(VehicleState::Readiness readiness) {
  static_assert(static_cast<int>(VehicleState::Readiness::kTaken) == Status::Vehicle::TAKEN);
  return static_cast<Status::Vehicle::Readiness>(readiness);
}
Status::Vehicle::Driver driver_of(VehicleState::Driver driver) {
  static_assert(static_cast<int>(VehicleState::Driver::kAnotherRun) == Status::Vehicle::ANOTHER_RUN);
  return static_cast<Status::Vehicle::Driver>(driver);
}

void encode(const VehicleState& state, Status::Vehicle& out) {
  out.set_kind(clean(state.kind));
  out.set_readiness(readiness_of(state.readiness));
  out.set_why(clean(state.why));
  out.set_age(state.age);
  if (state.trip) out.set_trip(*state.trip);
  out.set_driver(driver_of(state.driver));
  out.set_is_stopped(state.is_stopped);
  out.set_is_global(state.is_global);
  if (state.motion_age) out.set_motion_age(*state.motion_age);
  if (state.battery) {
    out.mutable_battery()->set_share(state.battery->share);
    out.mutable_battery()->set_voltage(state.battery->voltage);
    out.mutable_battery()->set_age(state.battery->age);
  }
  for (const VehicleState::Sensor& sensor : state.sensors) {
    Status::Vehicle::Sensor& told = *out.add_sensors();
    told.set_number(sensor.number);
    told.set_beams(sensor.beams);
    told.set_farthest(sensor.farthest);
    told.set_beam_width(sensor.beam_width);
    told.set_age(sensor.age);
  }
}

}  // namespace

void encode_vehicles(const run::MissionRun& run, Status& out) {
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    if (robot.program == nullptr || !robot.program->is_of_vehicle) continue;
    const std::string name = robot.program->vehicle();
    Status::Vehicle& told = *out.add_vehicles();
    told.set_robot(robot.id.value);
    told.set_name(clean(name));
    told.set_kind(told.name());
    if (const auto state = run.vehicle(name))
      encode(*state, told);
    else
      told.set_why("is not in the fleet");
  }
}

void encode_held_back(const preflight::Gate& gate, Status& out) {
  std::vector<std::string> unheard;
  for (const Status::Vehicle& one : out.vehicles()) {
    if (one.readiness() == Status::Vehicle::UNHEARD) unheard.push_back(one.name());
  }
  if (unheard.empty()) return;
  const std::string why = gate.has_let_pass()
                              ? "it was not there when the vehicles were checked, and stays out of this run"
                              : "nothing of this reaches the run before the mission starts on its vehicles";
  for (const preflight::VehicleFacts& facts : gate.held_back(unheard)) {
    const auto state = preflight::state_of(facts);
    const auto told = std::ranges::find(*out.mutable_vehicles(), clean(facts.name), &Status::Vehicle::name);
    if (!state || told == out.mutable_vehicles()->end()) continue;
    encode(*state, *told);
    told->set_held_back(why);
  }
}

}  // namespace mlab::console
