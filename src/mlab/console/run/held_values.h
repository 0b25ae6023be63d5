#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mlab/console.pb.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// All outputs of robots' programs that somebody holds, by robot.
void encode_held(const run::MissionRun& run, HeldValues& out);

/// Ids of robots of which this port is held; of an empty one: any.
std::vector<std::uint32_t> robots_that_hold(const run::MissionRun& run, const std::string& port);

}  // namespace mlab::console
