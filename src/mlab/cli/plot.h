#pragma once

#include <string>
#include <vector>

#include "mlab/run/mission_run.h"

namespace mlab::cli {

/// Draws a run as a picture: the overlay, what is solid, the robots' ways and where they ended, and what
/// vehicles met on theirs.
class Plot {
 public:
  /// Notes where the robots are; call it after each cycle. Every `kEvery` seconds a point is kept.
  void note(const run::MissionRun& run);
  /// The picture as SVG. A file of its own: it needs no other, and no fonts but the viewer's.
  std::string svg(const run::MissionRun& run) const;

 private:
  static constexpr double kEvery = 1.0;      // [s]
  static constexpr std::size_t kMost = 200;  // robots that have a way drawn
  static constexpr double kSame = 0.25;      // [m]: nearer to each other, things are one that was seen twice
  static constexpr std::size_t kMostThings = 2000;

  void note_met(const run::MissionRun& run, const fleet::FleetRobot& robot);

  double next_ = 0.0;
  std::vector<std::vector<geom::Point>> ways_;
  std::vector<binding::Disc> met_;  ///< by vehicles: in the simulator all is on the map
};

}  // namespace mlab::cli
