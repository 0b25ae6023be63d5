#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mlab/comparison/comparison.h"
#include "mlab/comparison/program_pair.h"

namespace mlab::comparison {

/// What the wires of a robot's program say of a difference, in the cycle in which it came up.
struct WireWalk {
  std::vector<std::string> causes;  ///< sentences about the node itself; empty: nothing there differs
  std::vector<Value> consequences;  ///< along the wires, in the order in which they are computed
  std::size_t values = 0;           ///< that differ, in all
  std::string senses;               ///< what it senses: `obstacles, robots`; empty: nothing
  std::vector<std::string> lists;   ///< that it reads, and of which only the number is known
};

/// @param first  the first output that differs
WireWalk walk_wires(const ProgramPair& programs, const ProgramPair::Frames& frames,
                    const ProgramPair::PortPair& first);

}  // namespace mlab::comparison
