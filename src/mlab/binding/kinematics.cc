#include "mlab/binding/kinematics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mlab/base/angle.h"

namespace mlab::binding {
namespace {

using geom::Offset;

/// Faster than this is as fast as this [m/s, rad/s].
constexpr double kFastest = 1e9;

double finite_or_zero(double value) {
  return std::isfinite(value) ? std::clamp(value, -kFastest, kFastest) : 0.0;
}

/// `value` within +-limit, where there is a limit.
double limited(double value, double limit) {
  return limit > 0.0 ? std::clamp(value, -limit, limit) : value;
}

/// From `now` towards `wanted`, by at most `limit` * dt where there is a limit.
double approached(double now, double wanted, double limit, double dt) {
  return limit > 0.0 ? now + std::clamp(wanted - now, -limit * dt, limit * dt) : wanted;
}

double turned(double heading, double angle) {
  const double sum = heading + angle;
  return sum > -std::numbers::pi && sum <= std::numbers::pi ? sum : base::wrap_angle(sum);
}

/// What was asked for, without what is not a number.
struct Wish {
  double x, y;  ///< [m/s, robot frame]
  double spin;  ///< [rad/s]
  bool spins;
};

Wish wish_of(const percept::Action& action) {
  if (!action.drives) return {0.0, 0.0, 0.0, false};
  return {finite_or_zero(action.velocity.x), finite_or_zero(action.velocity.y),
          action.spins ? finite_or_zero(action.spin) : 0.0, action.spins};
}

WantedMotion drive_holonomic(const Kinematics& k, const Wish& wish, double heading, Offset ahead,
                             const Momentum& now, double dt) {
  Offset velocity{ahead.x * wish.x - ahead.y * wish.y, ahead.y * wish.x + ahead.x * wish.y};
  const double wished = length(velocity);
  if (k.max_speed > 0.0 && wished > k.max_speed) velocity = velocity * (k.max_speed / wished);
  if (k.max_acceleration > 0.0) {
    const Offset change = velocity - now.velocity;
    const double size = length(change);
    if (size > k.max_acceleration * dt) velocity = now.velocity + change * (k.max_acceleration * dt / size);
  }
  double turn = 0.0;
  if (wish.spins) {
    turn = wish.spin * dt;
  } else if (length(velocity) >= geom::kZeroLength) {
    turn = std::atan2(cross(ahead, velocity), dot(ahead, velocity));
  }
  const double rate =
      approached(now.turn_rate, limited(turn / dt, k.max_turn_rate), k.max_turn_acceleration, dt);
  return {velocity * dt, turned(heading, rate * dt), {velocity, 0.0, rate}};
}

/// Forward speed and turn rate that take the body towards a wanted velocity.
struct Steering {
  double speed;
  double turn_rate;
};

Steering steering_of(const Kinematics& k, const Wish& wish, double dt) {
  if (wish.spins) return {wish.x, wish.spin};
  const double size = std::sqrt(wish.x * wish.x + wish.y * wish.y);
  if (size < geom::kZeroLength) return {0.0, 0.0};
  const double turn_rate = std::atan2(wish.y, wish.x) / dt;
  return {k.drive == Drive::kCar ? size : std::max(0.0, wish.x), turn_rate};
}

WantedMotion drive_steered(const Kinematics& k, const Wish& wish, double heading, Offset ahead,
                           const Momentum& now, double dt) {
  const Steering steering = steering_of(k, wish, dt);
  double speed = approached(now.speed, limited(steering.speed, k.max_speed), k.max_acceleration, dt);
  double rate =
      approached(now.turn_rate, limited(steering.turn_rate, k.max_turn_rate), k.max_turn_acceleration, dt);
  if (k.drive == Drive::kCar) {
    const double most = std::abs(speed) * std::tan(k.max_steer) / k.wheelbase;
    rate = std::clamp(rate, -most, most);
  } else if (k.drive == Drive::kSynchro) {
    speed = limited(speed, k.max_wheel_speed);  // steering has a motor of its own
  } else if (k.max_wheel_speed > 0.0) {
    const double faster_wheel = std::abs(speed) + std::abs(rate) * k.axle / 2;
    if (faster_wheel > k.max_wheel_speed) {
      speed *= k.max_wheel_speed / faster_wheel;
      rate *= k.max_wheel_speed / faster_wheel;
    }
  }
  const double turn = rate * dt;
  if (turn == 0.0) return {ahead * (speed * dt), heading, {ahead * speed, speed, rate}};
  // The chord of the arc: shorter by sin(h)/h and turned by h, half of the turn.
  const double half = turn / 2;
  const double c = std::cos(half);
  const double s = std::sin(half);
  const Offset velocity = Offset{ahead.x * c - ahead.y * s, ahead.y * c + ahead.x * s} * (speed * s / half);
  return {velocity * dt, turned(heading, turn), {velocity, speed, rate}};
}

}  // namespace

WantedMotion drive(const Kinematics& kinematics, const percept::Action& action, double heading, Offset ahead,
                   const Momentum& momentum, double dt) {
  const Wish wish = wish_of(action);
  return kinematics.drive == Drive::kHolonomic
             ? drive_holonomic(kinematics, wish, heading, ahead, momentum, dt)
             : drive_steered(kinematics, wish, heading, ahead, momentum, dt);
}

}  // namespace mlab::binding
