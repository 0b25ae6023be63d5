#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "mlab/base/id.h"
#include "mlab/binding/world_view.h"
#include "mlab/geom/pose.h"
#include "mlab/overlay/course.h"
#include "mlab/overlay/overlay.h"
#include "mlab/percept/percepts.h"
#include "mlab/sim/site.h"

namespace mlab::sim {

using binding::Disc;
using binding::kAreaMargin;
using binding::MovingDisc;
using binding::Object;
using binding::Wall;

/// Something round that moves along its course whatever is in its way.
struct Roamer {
  overlay::Course course;
  double radius = 0.0;  ///< [m], >= 0

  MovingDisc at(double time) const;
  friend bool operator==(const Roamer&, const Roamer&) = default;
};

/// An object that goes along a course, until somebody takes it up.
struct Travel {
  base::ObjectId object;
  std::shared_ptr<const overlay::Course> course;

  friend bool operator==(const Travel& a, const Travel& b) {
    return a.object == b.object && *a.course == *b.course;
  }
};

/// The corners of an area, one after the other [m].
using Outline = std::vector<geom::Point>;

/// What is around, before any robot comes. A plain value.
struct World {
  /// Lower left and upper right corner of the mission area; a body that starts inside stays kAreaMargin
  /// inside.
  geom::Point area_low{-kFarthest, -kFarthest};
  geom::Point area_high{kFarthest, kFarthest};
  std::vector<Disc> discs;
  std::vector<Roamer> roamers;
  std::vector<Wall> walls;  ///< the solid ones first
  std::vector<Object> objects;
  std::vector<Travel> travels;  ///< of objects, each of another one
  Building building;
  std::vector<Outline> silences;  ///< zones from where nothing is heard, and where nobody hears

  /// No coordinate is ever farther from 0 than this: within it a micrometre still counts [m].
  static constexpr double kFarthest = 1e8;
};

/// The discs, roamers, walls and objects of an overlay as robots on the ground meet them: OBSTACLE, WALL, the
/// edges of weather zones; MINEFIELD, which stops nobody; OBJECT, ATTRACTOR, BASKET with their class told by
/// colour; ROOM, DOOR, HALLWAY as the building; zones without communication. Objects get the ids 1, 2, ... in
/// file order. Coordinates that are not finite or beyond World::kFarthest are left out.
World world_of(const overlay::Overlay& overlay);

/// Which of the objects of a changed map are those of the map before: for each of `after` the id of an equal
/// one of `before` (kind, place, size), each used once, in order; 0: none is.
std::vector<base::ObjectId> same_objects(std::span<const Object> before, std::span<const Object> after);

/// Takes out what has coordinates or radii that are not finite, negative or beyond World::kFarthest.
void keep_usable(World& world);

}  // namespace mlab::sim
