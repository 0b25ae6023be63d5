#include "mlab/mission/passage.h"

#include <algorithm>
#include <cstddef>

#include "mlab/base/up_to.h"
#include "mlab/overlay/measure_kinds.h"

namespace mlab::mission {
namespace {

constexpr double kNear = 2.0;      ///< from the robot [m]
constexpr std::size_t kMost = 32;  ///< that are looked at
constexpr double kOneSide = 0.8;   ///< cosine of the angle between what is on the same side of it

/// From the place to what is near.
base::UpTo<geom::Offset, kMost> things_near(const overlay::Overlay& map, geom::Point place) {
  base::UpTo<geom::Offset, kMost> out;
  for (const overlay::ObstacleDisc& disc : map.obstacles) {
    const geom::Offset to = disc.center - place;
    if (!disc.is_moving() && geom::length(to) < disc.radius + kNear) out.add(to);
  }
  for (const overlay::ControlMeasure& measure : map.measures) {
    if (overlay::info(measure.kind).substance != overlay::Substance::kSolid) continue;
    for (std::size_t i = 1; i < measure.points.size(); ++i) {
      const geom::Offset to =
          nearest_point(geom::Segment{measure.points[i - 1], measure.points[i]}, place) - place;
      if (geom::length(to) < kNear) out.add(to);
    }
  }
  return out;
}

}  // namespace

bool is_in_passage(const overlay::Overlay& map, geom::Point place) {
  const auto things = things_near(map, place);
  return std::ranges::any_of(things, [&](geom::Offset a) {
    return std::ranges::any_of(things, [&](geom::Offset b) {
      return geom::dot(a, b) < kOneSide * geom::length(a) * geom::length(b);
    });
  });
}

}  // namespace mlab::mission
