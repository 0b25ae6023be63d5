#pragma once

#include <cstdint>

#include "mlab/sim/statics.h"

namespace mlab::sim {

/// A place around which nothing stands: no disc, and no wall that stops anybody. Who is far from all of them
/// has some way to go before he has to look again.
class ClearPlace {
 public:
  /// @param radius  looks so far [m], >= 0
  static ClearPlace look(const Statics& statics, geom::Point place, double radius);

  /// Whether it says that nothing is nearer to a place than `reach` [m]. Where it doesn't, something may be.
  bool covers(const Statics& statics, geom::Point place, double reach) const {
    constexpr double kRounding = 1e-6;  // more than any of this [m]
    return statics_ == statics.id() && distance(place_, place) + reach + kRounding <= radius_;
  }

 private:
  std::uint64_t statics_ = 0;  // id of those that it was looked for among; 0: nobody has looked
  geom::Point place_;
  double radius_ = 0.0;  // nothing is nearer [m]
};

}  // namespace mlab::sim
