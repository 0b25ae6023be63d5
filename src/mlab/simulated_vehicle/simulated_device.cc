#include "mlab/simulated_vehicle/simulated_device.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/core.h>

#include "mlab/vehicle/steering.h"

namespace mlab::vehicle {
namespace {

constexpr double kStep = 0.02;     // of its simulation [s]
constexpr double kWatchdog = 0.5;  // it brakes so long after the last command [s]
constexpr int kMostSteps = 50;     // at once: who was stopped for longer does not catch up

}  // namespace

binding::BodySpec SimulatedDevice::standard() {
  binding::BodySpec out;
  out.radius = 0.3;
  out.kinematics.drive = binding::Drive::kDifferential;
  out.kinematics.axle = 0.5;
  out.kinematics.max_speed = 1.0;
  out.kinematics.max_acceleration = 2.0;
  out.kinematics.max_turn_rate = 2.0;
  out.ring.count = 60;
  out.ring.range = 10.0;
  return out;
}

SimulatedDevice::SimulatedDevice(sim::World world, const Settings& settings)
    : name_(settings.name),
      world_(std::move(world), {.seed = settings.seed, .threads = 1, .breakdowns = {}}) {
  limits_.kinematics = settings.spec.kinematics;
  limits_.radius = settings.spec.radius;
  limits_.min_speed = -settings.spec.kinematics.max_speed;
  const double braking = limits_.kinematics.max_acceleration > 0.0
                             ? limits_.kinematics.max_speed / limits_.kinematics.max_acceleration
                             : 0.0;
  limits_.standstill = kWatchdog + braking + 2.0 * kStep;
  const auto placed = world_.embody({settings.spec, settings.start, {1}, 0, {}});
  body_ = placed ? placed->body : binding::kNoBody;
  if (!placed) report_.why = "has no free place to stand in its world";
}

void SimulatedDevice::work(Clock::time_point now) {
  if (body_ == binding::kNoBody) return;
  if (at_ == Clock::time_point{}) at_ = now;
  const bool is_told = seconds_between(told_, now) <= kWatchdog;
  percept::Action action;
  action.drives = action.spins = true;
  action.velocity = {is_told ? command_.speed : 0.0, 0.0, 0.0};
  action.spin = is_told ? command_.turn_rate : 0.0;
  const auto step = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(kStep));
  for (int i = 0; i < kMostSteps && at_ + step <= now; ++i, at_ += step)
    world_.carry_out({&action, 1}, kStep);
  if (at_ + step <= now) at_ = now;
  if (!report_.motion || report_.motion->at != at_) look();
}

// How it is at the moment to which it has been simulated.
void SimulatedDevice::look() {
  geom::Pose pose;
  world_.poses({&body_, 1}, {&pose, 1});
  const binding::BodyState state = world_.view().body(body_);
  report_.readiness = Readiness::kReady;
  report_.is_global = true;
  report_.motion = Motion{pose, state.speed, state.turn_rate, at_};
  const percept::Percepts seen = world_.view().sense(body_, {{percept::Sensor::kRanges}});
  report_.scans.resize(seen.ranges.empty() ? 0 : 1);
  if (seen.ranges.empty()) return;
  Scan& out = report_.scans.front();
  out.first_angle = seen.ranges.front().angle;
  out.step = seen.ranges.size() > 1 ? seen.ranges[1].angle - seen.ranges[0].angle : 0.0;
  out.farthest = limits_.radius + seen.range_limit;
  out.at = at_;
  out.distances.clear();
  for (const percept::RangeReading& one : seen.ranges)
    out.distances.push_back(one.hit ? static_cast<float>(limits_.radius) + one.distance
                                    : std::numeric_limits<float>::infinity());
}

std::vector<Check> SimulatedDevice::checks(Clock::time_point /*now*/) {
  return {{"watchdog", CheckResult::kPass, fmt::format("brakes {} s after its last command", kWatchdog),
           fmt::format("stands within {:.1f} s", limits_.standstill)}};
}

void SimulatedDevice::drive(const Command& command, Clock::time_point now) {
  command_ = cut_to(limits_, command);
  told_ = now;
}

void SimulatedDevice::stop(Clock::time_point now) {
  drive({}, now);
}

}  // namespace mlab::vehicle
