#pragma once

#include <cstddef>
#include <span>

#include "mlab/geom/pose.h"

namespace mlab::geom {

/// Whether a ray to the east crosses the line, counted so that a closed edge is crossed an odd number of
/// times from inside.
inline bool is_crossed(const Segment& line, Point from) {
  const auto& [a, b] = line;
  if ((a.y > from.y) == (b.y > from.y)) return false;
  return from.x < a.x + (b.x - a.x) * (from.y - a.y) / (b.y - a.y);
}

/// Whether a point lies within an area, by how often a ray to the east crosses its edge.
/// @param outline  the corners, one after the other, in either direction; none: nothing lies within
inline bool is_within(std::span<const Point> outline, Point point) {
  bool is_inside = false;
  for (std::size_t i = 0, before = outline.size() - 1; i < outline.size(); before = i++)
    is_inside ^= is_crossed({outline[before], outline[i]}, point);
  return is_inside;
}

}  // namespace mlab::geom
