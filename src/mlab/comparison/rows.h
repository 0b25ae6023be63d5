#pragma once

#include "mlab/comparison/comparison.h"
#include "mlab/history/history.h"
#include "mlab/run/mission_run.h"

// What both runs have side by side.
namespace mlab::comparison {

/// What was told in each of them: the same words are the same event, in their order.
void add_events(const Both<const history::History*>& histories, Comparison& out);
/// Commands of the plan and of operators: those of the same step with the same words belong together.
void add_commands(const Both<const run::MissionRun*>& runs, Comparison& out);
/// How units, by their names, kept formations.
void add_units(const Both<const run::MissionRun*>& runs, Comparison& out);

}  // namespace mlab::comparison
