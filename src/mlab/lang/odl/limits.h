#pragma once

namespace mlab::odl {

/// A coordinate or size past this is a mistake, not a map: UTM northings end at ten million [m].
inline constexpr double kMaxCoordinate = 1e8;
/// Nothing on a route is faster [m/s].
inline constexpr double kMaxRouteSpeed = 100.0;
/// More cells than this a height map does not have in either direction.
inline constexpr double kMaxHeightMapCells = 100000;

}  // namespace mlab::odl
