#pragma once

#include <string>

#include "mlab/robot/host/robot_program_process.h"

namespace mlab::robot_host::testing {

/// For programs of a test's own that do more than a cell lets them: scripts that start other programs.
inline Launch without_cell(const std::string& executable) {
  Launch out{executable, {}, cell::Wall::kNone};
  out.policy.memory = 0;
  return out;
}

}  // namespace mlab::robot_host::testing
