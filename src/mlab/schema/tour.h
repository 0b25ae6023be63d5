#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mlab/geom/pose.h"
#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"
#include "mlab/schema/errands.h"

/// Going round the places of a PATROL: each robot of the unit does, and tells the others where it is.

namespace mlab::schema {

/// Where a robot is on its way round the places of a PATROL. It tells that with its place: in the number of
/// the object that a SharedPlace is about. Of a VISIT only that it is shut in is told.
struct TourPlace {
  std::size_t leg = 0;  ///< it heads for that place of the route
  bool has_gone_round = false;
  bool comes_to_none = false;  ///< it has come to none of the places, and can't
  bool is_shut_in = false;     ///< no way leads out of where it is
};
base::ObjectId tour_code(const percept::Order& order, TourPlace place);
/// Nothing: it speaks of something else.
std::optional<TourPlace> tour_place(const percept::Order& order, const percept::SharedPlace& shared);
/// The leg of the tour that is nearest to a place.
std::size_t nearest_leg(std::span<const geom::Point> tour, geom::Point p);

/// How far a robot is on its way round. A value of a frame.
struct TourState {
  TourPlace at;
  std::uint32_t passed = 0;   ///< places so far: come to, or in vain
  std::uint32_t in_vain = 0;  ///< in a row
};
/// Where a robot is to go next that shares a PATROL. Tells the others where it is.
geom::Point next_tour_place(const percept::Percepts& percepts, LegWatch::Verdict verdict, TourState& state,
                            LegWatch& watch, percept::Action& action);

/// How fast a robot goes round so that all that do spread evenly: 1, or less where it is nearer to the next
/// one than its share of the round. Who has told nothing for `patience` [s] does not count.
double patrol_pace(const percept::Percepts& percepts, double patience, double slowest);

/// What a robot of a PATROL has before it: the round from where it is as far as the next robot, which an even
/// share of the round is.
struct Stretch {
  base::RobotId robot;
  std::vector<geom::Point> way;  ///< [m, world]; at least two points
};
/// The stretches of all who have told where they are, but those who have told nothing for `patience` [s] or
/// come to none of the places: together they are the round. In the order of the robots on it. From place to
/// place they are as robots plan them on the ground that is known; straight where none is, or no way leads.
/// @param radius  of their bodies [m]
/// @param margin  that they keep [m]
std::vector<Stretch> stretches(const percept::Percepts& percepts, double patience, double radius,
                               double margin);

}  // namespace mlab::schema
