#include "mlab/overlay/barriers.h"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "mlab/overlay/measure_kinds.h"

namespace mlab::overlay {
namespace {

// Which measure: its own number among those with barriers, and its place in the overlay.
struct Origin {
  std::uint32_t group = 0;
  std::uint32_t measure = 0;
};

void add_line(std::vector<Barrier>& out, const std::vector<geom::Point>& points, bool is_closed,
              Origin origin) {
  const auto add = [&](geom::Point a, geom::Point b) {
    out.push_back({{a, b}, origin.group, origin.measure});
  };
  for (std::size_t i = 0; i + 1 < points.size(); ++i) add(points[i], points[i + 1]);
  if (is_closed && points.size() > 2) add(points.back(), points.front());
}

// The edge of an area: through the corners of the measure, or around its only point.
void add_edge(std::vector<Barrier>& out, const ControlMeasure& measure, Origin origin) {
  constexpr int kCornersOfCircle = 24;
  std::vector<geom::Point> corners = measure.points;
  if (corners.size() == 1) {
    // Around the circle, not inside of it.
    const double radius = measure.size / 2.0 / std::cos(std::numbers::pi / kCornersOfCircle);
    const geom::Point center = corners.front();
    corners.clear();
    for (int i = 0; i < kCornersOfCircle; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kCornersOfCircle;
      corners.push_back({center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)});
    }
  }
  for (std::size_t i = 0; i < corners.size(); ++i)
    out.push_back({{corners[i], corners[(i + 1) % corners.size()]}, origin.group, origin.measure, false});
}

}  // namespace

std::vector<Barrier> barriers(const Overlay& overlay) {
  std::vector<Barrier> out;
  std::vector<Barrier> edges;
  Origin origin;
  for (const ControlMeasure& measure : overlay.measures) {
    const Substance substance = info(measure.kind).substance;
    if (substance == Substance::kSolid) {
      add_line(out, measure.points, false, origin);
      ++origin.group;
    } else if (substance == Substance::kAvoided) {
      add_edge(edges, measure, origin);
      ++origin.group;
    } else if (zone_kind(measure) == ZoneKind::kWeather) {
      add_line(out, measure.points, true, origin);
      ++origin.group;
    }
    ++origin.measure;
  }
  out.insert(out.end(), edges.begin(), edges.end());
  return out;
}

}  // namespace mlab::overlay
