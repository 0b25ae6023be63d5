#pragma once

#include "mlab/console.pb.h"
#include "mlab/preflight/gate.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// The vehicles of a run that are bodies of its robots or will be, by robot; what of them is known at this
/// moment of it.
void encode_vehicles(const run::MissionRun& run, Status& out);

/// Of those of them that the run has not heard: what they say to the fleet meanwhile, which the gate holds
/// back from the run.
void encode_held_back(const preflight::Gate& gate, Status& out);

}  // namespace mlab::console
