#pragma once

#include <span>

#include "mlab/geom/pose.h"

namespace mlab::schema {

/// Of the gap that bodies keep where there is room, so much at least in a narrow place, and where somebody
/// takes his turn; who is nearer flees.
inline constexpr double kLeastGap = 0.25;

/// A robot near to a body that goes along a narrow place, as seen from there.
struct Neighbour {
  geom::Offset place;       ///< from the body [m]
  geom::Offset velocity;    ///< [m/s]
  double radius = 0.2;      ///< [m]
  bool is_mate = false;     ///< of the same unit
  bool goes_first = false;  ///< where only one of the two can pass
};

/// Something round that stands near.
struct RoundThing {
  geom::Offset center;  ///< from the body [m]
  double radius = 0.0;  ///< [m]
};

/// Where something solid stands to both sides of who goes along.
struct SideRoom {
  double left = 0.0;   ///< from the body's middle to what stands there [m]; infinite: nothing near
  double right = 0.0;  ///< likewise

  /// Whether some bodies beside each other have no room in it.
  /// @param gap  that they keep where there is room [m]
  bool is_narrow(double radius, double gap) const;
};

/// What stands to the left and to the right of a direction.
/// @param along   of length 1
/// @param walls   as seen from the body, which is at (0, 0)
SideRoom side_room(geom::Offset along, std::span<const geom::Segment> walls,
                   std::span<const RoundThing> rounds);

/// How far away something may be that makes a passage narrow [m].
inline double narrow_reach(double radius, double gap) {
  constexpr double kAbreast = 4.0;  // so many bodies with their gaps beside each other have room enough
  return kAbreast * (2.0 * radius + gap);
}

/// What a body does for those who come towards it.
struct WayMade {
  geom::Offset wanted;  ///< [m/s]
  double gap = 0.0;     ///< that it keeps from them [m]
};

/// What a body wants instead, in a place so narrow that those who come towards it need one half of it: it
/// keeps to the right; who has somebody beside it on its right who goes the same way falls back behind him;
/// and where no two can pass, who doesn't go first goes back. Where nobody comes, what it wanted.
///
/// @param wanted   [m/s]
/// @param radius   of the body [m]
/// @param gap      that bodies keep where there is room [m]
/// @param room     narrow
WayMade make_way(geom::Offset wanted, double radius, double gap, const SideRoom& room,
                 std::span<const Neighbour> others);

}  // namespace mlab::schema
