#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mlab/ways/clearances.h"
#include "mlab/ways/ground.h"

namespace mlab::ways {

/// What became of the search for a way.
enum class CoverageEnd : std::uint8_t {
  kCovered,          ///< the way sees as much as is wanted of what can be seen
  kPartly,           ///< it sees less; how much is said
  kNoArea,           ///< the outline's corners lie on one line, or on one spot
  kNothingToSearch,  ///< the outline holds no ground, or nothing of it can be seen
  kUnusable,         ///< numbers that aren't finite or have the wrong sign
  kTooLarge          ///< for this swath: more lanes, cells or waypoints than are computed
};

/// Ways that see an area together, one for each share, and what they see.
struct Coverage {
  static constexpr double kWanted = 0.995;  ///< share of what can be seen
  static constexpr int kMostLanes = 1000;
  static constexpr std::size_t kMostWaypoints = 10'000;

  CoverageEnd end = CoverageEnd::kNothingToSearch;
  /// Of all shares, one after the other. Each a free place; from each to the next of its share as
  /// `BendingPlanner` plans it. Empty where there is none [m, world].
  std::vector<geom::Point> waypoints;
  /// By waypoint: the corners of the way to the next one, in between; none after a share's last [m, world].
  std::vector<std::vector<geom::Point>> corners;
  /// By share: which waypoint is its first one. A share has two at least, but for an only one.
  std::vector<std::size_t> shares;
  /// That it keeps from everything, where there is room [m].
  double clearance = 0.0;
  double length = 0.0;     ///< of the planned ways between them, all together [m]
  double free_area = 0.0;  ///< inside of the outline and the bounds, outside of things [m^2]
  double visible = 0.0;    ///< share of that which can be seen from where a robot may be, 0..1
  double seen = 0.0;       ///< share of what can be seen that the way sees, 0..1; told by cells
};

/// Ways by which robots see all of an area, as far as that can be: they come within half a swath of every
/// place, with no wall in between. What each has to go, from where it is, is about the same. Discs hide
/// nothing. Lanes side by side, to and fro, round what stands there; then what they miss is added where it
/// costs least, and what sees nothing new is left out. It keeps the widest clearance from which about as much
/// can be seen as from the least one, and less where no way is so wide: it passes every door that the least
/// one passes. Places to which no way leads, and places too close to things, can't be seen. Very large areas
/// with very many things are not looked at to the end: `seen` says it. The way may leave the outline by less
/// than half a swath, but not the bounds.
///
/// @param outline    corners of a polygon, in either sense [m, world]; where it crosses itself, what lies
/// inside of
///                   an even number of rounds is outside
/// @param clearances  what the robot's centre keeps from everything, as far as there is room
/// @param swath      how wide a robot sees, half of it to either side [m], > 0; more than four times the
/// outline's
///                   extent sees no more
/// @param opaque     the walls that hide what is behind them; without, all of the ground's
/// @param robots     where those are that share it: only what the first one comes to can be seen; without, it
/// is
///                   for one, and of parts between which no way leads the one counts in which there is most
///                   to see [m, world]
/// @return  the same for the same, whatever was asked before
/// @source  H. Choset, Coverage of Known Spaces: The Boustrophedon Cellular Decomposition, Autonomous Robots
/// 9(3),
///          2000; W. Huang, Optimal Line-sweep-based Decompositions for Coverage Algorithms, ICRA 2001
///          (direction of the lanes); E. Galceran, M. Carreras, A survey on coverage path planning for
///          robotics, Robotics and Autonomous Systems 61(12), 2013
Coverage coverage_route(std::span<const geom::Point> outline, const Ground& ground,
                        const Clearances& clearances, double swath, std::span<const geom::Point> robots = {},
                        const std::optional<std::vector<geom::Segment>>& opaque = std::nullopt);

/// What of an area could be seen, without looking for a way by which it is: `kPartly` with its size and the
/// visible share, where there is something to see; `from` is where the robots are. Nothing where it would
/// take longer than some tenths of a second to know.
std::optional<Coverage> coverage_outlook(
    std::span<const geom::Point> outline, const Ground& ground, const Clearances& clearances, double swath,
    std::optional<geom::Point> from = std::nullopt,
    const std::optional<std::vector<geom::Segment>>& opaque = std::nullopt);

}  // namespace mlab::ways
