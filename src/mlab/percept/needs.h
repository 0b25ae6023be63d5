#pragma once

namespace mlab::percept {

/// What has to be sensed for the next cycle, and how far at most [m]; 0: not wanted.
struct Needs {
  double obstacles = 0.0;
  double robots = 0.0;
  double objects = 0.0;
  bool ranges = false;  ///< the ring of range sensors, with its own range

  /// Wants what either wants.
  constexpr void add(const Needs& other) {
    if (other.obstacles > obstacles) obstacles = other.obstacles;
    if (other.robots > robots) robots = other.robots;
    if (other.objects > objects) objects = other.objects;
    ranges = ranges || other.ranges;
  }
};

}  // namespace mlab::percept
