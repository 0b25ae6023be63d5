#include "mlab/model_vehicles/body.h"

#include <array>
#include <cmath>

#include "mlab/base/angle.h"
#include "mlab/percept/needs.h"
#include "mlab/sim/simulator.h"

namespace mlab::model_vehicles {

struct Body::Parts {
  sim::Simulator simulator;
  binding::BodyIndex body = binding::kNoBody;
  percept::Needs needs{{percept::Sensor::kRanges}};
  sim::SenseBuffer buffer;
  percept::Percepts percepts;
  geom::Pose origin;  // of what is counted

  Parts(const overlay::Overlay& world, std::uint64_t seed)
      : simulator(sim::world_of(world), {.seed = seed}) {}
  void sense() { simulator.sense(body, needs, buffer, percepts); }
};

Body::Body(const overlay::Overlay& world, const binding::BodySpec& spec, const geom::Pose& place,
           std::uint64_t seed)
    : parts_(std::make_unique<Parts>(world, seed)) {
  const auto placed = parts_->simulator.add_body({.spec = spec, .pose = place, .robot = base::RobotId{1}});
  if (placed.has_value()) parts_->body = placed->body;
  count_from_here();
}

Body::~Body() = default;

void Body::step(double speed, double turn_rate, double dt) {
  percept::Action action;
  action.velocity = {speed, 0.0, 0.0};
  action.spin = turn_rate;
  action.drives = true;
  action.spins = true;
  parts_->simulator.step(std::array{action}, dt);
}

ModelVehicle::Truth Body::truth() const {
  const sim::Simulator& simulator = parts_->simulator;
  const geom::Pose pose = simulator.pose(parts_->body);
  const geom::Offset velocity = simulator.velocity(parts_->body);
  const double ahead = geom::dot(velocity, pose.to_world({1.0, 0.0, 0.0}));
  return {pose, std::copysign(geom::length(velocity), ahead), simulator.momentum(parts_->body).turn_rate};
}

geom::Pose Body::counted() {
  parts_->sense();
  const geom::Pose& pose = parts_->percepts.pose;
  const geom::Vector from = parts_->origin.to_robot(pose.position);
  return {{from.x, from.y}, base::wrap_angle(pose.heading - parts_->origin.heading)};
}

void Body::count_from_here() {
  parts_->sense();
  parts_->origin = parts_->percepts.pose;
}

std::span<const percept::RangeReading> Body::ranges() {
  parts_->sense();
  return parts_->percepts.ranges;
}

std::span<const binding::Wall> Body::walls() const {
  return parts_->simulator.walls();
}

}  // namespace mlab::model_vehicles
