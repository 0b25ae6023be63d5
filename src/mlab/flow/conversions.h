#pragma once

#include "mlab/flow/behavior.h"

namespace mlab::flow {

/// Behaviors that the program builder puts between two ports whose values differ only in how they are
/// written.
const Behavior& integer_to_real();
const Behavior& radians_to_degrees();
const Behavior& degrees_to_radians();

}  // namespace mlab::flow
