#pragma once

#include <array>
#include <span>

#include "mlab/geom/pose.h"

namespace mlab::schema {

/// Arithmetic of polylines. Places on a route are told by the length of way from its first point [m].

/// 0 for a route of less than two points.
double route_length(std::span<const geom::Point> route);
/// Held at the ends; the world's origin for a route without points.
geom::Point route_point(std::span<const geom::Point> route, double way);
/// As route_point at three places, none of which is before another one in front of it.
std::array<geom::Point, 3> route_points(std::span<const geom::Point> route, std::array<double, 3> ways);
/// Which place between `from` and `to` is nearest to p; the first of several.
double nearest_way(std::span<const geom::Point> route, geom::Point p, double from, double to);

}  // namespace mlab::schema
