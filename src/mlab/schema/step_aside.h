#pragma once

#include <optional>
#include <span>

#include "mlab/geom/pose.h"
#include "mlab/percept/percepts.h"
#include "mlab/ways/planned_way.h"

namespace mlab::schema {

/// A piece of the ground that somebody wants to go along, or stands on.
struct Lane {
  geom::Segment piece;  ///< [m, world]
  double reach = 0.0;   ///< so near to it a body's centre is in the way [m]

  bool holds(geom::Point p) const { return distance(nearest_point(piece, p), p) < reach; }
};

/// What somebody who steps aside keeps clear of.
struct KeepClear {
  std::span<const Lane> lanes;   ///< where he does not stay
  std::span<const Lane> bodies;  ///< that nothing gets past: his way does not lead there
  std::span<const Lane> others;  ///< that may make way themselves: where he does not stay, if he can help it
};

/// The way to the nearest place where a body is in nobody's way, if there is one within some metres.
/// @param radius  of the body [m]
/// @return  a way of its own, however narrow; nothing: the body is cornered
std::optional<ways::PlannedWay> way_aside(const percept::KnownGround& ground, geom::Point here, double radius,
                                          const KeepClear& clear);

}  // namespace mlab::schema
