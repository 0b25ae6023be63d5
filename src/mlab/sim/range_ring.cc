#include "mlab/sim/range_ring.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mlab/base/angle.h"

namespace mlab::sim {
namespace {

using geom::Vector;

constexpr double kTurn = 2.0 * std::numbers::pi;
/// Beams this near to the edge of what a thing can touch are looked at too [beams].
constexpr double kHair = 1e-4;

}  // namespace

RingBeams::RingBeams(const RangeRing& ring, double body_radius)
    : reach_(ring.range + body_radius),
      first_angle_(ring.first_angle),
      half_width_(std::clamp(ring.beam_width / 2, 0.0, std::numbers::pi / 2)),
      per_radian_(ring.arc > 0.0 && ring.count > 1 ? (ring.count - 1) / ring.arc : ring.count / kTurn),
      arc_(ring.arc > 0.0 ? ring.arc : 0.0) {
  for (int beam = 0; beam < ring.count; ++beam) {
    const double angle = ring.first_angle + beam / per_radian_;
    const auto direction = [](double a) { return Direction{std::cos(a), std::sin(a)}; };
    nothing_seen_.push_back(
        {static_cast<float>(base::wrap_angle(angle)), static_cast<float>(ring.range), false});
    axes_.push_back(direction(angle));
    if (half_width_ <= 0.0) continue;
    right_edges_.push_back(direction(angle - half_width_));
    left_edges_.push_back(direction(angle + half_width_));
  }
}

template <class Look>
void RingBeams::for_each_beam(double angle, double half_angle, Look&& look) const {
  const int n = static_cast<int>(axes_.size());
  if (arc_ > 0.0) {
    // Measured from the middle of the arc; what reaches round behind it may touch both ends.
    const double from_middle = base::wrap_angle(angle - first_angle_ - arc_ / 2);
    const double half = half_angle * per_radian_ + kHair;
    for (const double round : {0.0, -kTurn, kTurn}) {
      const double middle = (from_middle + arc_ / 2 + round) * per_radian_;
      const int first = static_cast<int>(std::ceil(std::clamp(middle - half, 0.0, static_cast<double>(n))));
      const int last = static_cast<int>(std::floor(std::clamp(middle + half, -1.0, n - 1.0)));
      for (int beam = first; beam <= last; ++beam) look(static_cast<std::size_t>(beam));
    }
    return;
  }
  const double middle = (angle - first_angle_) * per_radian_;
  const double half = half_angle * per_radian_ + kHair;
  const int first = static_cast<int>(std::ceil(middle - half));
  const int last = std::min(static_cast<int>(std::floor(middle + half)), first + n - 1);
  int beam = first % n;
  if (beam < 0) beam += n;
  for (int i = first; i <= last; ++i) {
    look(static_cast<std::size_t>(beam));
    if (++beam == n) beam = 0;
  }
}

void RingBeams::see_disc(Vector center, double radius, double reach, std::span<double> distances) const {
  const double square = center.x * center.x + center.y * center.y;
  const double farthest = reach + radius;
  if (square >= farthest * farthest) return;
  const double distance = std::sqrt(square);
  if (distance <= radius) {
    std::ranges::fill(distances, 0.0);
    return;
  }
  const double direction = std::atan2(center.y, center.x);
  const auto look_along = [&](Direction ray, std::size_t beam) {
    const double aside = std::abs(ray.x * center.y - ray.y * center.x);
    if (aside > radius) return;
    const double hit = ray.x * center.x + ray.y * center.y - std::sqrt((radius - aside) * (radius + aside));
    if (hit > 0.0) distances[beam] = std::min(distances[beam], hit);
  };
  const double half_angle = std::asin(radius / distance) + half_width_;
  for_each_beam(direction, half_angle, [&](std::size_t beam) {
    if (half_width_ <= 0.0) {
      look_along(axes_[beam], beam);
      return;
    }
    const double to_left = left_edges_[beam].x * center.y - left_edges_[beam].y * center.x;
    const double to_right = right_edges_[beam].x * center.y - right_edges_[beam].y * center.x;
    if (to_left <= 0.0 && to_right >= 0.0) {  // the centre lies in the cone
      distances[beam] = std::min(distances[beam], distance - radius);
    } else {
      look_along(left_edges_[beam], beam);
      look_along(right_edges_[beam], beam);
    }
  });
}

void RingBeams::see_wall(Vector a, Vector b, double reach, std::span<double> distances) const {
  const Vector along = b - a;
  const double square = dot(along, along);
  const double foot_share = square > 0.0 ? std::clamp(-dot(a, along) / square, 0.0, 1.0) : 0.0;
  const Vector foot = a + along * foot_share;
  const double nearest = length(foot);
  if (nearest >= reach) return;
  const double turn = std::atan2(cross(a, b), dot(a, b));
  const double middle = std::atan2(a.y, a.x) + turn / 2;
  const double offset = cross(a, along);
  const auto look_along = [&](Direction ray, std::size_t beam) {
    const double closing = ray.x * along.y - ray.y * along.x;
    if (closing == 0.0) return;
    const double hit = offset / closing;
    const double share = (a.x * ray.y - a.y * ray.x) / closing;
    if (hit >= 0.0 && share >= -1e-9 && share <= 1.0 + 1e-9) distances[beam] = std::min(distances[beam], hit);
  };
  for_each_beam(middle, std::abs(turn) / 2 + half_width_, [&](std::size_t beam) {
    if (half_width_ <= 0.0) {
      look_along(axes_[beam], beam);
      return;
    }
    const Vector left{left_edges_[beam].x, left_edges_[beam].y};
    const Vector right{right_edges_[beam].x, right_edges_[beam].y};
    for (const Vector point : {foot, a, b}) {
      if (cross(right, point) >= 0.0 && cross(left, point) <= 0.0 &&
          dot(left, point) + dot(right, point) > 0.0) {
        distances[beam] = std::min(distances[beam], length(point));
      }
    }
    look_along(left_edges_[beam], beam);
    look_along(right_edges_[beam], beam);
  });
}

}  // namespace mlab::sim
