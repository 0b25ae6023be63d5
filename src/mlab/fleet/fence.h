#pragma once

#include <span>
#include <vector>

#include "mlab/binding/body.h"
#include "mlab/binding/kinematics.h"
#include "mlab/geom/pose.h"
#include "mlab/percept/action.h"

namespace mlab::fleet {

/// How a body moves between two cycles, as far as it is known.
struct Motion {
  geom::Pose pose;
  geom::Offset velocity;   ///< [m/s, world]
  double turn_rate = 0.0;  ///< [rad/s]
};

/// A closed line that robots stay within. A body that can still stop within it may do what it wants, another
/// one brakes: so it stands before the line, from any speed, as long as it can brake as its kinematics say.
class Fence {
 public:
  /// @param corners  at least three; the line closes by itself
  explicit Fence(std::span<const geom::Point> corners);

  /// How far a place is from the line: inside more than 0, outside less [m].
  double depth(geom::Point place) const;
  /// The place on the line that is nearest.
  geom::Point nearest(geom::Point place) const;

  /// Whether the body stays within if it does this for a cycle and then brakes; from outside, whether it
  /// comes back.
  ///
  /// @param radius  of the body [m]
  /// @param dt      of a cycle [s], > 0
  bool allows(const binding::Kinematics& kinematics, const percept::Action& action, const Motion& motion,
              double radius, double dt) const;

 private:
  std::vector<geom::Segment> sides_;
};

}  // namespace mlab::fleet
