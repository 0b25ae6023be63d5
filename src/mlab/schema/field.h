#pragma once

#include "mlab/geom/vector.h"
#include "mlab/schema/constants.h"

namespace mlab::schema {

/// Strength of a repulsion: kInfinity up to `inner`, then falling in a straight line from 1 to 0 at `outer`,
/// 0 beyond. With outer <= inner there is no slope. 0 for a distance that is not a number.
/// @source  Arkin 1989, section IV
constexpr double repulsion_strength(double distance, double inner, double outer) {
  if (distance <= inner) return kInfinity;
  return distance < outer ? (outer - distance) / (outer - inner) : 0.0;
}

/// The push away from something at `center` whose distance is `distance` (to its centre or to its edge, as
/// the schema wants). Something exactly at the robot pushes along -x: back where the robot came from.
inline geom::Vector repulsion(geom::Vector center, double distance, double inner, double outer) {
  const double strength = repulsion_strength(distance, inner, outer);
  if (strength <= 0.0) return {};
  const double length = geom::length(center);
  if (!(length > geom::kZeroLength)) return {-strength, 0.0, 0.0};
  return {-center.x / length * strength, -center.y / length * strength, 0.0};
}

/// 0 up to `low`, 1 from `high` on, straight between; a step just beyond `low` where high <= low. No number
/// for what is none.
constexpr double ramp(double value, double low, double high) {
  if (value <= low) return 0.0;
  return value >= high ? 1.0 : (value - low) / (high - low);
}

}  // namespace mlab::schema
