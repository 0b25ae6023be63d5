#pragma once

#include <vector>

#include "mlab/geom/pose.h"

namespace mlab::ways {

/// Something round that stands in the way.
struct Round {
  geom::Point center;   ///< [m, world]
  double radius = 0.0;  ///< [m]; 0: a point
};

/// A rectangle with its sides along the axes, beyond which there is no ground [m, world].
struct Bounds {
  double x0 = -1e9, y0 = -1e9, x1 = 1e9, y1 = 1e9;

  friend bool operator==(const Bounds&, const Bounds&) = default;
  bool contains(geom::Point p) const { return p.x >= x0 && p.x <= x1 && p.y >= y0 && p.y <= y1; }
};

/// What stands on the ground: discs, and walls without thickness.
struct Ground {
  std::vector<Round> discs;
  std::vector<geom::Segment> walls;
  Bounds bounds;
};

}  // namespace mlab::ways
