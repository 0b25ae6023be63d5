#pragma once

#include <vector>

#include "mlab/ways/ground.h"

namespace mlab::ways {

/// A piece of a circle, counter-clockwise from `begin` to `end` [rad]; 0 <= begin < 2 pi,
/// begin <= end <= begin + 2 pi.
struct Arc {
  double begin = 0.0;
  double end = 0.0;
};

/// What is left of a circle once others have taken their parts.
class OpenArcs {
 public:
  /// @param circle  radius > 0
  explicit OpenArcs(const Round& circle) : circle_(circle) {}

  /// What lies in a disc goes.
  void block(const Round& disc);
  /// What lies so near to a wall goes, where that is nearest beside its ends [m].
  void block_band(const geom::Segment& wall, double width);
  void block_outside(const Bounds& bounds);

  std::vector<Arc> arcs();

 private:
  void take(double middle, double half);
  void block_beyond(double distance, double angle);

  Round circle_;
  bool is_all_taken_ = false;
  std::vector<Arc> taken_;
};

}  // namespace mlab::ways
