#pragma once

#include <memory>

#include "mlab/agents/roster.h"
#include "mlab/cli/commands.h"
#include "mlab/console/machine_watch.h"

namespace mlab::cli {

/// Who is in a fleet, for people at a console of a run of that fleet: what `mlab fleet` shows.
std::shared_ptr<console::MachineWatch> watch_machines(std::shared_ptr<agents::Roster> roster,
                                                      const NetworkOptions& network);

}  // namespace mlab::cli
