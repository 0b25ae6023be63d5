#pragma once

#include <optional>
#include <span>

#include "mlab/geom/pose.h"

/// For sources of this module only.
namespace mlab::ways {

/// A place as lanes count it: along them, and across [m].
struct LanePlace {
  double along = 0.0;
  double across = 0.0;
};

/// Parallel lanes over an area, evenly spaced, and the rectangle that they fill.
struct Lanes {
  geom::Point origin;      ///< where the rectangle begins [m, world]
  geom::Offset direction;  ///< of the lanes; of length 1
  double length = 0.0;     ///< of the rectangle [m]
  double spacing = 0.0;    ///< from lane to lane [m]
  int count = 0;

  geom::Point to_world(LanePlace p) const {
    return origin + direction * p.along + geom::Offset{-direction.y, direction.x} * p.across;
  }
  LanePlace to_lanes(geom::Point p) const {
    return {dot(direction, p - origin), cross(direction, p - origin)};
  }
};

/// Those in the direction in which they are shortest, all in all; nothing where that can't be computed, or
/// where there would be too many.
///
/// @param outline  all numbers finite; not empty
/// @param swath    most from lane to lane [m], > 0
std::optional<Lanes> shortest_lanes(std::span<const geom::Point> outline, double swath, int most);

}  // namespace mlab::ways
