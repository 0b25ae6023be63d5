#pragma once

#include <cstdint>
#include <optional>

#include "mlab/vehicle/device.h"

namespace mlab::vehicle {

/// Puts times of a vehicle's own clock, in milliseconds since it was switched on, onto ours. What has come
/// the fastest so far is taken to have come at once, so a time is never told to be later than it was by more
/// than that took; what waited in the line is told to be as old as it is.
class TheirClock {
 public:
  /// Something arrives that the vehicle said at `theirs`; 49 days later its clock may begin with 0 again.
  /// @return  false: its clock ran backwards, and this is left out
  bool hear(std::uint32_t theirs, Clock::time_point arrived);
  /// It was switched off, or another one is there.
  void forget() { base_.reset(); }
  bool is_known() const { return base_.has_value(); }
  /// Whether times can be counted on. Not so right after it was heard first, nor while what comes was held
  /// back somewhere and catches up: each piece of that is less late than the one before.
  bool is_settled(Clock::time_point now) const;

  /// When it was so. It has to be known.
  Clock::time_point ours(std::uint32_t theirs) const;
  /// What their clock shows then, at least. It has to be known.
  std::uint32_t theirs(Clock::time_point ours) const;

 private:
  /// What their clock showed and when that was on ours.
  struct Base {
    std::uint32_t theirs;
    Clock::time_point ours;
  };
  std::optional<Base> base_;
  Clock::time_point caught_up_at_;  // something was less late than all before
};

}  // namespace mlab::vehicle
