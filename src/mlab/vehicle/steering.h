#pragma once

#include "mlab/percept/action.h"
#include "mlab/vehicle/device.h"

namespace mlab::vehicle {

/// A command that the vehicle can be given: within its limits, numbers only; what is none counts as standing.
Command cut_to(const Limits& limits, const Command& command);

/// What a vehicle is to be told so that it does what a program wants, from what it was told before.
/// @param before  what it does now; limits of acceleration start from there
/// @param dt      until it is told the next time [s], > 0
Command command_for(const Limits& limits, const percept::Action& action, const Command& before, double dt);

}  // namespace mlab::vehicle
