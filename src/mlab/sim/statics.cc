#include "mlab/sim/statics.h"

#include <utility>

namespace mlab::sim {
namespace {

/// Discs whose radii differ by no more than this factor share a grid.
constexpr double kSizeClass = 4.0;
constexpr double kSmallestClass = 0.05;

/// A table of walls has about so many entries, even for a single wall.
constexpr std::size_t kLeastEntries = 16384;

int size_class(double radius) {
  return static_cast<int>(
      std::ceil(std::log(std::max(radius, kSmallestClass) / kSmallestClass) / std::log(kSizeClass)));
}

}  // namespace

void WallGrid::build(std::span<const Wall> walls) {
  indices_.clear();
  if (walls.empty()) return;
  double total_length = 0.0;
  std::vector<double> x;
  std::vector<double> y;
  for (const Wall& wall : walls) {
    total_length += distance(wall.segment.a, wall.segment.b);
    x.insert(x.end(), {wall.segment.a.x, wall.segment.b.x});
    y.insert(y.end(), {wall.segment.a.y, wall.segment.b.y});
  }
  // Entries, roughly: memory grows with the number of walls, not with their length.
  const std::size_t budget = kLeastEntries + 4 * walls.size();
  cells_.resize(budget, 1.0);
  cells_.resize(budget, std::max({0.01, total_length / static_cast<double>(budget),
                                  spread(x) / cells_.columns(), spread(y) / cells_.rows()}));

  starts_.assign(cells_.size() + 1, 0);
  const auto for_each_entry = [&](auto&& entry) {
    for (std::uint32_t index = 0; index < walls.size(); ++index) {
      for_each_run_along(walls[index].segment, HUGE_VAL, [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t place = first; place <= last; ++place) entry(place, index);
      });
    }
  };
  for_each_entry([&](std::uint32_t place, std::uint32_t) { ++starts_[place + 1]; });
  for (std::size_t place = 0; place < cells_.size(); ++place) starts_[place + 1] += starts_[place];
  indices_.resize(starts_.back());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for_each_entry([&](std::uint32_t place, std::uint32_t index) { indices_[next[place]++] = index; });
}

Statics::Statics(std::vector<Disc> discs, std::vector<Wall> walls)
    : discs_(std::move(discs)), walls_(std::move(walls)) {
  std::vector<std::vector<PointGrid::Item>> by_size;
  for (std::uint32_t index = 0; index < discs_.size(); ++index) {
    const Disc& disc = discs_[index];
    const auto size = static_cast<std::size_t>(size_class(disc.radius));
    if (size >= by_size.size()) by_size.resize(size + 1);
    by_size[size].push_back({disc.center.x, disc.center.y, rounded_up(disc.radius), index});
  }
  for (const auto& items : by_size) {
    if (items.empty()) continue;
    disc_grids_.emplace_back();
    disc_grids_.back().build(items, 0.01);
  }
  wall_grid_.build(walls_);
}

bool Statics::in_sight(geom::Point a, geom::Point b) const {
  bool is_free = true;
  wall_grid_.visit_line({a, b}, [&](std::uint32_t index) {
    is_free = is_free && !intersects(geom::Segment{a, b}, walls_[index].segment);
  });
  return is_free;
}

}  // namespace mlab::sim
