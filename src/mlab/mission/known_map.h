#pragma once

#include "mlab/overlay/barriers.h"
#include "mlab/overlay/overlay.h"
#include "mlab/percept/area_margin.h"
#include "mlab/ways/ground.h"

namespace mlab::mission {

/// What a map says to stand on the ground, for who plans ways: what moves is not among it. Without bounds.
inline ways::Ground known_things(const overlay::Overlay& map) {
  ways::Ground out;
  for (const overlay::ObstacleDisc& disc : map.obstacles) {
    if (!disc.is_moving()) out.discs.push_back({disc.center, disc.radius});
  }
  for (const overlay::Barrier& one : overlay::barriers(map)) out.walls.push_back(one.segment);
  return out;
}

/// Where robots' centres may be [m, world].
inline ways::Bounds known_bounds(const overlay::Overlay& map) {
  constexpr double kEdge = percept::kAreaMargin;
  const overlay::Area area = map.mission_area();
  return {kEdge, kEdge, area.width - kEdge, area.height - kEdge};
}

}  // namespace mlab::mission
