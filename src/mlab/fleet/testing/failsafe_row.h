#pragma once

#include <initializer_list>
#include <utility>

#include "mlab/fleet/what_if.h"
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

/// Conditions that hold for so long [s].
inline WhatIf::Lasting lasting(
    std::initializer_list<std::pair<mission::FailsafeCondition, double>> conditions) {
  WhatIf::Lasting out{};
  for (const auto& [condition, seconds] : conditions) out[static_cast<std::size_t>(condition)] = seconds;
  return out;
}

}  // namespace mlab::fleet::testing
