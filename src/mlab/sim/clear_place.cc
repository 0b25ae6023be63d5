#include "mlab/sim/clear_place.h"

#include <algorithm>

namespace mlab::sim {

ClearPlace ClearPlace::look(const Statics& statics, geom::Point place, double radius) {
  ClearPlace out;
  out.statics_ = statics.id();
  out.place_ = place;
  out.radius_ = radius;
  const auto meet = [&](double away) { out.radius_ = std::min(out.radius_, away); };
  const Box around = Box::around(place.x, place.y, radius);
  statics.visit_discs(
      around, [&](std::uint32_t, const Disc& disc) { meet(distance(disc.center, place) - disc.radius); });
  statics.visit_walls(around, [&](std::uint32_t, const Wall& wall) {
    meet(distance(nearest_point(wall.segment, place), place));
  });
  return out;
}

}  // namespace mlab::sim
