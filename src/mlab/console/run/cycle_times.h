#pragma once

#include <ctime>

#include "mlab/metrics/histogram.h"

namespace mlab::console {

/// How long control cycles took.
class CycleTimes {
 public:
  const metrics::Histogram& wall() const { return wall_; }
  /// All threads of this process together, also those that have nothing to do with the cycle.
  const metrics::Histogram& processor() const { return processor_; }

  /// One cycle, from here to `note`.
  class Watch {
   public:
    // The processors' clock takes half a microsecond: a cycle that follows the last one at once begins where
    // that ended.
    explicit Watch(const CycleTimes& times)
        : wall_(now(CLOCK_MONOTONIC)),
          processor_(wall_ < times.ended_ + kAtOnce ? times.ended_processor_
                                                    : now(CLOCK_PROCESS_CPUTIME_ID)) {}
    void note(CycleTimes& times) const {
      times.ended_ = now(CLOCK_MONOTONIC);
      times.ended_processor_ = now(CLOCK_PROCESS_CPUTIME_ID);
      times.wall_.note(times.ended_ - wall_);
      times.processor_.note(times.ended_processor_ - processor_);
    }

   private:
    double wall_;
    double processor_;
  };

 private:
  static double now(clockid_t clock) {
    std::timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
  }

  static constexpr double kAtOnce = 5e-6;  // [s]

  double ended_ = -1.0;  // the last one, by the clock and in time of processors [s]
  double ended_processor_ = 0.0;
  metrics::Histogram wall_;
  metrics::Histogram processor_;
};

}  // namespace mlab::console
