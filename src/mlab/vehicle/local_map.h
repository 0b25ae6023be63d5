#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mlab/geom/pose.h"
#include "mlab/percept/percepts.h"
#include "mlab/vehicle/device.h"

namespace mlab::vehicle {

/// What a vehicle's sensors of distances have seen around it, in the frame of its odometry: it moves with
/// the vehicle, and keeps for a while what no beam reaches any more. What a beam has gone through is there no
/// longer. It knows nothing of what no beam met: what is lower or higher than the beams, or does not reflect
/// them, is not in it.
class LocalMap {
 public:
  /// Things farther away are forgotten [m], and those that were not seen for so long [s].
  static constexpr double kReach = 20.0;
  static constexpr double kMemory = 10.0;
  static constexpr std::size_t kMost = 256;  ///< things; what was seen longest ago makes room

  /// Takes in what a sensor saw. One that is none newer than the last of that sensor is left out.
  /// @param pose  of the vehicle then, in the frame of its odometry
  void add(const Scan& scan, const geom::Pose& pose);
  /// Forgets what is too old, or too far from there.
  void age(const geom::Pose& pose, Clock::time_point now);
  /// Everything that is known, nearest first, in the vehicle's frame. Valid until the next call of anything.
  /// @param reach   [m], from the vehicle's middle to the edge of a thing
  /// @param others  bodies that are known otherwise, in the vehicle's frame: what was seen of them is left
  ///                out
  std::span<const percept::Obstacle> obstacles(const geom::Pose& pose, double reach,
                                               std::span<const percept::RobotReading> others);

 private:
  /// Something that beams met, as a disc around the points where they did.
  struct Thing {
    geom::Point center;  ///< [m, odometry]
    double radius = 0.0;
    Clock::time_point seen;
  };
  struct Seen {
    std::uint32_t sensor = 0;
    Clock::time_point at;
  };
  bool is_new(const Scan& scan);
  void clear(const Scan& scan, const geom::Pose& sensor);
  void add_hits(const Scan& scan, const geom::Pose& sensor);
  void put(const Thing& thing);

  std::vector<Thing> things_;
  std::vector<Seen> seen_;
  std::vector<percept::Obstacle> told_;
  std::vector<geom::Point> cluster_;
};

}  // namespace mlab::vehicle
