#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <queue>
#include <random>
#include <utility>
#include <vector>

#include "mlab/ways/clearing.h"

namespace mlab::ways::testing {

/// How far somebody is from the nearest thing on a ground, told by looking at all of them [m].
inline double room_at(const Ground& ground, geom::Point p) {
  double out = std::numeric_limits<double>::infinity();
  for (const Round& disc : ground.discs) out = std::min(out, distance(disc.center, p) - disc.radius);
  for (const geom::Segment& wall : ground.walls) out = std::min(out, distance(nearest_point(wall, p), p));
  return out;
}

/// Discs and walls anywhere on a square; some cross each other.
template <class Random>
Ground any_ground(Random& random, double side, int discs, int walls) {
  std::uniform_real_distribution<double> place(0.0, side);
  std::uniform_real_distribution<double> radius(0.01 * side, 0.08 * side);
  Ground out;
  out.bounds = {0.0, 0.0, side, side};
  for (int i = 0; i < discs; ++i) out.discs.push_back({{place(random), place(random)}, radius(random)});
  for (int i = 0; i < walls; ++i) {
    const geom::Point a{place(random), place(random)};
    const double angle = place(random) / side * 2.0 * std::numbers::pi;
    const double length = 0.05 * side + 0.3 * place(random);
    out.walls.push_back({a, a + geom::Offset{length * std::cos(angle), length * std::sin(angle)}});
  }
  return out;
}

/// Shortest ways over the points of a square grid and their eight neighbours: what does without tangents.
class GridWays {
 public:
  GridWays(const Ground& ground, double clearance, double side, double step)
      : step_(step), count_(static_cast<int>(side / step) + 1) {
    for (int y = 0; y < count_; ++y) {
      for (int x = 0; x < count_; ++x) free_.push_back(room_at(ground, {x * step, y * step}) >= clearance);
    }
  }

  bool is_free(geom::Point p) const { return free_[at(p)]; }
  geom::Point snapped(geom::Point p) const {
    return {std::round(p.x / step_) * step_, std::round(p.y / step_) * step_};
  }
  /// [m]; infinite: there is none.
  double length(geom::Point from, geom::Point to) const {
    std::vector<double> known(free_.size(), std::numeric_limits<double>::infinity());
    using Open = std::pair<double, std::size_t>;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
    known[at(from)] = 0.0;
    open.emplace(0.0, at(from));
    while (!open.empty()) {
      const auto [cost, here] = open.top();
      open.pop();
      if (here == at(to)) return cost;
      if (cost > known[here]) continue;
      const int x = static_cast<int>(here) % count_;
      const int y = static_cast<int>(here) / count_;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          if (x + dx < 0 || y + dy < 0 || x + dx >= count_ || y + dy >= count_) continue;
          const std::size_t next = here + static_cast<std::size_t>(dy * count_ + dx);
          const double beyond = cost + step_ * geom::length(geom::Offset{1.0 * dx, 1.0 * dy});
          if (!free_[next] || beyond >= known[next]) continue;
          known[next] = beyond;
          open.emplace(beyond, next);
        }
      }
    }
    return std::numeric_limits<double>::infinity();
  }

 private:
  std::size_t at(geom::Point p) const {
    return static_cast<std::size_t>(std::lround(p.y / step_) * count_ + std::lround(p.x / step_));
  }

  double step_;
  int count_;
  std::vector<bool> free_;
};

}  // namespace mlab::ways::testing
