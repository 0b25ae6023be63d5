#pragma once

#include <algorithm>

#include "mlab/geom/vector.h"
#include "mlab/schema/constants.h"

namespace mlab::schema {

/// How fast a robot may go [m/s].
struct SpeedLimits {
  double base = 0.0;      ///< speed for a vector of length 1
  double max = 0.0;       ///< never faster than this
  double cautious = 0.0;  ///< the most while an absolute demand stands, in cautious mode
  bool is_cautious = false;
};

/// The velocity for a schema vector [m/s]. Too fast is made slower in the same direction. In cautious mode
/// the lower limit holds only while some schema makes an absolute demand (its safety margin is broken), not
/// for every vector that is too long. No number for a vector that is none, so that whoever runs the robot
/// sees the fault instead of a robot that stands.
constexpr bool is_absolute(double strength) {
  return strength >= kAbsolute;
}
inline geom::Vector velocity(geom::Vector v, SpeedLimits limits) {
  const double strength = geom::length(v);
  const double limit =
      limits.is_cautious && is_absolute(strength) ? std::min(limits.cautious, limits.max) : limits.max;
  const geom::Vector wanted{v.x * limits.base, v.y * limits.base, 0.0};
  const double speed = strength * limits.base;
  return speed > limit ? geom::unit(v) * limit : wanted;
}

}  // namespace mlab::schema
