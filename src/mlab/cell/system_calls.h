#pragma once

#include <linux/filter.h>

#include <expected>
#include <string>
#include <vector>

#include "mlab/cell/means.h"
#include "mlab/cell/policy.h"

namespace mlab::cell {

/// The system calls that a program may make in its cell, as the kernel reads it. It is an allow-list, so what
/// a later kernel can do is refused until somebody has thought about it.
///
/// What is refused fails with EPERM rather than ending the program: libraries that try something and know
/// what to do without go on, and what can't go on says `Operation not permitted` in its own words.
class CallFilter {
 public:
  /// @errors  what libseccomp says
  static std::expected<CallFilter, std::string> make(const Policy& policy, Wall wall);

  /// Puts the calling thread under the filter, for good; it must have given up gaining privileges. Safe
  /// between fork and exec, in the child alone: it writes the child's own number into the filter.
  /// @return  0, or why not (errno)
  int enter() noexcept;

  const std::vector<sock_filter>& instructions() const { return instructions_; }

 private:
  std::vector<sock_filter> instructions_;
};

}  // namespace mlab::cell
