#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mlab/geom/pose.h"
#include "mlab/percept/percepts.h"
#include "mlab/ways/planned_way.h"

/// Ways that lead along the route of a command.

namespace mlab::schema {

/// A corner of a route that no way leads to.
struct LeftOut {
  std::size_t corner = 0;  ///< of those that the way was planned for
  geom::Point place;       ///< [m, world]
  geom::Point last;        ///< where the way to it ends [m, world]
};
struct RouteWay {
  ways::PlannedWay
      way;  ///< its `end` says what is at the route's end; `kFull`: it is longer than it can tell
  std::vector<LeftOut> left_out;
  double behind = 0.0;  ///< so much of it is behind who is on it [m]
};
/// A way that leads from where one is to a route and along it to its end, round what stands on it: beside
/// corners of the route that something stands at, or is nearer to than the way keeps, but for the last one.
/// Those that no way leads to are left out; those in line, within 0.2 m, are passed without being told.
/// @param corners  those of the route that are still to come [m, world]; at least one
RouteWay plan_route(const percept::KnownGround& ground, geom::Point from,
                    std::span<const geom::Point> corners, double radius, double margin);

/// The same for who is on a way along the route already: it begins so far behind him that the last of a
/// formation go on along it, too, as far as nothing stands there by now and there is room for corners; its
/// `cut_off` says where.
/// @param before   which he is on
/// @param at       how far along it [m]
/// @param corners  those of the route that are still to come then [m, world]; at least one
/// @return nothing where it does not lead on from there
std::optional<RouteWay> go_on_along_route(const percept::KnownGround& ground, const ways::PlannedWay& before,
                                          double at, std::span<const geom::Point> corners, double radius,
                                          double margin);

/// Of corners that are left out those from the one of that number on.
std::span<const LeftOut> not_told(std::span<const LeftOut> left_out, std::size_t from);

/// How many corners of a route one has passed who is so far along a way that leads along it [m]; never the
/// last one.
/// @param corners  those that were still to come when it was planned [m, world]
std::size_t corners_passed(const ways::PlannedWay& way, double at, std::span<const geom::Point> corners);

/// Where corners of a route are left out.
/// @param left_out  at least one
std::string left_out_text(const percept::KnownGround& ground, std::span<const LeftOut> left_out);

}  // namespace mlab::schema
