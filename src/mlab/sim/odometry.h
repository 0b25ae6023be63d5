#pragma once

#include "mlab/base/random.h"
#include "mlab/geom/pose.h"

namespace mlab::sim {

/// What a body really did in a cycle.
struct OdometryStep {
  geom::Pose from;
  geom::Pose to;
};

/// Where a robot believes to be that counts what its wheels turned: the step, seen from where it started,
/// with its length and its turn off by a random share each, put behind what was believed before. Errors add
/// up.
/// @param noise  standard deviation of both shares
geom::Pose counted(geom::Pose before, const OdometryStep& step, double noise, base::Random& random);

}  // namespace mlab::sim
