#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "mlab/overlay/barriers.h"
#include "mlab/overlay/overlay.h"
#include "mlab/percept/area_margin.h"
#include "mlab/ways/ground.h"

namespace mlab::mission {

/// What is always in the way of something that moves so little that its middle is always covered: all that it
/// ever covers; nothing: it goes elsewhere.
inline std::optional<ways::Round> swept(const overlay::ObstacleDisc& moving) {
  geom::Point low = moving.center;
  geom::Point high = moving.center;
  for (const geom::Point point : moving.route) {
    low = {std::min(low.x, point.x), std::min(low.y, point.y)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y)};
  }
  const geom::Point middle = low + (high - low) * 0.5;
  const double half = distance(low, middle);
  if (half >= moving.radius) return std::nullopt;
  return ways::Round{middle, moving.radius + half};
}

/// What a map says to stand on the ground, for who plans ways: what moves is among it only where it doesn't
/// go away from its place. Without bounds.
inline ways::Ground known_things(const overlay::Overlay& map) {
  ways::Ground out;
  for (const overlay::ObstacleDisc& disc : map.obstacles) {
    const auto taken = disc.is_moving() ? swept(disc) : std::optional(ways::Round{disc.center, disc.radius});
    if (taken) out.discs.push_back(*taken);
  }
  for (const overlay::Barrier& one : overlay::barriers(map)) out.walls.push_back(one.segment);
  return out;
}

/// So many of the last of these walls are edges of areas to keep out of.
inline std::size_t known_edges(const overlay::Overlay& map) {
  const std::vector<overlay::Barrier> barriers = overlay::barriers(map);
  return static_cast<std::size_t>(std::ranges::count(barriers, false, &overlay::Barrier::is_solid));
}

/// Where robots' centres may be [m, world].
inline ways::Bounds known_bounds(const overlay::Overlay& map) {
  constexpr double kEdge = percept::kAreaMargin;
  const overlay::Area area = map.mission_area();
  return {kEdge, kEdge, area.width - kEdge, area.height - kEdge};
}

}  // namespace mlab::mission
