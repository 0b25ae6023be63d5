#pragma once

#include "mlab/mission/mission.h"
#include "mlab/text/diagnostic.h"

namespace mlab::mdl {

/// Walks through a mission's steps as a run would and warns of what will go wrong: units that are sent before
/// they are started or after they were stopped, robots with two commands at once, robots that start outside
/// the area or in an obstacle, goals there, formations that the area or a gap on the way is too small for,
/// steps that are never reached.
///
/// The work is bounded: in missions of hundreds of thousands of robots some of it is left out.
void check_plan(const mission::Mission& mission, text::Diagnostics& diagnostics);

/// Only this: warns of robots that two of these commands speak to, and of goals that nobody can reach.
void check_commands_of_one_step(const std::vector<mission::Command>& commands,
                                const mission::Mission& mission, text::Diagnostics& diagnostics);

}  // namespace mlab::mdl
