#include "mlab/schema/local_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mlab::schema {
namespace {

using geom::Point;

constexpr int kSize = LocalMap::kSize;
/// No world is larger, counted in cells: keeps the arithmetic of integers whole.
constexpr double kFarthest = 1e15;

/// As a whole number within the bounds; the lower one for what is not a number.
template <class Integer>
Integer whole(double value, double low, double high) {
  return static_cast<Integer>(std::isnan(value) ? low : std::clamp(value, low, high));
}

std::int64_t index_of(double at, double cell) {
  return whole<std::int64_t>(std::floor(at / cell), -kFarthest, kFarthest);
}

std::size_t index_in(int x, int y) {
  return static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x);
}

// One coordinate of a line, seen from the borders of cells that it crosses.
struct Line {
  Line(double from, double to, double cell) : first(index_of(from, cell)), step(to >= from ? 1 : -1) {
    if (from == to) return;
    const double border = (static_cast<double>(first) + (step > 0 ? 1.0 : 0.0)) * cell;
    next = (border - from) / (to - from);
    between = cell / std::abs(to - from);
  }
  std::int64_t first;  // index of the cell where it starts
  int step;
  double next = std::numeric_limits<double>::infinity();     // share of the way up to the first border
  double between = std::numeric_limits<double>::infinity();  // share of the way from border to border
};

struct Step {
  int dx, dy, cost;
};
constexpr std::array<Step, 8> kSteps = {
    {{1, 0, 10}, {0, 1, 10}, {-1, 0, 10}, {0, -1, 10}, {1, 1, 14}, {-1, 1, 14}, {-1, -1, 14}, {1, -1, 14}}};

}  // namespace

void LocalMap::center(Point robot, double cell) {
  const std::int64_t x = index_of(robot.x, cell) - kSize / 2;
  const std::int64_t y = index_of(robot.y, cell) - kSize / 2;
  const std::int64_t dx = x - x0_;
  const std::int64_t dy = y - y0_;
  x0_ = x;
  y0_ = y;
  if (std::abs(dx) >= kSize || std::abs(dy) >= kSize) {
    rows_ = {};
    return;
  }
  const std::array<std::uint64_t, kSize> before = rows_;
  for (int row = 0; row < kSize; ++row) {
    const std::int64_t from = row + dy;
    const std::uint64_t bits = from >= 0 && from < kSize ? before[static_cast<std::size_t>(from)] : 0;
    rows_[static_cast<std::size_t>(row)] = dx >= 0 ? bits >> dx : bits << -dx;
  }
}

void LocalMap::block(Point center, double radius, double cell) {
  const auto clamped = [](double v) { return whole<int>(v, -1.0, kSize); };
  const double left = center.x / cell - static_cast<double>(x0_);
  const double low = center.y / cell - static_cast<double>(y0_);
  const double reach = radius / cell;
  for (int y = std::max(0, clamped(low - reach)); y <= std::min(kSize - 1, clamped(low + reach)); ++y) {
    for (int x = std::max(0, clamped(left - reach)); x <= std::min(kSize - 1, clamped(left + reach)); ++x) {
      const double ox = x + 0.5 - left;
      const double oy = y + 0.5 - low;
      if (ox * ox + oy * oy <= reach * reach) rows_[static_cast<std::size_t>(y)] |= 1ULL << x;
    }
  }
}

bool LocalMap::is_blocked(Point place, double cell) const {
  const std::int64_t x = index_of(place.x, cell) - x0_;
  const std::int64_t y = index_of(place.y, cell) - y0_;
  return x >= 0 && x < kSize && y >= 0 && y < kSize && !is_free(static_cast<int>(x), static_cast<int>(y));
}

// All cells that the line crosses, border by border.
bool LocalMap::sees(Point from, Point to, double cell) const {
  const Line x_line(from.x, to.x, cell);
  const Line y_line(from.y, to.y, cell);
  std::int64_t x = x_line.first - x0_;
  std::int64_t y = y_line.first - y0_;
  double next_x = x_line.next;
  double next_y = y_line.next;
  for (int i = 0; i < 4 * kSize && std::min(next_x, next_y) <= 1.0; ++i) {
    if (next_x < next_y) {
      x += x_line.step;
      next_x += x_line.between;
    } else {
      y += y_line.step;
      next_y += y_line.between;
    }
    const bool is_inside = x >= 0 && x < kSize && y >= 0 && y < kSize;
    if (is_inside && !is_free(static_cast<int>(x), static_cast<int>(y))) return false;
  }
  return true;
}

Point LocalMap::middle(int x, int y, double cell) const {
  return {(static_cast<double>(x0_ + x) + 0.5) * cell, (static_cast<double>(y0_ + y) + 0.5) * cell};
}

// Between two cells that touch at a corner lies free room only where both of their neighbours are free.
bool LocalMap::cuts_corner(int x, int y, int dx, int dy) const {
  return dx != 0 && dy != 0 && (!is_free(x + dx, y) || !is_free(x, y + dy));
}

Point LocalMap::first_stop(Point robot, Point goal, double cell) const {
  const auto inside = [](std::int64_t v) {
    return static_cast<int>(std::clamp<std::int64_t>(v, 0, kSize - 1));
  };
  const int goal_x = inside(index_of(goal.x, cell) - x0_);
  const int goal_y = inside(index_of(goal.y, cell) - y0_);
  const bool is_far = distance(middle(goal_x, goal_y, cell), goal) > cell;
  const Point wanted = is_far ? middle(goal_x, goal_y, cell) : goal;
  if (sees(robot, wanted, cell)) return wanted;
  const Ways ways = ways_to(goal_x, goal_y);

  // Down the shortest way, as far as the robot sees.
  int x = inside(index_of(robot.x, cell) - x0_);
  int y = inside(index_of(robot.y, cell) - y0_);
  Point stop = robot;
  for (int i = 0; i < kSize; ++i) {
    int best = ways[index_in(x, y)];
    const int here_x = x;
    const int here_y = y;
    for (const Step& step : kSteps) {
      const int nx = here_x + step.dx;
      const int ny = here_y + step.dy;
      if (nx < 0 || ny < 0 || nx >= kSize || ny >= kSize || cuts_corner(here_x, here_y, step.dx, step.dy))
        continue;
      const int way = ways[index_in(nx, ny)];
      if (way == kNoWay || way >= best) continue;
      best = way;
      x = nx;
      y = ny;
    }
    if (x == here_x && y == here_y) break;
    if (i > 0 && !sees(robot, middle(x, y, cell), cell)) break;
    stop = middle(x, y, cell);
  }
  return stop;
}

// From the goal outwards, until no cell gets a shorter one.
LocalMap::Ways LocalMap::ways_to(int goal_x, int goal_y) const {
  Ways ways;
  ways.fill(kNoWay);
  std::array<std::uint16_t, kCells> queue;
  std::array<bool, kCells> is_queued{};
  std::size_t head = 0;
  std::size_t count = 1;
  const std::size_t start = index_in(goal_x, goal_y);
  ways[start] = 0;
  queue[0] = static_cast<std::uint16_t>(start);
  while (count > 0) {
    const int at = queue[head];
    head = (head + 1) % kCells;
    --count;
    is_queued[static_cast<std::size_t>(at)] = false;
    for (const Step& step : kSteps) {
      const int x = at % kSize + step.dx;
      const int y = at / kSize + step.dy;
      if (x < 0 || y < 0 || x >= kSize || y >= kSize || !is_free(x, y)) continue;
      if (cuts_corner(at % kSize, at / kSize, step.dx, step.dy)) continue;
      const auto next = index_in(x, y);
      const int way = ways[static_cast<std::size_t>(at)] + step.cost;
      if (way >= ways[next]) continue;
      ways[next] = way;
      if (is_queued[next]) continue;
      is_queued[next] = true;
      queue[(head + count) % kCells] = static_cast<std::uint16_t>(next);
      ++count;
    }
  }
  return ways;
}

}  // namespace mlab::schema
