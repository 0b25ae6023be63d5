#pragma once

#include "mlab/mission/event.h"
#include "mlab/mission/turn.h"

namespace mlab::mission {

/// A control cycle: what the robots report, what follows from it.
void take_cycle(Turn& turn, const event::Cycle& cycle);

}  // namespace mlab::mission
