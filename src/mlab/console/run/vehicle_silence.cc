#include "mlab/console/run/vehicle_silence.h"

#include <algorithm>

namespace mlab::console {
namespace {

// All that is taken is part of the run's history, so it is taken no more often than people want to know [s].
constexpr double kApart = 1.0;
constexpr double kUsual = 2.0;  // in which something comes, if all is well [s]

}  // namespace

bool VehicleSilence::look(run::MissionRun& run, double wall) {
  const bool is_due = known_.empty() || std::ranges::any_of(known_, [&](const auto& one) {
                        return wall >= one.second.since + kApart;
                      });
  bool has_vehicles = false;
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    if (robot.program == nullptr || !robot.program->is_of_vehicle) continue;
    if (!has_vehicles && is_due) run.hear_bodies();
    has_vehicles = true;
    const std::string name = robot.program->vehicle();
    const auto state = run.vehicle(name);
    const auto [known, is_new] = known_.try_emplace(name, Known{0, wall});
    if (!state || (state->number == known->second.number && !is_new)) continue;
    known->second = {state->number, wall};
  }
  return has_vehicles;
}

void VehicleSilence::add(double wall, Status& status) const {
  for (Status::Vehicle& one : *status.mutable_vehicles()) {
    const auto known = known_.find(one.name());
    if (known == known_.end() || wall - known->second.since <= kUsual) continue;
    const double silent = wall - known->second.since;
    one.set_age(one.age() + silent);
    if (one.has_motion_age()) one.set_motion_age(one.motion_age() + silent);
    if (one.has_battery()) one.mutable_battery()->set_age(one.battery().age() + silent);
    for (Status::Vehicle::Sensor& sensor : *one.mutable_sensors()) sensor.set_age(sensor.age() + silent);
  }
}

}  // namespace mlab::console
