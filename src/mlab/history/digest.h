#pragma once

#include <cstdint>

#include "mlab/run/mission_run.h"

namespace mlab::history {

/// A number out of where all robots are, what became of them, and where the plan stands: two runs that have
/// the same in the same cycle are, as good as certainly, the same.
std::uint64_t digest_of(const run::MissionRun& run);

}  // namespace mlab::history
