#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mlab/flow/frame.h"
#include "mlab/flow/program.h"

namespace mlab::flow {

/// A node that was there before the program was exchanged, and begins anew.
struct Restart {
  std::string path;
  std::string why;  ///< behind the path: `is another component now`

  friend auto operator<=>(const Restart&, const Restart&) = default;
};

/// Of a parameter that somebody has set, behind its path.
inline constexpr const char* kOutOfRange = "is as the text says: what was set is out of its range now";

/// A program with the values of its robots before their first cycle.
struct ProgramVersion {
  const Program& program;
  const Frame& initial;
};

struct CarriedOver {
  Frame frame;                    ///< of the program after
  std::vector<Restart> restarts;  ///< in the order of the nodes after
};

/// What a robot's values become when another program takes the place of its own between two cycles. Nodes are
/// the same that have the same path and behavior: they keep state, output, and when they fired. Sequences
/// stay in their state where there is one of its name. Parameters and constants become those of the program
/// after, but for those that somebody has set meanwhile, where they are still in range. Asynchronous
/// procedures begin what they compute anew. Of the same program everything is kept, bit for bit.
///
/// @param frame          of the program before; any bytes
/// @param has_same_code  behaviors that only a process elsewhere can fire do the same under the same name
CarriedOver carry_over(const ProgramVersion& before, const std::byte* frame, const ProgramVersion& after,
                       bool has_same_code);

}  // namespace mlab::flow
