#include "mlab/ways/open_arcs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mlab/ways/turn.h"

namespace mlab::ways {

void OpenArcs::take(double middle, double half) {
  if (half <= 0.0) return;
  if (half >= std::numbers::pi) {
    is_all_taken_ = true;
    return;
  }
  const double begin = in_turn(middle - half);
  taken_.push_back({begin, begin + 2.0 * half});
}

std::vector<Arc> OpenArcs::arcs() {
  if (is_all_taken_) return {};
  if (taken_.empty()) return {{0.0, kTurn}};
  std::ranges::sort(taken_, {}, &Arc::begin);
  std::vector<Arc> out;
  double begin = 0.0;
  for (const Arc& one : taken_) begin = std::max(begin, one.end - kTurn);  // from the end of the turn before
  for (const Arc& one : taken_) {
    if (one.begin > begin) out.push_back({begin, one.begin});
    begin = std::max(begin, one.end);
  }
  if (begin < kTurn) out.push_back({begin, kTurn});
  // What ends with the turn goes on with what begins it.
  if (out.size() > 1 && out.back().end == kTurn && out.front().begin == 0.0) {
    out.back().end += out.front().end;
    out.erase(out.begin());
  }
  return out;
}

void OpenArcs::block(const Round& disc) {
  const auto [center, radius] = circle_;
  const double d = distance(center, disc.center);
  if (d >= radius + disc.radius || d + disc.radius <= radius) return;
  if (d + radius <= disc.radius) {
    is_all_taken_ = true;
    return;
  }
  const double cosine = (d * d + radius * radius - disc.radius * disc.radius) / (2.0 * d * radius);
  take(direction(disc.center - center), std::acos(std::clamp(cosine, -1.0, 1.0)));
}

// Between neighbouring crossings of the circle with the band's four sides, all of it lies in the band or
// none.
void OpenArcs::block_band(const geom::Segment& wall, double width) {
  const geom::Offset w = wall.b - wall.a;
  const double l = length(w);
  if (l <= 0.0) return;
  const double radius = circle_.radius;
  const geom::Offset u = w * (1.0 / l);
  const geom::Offset m = circle_.center - wall.a;
  const double along = dot(m, u);
  const double aside = cross(u, m);
  if (along + radius <= 0.0 || along - radius >= l || std::abs(aside) - radius >= width) return;
  std::vector<double> cuts;
  const auto cut = [&](double distance, double angle) {  // a side so far away in that direction
    if (std::abs(distance) >= radius) return;
    const double half = std::acos(distance / radius);
    cuts.push_back(in_turn(angle + half));
    cuts.push_back(in_turn(angle - half));
  };
  const double base = direction(u);
  cut(-along, base);
  cut(l - along, base);
  cut(width - aside, base + std::numbers::pi / 2.0);
  cut(-width - aside, base + std::numbers::pi / 2.0);
  const auto is_in = [&](double angle) {
    const geom::Offset at = m + geom::Offset{radius * std::cos(angle), radius * std::sin(angle)};
    const double x = dot(at, u);
    return x > 0.0 && x < l && std::abs(cross(u, at)) < width;
  };
  if (cuts.empty()) {
    is_all_taken_ = is_all_taken_ || is_in(0.0);
    return;
  }
  std::ranges::sort(cuts);
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const double end = i + 1 < cuts.size() ? cuts[i + 1] : cuts.front() + kTurn;
    const double middle = 0.5 * (cuts[i] + end);
    if (is_in(middle)) take(middle, 0.5 * (end - cuts[i]));
  }
}

/// What lies farther away than that in the direction.
void OpenArcs::block_beyond(double distance, double angle) {
  if (distance >= circle_.radius) return;
  take(angle, distance <= -circle_.radius ? kTurn : std::acos(distance / circle_.radius));
}

void OpenArcs::block_outside(const Bounds& bounds) {
  const geom::Point center = circle_.center;
  block_beyond(bounds.x1 - center.x, 0.0);
  block_beyond(bounds.y1 - center.y, std::numbers::pi / 2.0);
  block_beyond(center.x - bounds.x0, std::numbers::pi);
  block_beyond(center.y - bounds.y0, -std::numbers::pi / 2.0);
}

}  // namespace mlab::ways
