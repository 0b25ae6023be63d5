#pragma once

#include <expected>
#include <string>

#include "mlab/cell/policy.h"

namespace mlab::cell {

/// Version of the kernel's Landlock; 0: it has none, or it is switched off.
int landlock_version();

/// A set of rules that keeps a process to the files of a policy, with all that this version can forbid.
///
/// @return  its descriptor, closed by exec; who asked for it closes it
/// @errors  a sentence that names the file
std::expected<int, std::string> landlock_rules(const Policy& policy, int version);

/// Puts the calling thread under the rules, for good. Safe between fork and exec.
/// @return  0, or why not (errno)
int enter_landlock(int rules) noexcept;

}  // namespace mlab::cell
