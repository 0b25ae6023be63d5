#pragma once

#include <span>

#include "mlab/geom/pose.h"

namespace mlab::schema {

/// Something that a body must not drive into in the cycle that comes, as seen from it.
struct Bar {
  geom::Segment line;  ///< it stands there; both ends are one for what is round [m]
  double reach = 0.0;  ///< that the body's centre must not come nearer than [m]
  double approach =
      -1.0;  ///< less than 0: it stands. Else it moves, and one comes so much nearer at most [m]
};

/// A movement with which the body drives into none of them while it lasts: along what it would meet, and no
/// farther towards what moves than that allows. The movement itself where it meets nothing.
///
/// Two robots that allow each other half of what is between them never touch, whatever else they do: what
/// they approach by is at most all of it.
/// @param motion  of one cycle [m]
geom::Offset clear_motion(geom::Offset motion, std::span<const Bar> bars);

}  // namespace mlab::schema
