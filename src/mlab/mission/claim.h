#pragma once

#include "mlab/mission/turn.h"

namespace mlab::mission {

/// True where none of the run's robots is under an order of the operator that is still under way. An order
/// itself always is free: it takes what it names.
bool is_free(const State& state, const Run& run);

/// The robots follow this run from now on. They leave the commands that they were under, which go on with the
/// others, or end as replaced where nobody is left. Robots that can't carry it out are told and left out.
///
/// @return false where the run has ended: none of its robots can carry it out
bool claim(Turn& turn, Run& run);

}  // namespace mlab::mission
