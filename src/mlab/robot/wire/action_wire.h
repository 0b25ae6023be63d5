#pragma once

#include <optional>
#include <string>

#include "mlab/percept/action.h"
#include "mlab/robot.pb.h"

namespace mlab::robot_wire {

/// Writes everything that a robot does; `out` loses what it held, and keeps its memory.
void encode(const percept::Action& action, wire::Action& out);

/// @errors  a sentence that names what does not fit; `out` is then unchanged
std::optional<std::string> decode(const wire::Action& message, percept::Action& out);

}  // namespace mlab::robot_wire
