#pragma once

#include "mlab/percept/action.h"
#include "mlab/vehicle/device.h"

namespace mlab::vehicle {

/// A command that the vehicle can be given: within its limits, numbers only; what is none counts as standing.
Command cut_to(const Limits& limits, const Command& command);

/// What a vehicle is to be told so that it does what a program wants, from how it moves now.
/// @param now  how it moves; nothing: it is not known, and it is taken to stand
/// @param dt   until it is told the next time [s], > 0
Command command_for(const Limits& limits, const percept::Action& action, const Motion* now, double dt);

}  // namespace mlab::vehicle
