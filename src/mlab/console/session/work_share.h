#pragma once

#include <algorithm>
#include <chrono>

namespace mlab::console {

/// Keeps what is not urgent to a share of the session's time, however much of it is asked for. Who has not
/// used it may do some at once.
class WorkShare {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param share    of the time, > 0 and <= 1
  /// @param at_once  so much may be done without a pause
  WorkShare(double share, Clock::duration at_once) : share_(share), most_(at_once), left_(at_once) {}

  bool may_begin(Clock::time_point now) {
    earn(now);
    return left_ > Clock::duration::zero();
  }
  void note(Clock::time_point began, Clock::time_point ended) {
    earn(ended);
    left_ -= ended - began;
  }

 private:
  void earn(Clock::time_point now) {
    if (now > earned_) {
      const auto earned = std::chrono::duration<double>(now - earned_) * share_;
      left_ = std::min(most_, left_ + std::chrono::duration_cast<Clock::duration>(
                                          std::min(earned, std::chrono::duration<double>(most_ * 1000))));
    }
    earned_ = now;
  }

  double share_;
  Clock::duration most_;
  Clock::duration left_;
  Clock::time_point earned_;
};

}  // namespace mlab::console
