#include "mlab/schema/step_aside.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "mlab/base/up_to.h"
#include "mlab/schema/way.h"

namespace mlab::schema {
namespace {

using geom::Offset;
using geom::Point;
using ways::PlannedWay;

constexpr std::array kRings{0.75, 1.25, 2.0, 3.0, 4.5, 6.5, 9.0};  // [m]
constexpr std::size_t kDirections = 16;
constexpr int kMostWays = 24;        // that are planned in one search
constexpr double kMargin = 0.1;      // [m]
constexpr double kRoundabout = 2.0;  // times as long as it is far: that is no step aside any more

bool is_held(std::span<const Lane> lanes, Point p) {
  return std::ranges::any_of(lanes, [&](const Lane& lane) { return lane.holds(p); });
}

// What of the ground is so near that it matters.
class Near {
 public:
  Near(const percept::KnownGround& ground, Point here) {
    const double reach = kRings.back() + 1.0;
    for (const geom::Segment& wall : ground.walls) {
      if (distance(nearest_point(wall, here), here) < reach) walls_.add(wall);
    }
    for (const ways::Round& disc : ground.discs) {
      if (distance(disc.center, here) < reach + disc.radius) discs_.add(disc);
    }
  }

  /// How the wall runs that is nearest, if it is beside the place [rad].
  std::optional<double> along_wall(Point here) const {
    constexpr double kBeside = 1.5;  // [m]
    const auto away = [&](const geom::Segment& wall) { return distance(nearest_point(wall, here), here); };
    const auto nearest = std::ranges::min_element(walls_.all(), {}, away);
    if (nearest == walls_.all().end() || away(*nearest) > kBeside) return std::nullopt;
    return geom::direction(nearest->b - nearest->a);
  }

  /// Whether nothing stands between two places, however near to the line.
  bool is_in_sight(Point a, Point b) const {
    const geom::Segment line{a, b};
    return std::ranges::none_of(walls_.all(),
                                [&](const geom::Segment& wall) { return intersects(line, wall); }) &&
           std::ranges::none_of(discs_.all(), [&](const ways::Round& disc) {
             return distance(nearest_point(line, disc.center), disc.center) < disc.radius;
           });
  }

 private:
  base::UpTo<geom::Segment, 64> walls_;
  base::UpTo<ways::Round, 64> discs_;
};

struct Place {
  Point at;
  double away = 0.0;
};
using Places = base::UpTo<Place, kRings.size() * kDirections>;

// Places all round, the nearest first: those in sight, and those that are in sight from one of these. Some
// lie straight ahead and back along the wall beside it, else along the lane.
Places places_around(const Near& near, Point here, std::span<const Lane> lanes) {
  const double along = lanes.empty() ? 0.0 : geom::direction(lanes[0].piece.b - lanes[0].piece.a);
  const double first = near.along_wall(here).value_or(along);
  Places out;
  Places hidden;
  for (const double away : kRings) {
    for (std::size_t i = 0; i < kDirections; ++i) {
      const double angle = first + 2.0 * std::numbers::pi * static_cast<double>(i) / kDirections;
      const Point at = here + geom::ahead_of(angle) * away;
      (near.is_in_sight(here, at) ? out : hidden).add({at, away});
    }
  }
  const Places seen = out;
  for (const Place& place : hidden) {
    const bool is_near = std::ranges::any_of(seen.all(), [&](const Place& via) {
      return via.away + distance(via.at, place.at) < kRoundabout * place.away &&
             near.is_in_sight(via.at, place.at);
    });
    if (is_near) out.add(place);
  }
  return out;
}

// Who stands very near to a body gets away from it, once it has got away from a wall.
bool passes(std::span<const Lane> bodies, const PlannedWay& way) {
  constexpr double kCloser = 0.1;     // one goes past who stands, than one stays beside who comes [m]
  constexpr double kFromWall = 0.15;  // at most [m]
  constexpr double kSlack = 0.03;     // [m]
  const auto points = way.points();
  const bool leaves_wall = points.size() > 2 && distance(points[0], points[1]) < kFromWall;
  const std::size_t begin = leaves_wall ? 1 : 0;
  return std::ranges::all_of(bodies, [&](const Lane& body) {
    const Point middle = body.piece.a;
    const double keep = std::min(body.reach - kCloser, distance(points[begin], middle) - kSlack);
    for (std::size_t i = begin + 1; i < points.size(); ++i) {
      if (distance(nearest_point({points[i - 1], points[i]}, middle), middle) < keep) return false;
    }
    return true;
  });
}

}  // namespace

std::optional<PlannedWay> way_aside(const percept::KnownGround& ground, Point here, double radius,
                                    const KeepClear& clear) {
  const Near near(ground, here);
  const Places places = places_around(near, here, clear.lanes);
  for (const bool is_free : {true, false}) {
    int ways = 0;
    for (const Place& place : places) {
      const auto is_wanted = [&](Point p) {
        return !is_held(clear.lanes, p) && !is_held(clear.bodies, p) &&
               !(is_free && is_held(clear.others, p));
      };
      if (!is_wanted(place.at)) continue;
      if (++ways > kMostWays) break;
      const PlannedWay way = plan_way(ground, here, place.at, radius, kMargin);
      if (way.end != ways::WayEnd::kGoal && way.end != ways::WayEnd::kBesideGoal) continue;
      if (way.count < 2 || way_length(way) > kRoundabout * place.away) continue;
      if (is_wanted(way.points().back()) && passes(clear.bodies, way)) return way;
    }
  }
  return std::nullopt;
}

}  // namespace mlab::schema
