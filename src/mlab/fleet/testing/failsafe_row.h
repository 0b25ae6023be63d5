#pragma once

#include "mlab/mission/failsafe.h"

namespace mlab::fleet::testing {

/// A row as a mission could have it; OUTSIDE means `Field`, 100 m by 60 m from the origin.
/// @param seconds  that its condition lasts
inline mission::Failsafe row(mission::FailsafeCondition condition, mission::FailsafeAction action,
                             double seconds = 0.0) {
  mission::Failsafe out;
  out.condition = condition;
  out.action = action;
  out.seconds = seconds;
  if (condition == mission::FailsafeCondition::kOutside) {
    out.fence_name = "Field";
    out.fence = {{0, 0}, {100, 0}, {100, 60}, {0, 60}};
  }
  return out;
}

}  // namespace mlab::fleet::testing
