#pragma once

#include "mlab/mission/turn.h"

namespace mlab::mission {

/// Finds out which phase lines the units come to, tells it, and holds or releases the units there.
void watch_phase_lines(Turn& turn);

/// True where the unit holds at a phase line.
bool holds_at_line(const Run& run);

}  // namespace mlab::mission
