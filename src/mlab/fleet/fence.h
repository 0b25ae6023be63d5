#pragma once

#include <span>
#include <vector>

#include "mlab/binding/body.h"
#include "mlab/binding/kinematics.h"
#include "mlab/binding/passage.h"
#include "mlab/geom/pose.h"
#include "mlab/percept/action.h"

namespace mlab::fleet {

/// A body between two cycles, as far as it is known.
struct Motion {
  geom::Pose pose;
  binding::Momentum momentum;
};

/// A closed line that robots stay within. A body that can still stop within it may do what it wants, another
/// one brakes: so it stands before the line, from any speed, as long as it can brake as its kinematics say.
class Fence {
 public:
  /// Nobody knows where a body comes to stand that brakes for more cycles: it is not allowed what it wants.
  static constexpr int kMostStepsToStand = 10'000;

  /// @param corners  at least three; the line closes by itself
  explicit Fence(std::span<const geom::Point> corners);

  /// How far a place is from the line: inside more than 0, outside less [m].
  double depth(geom::Point place) const;
  /// The place on the line that is nearest.
  geom::Point nearest(geom::Point place) const;

  /// A way by which depth grows. [unit vector, world]; zero on a fence without any
  geom::Offset inward(geom::Point place) const;

  /// Whether the body stays within if it does this for a cycle and then brakes; from outside, whether it
  /// comes back.
  ///
  /// @param radius   of the body [m]
  /// @param dt       of a cycle [s], > 0
  /// @param passage  what is in its way, and may lead it aside
  bool allows(const binding::Kinematics& kinematics, const percept::Action& action, const Motion& motion,
              double radius, double dt, const binding::Passage& passage) const;
  /// How far a body comes, at the most, that does this for a cycle and then brakes [m]. What is farther away
  /// from it can't lead it aside.
  static double reach(const binding::Kinematics& kinematics, const percept::Action& action,
                      const Motion& motion, double dt);

 private:
  class Border;

  std::vector<geom::Segment> sides_;
};

}  // namespace mlab::fleet
