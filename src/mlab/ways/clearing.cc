#include "mlab/ways/clearing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mlab/ways/turn.h"

namespace mlab::ways {
namespace {

/// Where a straight piece (0 .. 1) enters a disc; more than 1: it doesn't.
double enters_disc(geom::Segment s, geom::Point center, double radius) {
  constexpr double kNever = 2.0;
  const geom::Offset d = s.b - s.a;
  const geom::Offset m = s.a - center;
  const double c = dot(m, m) - radius * radius;
  if (c < 0.0) return 0.0;
  const double a = dot(d, d);
  const double b = dot(m, d);
  if (a <= 0.0 || b >= 0.0) return kNever;
  const double root = b * b - a * c;
  if (root <= 0.0) return kNever;
  const double t = (-b - std::sqrt(root)) / a;
  return t <= 1.0 ? t : kNever;
}

/// The same for the band along a wall, without its round ends.
double enters_band(geom::Segment s, geom::Segment wall, double width) {
  constexpr double kNever = 2.0;
  const geom::Offset w = wall.b - wall.a;
  const double l = length(w);
  if (l <= 0.0 || width <= 0.0) return kNever;
  const geom::Offset u = w * (1.0 / l);
  double from = 0.0;
  double to = 1.0;
  const auto clip = [&](double at, double step, double low, double high) {
    if (step == 0.0) {
      if (at <= low || at >= high) to = -1.0;
      return;
    }
    const double p = (low - at) / step;
    const double q = (high - at) / step;
    from = std::max(from, std::min(p, q));
    to = std::min(to, std::max(p, q));
  };
  const geom::Offset a = s.a - wall.a;
  const geom::Offset d = s.b - s.a;
  clip(dot(a, u), dot(d, u), 0.0, l);
  clip(cross(u, a), cross(u, d), -width, width);
  return from < to ? from : kNever;
}

/// Blocked pieces of a circle, as angles; `end` may be beyond a turn.
class Blocked {
 public:
  void add(double middle, double half) {
    if (half <= 0.0) return;
    if (half >= std::numbers::pi) {
      is_all_ = true;
      return;
    }
    const double begin = in_turn(middle - half);
    pieces_.push_back({begin, begin + 2.0 * half});
  }
  std::vector<Clearing::Arc> rest() {
    if (is_all_) return {};
    if (pieces_.empty()) return {{0.0, kTurn}};
    std::ranges::sort(pieces_, {}, &Clearing::Arc::begin);
    std::vector<Clearing::Arc> out;
    double reached = 0.0;  // how far the last turn's pieces reach into this one
    for (const Clearing::Arc& one : pieces_) reached = std::max(reached, one.end - kTurn);
    double begin = reached;
    for (const Clearing::Arc& one : pieces_) {
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

 private:
  bool is_all_ = false;
  std::vector<Clearing::Arc> pieces_;
};

/// Where free ground may begin.
struct Edges {
  std::vector<Round> circles;
  std::vector<geom::Segment> sides;

  void add_sides(const geom::Segment& wall, double width) {
    const geom::Offset w = wall.b - wall.a;
    const double l = length(w);
    if (l <= 0.0) return;
    const geom::Offset aside = geom::Offset{-w.y, w.x} * (width / l);
    sides.push_back({wall.a + aside, wall.b + aside});
    sides.push_back({wall.a - aside, wall.b - aside});
  }
  void add_bounds(const Bounds& bounds, geom::Point p, double reach) {
    const Bounds near{std::max(bounds.x0, p.x - reach), std::max(bounds.y0, p.y - reach),
                      std::min(bounds.x1, p.x + reach), std::min(bounds.y1, p.y + reach)};
    sides.push_back({{near.x0, near.y0}, {near.x1, near.y0}});
    sides.push_back({{near.x1, near.y0}, {near.x1, near.y1}});
    sides.push_back({{near.x1, near.y1}, {near.x0, near.y1}});
    sides.push_back({{near.x0, near.y1}, {near.x0, near.y0}});
  }
  std::vector<geom::Point> points(geom::Point p) const;
};

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
    return static_cast<std::int32_t>(
        std::clamp(std::floor((at - from) / cell_), 0.0, static_cast<double>(count - 1)));
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
  return std::ranges::none_of(items(cell_of(p)), [&](std::uint32_t item) { return blocks(item, p); });
}

double Clearing::met_at(std::uint32_t item, geom::Segment s) const {
  if (item < ground_.discs.size())
    return enters_disc(s, rounds_[item].center, rounds_[item].radius - kTolerance);
  const geom::Segment& wall = ground_.walls[item - ground_.discs.size()];
  const double width = clearance_ - kTolerance;
  if (width <= 0.0) return intersects(s, wall) ? 0.5 : 2.0;
  return std::min(
      {enters_disc(s, wall.a, width), enters_disc(s, wall.b, width), enters_band(s, wall, width)});
}

/// Calls visit(item, most) for what lies in the cells along the piece, in their order; `most`: how far along
/// the piece (0 .. 1) its cell reaches. An item may come several times. True from `visit` ends it.
template <class Visit>
bool Clearing::walk(geom::Segment s, Visit&& visit) const {
  if (items_.empty()) return false;
  const geom::Offset d = s.b - s.a;
  // Only what lies over the grid.
  double from = 0.0;
  double to = 1.0;
  const auto clip = [&](double at, double step, double low, double high) {
    if (step == 0.0) {
      if (at < low || at > high) to = -1.0;
      return;
    }
    const double p = (low - at) / step;
    const double q = (high - at) / step;
    from = std::max(from, std::min(p, q));
    to = std::min(to, std::max(p, q));
  };
  clip(s.a.x, d.x, x0_, x0_ + columns_ * cell_);
  clip(s.a.y, d.y, y0_, y0_ + rows_ * cell_);
  if (from > to) return false;
  Cell cell = cell_of(s.a + d * from);
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
    if (most >= to) return false;
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

std::vector<Clearing::Arc> Clearing::free_arcs(std::uint32_t round) const {
  const auto [center, radius] = rounds_[round];
  Blocked blocked;
  if (radius <= 0.0) {
    if (!is_free(center)) return {};
    return {{0.0, kTurn}};
  }
  const auto add_disc = [&](geom::Point other, double reach) {
    const double d = distance(center, other);
    if (d >= radius + reach || d + reach <= radius) return;
    if (d + radius <= reach) {
      blocked.add(0.0, kTurn);
      return;
    }
    const double cosine = (d * d + radius * radius - reach * reach) / (2.0 * d * radius);
    blocked.add(direction(other - center), std::acos(std::clamp(cosine, -1.0, 1.0)));
  };
  const auto add_half_plane = [&](double angle, double far) {  // what lies farther than `far` that way
    if (far >= radius) return;
    blocked.add(angle, far <= -radius ? kTurn : std::acos(far / radius));
  };
  const auto add_band = [&](const geom::Segment& wall, double width) {
    const geom::Offset w = wall.b - wall.a;
    const double l = length(w);
    if (l <= 0.0) return;
    const geom::Offset u = w * (1.0 / l);
    const geom::Offset m = center - wall.a;
    const double along = dot(m, u);
    const double aside = cross(u, m);
    if (along + radius <= 0.0 || along - radius >= l || std::abs(aside) - radius >= width) return;
    // Where the circle crosses the band's four sides.
    std::vector<double> cuts;
    const double base = direction(u);
    const auto cut = [&](double distance, double angle) {  // a side so far away in that direction
      if (std::abs(distance) >= radius) return;
      const double half = std::acos(distance / radius);
      cuts.push_back(in_turn(angle + half));
      cuts.push_back(in_turn(angle - half));
    };
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
      if (is_in(0.0)) blocked.add(0.0, kTurn);
      return;
    }
    std::ranges::sort(cuts);
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      const double begin = cuts[i];
      const double end = i + 1 < cuts.size() ? cuts[i + 1] : cuts.front() + kTurn;
      const double middle = 0.5 * (begin + end);
      if (is_in(middle)) blocked.add(middle, 0.5 * (end - begin));
    }
  };
  const std::vector<std::uint32_t> near = items_near(center, radius);
  for (const std::uint32_t item : near) {
    if (item < ground_.discs.size()) {
      if (item != round) add_disc(rounds_[item].center, rounds_[item].radius - kTolerance);
      continue;
    }
    const geom::Segment& wall = ground_.walls[item - ground_.discs.size()];
    const double width = clearance_ - kTolerance;
    if (wall.a != center) add_disc(wall.a, width);
    if (wall.b != center) add_disc(wall.b, width);
    add_band(wall, width);
  }
  const Bounds& bounds = ground_.bounds;
  add_half_plane(0.0, bounds.x1 - center.x);
  add_half_plane(std::numbers::pi / 2.0, bounds.y1 - center.y);
  add_half_plane(std::numbers::pi, center.x - bounds.x0);
  add_half_plane(-std::numbers::pi / 2.0, center.y - bounds.y0);
  return blocked.rest();
}

// The nearest one lies on the edge of something that has grown: where that is nearest, or where two meet.
std::optional<geom::Point> Clearing::nearest_free(geom::Point p) const {
  const Bounds& bounds = ground_.bounds;
  const geom::Point inside{std::clamp(p.x, bounds.x0, bounds.x1), std::clamp(p.y, bounds.y0, bounds.y1)};
  if (is_free(inside)) return inside;
  for (double reach = std::max(4.0 * clearance_, 2.0 * cell_);; reach *= 2.0) {
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
    edges.add_bounds(bounds, p, reach);
    std::optional<geom::Point> out;
    for (const geom::Point one : edges.points(p)) {
      if (distance(one, p) <= reach && (!out || distance(one, p) < distance(*out, p)) && is_free(one))
        out = one;
    }
    const double all = cell_ * std::hypot(columns_, rows_) + distance(p, {x0_, y0_});
    if (out || reach > 2.0 * all) return out;
  }
}

}  // namespace mlab::ways
