#pragma once

#include <deque>
#include <optional>

#include "mlab/vehicle/device.h"

namespace mlab::vehicle {

/// Where a vehicle was during the last seconds, as it said: what a sensor saw belongs to the pose of its
/// moment, not to the newest one.
class PoseHistory {
 public:
  /// Poses are told for so long before the newest motion, and so long after it or beside a gap: by how the
  /// vehicle moved then [s].
  static constexpr double kKept = 3.0;
  static constexpr double kAhead = 0.5;

  /// One that is none newer than the last is left out; one from before it, by more than `kKept`, begins anew.
  void add(const Motion& motion);
  /// In the frame of its motions; nothing: it is not known where it was then.
  std::optional<geom::Pose> at(Clock::time_point time) const;

 private:
  std::deque<Motion> motions_;
};

}  // namespace mlab::vehicle
