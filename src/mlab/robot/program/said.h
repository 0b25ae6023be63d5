#pragma once

#include <string>
#include <vector>

namespace mlab::robot {

/// A line that the agent of some machine told.
struct LogLine {
  double age = 0.0;  ///< since it was told [s]
  std::string text;
};

/// What was said where a robot is computed, for a person who looks for a reason.
struct Said {
  std::vector<LogLine> machine;  ///< by its machine's agent, oldest first; empty: it has none
  std::string program;           ///< the end of what its program wrote to standard error
};

}  // namespace mlab::robot
