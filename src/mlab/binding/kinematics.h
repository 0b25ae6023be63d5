#pragma once

#include "mlab/binding/body.h"
#include "mlab/geom/pose.h"
#include "mlab/percept/action.h"

namespace mlab::binding {

/// How a body moves at the end of a cycle: what limits of acceleration start from.
struct Momentum {
  geom::Offset velocity;   ///< [m/s, world]
  double speed = 0.0;      ///< along the heading; differential and car only [m/s]
  double turn_rate = 0.0;  ///< [rad/s]
};

/// Where a body wants to be at the end of a cycle. It goes there straight: an arc counts as its chord.
struct WantedMotion {
  geom::Offset step;     ///< [m, world]
  double heading = 0.0;  ///< at the end, in (-pi, pi] [rad]
  Momentum momentum;     ///< at the end, where nothing was in the way
};

/// Turns an action into motion, by the laws of docs/simulator.md.
/// @param heading    at the beginning [rad]
/// @param ahead      cosine and sine of the heading
/// @param momentum   at the end of the cycle before
/// @param dt         [s], > 0
WantedMotion drive(const Kinematics& kinematics, const percept::Action& action, double heading,
                   geom::Offset ahead, const Momentum& momentum, double dt);

}  // namespace mlab::binding
