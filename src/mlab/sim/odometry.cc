#include "mlab/sim/odometry.h"

#include "mlab/base/angle.h"

namespace mlab::sim {

geom::Pose counted(geom::Pose before, const OdometryStep& step, double noise, base::Random& random) {
  const geom::Vector way = step.from.to_robot(step.to.position) * (1.0 + noise * random.normal());
  const double turn = base::wrap_angle(step.to.heading - step.from.heading) * (1.0 + noise * random.normal());
  return {before.point_at(way), base::wrap_angle(before.heading + turn)};
}

}  // namespace mlab::sim
