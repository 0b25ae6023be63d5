#pragma once

#include <optional>
#include <string>

#include "mlab/console.pb.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// What a series shows now; nothing while there is no such value (not started, no goal).
std::optional<double> measure(const run::MissionRun& run, const Series& series);

/// Why there can never be a value: no such robot, unit or port; empty: there can.
std::string problem_of(const run::MissionRun& run, const Series& series);

}  // namespace mlab::console
