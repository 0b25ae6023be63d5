#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include <fmt/core.h>

#include "mlab/base/counted.h"
#include "mlab/schema/route_way.h"
#include "mlab/schema/way.h"

namespace mlab::schema {
namespace {

// What is nearest to a straight line on either side of it, where it passes between two things.
std::optional<std::string> gap_on(const percept::KnownGround& ground, geom::Segment line) {
  struct Side {
    double away = std::numeric_limits<double>::infinity();  // from the line [m]
    geom::Point place;
  };
  Side left;
  Side right;
  const auto offer = [&](geom::Point place, geom::Point on_line) {
    const double away = distance(place, on_line);
    Side& side = cross(line.b - line.a, place - line.a) > 0.0 ? left : right;
    if (away < side.away) side = {away, place};
  };
  for (const ways::Round& disc : ground.discs) {
    const geom::Point on_line = nearest_point(line, disc.center);
    offer(disc.center + unit(on_line - disc.center) * disc.radius, on_line);
  }
  for (const geom::Segment& wall : ground.walls) {
    for (const geom::Point end : {wall.a, wall.b}) offer(end, nearest_point(line, end));
    for (const geom::Point end : {line.a, line.b}) offer(nearest_point(wall, end), end);
  }
  constexpr double kGap = 20.0;  // [m]
  const double width = distance(left.place, right.place);
  // Things that don't face each other are no gap.
  if (!(width < kGap && width < 1.5 * (left.away + right.away))) return std::nullopt;
  const geom::Point middle = left.place + (right.place - left.place) * 0.5;
  return fmt::format("a gap of {:.2g} m at ({:.1f}, {:.1f}), which is too narrow,", width, middle.x,
                     middle.y);
}

}  // namespace

std::string what_blocks(const percept::KnownGround& ground, geom::Point from, geom::Point goal) {
  const geom::Offset along = goal - from;
  const double length2 = std::max(dot(along, along), 1e-12);
  double first = 2.0;  // share of the line
  std::string out;
  for (const ways::Round& disc : ground.discs) {
    const double at = std::clamp(dot(disc.center - from, along) / length2, 0.0, 1.0);
    if (distance(from + along * at, disc.center) > disc.radius || at >= first) continue;
    first = at;
    out = fmt::format("an obstacle of radius {:.1f} m at ({:.1f}, {:.1f})", disc.radius, disc.center.x,
                      disc.center.y);
  }
  for (std::size_t i = 0; i < ground.walls.size(); ++i) {
    const geom::Segment& wall = ground.walls[i];
    const geom::Offset side = wall.b - wall.a;
    const double slope = cross(along, side);
    if (!intersects({from, goal}, wall) || slope == 0.0) continue;
    const double at = cross(wall.a - from, side) / slope;
    if (at >= first) continue;
    first = at;
    const geom::Point there = from + along * at;
    out = fmt::format("{} at ({:.1f}, {:.1f})", ground.is_edge(i) ? "the edge of a minefield" : "a wall",
                      there.x, there.y);
  }
  if (first <= 1.0) return out;
  if (!ground.bounds.contains(goal)) return "the edge of the mission area";
  return gap_on(ground, {from, goal}).value_or("what stands around it");
}

std::string no_way_text(const percept::KnownGround& ground, geom::Point last, geom::Point goal) {
  return fmt::format("no way to ({:.0f}, {:.0f}) is known: {} is in front of it, {:.0f} m away", goal.x,
                     goal.y, what_blocks(ground, last, goal), distance(last, goal));
}

std::string beside_goal_text(const percept::KnownGround& ground, geom::Point last, geom::Point goal) {
  const bool is_outside = ground.revision != 0 && !ground.bounds.contains(goal);
  return fmt::format("{} ({:.0f}, {:.0f}); ({:.1f}, {:.1f}) is the nearest place to it",
                     is_outside ? "the mission area ends before" : "something stands at", goal.x, goal.y,
                     last.x, last.y);
}

std::string left_out_text(const percept::KnownGround& ground, std::span<const LeftOut> left_out) {
  const LeftOut& first = left_out.front();
  const std::string why = no_way_text(ground, first.last, first.place);
  if (left_out.size() == 1) return why + "; this corner is left out";
  return fmt::format("{}; it and {} more are left out", why, base::counted(left_out.size() - 1, "corner"));
}

std::string trap_text(geom::Point here, bool stands, double seconds) {
  return fmt::format(
      "{} near ({:.0f}, {:.0f}), no nearer to the goal for {:g} s; robots that plan their ways get out",
      stands ? "stands" : "goes round", here.x, here.y, seconds);
}

}  // namespace mlab::schema
