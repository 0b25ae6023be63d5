#pragma once

#include <span>

#include "mlab/geom/pose.h"

namespace mlab::percept {

/// A door of a building: the line between its posts.
struct Door {
  geom::Point a;           ///< [m, world]
  geom::Point b;           ///< [m, world]
  bool is_marked = false;  ///< by some robot, so that others leave it out
};

/// A room of a building: its outline, closed from the last point to the first.
struct Room {
  std::span<const geom::Point> outline;  ///< [m, world]
};

/// A hallway of a building: a straight band.
struct Hallway {
  geom::Point start;   ///< of its centreline [m, world]
  geom::Point end;     ///< [m, world]
  double width = 0.0;  ///< from wall to wall [m]
};

/// The building that a robot moves in, as its map says. Not solid: walls are sensed.
struct SiteMap {
  std::span<const Door> doors;
  std::span<const Room> rooms;
  std::span<const Hallway> hallways;
};

}  // namespace mlab::percept
