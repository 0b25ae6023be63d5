#pragma once

#include <cstdint>
#include <vector>

#include "mlab/base/id.h"
#include "mlab/mission/mission.h"

namespace mlab::simulated {

/// A robot that breaks down.
struct Breakdown {
  base::RobotId robot;
  double after = 0.0;  ///< since it came into the world [s]
};

/// Which robots break down in a run of this seed, and when, as SET FAILING-ROBOTS and FAILURES-WITHIN want
/// it. All follows from the seed and the robots' numbers: with one robot more that fails, those that failed
/// without it do so as before.
std::vector<Breakdown> breakdowns_of(const mission::Mission& mission, std::uint64_t seed);

}  // namespace mlab::simulated
