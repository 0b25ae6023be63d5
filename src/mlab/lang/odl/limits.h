#pragma once

#include "mlab/overlay/limits.h"

namespace mlab::odl {

using overlay::kMaxCoordinate;
/// Nothing on a route is faster [m/s].
inline constexpr double kMaxRouteSpeed = 100.0;
/// More cells than this a height map does not have in either direction.
inline constexpr double kMaxHeightMapCells = 100000;

}  // namespace mlab::odl
