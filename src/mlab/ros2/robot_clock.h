#pragma once

#include <cstdint>
#include <optional>

#include "mlab/ros2/messages.h"
#include "mlab/vehicle/device.h"
#include "mlab/vehicle/their_clock.h"

namespace mlab::ros2 {

/// Puts stamps of a robot's messages onto our clock, and ours onto its. A robot whose clock is set, or whose
/// simulation begins anew, is noticed.
class RobotClock {
 public:
  using Time = vehicle::Clock::time_point;
  enum class Verdict : std::uint8_t {
    kGood,
    kLate,       ///< older than what came before, or no time: it is left out
    kRestarted,  ///< it runs from elsewhere now; what was known of it is forgotten, and this is the first
  };

  /// Something is there that the robot stamped so. To be asked of one topic, which comes often.
  Verdict hear(const Stamp& stamp, Time arrived);
  bool is_known() const { return newest_.has_value(); }
  /// Whether times can be counted on: not right after it was heard first, nor while what comes was held back.
  bool is_settled(Time now) const { return clock_.is_settled(now); }
  void forget();

  /// When it was so; nothing: not within a minute of what was heard, or nothing was.
  std::optional<Time> ours(const Stamp& stamp) const;
  /// What its clock shows then, at least; all zero: it is not known.
  Stamp theirs(Time time) const;

 private:
  vehicle::TheirClock clock_;
  std::optional<std::int64_t> newest_;  // [ms], of the robot's
  Time heard_at_;
};

}  // namespace mlab::ros2
