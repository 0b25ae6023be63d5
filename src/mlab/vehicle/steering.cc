#include "mlab/vehicle/steering.h"

#include <algorithm>
#include <cmath>

#include "mlab/binding/kinematics.h"

namespace mlab::vehicle {
namespace {

/// What a vehicle says and what it is told are some tenths of a second on their way. One that turned by all
/// that it is off within a cycle, as bodies in simulation do, would swing to and fro [s].
constexpr double kTurnsIn = 0.8;

}  // namespace

Command cut_to(const Limits& limits, const Command& command) {
  if (!std::isfinite(command.speed) || !std::isfinite(command.turn_rate)) return {};
  const binding::Kinematics& k = limits.kinematics;
  Command out = command;
  if (k.max_speed > 0.0) out.speed = std::min(out.speed, k.max_speed);
  out.speed = std::max(out.speed, std::min(limits.min_speed, 0.0));
  if (k.max_turn_rate > 0.0) out.turn_rate = std::clamp(out.turn_rate, -k.max_turn_rate, k.max_turn_rate);
  return out;
}

Command command_for(const Limits& limits, const percept::Action& action, const Command& before, double dt) {
  const Command now = cut_to(limits, before);
  binding::Momentum momentum;
  momentum.speed = now.speed;
  momentum.turn_rate = now.turn_rate;
  const auto wanted = binding::drive(limits.kinematics, action, 0.0, geom::Offset{1.0, 0.0}, momentum, dt);
  Command out{wanted.momentum.speed, wanted.momentum.turn_rate};
  if (!action.spins) {
    const double most = std::abs(std::atan2(action.velocity.y, action.velocity.x)) / kTurnsIn;
    out.turn_rate = std::clamp(out.turn_rate, -most, most);
  }
  return cut_to(limits, out);
}

}  // namespace mlab::vehicle
