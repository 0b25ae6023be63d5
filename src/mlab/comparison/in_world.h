#pragma once

#include "mlab/run/mission_run.h"

namespace mlab::comparison {

/// Null: there is no such robot, or it was not started.
inline const fleet::FleetRobot* in_world(const run::MissionRun& run, base::RobotId id) {
  const fleet::FleetRobot* const robot = run.fleet().find(id);
  return robot != nullptr && robot->life != fleet::RobotLife::kNotStarted ? robot : nullptr;
}

}  // namespace mlab::comparison
