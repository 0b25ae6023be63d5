#include "mlab/schema/route.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace mlab::schema {

double route_length(std::span<const geom::Point> route) {
  double sum = 0.0;
  for (std::size_t i = 1; i < route.size(); ++i) sum += geom::distance(route[i - 1], route[i]);
  return sum;
}

geom::Point route_point(std::span<const geom::Point> route, double way) {
  if (route.empty()) return {};
  if (!(way > 0.0)) return route.front();
  for (std::size_t i = 1; i < route.size(); ++i) {
    const geom::Offset along = route[i] - route[i - 1];
    const double leg = geom::length(along);
    if (way < leg) return route[i - 1] + along * (way / leg);
    way -= leg;
  }
  return route.back();
}

std::array<geom::Point, 3> route_points(std::span<const geom::Point> route, std::array<double, 3> ways) {
  std::array<geom::Point, 3> out{};
  if (route.empty()) return out;
  out.fill(route.back());
  std::size_t found = 0;
  for (; found < out.size() && !(ways[found] > 0.0); ++found) out[found] = route.front();
  for (std::size_t i = 1; i < route.size() && found < out.size(); ++i) {
    const geom::Offset along = route[i] - route[i - 1];
    const double leg = geom::length(along);
    for (; found < out.size() && ways[found] < leg; ++found)
      out[found] = route[i - 1] + along * (ways[found] / leg);
    for (std::size_t k = found; k < out.size(); ++k) ways[k] -= leg;
  }
  return out;
}

double nearest_way(std::span<const geom::Point> route, geom::Point p, double from, double to) {
  double best = from;
  double best_distance2 = std::numeric_limits<double>::infinity();
  double best_distance = best_distance2;
  double start = 0.0;
  for (std::size_t i = 1; i < route.size() && start <= to; ++i) {
    const geom::Offset along = route[i] - route[i - 1];
    const double leg = geom::length(along);
    if (leg > 0.0 && start + leg >= from) {
      const double projected = geom::dot(p - route[i - 1], along) / leg;
      const double low = std::max(0.0, from - start);
      const double high = std::max(low, std::min(leg, to - start));  // the last digit of a sum may say less
      const double way = std::clamp(projected, low, high);
      const geom::Offset off = route[i - 1] + along * (way / leg) - p;
      // Two squares may have one root: then the first place counts.
      const double d2 = geom::dot(off, off);
      const double d = d2 < best_distance2 ? std::sqrt(d2) : best_distance;
      if (d < best_distance) {
        best_distance2 = d2;
        best_distance = d;
        best = start + way;
      }
    }
    start += leg;
  }
  return best;
}

}  // namespace mlab::schema
