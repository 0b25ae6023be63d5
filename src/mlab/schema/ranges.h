#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "mlab/base/angle.h"
#include "mlab/geom/vector.h"
#include "mlab/percept/percepts.h"

namespace mlab::schema {

/// How near what a beam hit is: 0 at the ring's range and for a beam that hit nothing, 1 at the body's
/// surface.
inline double proximity(const percept::RangeReading& beam, double range) {
  if (!beam.hit || !(range > 0.0)) return 0.0;
  return std::clamp(1.0 - static_cast<double>(beam.distance) / range, 0.0, 1.0);
}

/// Mean over all beams of their proximity along their axes: where and how much the surroundings press.
inline geom::Vector crowding(std::span<const percept::RangeReading> ring, double range) {
  geom::Vector sum;
  for (const auto& beam : ring) {
    const double near = proximity(beam, range);
    if (near > 0.0) sum += geom::polar(near, static_cast<double>(beam.angle));
  }
  return ring.empty() ? sum : sum * (1.0 / static_cast<double>(ring.size()));
}

/// The largest proximity among the beams within `half_angle` of straight ahead [rad].
inline double proximity_ahead(std::span<const percept::RangeReading> ring, double range, double half_angle) {
  double nearest = 0.0;
  for (const auto& beam : ring) {
    if (std::abs(base::wrap_angle(static_cast<double>(beam.angle))) <= half_angle) {
      nearest = std::max(nearest, proximity(beam, range));
    }
  }
  return nearest;
}

}  // namespace mlab::schema
