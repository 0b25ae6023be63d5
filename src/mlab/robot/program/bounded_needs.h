#pragma once

#include <algorithm>
#include <cmath>

#include "mlab/percept/needs.h"

namespace mlab::robot {

/// What a stranger's program wants is no reason to look farther than there is a world, or nowhere.
inline percept::Needs bounded(const percept::Needs& wanted) {
  constexpr double kLargestWorld = 1e9;  // [m]
  percept::Needs out;
  for (const percept::SensorInfo& sensor : percept::kSensors) {
    const double reach = wanted[sensor.sensor];
    if (std::isfinite(reach)) out.want(sensor.sensor, std::min(reach, kLargestWorld));
  }
  return out;
}

}  // namespace mlab::robot
