#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>

#include "mlab/percept/sensors.h"

namespace mlab::percept {

/// What is wanted of a sensor that senses as far as it is built to.
inline constexpr double kOwnReach = 1.0;

/// What has to be sensed for the next cycle, and how far at most.
class Needs {
 public:
  struct Need {
    Sensor sensor;
    double reach = kOwnReach;  ///< [m], or kOwnReach
  };

  constexpr Needs() = default;
  constexpr Needs(std::initializer_list<Need> needs) {
    for (const Need& need : needs) want(need.sensor, need.reach);
  }

  /// [m]; 0: not wanted.
  constexpr double operator[](Sensor sensor) const { return reach_[static_cast<std::size_t>(sensor)]; }
  constexpr bool has(Sensor sensor) const { return (*this)[sensor] > 0.0; }

  /// At least so far. Everybody includes this, so it goes without <algorithm>.
  constexpr void want(Sensor sensor, double reach = kOwnReach) {
    double& wanted = reach_[static_cast<std::size_t>(sensor)];
    if (reach > wanted) wanted = reach;  // NOLINT(readability-use-std-min-max)
  }
  /// Wants what either wants.
  constexpr void add(const Needs& other) {
    for (const SensorInfo& sensor : kSensors) want(sensor.sensor, other[sensor.sensor]);
  }

 private:
  std::array<double, kSensors.size()> reach_{};
};

}  // namespace mlab::percept
