#include "robot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "mlab/base/random.h"
#include "mlab/model_vehicles/body.h"
#include "mlab/percept/needs.h"
#include "mlab/sim/simulator.h"

namespace mlab::ros2_robot {
namespace {

constexpr double kLasts = 2 * 3600.0;  // a full battery [s]
constexpr double kDegree = std::numbers::pi / 180.0;

binding::BodySpec body_of(const RobotSpec& spec) {
  binding::BodySpec out;
  out.radius = spec.radius;
  out.kinematics = {.drive = binding::Drive::kDifferential,
                    .axle = 0.4,
                    .max_speed = spec.max_speed,
                    .max_acceleration = spec.acceleration,
                    .max_turn_rate = spec.max_turn_rate,
                    .max_turn_acceleration = spec.turn_acceleration};
  out.odometry_noise = spec.drift;
  return out;
}

/// A scanner is a body of no size in a world of its own, put where it looks from.
binding::BodySpec scanner_of(const RobotSpec& spec) {
  binding::BodySpec out;
  out.radius = 0.0;
  const double arc = spec.beams < 360 ? (spec.beams - 1) * kDegree : 0.0;
  out.ring = {.count = spec.beams,
              .arc = arc,
              .first_angle = arc > 0.0 ? -arc / 2.0 : -std::numbers::pi,
              .range = spec.range};
  return out;
}

}  // namespace

struct Robot::Parts {
  model_vehicles::Body body;
  sim::Simulator seen;  // by the scanner
  binding::BodyIndex scanner = binding::kNoBody;
  base::Random random;

  Parts(const overlay::Overlay& world, const RobotSpec& spec)
      : body(world, body_of(spec), spec.place, spec.seed),
        seen(sim::world_of(world), {.seed = spec.seed}),
        random(spec.seed) {
    const auto placed =
        seen.add_body({.spec = scanner_of(spec), .pose = spec.place, .robot = base::RobotId{1}});
    if (placed.has_value()) scanner = placed->body;
  }
};

Robot::Robot(const overlay::Overlay& world, const RobotSpec& spec)
    : spec_(spec), parts_(std::make_unique<Parts>(world, spec)) {}

Robot::~Robot() = default;

void Robot::command(const Speeds& wanted) {
  if (!std::isfinite(wanted.ahead) || !std::isfinite(wanted.turn)) return;
  driven_ = {std::clamp(wanted.ahead, -spec_.max_speed, spec_.max_speed),
             std::clamp(wanted.turn, -spec_.max_turn_rate, spec_.max_turn_rate)};
  heard_at_ = time_;
}

Speeds Robot::commanded() const {
  return is_driven() ? driven_ : navigated_;
}

void Robot::step(double dt) {
  time_ += dt;
  const Speeds wanted = commanded();
  parts_->body.step(wanted.ahead, wanted.turn, dt);
  parts_->seen.step(std::array{percept::Action{}}, dt);  // what roams there moves, too
}

geom::Pose Robot::pose() const {
  return parts_->body.truth().pose;
}

Speeds Robot::speeds() const {
  const auto truth = parts_->body.truth();
  return {truth.speed, truth.turn_rate};
}

geom::Pose Robot::counted() {
  return parts_->body.counted();
}

double Robot::battery() const {
  return std::max(0.0, spec_.battery - time_ / kLasts);
}

Scan Robot::scan() {
  const geom::Pose from = pose();
  const geom::Pose mount{from.point_at({kScannerAhead, 0.0, 0.0}), from.heading};
  Parts& p = *parts_;
  p.seen.put_body(p.scanner, mount, {}, 0.0);
  sim::SenseBuffer buffer;
  percept::Percepts percepts;
  p.seen.sense(p.scanner, percept::Needs{{percept::Sensor::kRanges}}, buffer, percepts);
  Scan out{.first_angle = scanner_of(spec_).ring.first_angle, .step = kDegree, .ranges = {}};
  for (const percept::RangeReading& reading : percepts.ranges) {
    const double told = reading.distance + spec_.range_noise * p.random.normal();
    const bool is_hit = reading.hit && told <= spec_.range;
    const double infinite = std::numeric_limits<double>::infinity();
    const double measured = told < spec_.nearest ? -infinite : told;
    out.ranges.push_back(static_cast<float>(is_hit ? measured : infinite));
  }
  return out;
}

}  // namespace mlab::ros2_robot
