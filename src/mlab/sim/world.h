#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mlab/base/id.h"
#include "mlab/geom/pose.h"
#include "mlab/overlay/overlay.h"
#include "mlab/percept/percepts.h"
#include "mlab/sim/site.h"

namespace mlab::sim {

/// Something round and solid.
struct Disc {
  geom::Point center;   ///< [m]
  double radius = 0.0;  ///< [m], >= 0
};

/// A straight piece of something solid without thickness. Pieces of the same group are one thing where
/// contacts are counted: sliding from one to the next is no new contact.
struct Wall {
  geom::Segment segment;
  std::uint32_t group = 0;
  /// False: a piece of the closed edge of an area that robots sense and keep out of, though nothing stops
  /// them. The group is the area.
  bool is_solid = true;
};

/// Something that robots perceive and perhaps carry. Not solid.
struct Object {
  base::ObjectId id;  ///< unique, from 1
  percept::ObjectClass object_class = percept::ObjectClass::kUnknown;
  percept::ObjectStyle style = percept::ObjectStyle::kFixed;
  geom::Point center;     ///< [m]; of a carried one its carrier's place, of one in a basket the basket's
  double radius = 0.0;    ///< [m]
  base::RobotId carrier;  ///< 0: nobody carries it
  base::ObjectId basket;  ///< the container that it lies in; 0: none. It is out of sight and reach then
};

/// What stands around, before any robot comes. A plain value.
struct World {
  /// Lower left and upper right corner of the mission area; a body that starts inside stays kAreaMargin
  /// inside.
  geom::Point area_low{-kFarthest, -kFarthest};
  geom::Point area_high{kFarthest, kFarthest};
  std::vector<Disc> discs;
  std::vector<Wall> walls;  ///< the solid ones first
  std::vector<Object> objects;
  Building building;

  /// No coordinate is ever farther from 0 than this: within it a micrometre still counts [m].
  static constexpr double kFarthest = 1e8;
};
/// How near to the edge of the mission area a robot's centre may come [m].
inline constexpr double kAreaMargin = 0.5;

/// The discs, walls and objects of an overlay as robots on the ground meet them: OBSTACLE, WALL, the edges of
/// weather zones; MINEFIELD, which stops nobody; OBJECT, ATTRACTOR, BASKET with their class told by colour;
/// ROOM, DOOR, HALLWAY as the building. Objects get the ids 1, 2, ... in file order. Coordinates that are not
/// finite or beyond World::kFarthest are left out.
World world_of(const overlay::Overlay& overlay);

/// Which of the objects of a changed map are those of the map before: for each of `after` the id of an equal
/// one of `before` (kind, place, size), each used once, in order; 0: none is.
std::vector<base::ObjectId> same_objects(std::span<const Object> before, std::span<const Object> after);

/// Takes out what has coordinates or radii that are not finite, negative or beyond World::kFarthest.
void keep_usable(World& world);

}  // namespace mlab::sim
