#include "mlab/ways/edges.h"

#include <algorithm>
#include <cmath>

namespace mlab::ways {
namespace {

void add_crossings(const Round& a, const Round& b, std::vector<geom::Point>& out) {
  const geom::Offset between = b.center - a.center;
  const double d = length(between);
  if (d <= 0.0 || d > a.radius + b.radius || d < std::abs(a.radius - b.radius)) return;
  const double along = (d * d + a.radius * a.radius - b.radius * b.radius) / (2.0 * d);
  const double aside = std::sqrt(std::max(0.0, a.radius * a.radius - along * along));
  const geom::Offset u = between * (1.0 / d);
  const geom::Point middle = a.center + u * along;
  out.push_back(middle + geom::Offset{-u.y, u.x} * aside);
  out.push_back(middle - geom::Offset{-u.y, u.x} * aside);
}

void add_crossings(const geom::Segment& s, const Round& c, std::vector<geom::Point>& out) {
  const geom::Offset w = s.b - s.a;
  const double l = length(w);
  if (l <= 0.0) return;
  const geom::Offset u = w * (1.0 / l);
  const double along = dot(c.center - s.a, u);
  const double aside = cross(u, c.center - s.a);
  if (std::abs(aside) > c.radius) return;
  const double half = std::sqrt(c.radius * c.radius - aside * aside);
  for (const double at : {along - half, along + half}) {
    if (at >= 0.0 && at <= l) out.push_back(s.a + u * at);
  }
}

void add_crossings(const geom::Segment& s, const geom::Segment& t, std::vector<geom::Point>& out) {
  const geom::Offset a = s.b - s.a;
  const geom::Offset b = t.b - t.a;
  const double area = cross(a, b);
  if (area == 0.0) return;
  const double at = cross(t.a - s.a, b) / area;
  const double of = cross(t.a - s.a, a) / area;
  if (at >= 0.0 && at <= 1.0 && of >= 0.0 && of <= 1.0) out.push_back(s.a + a * at);
}

}  // namespace

void Edges::add_sides(const geom::Segment& wall, double width) {
  const geom::Offset w = wall.b - wall.a;
  const double l = length(w);
  if (l <= 0.0) return;
  const geom::Offset aside = geom::Offset{-w.y, w.x} * (width / l);
  sides.push_back({wall.a + aside, wall.b + aside});
  sides.push_back({wall.a - aside, wall.b - aside});
}

void Edges::add_bounds(const Bounds& bounds, geom::Point p, double reach) {
  const Bounds near{std::max(bounds.x0, p.x - reach), std::max(bounds.y0, p.y - reach),
                    std::min(bounds.x1, p.x + reach), std::min(bounds.y1, p.y + reach)};
  sides.push_back({{near.x0, near.y0}, {near.x1, near.y0}});
  sides.push_back({{near.x1, near.y0}, {near.x1, near.y1}});
  sides.push_back({{near.x1, near.y1}, {near.x0, near.y1}});
  sides.push_back({{near.x0, near.y1}, {near.x0, near.y0}});
}

std::vector<geom::Point> Edges::points(geom::Point p) const {
  std::vector<geom::Point> out;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    const Round& one = circles[i];
    const double d = distance(p, one.center);
    const geom::Offset away = d > 0.0 ? (p - one.center) * (1.0 / d) : geom::Offset{1.0, 0.0};
    out.push_back(one.center + away * one.radius);
    for (std::size_t j = 0; j < i; ++j) add_crossings(one, circles[j], out);
    for (const geom::Segment& side : sides) add_crossings(side, one, out);
  }
  for (std::size_t i = 0; i < sides.size(); ++i) {
    out.push_back(nearest_point(sides[i], p));
    for (std::size_t j = 0; j < i; ++j) add_crossings(sides[i], sides[j], out);
  }
  return out;
}

}  // namespace mlab::ways
