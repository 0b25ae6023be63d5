#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace mlab::metrics {

/// How often something took how long, in steps of about three.
class Histogram {
 public:
  /// Upper bounds of all buckets but the last, which has none [s].
  static constexpr std::array kBounds = {1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3, 1.0};

  void note(double seconds) {
    ++counts_[static_cast<std::size_t>(std::ranges::lower_bound(kBounds, seconds) - kBounds.begin())];
    sum_ += seconds;
  }
  /// By bucket.
  const std::array<std::uint64_t, kBounds.size() + 1>& counts() const { return counts_; }
  double sum() const { return sum_; }  ///< [s]

 private:
  std::array<std::uint64_t, kBounds.size() + 1> counts_{};
  double sum_ = 0.0;
};

}  // namespace mlab::metrics
