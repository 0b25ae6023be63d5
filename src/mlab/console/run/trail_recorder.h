#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "mlab/console.pb.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// Where every robot of a run has been: a point each time it has gone a certain way. When there are too many
/// points, of all robots together, every second one is dropped and the way becomes twice as long.
class TrailRecorder {
 public:
  static constexpr std::size_t kMostPoints = 200'000;  ///< of all robots together
  static constexpr std::size_t kMostOfOne = 2'000;     ///< of one robot
  static constexpr double kFirstStep = 0.5;            ///< between points at the beginning [m]

  /// Once per cycle.
  void look(const run::MissionRun& run);
  /// As if nobody had gone anywhere yet.
  void clear();
  /// @param until  points that came later are left out [s]
  void encode(Trails& out, double until = std::numeric_limits<double>::infinity()) const;

 private:
  struct Point {
    float x, y, time;
  };
  struct Trail {
    std::uint32_t robot = 0;
    geom::Point last;
    double step = kFirstStep;  // [m]
    std::vector<Point> points;
  };

  void match(const std::vector<fleet::FleetRobot>& fleet);
  void thin(Trail& trail);

  std::vector<Trail> trails_;  // by place in the fleet
  std::size_t count_ = 0;
};

}  // namespace mlab::console
