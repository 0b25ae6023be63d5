#pragma once

#include <cmath>
#include <numbers>

namespace mlab::ways {

/// A full one [rad].
inline constexpr double kTurn = 2.0 * std::numbers::pi;

/// The same direction, from 0 to less than a turn [rad].
inline double in_turn(double angle) {
  const double out = std::fmod(angle, kTurn);
  return out < 0.0 ? out + kTurn : out;
}

}  // namespace mlab::ways
