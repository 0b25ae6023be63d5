#include "mlab/ways/clearing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mlab/ways/edges.h"
#include "mlab/ways/open_arcs.h"
#include "mlab/ways/turn.h"

namespace mlab::ways {
namespace {

constexpr double kNotMet = 2.0;  // along a straight piece, which is 0 .. 1

/// What of a straight piece lies within something: 0 <= from < to <= 1, or nothing of it.
struct Part {
  double from = 0.0;
  double to = 1.0;

  /// Of one coordinate, which is `at` first and grows by `step`, what lies between.
  void keep(double at, double step, double low, double high) {
    if (step == 0.0) {
      if (at <= low || at >= high) to = -1.0;
      return;
    }
    const double p = (low - at) / step;
    const double q = (high - at) / step;
    from = std::max(from, std::min(p, q));
    to = std::min(to, std::max(p, q));
  }
};

/// Where a straight piece enters a disc; kNotMet: it doesn't.
double enters_disc(geom::Segment s, geom::Point center, double radius) {
  const geom::Offset d = s.b - s.a;
  const geom::Offset m = s.a - center;
  const double c = dot(m, m) - radius * radius;
  if (c < 0.0) return 0.0;
  const double a = dot(d, d);
  const double b = dot(m, d);
  if (a <= 0.0 || b >= 0.0) return kNotMet;
  const double root = b * b - a * c;
  if (root <= 0.0) return kNotMet;
  const double t = (-b - std::sqrt(root)) / a;
  return t <= 1.0 ? t : kNotMet;
}

/// The same for the band along a wall, without its round ends.
double enters_band(geom::Segment s, geom::Segment wall, double width) {
  const geom::Offset w = wall.b - wall.a;
  const double l = length(w);
  if (l <= 0.0 || width <= 0.0) return kNotMet;
  const geom::Offset u = w * (1.0 / l);
  Part part;
  const geom::Offset a = s.a - wall.a;
  const geom::Offset d = s.b - s.a;
  part.keep(dot(a, u), dot(d, u), 0.0, l);
  part.keep(cross(u, a), cross(u, d), -width, width);
  return part.from < part.to ? part.from : kNotMet;
}

}  // namespace

Clearing::Clearing(const Ground& ground, double clearance) : ground_(ground), clearance_(clearance) {
  rounds_.reserve(ground.discs.size() + 2 * ground.walls.size());
  for (const Round& disc : ground.discs) rounds_.push_back({disc.center, disc.radius + clearance});
  std::vector<geom::Point> ends;
  for (const geom::Segment& wall : ground.walls) {
    ends.push_back(wall.a);
    ends.push_back(wall.b);
  }
  const auto is_before = [](geom::Point a, geom::Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  std::ranges::sort(ends, is_before);
  ends.erase(std::ranges::unique(ends).begin(), ends.end());
  for (const geom::Point end : ends) rounds_.push_back({end, clearance});
  enter_items();
}

Clearing::Cell Clearing::cell_of(geom::Point p) const {
  const auto index = [&](double at, double from, std::int32_t count) {
    // What is not below 0 is rounded down by the cast; std::floor is a call.
    return static_cast<std::int32_t>(std::clamp((at - from) / cell_, 0.0, static_cast<double>(count - 1)));
  };
  return {index(p.x, x0_, columns_), index(p.y, y0_, rows_)};
}

std::span<const std::uint32_t> Clearing::items(Cell cell) const {
  const auto at = static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(cell.x);
  return std::span(items_).subspan(starts_[at], starts_[at + 1] - starts_[at]);
}

void Clearing::enter_items() {
  const std::size_t discs = ground_.discs.size();
  const std::size_t count = discs + ground_.walls.size();
  struct Box {
    double x0, y0, x1, y1;
  };
  const auto box_of = [&](std::size_t item) {
    if (item < discs) {
      const Round& one = rounds_[item];
      return Box{one.center.x - one.radius, one.center.y - one.radius, one.center.x + one.radius,
                 one.center.y + one.radius};
    }
    const geom::Segment& wall = ground_.walls[item - discs];
    return Box{std::min(wall.a.x, wall.b.x) - clearance_, std::min(wall.a.y, wall.b.y) - clearance_,
               std::max(wall.a.x, wall.b.x) + clearance_, std::max(wall.a.y, wall.b.y) + clearance_};
  };
  starts_.assign(2, 0);
  if (count == 0) return;
  Box all = box_of(0);
  for (std::size_t i = 1; i < count; ++i) {
    const Box one = box_of(i);
    all = {std::min(all.x0, one.x0), std::min(all.y0, one.y0), std::max(all.x1, one.x1),
           std::max(all.y1, one.y1)};
  }
  x0_ = all.x0;
  y0_ = all.y0;
  const double width = std::max(all.x1 - all.x0, 1e-3);
  const double height = std::max(all.y1 - all.y0, 1e-3);
  // About two cells for each thing, but none so small that things lie in many of them.
  constexpr double kMostCells = 1U << 20U;
  const double wanted = std::min(2.0 * static_cast<double>(count) + 16.0, kMostCells);
  cell_ = std::max({std::sqrt(width * height / wanted), width / 4096.0, height / 4096.0, 1e-3});
  columns_ = static_cast<std::int32_t>(std::floor(width / cell_)) + 1;
  rows_ = static_cast<std::int32_t>(std::floor(height / cell_)) + 1;
  const auto each_cell = [&](std::size_t item, auto&& visit) {
    const Box box = box_of(item);
    const Cell low = cell_of({box.x0, box.y0});
    const Cell high = cell_of({box.x1, box.y1});
    for (std::int32_t y = low.y; y <= high.y; ++y) {
      for (std::int32_t x = low.x; x <= high.x; ++x) {
        if (item >= discs) {  // a wall lies in few of the cells of its box
          const geom::Segment& wall = ground_.walls[item - discs];
          const geom::Point middle{x0_ + (x + 0.5) * cell_, y0_ + (y + 0.5) * cell_};
          if (distance(nearest_point(wall, middle), middle) > clearance_ + cell_ * 0.7072) continue;
        }
        visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x));
      }
    }
  };
  starts_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (std::size_t i = 0; i < count; ++i) each_cell(i, [&](std::size_t cell) { ++starts_[cell + 1]; });
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  items_.resize(starts_.back());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::size_t i = 0; i < count; ++i) {
    each_cell(i, [&](std::size_t cell) { items_[next[cell]++] = static_cast<std::uint32_t>(i); });
  }
}

/// Each once, in their order.
std::vector<std::uint32_t> Clearing::items_near(geom::Point p, double reach) const {
  const Cell low = cell_of({p.x - reach, p.y - reach});
  const Cell high = cell_of({p.x + reach, p.y + reach});
  std::vector<std::uint32_t> out;
  for (std::int32_t y = low.y; y <= high.y; ++y) {
    for (std::int32_t x = low.x; x <= high.x; ++x) {
      const auto in_cell = items({x, y});
      out.insert(out.end(), in_cell.begin(), in_cell.end());
    }
  }
  std::ranges::sort(out);
  out.erase(std::ranges::unique(out).begin(), out.end());
  return out;
}

bool Clearing::blocks(std::uint32_t item, geom::Point p) const {
  if (item < ground_.discs.size()) {
    const double reach = rounds_[item].radius - kTolerance;
    return distance(rounds_[item].center, p) < reach;
  }
  const geom::Segment& wall = ground_.walls[item - ground_.discs.size()];
  return distance(nearest_point(wall, p), p) < clearance_ - kTolerance;
}

bool Clearing::is_free(geom::Point p) const {
  if (!ground_.bounds.contains(p)) return false;
  if (items_.empty()) return true;
  return std::ranges::none_of(items(cell_of(p)), [&](std::uint32_t item) { return blocks(item, p); });
}

double Clearing::met_at(std::uint32_t item, geom::Segment s) const {
  if (item < ground_.discs.size())
    return enters_disc(s, rounds_[item].center, rounds_[item].radius - kTolerance);
  const geom::Segment& wall = ground_.walls[item - ground_.discs.size()];
  const double width = clearance_ - kTolerance;
  if (width <= 0.0) return intersects(s, wall) ? 0.5 : kNotMet;
  return std::min(
      {enters_disc(s, wall.a, width), enters_disc(s, wall.b, width), enters_band(s, wall, width)});
}

/// Calls visit(item, most) for what lies in the cells along the piece, in their order; `most`: how far along
/// the piece (0 .. 1) its cell reaches. An item may come several times. True from `visit` ends it.
template <class Visit>
bool Clearing::walk(geom::Segment s, Visit&& visit) const {
  if (items_.empty()) return false;
  const geom::Offset d = s.b - s.a;
  Part part;  // that lies over the grid
  part.keep(s.a.x, d.x, x0_, x0_ + columns_ * cell_);
  part.keep(s.a.y, d.y, y0_, y0_ + rows_ * cell_);
  if (part.from > part.to) return false;
  Cell cell = cell_of(s.a + d * part.from);
  const std::int32_t step_x = d.x > 0.0 ? 1 : -1;
  const std::int32_t step_y = d.y > 0.0 ? 1 : -1;
  const auto edge = [&](std::int32_t index, std::int32_t step, double origin, double at, double along) {
    if (along == 0.0) return std::numeric_limits<double>::infinity();
    return (origin + (index + (step > 0 ? 1 : 0)) * cell_ - at) / along;
  };
  while (true) {
    const double next_x = edge(cell.x, step_x, x0_, s.a.x, d.x);
    const double next_y = edge(cell.y, step_y, y0_, s.a.y, d.y);
    const double most = std::min(next_x, next_y);
    for (const std::uint32_t item : items(cell)) {
      if (visit(item, most)) return true;
    }
    if (most >= part.to) return false;
    if (next_x < next_y)
      cell.x += step_x;
    else
      cell.y += step_y;
    if (cell.x < 0 || cell.y < 0 || cell.x >= columns_ || cell.y >= rows_) return false;
  }
}

std::optional<std::uint32_t> Clearing::first_hit(geom::Segment s) const {
  std::optional<std::uint32_t> out;
  double first = 1.5;
  double reached = 0.0;  // all that is met before is known
  walk(s, [&](std::uint32_t item, double most) {
    if (most != reached && first <= reached) return true;
    reached = most;
    if (const double at = met_at(item, s); at < first) {
      first = at;
      out = item;
    }
    return false;
  });
  return out;
}

bool Clearing::is_free(geom::Segment s) const {
  if (!ground_.bounds.contains(s.a) || !ground_.bounds.contains(s.b)) return false;
  return !walk(s, [&](std::uint32_t item, double) { return met_at(item, s) <= 1.0; });
}

std::vector<Arc> Clearing::free_arcs(std::uint32_t round) const {
  const auto [center, radius] = rounds_[round];
  if (radius <= 0.0) return is_free(center) ? std::vector<Arc>{{0.0, kTurn}} : std::vector<Arc>();
  OpenArcs open({center, radius});
  const double width = clearance_ - kTolerance;
  for (const std::uint32_t item : items_near(center, radius)) {
    if (item < ground_.discs.size()) {
      if (item != round) open.block({rounds_[item].center, rounds_[item].radius - kTolerance});
      continue;
    }
    const geom::Segment& wall = ground_.walls[item - ground_.discs.size()];
    if (wall.a != center) open.block({wall.a, width});
    if (wall.b != center) open.block({wall.b, width});
    open.block_band(wall, width);
  }
  open.block_outside(ground_.bounds);
  return open.arcs();
}

// Of everything so near: where its edge is nearest, and where two edges meet.
std::vector<geom::Point> Clearing::edge_points(geom::Point p, double reach) const {
  Edges edges;
  for (const std::uint32_t item : items_near(p, reach)) {
    if (item < ground_.discs.size()) {
      edges.circles.push_back(rounds_[item]);
      continue;
    }
    const geom::Segment& wall = ground_.walls[item - ground_.discs.size()];
    edges.circles.push_back({wall.a, clearance_});
    edges.circles.push_back({wall.b, clearance_});
    edges.add_sides(wall, clearance_);
  }
  edges.add_bounds(ground_.bounds, p, reach);
  return edges.points(p);
}

// Whether everything that there is lies within reach of a place.
bool Clearing::is_all(geom::Point p, double reach) const {
  return reach > 2.0 * (cell_ * static_cast<double>(columns_ + rows_) + distance(p, {x0_, y0_}));
}

std::optional<geom::Point> Clearing::nearest_free(geom::Point p) const {
  const Bounds& bounds = ground_.bounds;
  const geom::Point inside{std::clamp(p.x, bounds.x0, bounds.x1), std::clamp(p.y, bounds.y0, bounds.y1)};
  if (is_free(inside)) return inside;
  for (double reach = std::max(4.0 * clearance_, 2.0 * cell_);; reach *= 2.0) {
    std::optional<geom::Point> out;
    for (const geom::Point one : edge_points(p, reach)) {
      if (distance(one, p) <= reach && (!out || distance(one, p) < distance(*out, p)) && is_free(one))
        out = one;
    }
    if (out || is_all(p, reach)) return out;
  }
}

std::vector<geom::Point> Clearing::free_places(geom::Point p, std::size_t most) const {
  for (double reach = std::max(4.0 * clearance_, 2.0 * cell_);; reach *= 2.0) {
    std::vector<geom::Point> out = edge_points(p, reach);
    std::erase_if(out, [&](geom::Point one) { return distance(one, p) > reach || !is_free(one); });
    if (out.size() < most && !is_all(p, reach)) continue;
    std::ranges::sort(out, {}, [&](geom::Point one) { return distance(one, p); });
    out.resize(std::min(out.size(), most));
    return out;
  }
}

}  // namespace mlab::ways
