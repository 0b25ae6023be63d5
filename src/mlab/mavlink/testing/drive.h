#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>

#include "mlab/mavlink/rover_device.h"
#include "mlab/mavlink/testing/toy_rover.h"

namespace mlab::mavlink::testing {

/// A device and a toy rover at both ends of a link, with a clock of their own.
struct Pair {
  ToyLink link;
  ToyRover rover;
  std::unique_ptr<RoverDevice> device;
  Time now{std::chrono::hours(1)};

  explicit Pair(const RoverSettings& settings = {}, const std::optional<Key>& rover_key = {})
      : rover(link, rover_key),
        device(std::make_unique<RoverDevice>(std::make_unique<ToyStream>(link), settings)) {}

  /// Goes on for a while, in steps of 50 ms.
  /// @param each  is done in each step, if it is given
  void pass(double seconds, const std::function<void()>& each = {}) {
    for (std::int64_t i = 0; i < std::llround(seconds * 20.0); ++i) {
      now += std::chrono::milliseconds(50);
      rover.work(now);
      device->work(now);
      if (each) each();
    }
  }
  void drive(double seconds, const vehicle::Command& command) {
    pass(seconds, [&] { device->drive(command, now); });
  }
  const vehicle::Report& report() { return device->report(now); }
  std::string why() { return report().why; }
};

}  // namespace mlab::mavlink::testing
