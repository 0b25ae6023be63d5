#pragma once

namespace mlab::flow {

/// What stands where a range has no end; negated where it has no least.
inline constexpr double kNoLimit = 1e300;

/// Whether an end of a range is one; else there is no limit.
constexpr bool is_limit(double end) {
  return end > -kNoLimit && end < kNoLimit;
}

}  // namespace mlab::flow
