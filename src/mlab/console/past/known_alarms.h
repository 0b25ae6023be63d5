#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

#include "mlab/console/run/alarms.h"

namespace mlab::console {

/// What was known of robots after a cycle; at first of no robot, before the first one.
struct KnownAlarms {
  std::uint64_t cycle = 0;
  Alarms alarms = {};
};

/// What was known by moments of a run, so that who computes it from one of them goes on with it. Moments are
/// as far apart as it takes for `kMost`.
class AlarmsOverTime {
 public:
  static constexpr std::size_t kMost = 128;
  static constexpr std::uint64_t kFirstApart = 50;  ///< cycles, at the beginning

  /// After each cycle, in order.
  void note(std::uint64_t cycle, const Alarms& alarms) {
    if (cycle % apart_ != 0) return;
    kept_.push_back({cycle, alarms});
    if (kept_.size() <= kMost) return;
    apart_ *= 2;
    std::erase_if(kept_, [this](const KnownAlarms& one) { return one.cycle % apart_ != 0; });
  }
  /// The last one up to the cycle.
  KnownAlarms before(std::uint64_t cycle) const {
    for (std::size_t i = kept_.size(); i-- > 0;) {
      if (kept_[i].cycle <= cycle) return kept_[i];
    }
    return {};
  }

 private:
  std::uint64_t apart_ = kFirstApart;
  std::deque<KnownAlarms> kept_;
};

}  // namespace mlab::console
