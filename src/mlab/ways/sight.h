#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mlab/ways/lanes.h"

/// For sources of this module only.
namespace mlab::ways {

/// What walls hide over lanes. Discs hide nothing.
class Sight {
 public:
  Sight() = default;
  /// @param reach  how far is seen [m], > 0; all places that are asked for lie nearer to the lanes' rectangle
  ///               than twice of it
  Sight(const Lanes& lanes, std::span<const geom::Segment> walls, double reach);

  bool is_open() const { return walls_.empty(); }
  /// Whether a wall stands between a place and who looks from another one. What is on a wall is seen from
  /// both sides.
  bool hides(LanePlace p, LanePlace from) const;
  /// Whether a place within reach of a straight piece is seen from the piece's nearest point, or from an end
  /// of it that is near enough.
  bool sees(LanePlace p, LanePlace a, LanePlace b, double reach) const;

 private:
  const std::vector<geom::Segment>& walls_near(LanePlace p) const;
  int box_along(double along) const;
  int box_across(double across) const;

  double box_ = 1.0;  // side [m]
  int boxes_along_ = 0;
  int boxes_across_ = 0;
  /// By box: those that may be within reach of a place in it; along lanes, and across [m]. Empty: there are
  /// no walls.
  std::vector<std::vector<geom::Segment>> walls_;
};

}  // namespace mlab::ways
