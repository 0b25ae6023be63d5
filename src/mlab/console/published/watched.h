#pragma once

#include "mlab/console.pb.h"
#include "mlab/console/run/estimates.h"
#include "mlab/console/run/transition_recorder.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// What somebody wants to see of a whole run beside its robots: cycle, stations, vectors, objects.
void encode_watched(const run::MissionRun& run, const Watch& watch, Frame& out);

/// One robot that somebody looks at, but for what it waits for.
/// @param transitions  that the robot made lately
void encode_watched(const run::MissionRun& run, const fleet::FleetRobot& robot, const Watch& watch,
                    const Estimates& estimates, const TransitionRecorder& transitions, RobotDetail& out);

}  // namespace mlab::console
