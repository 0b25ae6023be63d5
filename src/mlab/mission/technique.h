#pragma once

#include "mlab/mission/turn.h"

namespace mlab::mission {

/// Decides which parts of a unit move now. Once per cycle; does nothing for a unit that travels.
void steer_parts(Turn& turn, Run& run);

/// Halts and releases the run's groups as its technique and its phase lines want it.
void apply_halts(Turn& turn, const Run& run);

}  // namespace mlab::mission
