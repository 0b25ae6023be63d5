#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "mlab/flow/program.h"

namespace mlab::python {

/// What a port holds, as Python has it: a truth, a whole number, a number, the parts of a vector (x, y, z), a
/// point (x, y) or a pose (x, y, heading), and everything else in words. SI units; angles in radians.
using Value = std::variant<bool, std::int64_t, double, std::vector<double>, std::string>;

Value value_of(const std::byte* frame, const flow::Port& port);

/// The roles of ports, as people call them.
const char* name_of(flow::Port::Role role);

/// What port of a run is set to a list of numbers, as a person writes it: `{1, 2}`.
std::string text_of(const std::vector<double>& parts);

}  // namespace mlab::python
