#pragma once

#include "mlab/geom/pose.h"

namespace mlab::binding {

/// Bodies stop this far from what they meet. It absorbs all rounding, so that they never overlap [m].
inline constexpr double kSkin = 2e-6;
/// Things nearer than skin and this count as touching [m].
inline constexpr double kTouch = 1e-5;
/// A sweep that comes into the skin by less than this is let through, so that sliding isn't held up by
/// rounding [m].
inline constexpr double kSlack = kSkin / 2;

/// Stands for "never in this motion", which takes the time 0 .. 1.
inline constexpr double kNever = 2.0;

/// When a point that moves by `motion` in the time 0 .. 1 meets a disc that stands still.
///
/// @param relative  from the disc's centre to the point at time 0 [m]
/// @param motion    of the point [m]
/// @param radius    at which it stops: both radii and the skin together [m]
/// @return  0 .. 1, at which the distance is `radius`; 0 for a point that is already as near and goes on
///          approaching; kNever where it comes no nearer than radius - kSlack, or no nearer than it is
double meets_disc(geom::Offset relative, geom::Offset motion, double radius);

/// The same for a wall.
/// @param from  where the point is at time 0 [m]
double meets_wall(const geom::Segment& wall, geom::Point from, geom::Offset motion, double radius);

/// When a point leaves a box; kNever where it does not. 0 where it is outside, and goes on.
double meets_edge(geom::Point low, geom::Point high, geom::Point from, geom::Offset motion);

/// The piece of a motion that two moving bodies make: each moves evenly until its own time and stands from
/// then on.
struct Mover {
  geom::Point from;
  geom::Offset motion;  ///< in the whole time 0 .. 1 [m]
  double until = 1.0;   ///< 0 .. 1
};
/// When two movers meet, as meets_disc says.
double meet(const Mover& a, const Mover& b, double radius);

}  // namespace mlab::binding
