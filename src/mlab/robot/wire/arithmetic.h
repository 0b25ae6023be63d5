#pragma once

#include <cstdint>

namespace mlab::robot_wire {

/// What the processor and the C library of this machine make of some forty thousand sines, logarithms and the
/// like: machines on which it is the same give the same robots, bit for bit. It differs between C libraries,
/// and where one processor multiplies and adds in one step (FMA) and the other does not: of each function
/// once in some thousand values, in the last digit.
std::uint64_t arithmetic();

}  // namespace mlab::robot_wire
