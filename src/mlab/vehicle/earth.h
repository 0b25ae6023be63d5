#pragma once

#include "mlab/geography/projection.h"

namespace mlab::vehicle {

/// Where true north is at a place of the map: counter-clockwise from its x axis [rad]. A quarter of a turn
/// along the map's middle meridian; the farther from there, the more it differs by the convergence of the
/// grid.
double north_at(const geography::Projection& map, geography::GeoPoint place);

}  // namespace mlab::vehicle
