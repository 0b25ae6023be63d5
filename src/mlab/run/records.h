#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mlab/base/id.h"
#include "mlab/geom/pose.h"

namespace mlab::run {

/// How well a unit kept its formations.
struct UnitMetrics {
  /// Robots under one order, from its beginning to where they are or were last.
  struct Leg {
    std::uint32_t order = 0;  ///< its sequence
    std::size_t members = 0;
    geom::Point from;  ///< of their centre [m, world]
    geom::Point to;    ///< likewise
  };
  std::vector<Leg> legs;               ///< in formation
  double driven = 0.0;                 ///< by all robots meanwhile [m]
  double error_sum = 0.0;              ///< over robots and cycles [m]
  double max_error = 0.0;              ///< [m]
  std::uint64_t samples = 0;           ///< robot-cycles in which there was a formation to keep
  std::uint64_t out_of_formation = 0;  ///< of these, farther from the station than the robot's formation_slop

  /// What all robots would have driven if each leg were straight [m].
  double straight() const {
    double out = 0.0;
    for (const Leg& leg : legs) out += static_cast<double>(leg.members) * geom::length(leg.to - leg.from);
    return out;
  }
  double mean_error() const { return samples == 0 ? 0.0 : error_sum / static_cast<double>(samples); }
  double out_share() const {
    return samples == 0 ? 0.0 : static_cast<double>(out_of_formation) / static_cast<double>(samples);
  }
};

/// An operator's answer, with the cycle in which it was given.
struct AnswerRecord {
  std::uint64_t cycle = 0;
  std::uint32_t question = 0;
  bool proceed = false;
};

/// Robots that go on with other programs.
struct Takeover {
  /// Of all robots whose program has changed this begins anew, though it was there before.
  struct Restart {
    std::string path;
    std::string why;
    std::vector<base::RobotId> robots;
  };
  std::uint64_t cycle = 0;  ///< that had run
  std::vector<base::RobotId> robots;
  std::vector<Restart> restarts;
};
/// In words: `robots 1 to 3 took over a change; ...`.
std::string text_of(const Takeover& takeover);

/// An object that came into a basket.
struct Delivery {
  double time = 0.0;  ///< [s]
  base::RobotId robot;
  base::ObjectId object;
  base::ObjectId basket;
};

/// What became of a robot's failsafes, as the log says it.
struct FailsafeRecord {
  double time = 0.0;  ///< [s]
  base::RobotId robot;
  std::string what;  ///< `FAILSAFE OUTSIDE Field HOLD` acts
};

}  // namespace mlab::run
