#pragma once

#include <span>
#include <vector>

#include "mlab/geom/vector.h"
#include "mlab/percept/percepts.h"
#include "mlab/sim/body.h"

namespace mlab::sim {

/// The beams of a ring, prepared: unit vectors and what one needs to tell which beams a thing can touch.
/// Works in the robot's frame, distances from the body's centre.
class RingBeams {
 public:
  /// @param body_radius  where beams begin [m]
  RingBeams(const RangeRing& ring, double body_radius);

  std::size_t count() const { return axes_.size(); }
  /// What the ring tells where nothing is near.
  const std::vector<percept::RangeReading>& nothing_seen() const { return nothing_seen_; }
  geom::Vector axis(std::size_t beam) const { return {axes_[beam].x, axes_[beam].y, 0.0}; }
  /// Farthest distance at which the ring sees anything, from the centre [m].
  double reach() const { return reach_; }

  /// Shortens the beams that see a disc. A disc round the centre shortens all of them to 0.
  /// @param reach      what is farther away from the centre is left out, or shortens nothing [m]
  /// @param distances  by beam, from the centre; begin with `reach` [m]
  void see_disc(geom::Vector center, double radius, double reach, std::span<double> distances) const;
  /// The same for a wall from a to b.
  void see_wall(geom::Vector a, geom::Vector b, double reach, std::span<double> distances) const;

 private:
  struct Direction {
    double x, y;
  };
  /// Calls look(beam) for each beam whose axis is within half_angle of the direction `angle`, a hair more
  /// included.
  template <class Look>
  void for_each_beam(double angle, double half_angle, Look&& look) const;

  std::vector<percept::RangeReading> nothing_seen_;
  std::vector<Direction> axes_;
  std::vector<Direction> right_edges_;  ///< of the cones; empty for rays
  std::vector<Direction> left_edges_;
  double reach_;
  double first_angle_;
  double half_width_;
  double per_radian_;  ///< beams
  double arc_;         ///< from the first beam to the last [rad]; 0: all round
};

}  // namespace mlab::sim
