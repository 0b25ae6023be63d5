#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "mlab/base/id.h"
#include "mlab/binding/body.h"
#include "mlab/binding/vehicle_state.h"
#include "mlab/geom/pose.h"
#include "mlab/percept/area_margin.h"
#include "mlab/percept/needs.h"
#include "mlab/percept/percepts.h"

namespace mlab::binding {

/// Something round and solid.
struct Disc {
  geom::Point center;   ///< [m]
  double radius = 0.0;  ///< [m], >= 0
};

/// A disc that moves along a way of its own and stops for nobody, where it is now.
struct MovingDisc {
  geom::Point center;     ///< [m]
  double radius = 0.0;    ///< [m], >= 0
  geom::Offset velocity;  ///< [m/s]
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

using percept::kAreaMargin;

/// How a body fares, as far as it is known.
struct BodyState {
  geom::Offset velocity;  ///< as driven in the last cycle [m/s, world]
  double speed = 0.0;  ///< along its heading, of bodies that drive so; in a turn more than the velocity [m/s]
  double turn_rate = 0.0;             ///< likewise [rad/s]
  double distance_driven = 0.0;       ///< since it was there [m]
  std::uint32_t contacts = 0;         ///< how often it met something solid or another body
  bool in_contact = false;            ///< it met something within the last kSameContact
  base::ObjectId carried;             ///< 0: nothing
  std::uint32_t run_over = 0;         ///< how often something that moves met it which it did not drive into
  std::optional<Upkeep> upkeep = {};  ///< of a vehicle; nothing: the body is made up
};

/// The world as who looks on sees it: consoles, reports, plots. It only reads, between two cycles, on one
/// thread; robots know only their percepts.
class WorldView {
 public:
  WorldView() = default;
  WorldView(const WorldView&) = delete;
  WorldView& operator=(const WorldView&) = delete;
  virtual ~WorldView() = default;

  virtual std::span<const Disc> discs() const = 0;  ///< those that stand
  /// None where it is not known where they are.
  virtual std::span<const MovingDisc> moving_discs() const { return {}; }
  virtual std::span<const Wall> walls() const = 0;
  virtual std::span<const Object> objects() const = 0;  ///< in the order of the map
  virtual BodyState body(BodyIndex body) const = 0;

  /// What the body senses now. Its lists are valid until something is sensed again.
  virtual percept::Percepts sense(BodyIndex body, const percept::Needs& needs) const = 0;
  /// What it would sense if it stood elsewhere, as far as that is known; lists as of `sense`.
  virtual percept::Percepts sense_at(BodyIndex body, const geom::Pose& pose,
                                     const percept::Needs& needs) const = 0;
};

}  // namespace mlab::binding
