#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <vector>

#include "mlab/mission/state.h"

namespace mlab::console {

/// How far the commands that run are, and when they will be done, from how fast what remains becomes less.
class Estimates {
 public:
  static constexpr double kApart = 1.0;    ///< between samples [s]
  static constexpr double kWindow = 15.0;  ///< over which the rate is taken [s]

  struct Estimate {
    double remaining = -1.0;  ///< of the robot that has the farthest to go [m]; negative: unknown
    double arrival = -1.0;    ///< run time [s]; negative: unknown
    double progress = 0.0;    ///< 0..1; negative: nothing to measure it by
    std::uint32_t robots = 0;
    std::uint32_t robots_done = 0;
  };

  /// Once per cycle.
  void look(const mission::State& state);
  void clear() { tracks_.clear(); }
  Estimate of(const mission::State& state, const mission::Run& run) const;
  /// When that command will be done, as of the last sample; negative: unknown. Costs nothing.
  double arrival_of(std::uint32_t record) const;

 private:
  struct Sample {
    double time;
    double remaining;
  };
  struct Track {
    std::map<base::RobotId, double> initial;  // the most that remained [m]; negative: not known yet
    std::deque<Sample> samples;
    double initial_of(base::RobotId robot) const {
      const auto known = initial.find(robot);
      return known == initial.end() ? -1.0 : known->second;
    }
  };
  std::map<std::uint32_t, Track> tracks_;  // by record of the command
  double next_ = 0.0;
};

/// What remains for a robot under the run [m]; negative: unknown, or it is not the run's.
double remaining_of(const mission::State& state, const mission::Run& run, base::RobotId robot);

}  // namespace mlab::console
