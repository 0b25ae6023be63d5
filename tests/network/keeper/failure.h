#pragma once

#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>

namespace mlab::network {

/// Why a host can't be made, in words for whoever reads that a test was skipped.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// `what`, and the reason that errno has.
[[noreturn]] inline void fail(const std::string& what) {
  throw Failure(what + ": " + std::generic_category().message(errno));
}

inline void check(bool is_done, const std::string& what) {
  if (!is_done) fail(what);
}

}  // namespace mlab::network
