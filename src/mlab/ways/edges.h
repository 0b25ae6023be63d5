#pragma once

#include <vector>

#include "mlab/ways/ground.h"

/// For sources of this module only.
namespace mlab::ways {

/// Where free ground may begin: circles, and straight sides.
struct Edges {
  std::vector<Round> circles;
  std::vector<geom::Segment> sides;

  /// Those of the band along a wall.
  void add_sides(const geom::Segment& wall, double width);
  /// Those of the bounds, as far as they are so near to a place.
  void add_bounds(const Bounds& bounds, geom::Point p, double reach);
  /// Where each of them is nearest to a place, and where two of them cross.
  std::vector<geom::Point> points(geom::Point p) const;
};

}  // namespace mlab::ways
