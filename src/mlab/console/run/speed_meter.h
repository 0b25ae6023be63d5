#pragma once

#include <deque>

namespace mlab::console {

/// Simulated seconds per second over the last second.
class SpeedMeter {
 public:
  void note(double wall, double sim);
  /// 0 where time has not passed for half a second.
  double speed(double wall) const;

 private:
  struct Sample {
    double wall;
    double sim;
  };
  std::deque<Sample> samples_;  // at most one for each hundredth of a second
};

}  // namespace mlab::console
