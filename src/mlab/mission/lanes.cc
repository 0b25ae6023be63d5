#include "mlab/mission/lanes.h"

#include <algorithm>
#include <cmath>

namespace mlab::mission {
namespace {

using percept::Formation;

constexpr std::size_t kMaxStations = 64;  ///< of larger units the extent is estimated
constexpr double kSharpest = 0.5;  ///< sharper corners are cut: a lane goes at most twice its distance out

geom::Offset left_of(geom::Offset direction) {
  return {-direction.y, direction.x};
}

// Direction from one point of the track to the next, `otherwise` where they are the same.
geom::Offset direction_of(geom::Point from, geom::Point to, geom::Offset otherwise) {
  const geom::Offset way = to - from;
  const double length = geom::length(way);
  return length > geom::kZeroLength ? way * (1.0 / length) : otherwise;
}

bool is_free(const overlay::Overlay& map, geom::Point place, double clearance) {
  const overlay::Area area = map.mission_area();
  const bool inside = place.x >= clearance && place.y >= clearance && place.x <= area.width - clearance &&
                      place.y <= area.height - clearance;
  return inside && std::ranges::none_of(map.obstacles, [&](const overlay::ObstacleDisc& disc) {
           return !disc.is_moving() && geom::distance(disc.center, place) < disc.radius + clearance;
         });
}

bool is_walled_off(const overlay::Overlay& map, const geom::Segment& between) {
  for (const overlay::ControlMeasure& measure : map.measures) {
    if (overlay::info(measure.kind).substance != overlay::Substance::kSolid) continue;
    for (std::size_t i = 1; i < measure.points.size(); ++i) {
      if (geom::intersects(between, {measure.points[i - 1], measure.points[i]})) return true;
    }
  }
  return false;
}

}  // namespace

Track beside(const Track& track, geom::Offset arrival, double left) {
  Track lane;
  lane.reserve(track.size());
  geom::Offset into = arrival;
  if (track.size() > 1) into = direction_of(track[0], track[1], arrival);
  for (std::size_t i = 0; i < track.size(); ++i) {
    geom::Offset out = into;
    if (i + 1 < track.size()) out = direction_of(track[i], track[i + 1], into);
    const geom::Offset corner = direction_of({}, geom::Point{} + (into + out), into);
    const double reach = left / std::max(kSharpest, geom::dot(corner, into));
    lane.push_back(track[i] + left_of(corner) * (geom::length(corner) > 0.0 ? reach : 0.0));
    into = out;
  }
  return lane;
}

bool is_clear(const overlay::Overlay& map, const Track& track, const Track& lane, double clearance) {
  for (std::size_t i = 0; i < lane.size(); ++i) {
    if (!is_free(map, lane[i], clearance) || is_walled_off(map, {track[i], lane[i]})) return false;
  }
  return true;
}

double half_extent(Formation formation, std::size_t count, double spacing, bool along) {
  if (formation == Formation::kNone || formation == Formation::kSweep) return 0.0;
  if (count > kMaxStations) return static_cast<double>(count) * spacing / 2.0;
  double extent = 0.0;
  for (int rank = 0; rank < static_cast<int>(count); ++rank) {
    const geom::Vector at = percept::station(formation, rank, static_cast<int>(count), spacing);
    extent = std::max(extent, std::abs(along ? at.x : at.y));
  }
  return extent;
}

}  // namespace mlab::mission
