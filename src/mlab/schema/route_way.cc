#include "mlab/schema/route_way.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "mlab/schema/route.h"
#include "mlab/schema/way.h"

namespace mlab::schema {
namespace {

using ways::PlannedWay;
using ways::WayEnd;

constexpr double kRounded = 1e-3;  // corners lie a little outside of arcs that they stand for [m]

bool is_free(const percept::KnownGround& ground, const geom::Segment& piece, double clearance) {
  const auto away = [&](geom::Point p) { return distance(nearest_point(piece, p), p); };
  return std::ranges::none_of(
             ground.discs,
             [&](const ways::Round& disc) { return away(disc.center) < disc.radius + clearance; }) &&
         std::ranges::none_of(ground.walls, [&](const geom::Segment& wall) {
           const auto from_wall = [&](geom::Point p) { return distance(nearest_point(wall, p), p); };
           return std::min({away(wall.a), away(wall.b), from_wall(piece.a), from_wall(piece.b)}) <
                      clearance ||
                  intersects(piece, wall);
         });
}

constexpr std::size_t kMostInLine = 64;

/// Whether a straight line passes all of these, one after the other.
bool passes(geom::Point from, std::span<const geom::Point> all, geom::Point to) {
  constexpr double kBeside = 0.2;  // so near [m]
  const geom::Offset along = unit(to - from);
  double farthest = 0.0;
  for (const geom::Point corner : all) {
    const geom::Offset away = corner - from;
    const double ahead = dot(away, along);
    // Not where it leads back.
    if (ahead < farthest || length(away - along * ahead) > kBeside) return false;
    farthest = ahead;
  }
  return farthest <= distance(from, to);
}

/// The last of the corners of a route that one comes to on a straight line which passes those before it: a
/// line that was drawn by hand has more of them than a way can tell.
/// @param first  the next one
std::size_t last_in_line(geom::Point from, std::span<const geom::Point> corners, std::size_t first) {
  std::size_t out = first;
  while (out + 1 < corners.size() && out + 1 - first < kMostInLine &&
         passes(from, corners.subspan(first, out + 1 - first), corners[out + 1]))
    ++out;
  return out;
}

/// A way along a route as it is put together: what lies in line is left out.
class RouteLine {
 public:
  /// @param room  for so many corners
  RouteLine(const percept::KnownGround& ground, PlannedWay& way, std::size_t room)
      : ground_(ground), way_(way), room_(room) {}

  /// @param passed  so many of the route's corners one has passed there
  void go_on(geom::Point corner, double clearance, std::size_t passed) {
    if (way_.end == WayEnd::kFull || !takes_place_of_last(corner, clearance)) {
      between_.clear();
      way_.append(corner, room_);
    }
    if (way_.end != WayEnd::kFull) way_.passed[way_.count - 1U] = static_cast<std::uint16_t>(passed);
  }

 private:
  bool takes_place_of_last(geom::Point corner, double clearance) {
    if (way_.count < 2 || between_.size() >= kMostInLine) return false;
    const geom::Point from = way_.corners[way_.count - 2U];
    between_.push_back(way_.corners[way_.count - 1U]);
    if (!passes(from, between_, corner) || !is_free(ground_, {from, corner}, clearance - kRounded))
      return false;
    way_.corners[way_.count - 1U] = corner;
    return true;
  }

  const percept::KnownGround& ground_;
  PlannedWay& way_;
  std::size_t room_;
  std::vector<geom::Point> between_;  // left out of its last piece
};

/// What a way has led along up to where somebody is on it, from there back, as far as it is free.
/// @return how many corners it has, nearest first
std::size_t line_behind(const percept::KnownGround& ground, const PlannedWay& way, double at,
                        double clearance, std::span<geom::Point> out) {
  constexpr double kBehind = 150.0;  // [m]
  const auto points = way.points();
  if (points.empty()) return 0;
  std::size_t before = 0;  // the last corner before him
  for (double sum = 0.0; before + 1 < points.size(); ++before) {
    sum += distance(points[before], points[before + 1]);
    if (sum >= at) break;
  }
  geom::Point last = point_on(way, at);
  std::size_t count = 0;
  for (double far = 0.0; far < kBehind && count < out.size(); --before) {
    const double piece = distance(last, points[before]);
    const geom::Point corner =
        far + piece > kBehind ? last + (points[before] - last) * ((kBehind - far) / piece) : points[before];
    if (!is_free(ground, {last, corner}, clearance - kRounded)) break;
    if (piece > 0.0) out[count++] = corner;
    far += piece;
    last = corner;
    if (before == 0) break;
  }
  return count;
}

/// Of a leg to a corner of a route, without the corner where something is nearer to it than the way keeps: it
/// is passed beside that.
std::span<const geom::Point> as_far_as_free(const percept::KnownGround& ground, const PlannedWay& leg,
                                            geom::Point corner) {
  constexpr double kDeepest = 0.75;  // of what the way keeps: what is deeper in is come to
  const auto points = leg.points();
  if (points.size() < 2 || points.back() != corner ||
      distance(points[points.size() - 2], corner) > kDeepest * leg.clearance ||
      is_free(ground, {corner, corner}, leg.clearance - kRounded))
    return points;
  return points.first(points.size() - 1);
}

/// A way along a route, but for its length.
/// @param room  for so many corners
RouteWay route_way(const percept::KnownGround& ground, geom::Point from, std::span<const geom::Point> corners,
                   double radius, double margin, std::size_t room) {
  constexpr int kMostLegs = 400;    // some milliseconds, or hundredths of a second among many things
  constexpr int kMostBeyond = 100;  // of those that there is no room for any more
  RouteWay found;
  PlannedWay& out = found.way;
  out.clearance = radius + margin;
  out.end = WayEnd::kGoal;
  RouteLine line(ground, out, room);
  geom::Point here = from;
  std::size_t passed = 0;
  int legs = 0;
  int beyond = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    std::size_t last = last_in_line(here, corners, i);
    PlannedWay leg = plan_way(ground, here, corners[last], radius, margin);
    for (++legs; last > i && (leg.count > 2 || leg.is_closed_off()); ++legs) {
      last = i + (last - i) / 2;  // it might not pass those in between
      leg = plan_way(ground, here, corners[last], radius, margin);
    }
    i = last;
    const bool is_last = i + 1 == corners.size();
    if (!is_last && leg.is_closed_off()) {
      found.left_out.push_back({i, corners[i], leg.count == 0 ? here : leg.whole_last()});
      continue;
    }
    const auto points = is_last ? leg.points() : as_far_as_free(ground, leg, corners[i]);
    if (leg.count > 0 && out.end != WayEnd::kFull) out.clearance = std::min(out.clearance, leg.clearance);
    for (const geom::Point& point : points) {
      if (&point == &points.back()) passed = i + 1;
      line.go_on(point, leg.clearance, passed);
    }
    if (leg.count > 0) here = leg.end == WayEnd::kFull ? leg.whole_last() : points.back();
    if (leg.end == WayEnd::kFull) out.append_beyond(leg.length_beyond(), leg.whole_last());
    if (is_last) {
      out.set_whole_end(leg.whole_end());
    } else if ((legs > kMostLegs && out.count >= 2) || (out.end == WayEnd::kFull && ++beyond > kMostBeyond)) {
      const auto rest = corners.subspan(i + 1);
      out.append_beyond(distance(here, rest.front()) + route_length(rest), rest.back());
      return found;
    }
  }
  return found;
}

}  // namespace

RouteWay plan_route(const percept::KnownGround& ground, geom::Point from,
                    std::span<const geom::Point> corners, double radius, double margin) {
  RouteWay out = route_way(ground, from, corners, radius, margin, PlannedWay::kMostCorners);
  out.way.length = route_length(out.way.points());
  return out;
}

std::optional<RouteWay> go_on_along_route(const percept::KnownGround& ground, const PlannedWay& before,
                                          double at, std::span<const geom::Point> corners, double radius,
                                          double margin) {
  constexpr std::size_t kMostBehind = PlannedWay::kMostCorners / 3;
  const geom::Point here = point_on(before, at);
  RouteWay out = route_way(ground, here, corners, radius, margin, PlannedWay::kMostCorners - kMostBehind);
  const bool is_closed = out.way.end != WayEnd::kFull && out.way.is_closed_off();
  if (out.way.count < 2 || (is_closed && !out.left_out.empty())) return std::nullopt;
  const PlannedWay ahead = out.way;
  std::array<geom::Point, kMostBehind> behind;
  const std::size_t count = line_behind(ground, before, at, ahead.clearance, behind);
  out.way = {};
  out.way.clearance = ahead.clearance;
  for (std::size_t i = count; i > 0; --i) out.way.append(behind[i - 1]);
  const double cut_at = count == 0 ? at : at - route_length(out.way.points()) - distance(behind[0], here);
  for (std::size_t i = 0; i < ahead.points().size(); ++i) {
    out.way.append(ahead.corners[i]);
    out.way.passed[out.way.count - 1U] = ahead.passed[i];
  }
  out.behind = at - cut_at;
  out.way.end_as(ahead);
  out.way.cut_off = static_cast<float>(std::max(0.0, cut_at));
  out.way.length = route_length(out.way.points());
  return out;
}

std::span<const LeftOut> not_told(std::span<const LeftOut> left_out, std::size_t from) {
  const auto first = std::ranges::lower_bound(left_out, from, {}, &LeftOut::corner);
  return left_out.subspan(static_cast<std::size_t>(first - left_out.begin()));
}

std::size_t corners_passed(const PlannedWay& way, double at, std::span<const geom::Point> corners) {
  const auto points = way.points();
  if (points.empty() || corners.empty()) return 0;
  std::size_t out = way.passed[points.size() - 1];
  double before = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double piece = distance(points[i - 1], points[i]);
    if (before + piece > at) {
      out = way.passed[i - 1];
      // Those that were left out because they are in line.
      const geom::Offset along = unit(points[i] - points[i - 1]);
      while (out + 1U < way.passed[i] && out < corners.size() &&
             dot(corners[out] - points[i - 1], along) < at - before)
        ++out;
      break;
    }
    before += piece;
  }
  return std::min(out, corners.size() - 1);
}

}  // namespace mlab::schema
