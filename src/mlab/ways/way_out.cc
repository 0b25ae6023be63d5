#include "mlab/ways/way_out.h"

#include <algorithm>
#include <cstddef>

namespace mlab::ways {
namespace {

constexpr double kTouching = 1e-3;  // who touches something may be so much nearer than its radius [m]

// How near a straight piece comes to a thing; less than 0 within a disc [m].
double gap(const Round& disc, geom::Segment s) {
  return distance(nearest_point(s, disc.center), disc.center) - disc.radius;
}
double gap(const geom::Segment& wall, geom::Segment s) {
  if (intersects(s, wall)) return 0.0;
  return std::min({distance(nearest_point(wall, s.a), s.a), distance(nearest_point(wall, s.b), s.b),
                   distance(nearest_point(s, wall.a), wall.a), distance(nearest_point(s, wall.b), wall.b)});
}

template <class Holds>
bool holds_for_all(const Ground& ground, const Holds& holds) {
  return std::ranges::all_of(ground.discs, holds) && std::ranges::all_of(ground.walls, holds);
}

}  // namespace

bool leads_straight(const Ground& ground, geom::Segment s, double radius) {
  return holds_for_all(ground, [&](const auto& thing) {
    const double away = gap(thing, s);
    return away >= radius - kTouching || away >= gap(thing, geom::Segment{s.a, s.a}) - Clearing::kTolerance;
  });
}

std::optional<geom::Point> way_out(const Ground& ground, const Clearing& clearing, geom::Point place,
                                   double radius) {
  constexpr std::size_t kMostPlaces = 24;
  const auto is_beside = [&](const auto& thing) {
    return gap(thing, geom::Segment{place, place}) >= radius - kTouching;
  };
  if (clearing.is_free(place) || !holds_for_all(ground, is_beside)) return std::nullopt;
  const auto places = clearing.free_places(place, kMostPlaces);
  const auto found = std::ranges::find_if(
      places, [&](geom::Point out) { return leads_straight(ground, {place, out}, radius); });
  return found == places.end() ? std::nullopt : std::optional(*found);
}

}  // namespace mlab::ways
