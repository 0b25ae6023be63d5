#pragma once

namespace mlab::percept {

/// What has to be sensed for the next cycle, and how far at most [m]; 0: not wanted.
struct Needs {
  double obstacles = 0.0;
  double robots = 0.0;
  double objects = 0.0;
  bool ranges = false;  ///< the ring of range sensors, with its own range

  /// Wants what either wants. Everybody includes this, so it goes without <algorithm>.
  constexpr void add(const Needs& other) {
    if (other.obstacles > obstacles) obstacles = other.obstacles;  // NOLINT(readability-use-std-min-max)
    if (other.robots > robots) robots = other.robots;              // NOLINT(readability-use-std-min-max)
    if (other.objects > objects) objects = other.objects;          // NOLINT(readability-use-std-min-max)
    ranges = ranges || other.ranges;
  }
};

}  // namespace mlab::percept
