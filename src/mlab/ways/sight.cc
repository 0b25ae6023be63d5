#include "mlab/ways/sight.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mlab::ways {
namespace {

geom::Point point_of(LanePlace p) {
  return {p.along, p.across};
}

bool stands_between(const geom::Segment& wall, const geom::Segment& look) {
  const geom::Offset along = wall.b - wall.a;
  if (cross(along, look.a - wall.a) * cross(along, look.b - wall.a) >= 0.0) return false;
  const geom::Offset ahead = look.b - look.a;
  return cross(ahead, wall.a - look.a) * cross(ahead, wall.b - look.a) <= 0.0;
}
bool stands_between(std::span<const geom::Segment> walls, const geom::Segment& look) {
  return std::ranges::any_of(walls, [&](const geom::Segment& wall) { return stands_between(wall, look); });
}

}  // namespace

Sight::Sight(const Lanes& lanes, std::span<const geom::Segment> walls, double reach) : box_(2.0 * reach) {
  if (walls.empty()) return;
  // One more on each side, for what lies beside the rectangle.
  boxes_along_ = static_cast<int>(std::ceil(lanes.length / box_)) + 2;
  boxes_across_ = static_cast<int>(std::ceil(lanes.spacing * lanes.count / box_)) + 2;
  walls_.resize(static_cast<std::size_t>(boxes_along_) * static_cast<std::size_t>(boxes_across_));
  const double near = reach + 0.7072 * box_;  // of a box's middle
  for (const geom::Segment& one : walls) {
    const geom::Segment wall{point_of(lanes.to_lanes(one.a)), point_of(lanes.to_lanes(one.b))};
    const int last_across = box_across(std::max(wall.a.y, wall.b.y) + reach);
    const int last_along = box_along(std::max(wall.a.x, wall.b.x) + reach);
    for (int y = box_across(std::min(wall.a.y, wall.b.y) - reach); y <= last_across; ++y) {
      for (int x = box_along(std::min(wall.a.x, wall.b.x) - reach); x <= last_along; ++x) {
        const geom::Point middle{(x - 0.5) * box_, (y - 0.5) * box_};
        if (distance(nearest_point(wall, middle), middle) > near) continue;
        walls_[static_cast<std::size_t>(y) * static_cast<std::size_t>(boxes_along_) +
               static_cast<std::size_t>(x)]
            .push_back(wall);
      }
    }
  }
}

int Sight::box_along(double along) const {
  return static_cast<int>(std::clamp(std::floor(along / box_) + 1.0, 0.0, boxes_along_ - 1.0));
}
int Sight::box_across(double across) const {
  return static_cast<int>(std::clamp(std::floor(across / box_) + 1.0, 0.0, boxes_across_ - 1.0));
}

const std::vector<geom::Segment>& Sight::walls_near(LanePlace p) const {
  return walls_[static_cast<std::size_t>(box_across(p.across)) * static_cast<std::size_t>(boxes_along_) +
                static_cast<std::size_t>(box_along(p.along))];
}

bool Sight::hides(LanePlace p, LanePlace from) const {
  return !is_open() && stands_between(walls_near(p), {point_of(p), point_of(from)});
}

bool Sight::sees(LanePlace p, LanePlace a, LanePlace b, double reach) const {
  if (is_open()) return true;
  const std::vector<geom::Segment>& walls = walls_near(p);
  if (walls.empty()) return true;
  const geom::Point here = point_of(p);
  const geom::Segment piece{point_of(a), point_of(b)};
  if (!stands_between(walls, {here, nearest_point(piece, here)})) return true;
  return std::ranges::any_of(std::array{piece.a, piece.b}, [&](geom::Point end) {
    return distance(end, here) <= reach && !stands_between(walls, {here, end});
  });
}

}  // namespace mlab::ways
