#pragma once

#include <cmath>
#include <numbers>

namespace mlab::base {

/// Degrees exist only at the edges (languages, screens); inside everything is radians.
constexpr double radians(double angle_deg) {
  return angle_deg * (std::numbers::pi / 180.0);
}
constexpr double degrees(double angle) {
  return angle * (180.0 / std::numbers::pi);
}

/// The same direction in (-pi, pi] [rad].
inline double wrap_angle(double angle) {
  if (angle > -std::numbers::pi && angle <= std::numbers::pi) return angle;  // std::remainder takes its time
  const double wrapped = std::remainder(angle, 2.0 * std::numbers::pi);
  return wrapped <= -std::numbers::pi ? wrapped + 2.0 * std::numbers::pi : wrapped;
}

}  // namespace mlab::base
