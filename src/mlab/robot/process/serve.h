#pragma once

#include "mlab/robot/process/speaker.h"

namespace mlab::robot_process {

/// Answers every message that arrives on a file, until it ends; once the run shares its cycles, computes
/// those.
///
/// @param in, out  file descriptors
/// @return  the process's exit status: 0 where `in` ended between two messages; 1 where it ended within one,
///          held what is no message at all, or nobody reads `out` any more
int serve(Speaker& speaker, int in, int out);

}  // namespace mlab::robot_process
