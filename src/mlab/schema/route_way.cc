#include "mlab/schema/route_way.h"

#include <algorithm>
#include <array>

#include "mlab/schema/route.h"
#include "mlab/schema/way.h"

namespace mlab::schema {
namespace {

using ways::PlannedWay;
using ways::WayEnd;

bool is_closed(const PlannedWay& way) {
  return way.end == WayEnd::kClosedOff || way.end == WayEnd::kNowhere;
}

/// The last of the corners of a route that one comes to on a straight line which passes those before it: a
/// line that was drawn by hand has more of them than a way can tell.
/// @param first  the next one
std::size_t last_in_line(geom::Point from, std::span<const geom::Point> corners, std::size_t first) {
  constexpr double kBesideLine = 0.5;  // so near it passes them [m]
  constexpr std::size_t kMostInLine = 64;
  const auto passes_all_before = [&](std::size_t last) {
    const geom::Offset along = unit(corners[last] - from);
    double farthest = 0.0;
    for (std::size_t i = first; i <= last; ++i) {
      const geom::Offset away = corners[i] - from;
      const double ahead = dot(away, along);
      // Not where it leads back.
      if (ahead < farthest || length(away - along * ahead) > kBesideLine) return false;
      farthest = ahead;
    }
    return true;
  };
  std::size_t out = first;
  while (out + 1 < corners.size() && out + 1 - first < kMostInLine && passes_all_before(out + 1)) ++out;
  return out;
}

bool is_free(const percept::KnownGround& ground, const geom::Segment& piece, double clearance) {
  return std::ranges::none_of(ground.discs,
                              [&](const ways::Round& disc) {
                                return distance(nearest_point(piece, disc.center), disc.center) <
                                       disc.radius + clearance;
                              }) &&
         std::ranges::none_of(ground.walls,
                              [&](const geom::Segment& wall) { return intersects(piece, wall); });
}

/// What a way has led along up to where somebody is on it, from there back, as far as it is free.
/// @return how many corners it has, nearest first
std::size_t line_behind(const percept::KnownGround& ground, const PlannedWay& way, double at,
                        double clearance, std::span<geom::Point> out) {
  constexpr double kBehind = 150.0;  // [m]
  constexpr double kRounded = 1e-3;  // corners lie a little outside of arcs that they stand for
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

/// Adds what leads along a route to what is there of a way, up to its last corner's place, and to its
/// `left_out`.
/// @param room  for so many corners
void add_route(const percept::KnownGround& ground, geom::Point from, std::span<const geom::Point> corners,
               double radius, double margin, std::size_t room, RouteWay& found) {
  PlannedWay& out = found.way;
  out.clearance = radius + margin;
  out.end = WayEnd::kGoal;
  geom::Point here = from;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = i;
    i = last_in_line(here, corners, next);
    PlannedWay leg = plan_way(ground, here, corners[i], radius, margin);
    const bool is_bent = leg.count > 2 || is_closed(leg);  // then it may not pass those in between
    if (is_bent && i > next) leg = plan_way(ground, here, corners[i = next], radius, margin);
    const bool is_last = i + 1 == corners.size();
    if (!is_last && is_closed(leg)) {
      found.left_out.push_back({i, corners[i], leg.count == 0 ? here : leg.points().back()});
      continue;
    }
    for (const geom::Point point : leg.points()) out.append(point, room);
    if (leg.count > 0) {
      out.clearance = std::min(out.clearance, leg.clearance);
      here = leg.points().back();
    }
    if (out.end == WayEnd::kFull || leg.end == WayEnd::kFull) {
      out.end = WayEnd::kFull;
      out.beyond =
          static_cast<float>(distance(out.points().back(), corners[i]) + route_length(corners.subspan(i)));
      return;
    }
    if (is_last) out.end = leg.end;
  }
}

}  // namespace

RouteWay plan_route(const percept::KnownGround& ground, geom::Point from,
                    std::span<const geom::Point> corners, double radius, double margin) {
  RouteWay out;
  add_route(ground, from, corners, radius, margin, PlannedWay::kMostCorners, out);
  out.way.length = route_length(out.way.points());
  return out;
}

std::optional<RouteWay> go_on_along_route(const percept::KnownGround& ground, const PlannedWay& before,
                                          double at, std::span<const geom::Point> corners, double radius,
                                          double margin) {
  constexpr std::size_t kMostBehind = PlannedWay::kMostCorners / 3;
  const geom::Point here = point_on(before, at);
  RouteWay out;
  add_route(ground, here, corners, radius, margin, PlannedWay::kMostCorners - kMostBehind, out);
  if (out.way.count < 2 || (is_closed(out.way) && !out.left_out.empty())) return std::nullopt;
  const PlannedWay ahead = out.way;
  std::array<geom::Point, kMostBehind> behind;
  const std::size_t count = line_behind(ground, before, at, ahead.clearance, behind);
  out.way.count = 0;
  for (std::size_t i = count; i > 0; --i) out.way.append(behind[i - 1]);
  const double cut_at = count == 0 ? at : at - route_length(out.way.points()) - distance(behind[0], here);
  for (const geom::Point corner : ahead.points()) out.way.append(corner);
  out.behind = at - cut_at;
  out.way.end = ahead.end;
  out.way.cut_off = static_cast<float>(std::max(0.0, cut_at));
  out.way.length = route_length(out.way.points());
  return out;
}

std::span<const LeftOut> not_told(std::span<const LeftOut> left_out, std::size_t from) {
  const auto first = std::ranges::lower_bound(left_out, from, {}, &LeftOut::corner);
  return left_out.subspan(static_cast<std::size_t>(first - left_out.begin()));
}

std::size_t corners_passed(const PlannedWay& way, double since, double at,
                           std::span<const geom::Point> corners) {
  const auto points = way.points();
  const double length = way_length(way);
  double before = since;
  std::size_t passed = 0;
  while (passed + 1 < corners.size()) {
    before = nearest_way(points, corners[passed], before, length);
    if (before >= at) break;
    ++passed;
  }
  return passed;
}

}  // namespace mlab::schema
