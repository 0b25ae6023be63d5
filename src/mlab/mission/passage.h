#pragma once

#include "mlab/geom/pose.h"
#include "mlab/overlay/overlay.h"

namespace mlab::mission {

/// Whether a robot that stands there may be in the way of others, as in a door: what the map says to stand or
/// to be walled is near to it on more than one side.
bool is_in_passage(const overlay::Overlay& map, geom::Point place);

}  // namespace mlab::mission
