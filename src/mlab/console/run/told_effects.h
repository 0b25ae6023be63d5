#pragma once

#include "mlab/console/run/event_log.h"
#include "mlab/mission/effect.h"
#include "mlab/run/mission_run.h"

// What a run's executive tells people, as its log has it.
namespace mlab::console {

/// Of effects that tell nobody anything nothing is entered.
void tell_effect(const run::MissionRun& run, const mission::Effect& effect, EventLog& log);
/// @param robot_info  where the robots are; else control measures and units
void tell_print(const run::MissionRun& run, bool robot_info, EventLog& log);

}  // namespace mlab::console
