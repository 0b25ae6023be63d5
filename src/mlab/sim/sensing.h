#pragma once

#include <cstdint>
#include <vector>

#include "mlab/percept/percepts.h"

namespace mlab::sim {

/// The objects list has robots and obstacles in it too, as things seen by their colour; these ids tell them
/// apart from objects that can be carried: the base plus the robot's id, or plus the place of the disc or
/// roamer in the world.
inline constexpr std::uint32_t kRobotObjectBase = 0x40000000;
inline constexpr std::uint32_t kDiscObjectBase = 0x80000000;
inline constexpr std::uint32_t kRoamerObjectBase = 0xC0000000;

/// Memory for the lists of one robot's percepts, owned by the caller and used again in every cycle: it grows
/// to what the fullest cycle needed, then the cycle allocates nothing. One for each robot, or one for each
/// thread where percepts are used up at once.
class SenseBuffer {
 public:
  /// Makes room for lists of this length, so that shorter ones never allocate.
  void reserve(std::size_t obstacles, std::size_t robots, std::size_t objects, std::size_t beams);

 private:
  friend class Sensors;
  /// Something seen, before the list is sorted.
  struct Detection {
    double distance;   ///< what the list is sorted by [m]
    std::uint32_t id;  ///< breaks ties
    double x, y;       ///< centre [m, robot frame]
    double radius;
  };
  std::vector<Detection> seen_;
  std::vector<double> beams_;         ///< distances from the body's centre [m]
  std::vector<std::uint32_t> walls_;  ///< near ones, each once
  std::vector<percept::Obstacle> obstacles_;
  std::vector<percept::RobotReading> robots_;
  std::vector<percept::ObjectReading> objects_;
  std::vector<percept::RangeReading> ranges_;
  std::vector<percept::RadioContact> radio_;
};

}  // namespace mlab::sim
