#pragma once

#include <string>

#include "mlab/mission/mission.h"
#include "mlab/mission/state.h"

namespace mlab::mission {

/// When a point in mission time comes, as run time [s].
///
/// @param reached  run time at which the unit was in place, or came to the line [s]
double run_time_of(const MissionTime& time, const ExecutiveOptions& options, double reached);

/// The mission clock at a run time, `12:30:05`; times are rounded to the second.
std::string clock_text(double run_time, const ExecutiveOptions& options);

}  // namespace mlab::mission
