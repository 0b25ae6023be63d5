#pragma once

#include <cstddef>
#include <vector>

#include "mlab/geom/pose.h"
#include "mlab/overlay/overlay.h"
#include "mlab/percept/formation.h"

namespace mlab::mission {

/// The way of a unit, or of a part beside it: a route, or a goal alone [m, world].
using Track = std::vector<geom::Point>;

/// The same way, moved sideways; corners stay as far from each other.
///
/// @param arrival  direction in which a track of one point is reached, length 1 or 0
/// @param left     how far to the left of the way [m]
Track beside(const Track& track, geom::Offset arrival, double left);

/// True where a part can keep to `lane`: each of its points is inside the area, clear of obstacles, and no
/// wall lies between it and the same point of `track`.
bool is_clear(const overlay::Overlay& map, const Track& track, const Track& lane, double clearance);

/// Half the length that a formation takes up along its heading, or across it [m]. Estimated for large units.
double half_extent(percept::Formation formation, std::size_t count, double spacing, bool along);

}  // namespace mlab::mission
