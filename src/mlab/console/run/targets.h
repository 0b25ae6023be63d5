#pragma once

#include <vector>

#include "mlab/console.pb.h"
#include "mlab/mission/mission.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// Who would be meant by commands, and who would be left out and why, before anything happens.
/// @param mission  that the commands' units belong to: the run's, or one that the typed line has added to
void encode_targets(const run::MissionRun& run, const mission::Mission& mission,
                    const std::vector<mission::Command>& commands, Targets& out);

}  // namespace mlab::console
