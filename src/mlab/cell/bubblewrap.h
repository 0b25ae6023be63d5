#pragma once

#include <string>
#include <vector>

#include "mlab/cell/policy.h"

namespace mlab::cell {

/// The words in front of a program that have `bwrap` run it among the files of a policy alone.
///
/// @param filter  the descriptor that it reads the filter of system calls from
/// @errors  none; a file that is not there is left out
std::vector<std::string> bubblewrap_words(const std::string& bwrap, const Policy& policy, int filter);

}  // namespace mlab::cell
