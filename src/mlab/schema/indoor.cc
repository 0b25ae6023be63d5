#include "mlab/schema/indoor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mlab::schema {
namespace {

using geom::Offset;
using geom::Point;

/// Nearer than this the robot is there [m].
constexpr double kDocked = 0.05;
/// To each side of a look [rad].
constexpr double kHalfLook = 6.0 * std::numbers::pi / 180.0;

Offset unit_or_zero(Offset o) {
  const double size = length(o);
  return size > geom::kZeroLength ? o * (1.0 / size) : Offset{};
}

}  // namespace

bool is_in(const percept::Room& room, Point place) {
  bool inside = false;
  for (std::size_t i = 0; i < room.outline.size(); ++i) {
    const Point a = room.outline[i];
    const Point b = room.outline[i + 1 == room.outline.size() ? 0 : i + 1];
    if ((a.y > place.y) == (b.y > place.y)) continue;
    if (place.x < a.x + (b.x - a.x) * (place.y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

bool is_in(const percept::Hallway& hallway, Point place) {
  const Offset along = hallway.end - hallway.start;
  const double size = length(along);
  if (!(size > geom::kZeroLength)) return false;
  const Offset way = place - hallway.start;
  const double ahead = dot(way, along) / size;
  return ahead >= 0.0 && ahead <= size && std::abs(cross(along, way)) / size <= hallway.width / 2;
}

bool is_in_room(const percept::SiteMap& map, Point place) {
  return std::ranges::any_of(map.rooms, [&](const percept::Room& room) { return is_in(room, place); });
}

const percept::Hallway* hallway_at(const percept::SiteMap& map, Point place) {
  const auto at =
      std::ranges::find_if(map.hallways, [&](const auto& hallway) { return is_in(hallway, place); });
  return at == map.hallways.end() ? nullptr : &*at;
}

std::uint32_t nearest_door(const percept::SiteMap& map, Point place, bool only_unmarked) {
  std::uint32_t best = 0;
  double least = 0.0;
  for (std::uint32_t i = 0; i < map.doors.size(); ++i) {
    const percept::Door& one = map.doors[i];
    if (only_unmarked && one.is_marked) continue;
    const double away = distance(place, nearest_point({one.a, one.b}, place));
    if (best != 0 && away >= least) continue;
    best = i + 1;
    least = away;
  }
  return best;
}

std::optional<percept::Door> door(const percept::SiteMap& map, std::uint32_t number) {
  if (number == 0 || number > map.doors.size()) return std::nullopt;
  return map.doors[number - 1];
}

Passage passage(const percept::Door& door, Point from, double depth) {
  const Offset across = door.b - door.a;
  const Point middle = door.a + across * 0.5;
  const Offset normal = unit_or_zero({-across.y, across.x});
  const double side = dot(normal, from - middle) > 0.0 ? -1.0 : 1.0;
  return {middle, middle + normal * (side * depth), length(across) / 2};
}

Offset dock_direction(Point robot, Point dock, double approach, const DockField& field) {
  const Offset way = dock - robot;
  const double away = length(way);
  if (away <= kDocked) return {};
  const Offset goal = way * (1.0 / away);
  if (away > field.controlled_radius) return goal * field.ballistic_gain;
  const Offset axis{std::cos(approach), std::sin(approach)};
  const Offset from_dock = way * -1.0;
  const double angle = std::abs(std::atan2(cross(axis, from_dock), dot(axis, from_dock)));
  // Square to the way to the dock, to the side on which the axis lies.
  const double side = cross(axis, from_dock) > 0.0 ? 1.0 : -1.0;
  const Offset tangent{from_dock.y / away * side, -from_dock.x / away * side};
  const double pull = field.controlled_gain;
  if (angle < field.cone) return tangent * (pull * angle / field.cone) + goal * pull;
  return tangent * pull + goal * (pull * away / field.controlled_radius);
}

bool looks_at(const percept::Door& door, Point from, double heading, double range) {
  constexpr double kAside[] = {0.0, -kHalfLook, kHalfLook};
  return std::ranges::any_of(kAside, [&](double aside) {
    const Offset ray = Offset{std::cos(heading + aside), std::sin(heading + aside)} * range;
    return geom::intersects({from, from + ray}, {door.a, door.b});
  });
}

}  // namespace mlab::schema
