#pragma once

#include <cstdint>
#include <stop_token>

namespace mlab::robot_host {

/// What a robot program may use up: time [s], by the clock on the wall where nothing else is said, and
/// memory.
struct Limits {
  double start = 10.0;       ///< from its start to its Welcome
  double answer = 5.0;       ///< to anything else
  double cycle = 2.0;        ///< for one robot's cycle, of processor time
  double cycle_wall = 10.0;  ///< the same for a program that sleeps; for an executable's answer
  std::uint64_t memory = std::uint64_t{512} << 20;  ///< of address space [bytes]; 0: any
  std::stop_token ends = {};                        ///< of whoever waits: asked for, nobody does any more
};

}  // namespace mlab::robot_host
