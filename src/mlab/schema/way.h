#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>

#include "mlab/geom/pose.h"
#include "mlab/percept/percepts.h"
#include "mlab/schema/route.h"
#include "mlab/ways/planned_way.h"

namespace mlab::schema {

/// Whether a place is one.
inline bool is_finite(geom::Point p) {
  return std::isfinite(p.x + p.y);
}

/// Whether what eyes see is an area that robots keep out of in which the robot stands: it is seen as a disc
/// opposite to the nearest way out, whose edge goes through the robot's middle.
inline bool is_around(const percept::Obstacle& seen) {
  constexpr double kRounding = 1e-6;  // [m]
  return seen.radius > 0.0 && !seen.is_moving() && std::abs(length(seen.center) - seen.radius) <= kRounding;
}

/// Where the robot is; within an area that it keeps out of, the nearest place outside.
/// @param keep  so far from the area's edge [m]
/// @return  [m, world]
geom::Point place_outside(const percept::Percepts& percepts, double keep);

/// A way for a body of this radius that keeps its margin from everything known, as far as there is room:
/// where no way is so wide the margin bends, to a half, a quarter, and at last to a tenth of a metre. Its
/// ends may be nearer to something. What was planned before on the same ground is remembered, so that robots
/// of a unit plan once; that makes no difference to what it is. May be called by several threads.
///
/// @param ground  what is known; with revision 0 the way is straight
/// @param radius  of the body [m], >= 0
/// @param margin  to keep from the edges of things [m], >= 0
/// @return  towards the goal as far as a way leads; its `end` says what is there
/// @source  mlab/ways/planner.h
ways::PlannedWay plan_way(const percept::KnownGround& ground, geom::Point from, geom::Point goal,
                          double radius, double margin);

/// Where somebody is who goes along a route, which may lead back along itself.
struct OnRoute {
  double at = 0.0;     ///< along the way; he is never looked for behind it [m]
  double since = 0.0;  ///< where he was when the way was planned [m]
};

/// Whether a way that was planned on other ground still leads where it did: nothing stands on it, and who is
/// on it is no farther off than `stray` [m], nor near the end of one that was too long to be told. Between a
/// body and where it heads for is nothing, either.
/// @param on_route  null: the way leads along none
/// @param off       becomes how far off the way one is [m]: on the same ground it leads on for whoever has
///                  moved less than what is missing to `stray`, and for a body to the way's clearance;
///                  infinite where that is not all
bool leads_on(const percept::KnownGround& ground, bool is_same_ground, const ways::PlannedWay& way,
              geom::Point from, double stray, bool is_body, const OnRoute* on_route, double& off);

/// So far ahead on a way is where who follows it heads for, where he is not told otherwise [m].
inline constexpr double kLookahead = 2.0;

/// Whether nothing that is known stands nearer to the way's pieces than its clearance, but for its ends.
bool is_open(const percept::KnownGround& ground, const ways::PlannedWay& way);

/// What is met first on the straight line from where a way ends to its goal, as a sentence's subject:
/// `a wall at (300.0, 210.5)`, `the edge of a minefield at (300.0, 210.5)`, `an obstacle of radius 4.0 m at
/// (310.0, 200.0)`, `the edge of the mission area`, `a gap of 0.5 m at (200.0, 150.0), which is too narrow,`;
/// `what stands around it` where nothing else is known.
std::string what_blocks(const percept::KnownGround& ground, geom::Point from, geom::Point goal);
/// What the operator is to read where no way leads farther than `last`, and where something stands at the
/// goal.
std::string no_way_text(const percept::KnownGround& ground, geom::Point last, geom::Point goal);
std::string beside_goal_text(const percept::KnownGround& ground, geom::Point last, geom::Point goal);
/// And where a robot that only reacts is in a trap.
std::string trap_text(geom::Point here, bool stands, double seconds);

/// A place beside a way, and how far along the way it is.
struct PlaceAhead {
  geom::Point place;  ///< [m, world]
  double at = 0.0;    ///< [m]
};

/// The place of a station of a formation that goes along a way, so far along it or farther: it moves on where
/// something stands, and at the inner side of a turn, until it is far enough from the robot. A wall between
/// it and the way moves it to the way: there the formation passes in file, and at the way's end it stands in
/// file. What stands at its last place moves it beside that. Where there is no way it is the robot's own
/// place.
/// @param station  x ahead along the way, y to its left [m]
/// @param in_file  how far from the way's end it stands in file [m]; asked only where it may do so
/// @param at       how far along the way, at most as far as the station is at the way's end [m]
/// @param here     the robot's place [m, world]
/// @param away     how far from there it is at least, if the way goes on [m]
/// @param most     so far it moves on where something stands; where that goes on for longer it is on the way
///                 itself, so that nothing of the way is left out [m]
PlaceAhead place_on_way(const percept::KnownGround& ground, const ways::PlannedWay& way, geom::Vector station,
                        const std::function<double()>& in_file, double at, geom::Point here, double away,
                        double most = std::numeric_limits<double>::infinity());

/// Of its pieces together [m].
inline double way_length(const ways::PlannedWay& way) {
  return way.length >= 0.0 ? way.length : route_length(way.points());
}
/// As point_on, with a way that goes straight on at both ends.
geom::Point way_point(const ways::PlannedWay& way, double at);
/// How many of the unit are nearer to the way's end than the robot, of those in sight.
template <class Readings>
int mates_before(const Readings& robots, const geom::Pose& pose, const ways::PlannedWay& way) {
  if (way.count == 0) return 0;
  const geom::Vector end = pose.to_robot(way.points().back());
  int out = 0;
  for (const percept::RobotReading& robot : robots)
    out += robot.is_unit_mate && length(robot.center - end) < length(end) ? 1 : 0;
  return out;
}

/// The nearest walls within reach [m], nearest first; as many as there is room for.
/// @return  how many
std::size_t nearest_walls(const percept::KnownGround& ground, geom::Point here, double reach,
                          std::span<geom::Segment> out);

/// Where to head for from beside a way, so that what one cuts off of its turns stays small.
/// @param at         how far along the way one is [m]
/// @param off        how far that is from where one is [m]
/// @param lookahead  the place is at most so much farther [m]
geom::Point carrot_on(const ways::PlannedWay& way, geom::Point here, double at, double off, double lookahead);
/// As route_point and nearest_way, on a way: faster where it is straight.
geom::Point point_on(const ways::PlannedWay& way, double at);
double nearest_on(const ways::PlannedWay& way, geom::Point p, double from, double to);
/// As nearest_on, on a way that goes straight on at both ends: less than 0 behind its beginning, more than
/// its length beyond its end [m].
double way_progress(const ways::PlannedWay& way, geom::Point p, double from, double to);

/// The place so far to the left of a way [m].
geom::Point beside_way(const ways::PlannedWay& way, double at, double left);
/// Where on a way somebody is whose place in a formation is so far to its left: where that place is nearest
/// to him, to some tenths of a metre. Where the way turns that is not what of the way itself is nearest.
/// @param from, to  where he is looked for [m]
double station_progress(const ways::PlannedWay& way, double left, geom::Point p, double from, double to);

/// How far along a way somebody has come, and since when he has come no farther: then he may have left out a
/// piece.
struct Advance {
  double at = 0.0;          ///< [m]
  double farther = 0.0;     ///< where he was when he had come farther last [m]
  double farther_at = 0.0;  ///< when that was [s]

  void begin(double place, double time) { *this = {place, place, time}; }
  /// @param is_excused  he is not to come farther
  void note(double time, bool is_excused) {
    constexpr double kFarther = 1.0;  // [m]
    if (is_excused || at > farther + kFarther) begin(at, time);
  }
  bool rests(double time) const {
    constexpr double kPatience = 5.0;  // [s]
    return time - farther_at > kPatience;
  }
};

}  // namespace mlab::schema
