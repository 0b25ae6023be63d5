#pragma once

#include <optional>

#include "mlab/geom/pose.h"
#include "mlab/ways/clearing.h"
#include "mlab/ways/ground.h"

namespace mlab::ways {

/// Whether a body gets straight from one place to another: it comes within its radius of nothing, or, of what
/// it is nearer to already, no nearer. Bounds are none.
/// @param radius  of the body [m]
bool leads_straight(const Ground& ground, geom::Segment s, double radius);

/// The nearest free place to a body that stands nearer to something than the clearance, to which it gets
/// straight: the nearest free one of all may lie behind what it is near to.
/// @param ground    what the clearing is of
/// @param radius    of the body [m], at most the clearance
/// @return  nothing for a free place, for one that no body can stand at, and where none is found
std::optional<geom::Point> way_out(const Ground& ground, const Clearing& clearing, geom::Point place,
                                   double radius);

}  // namespace mlab::ways
