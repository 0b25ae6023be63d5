#include "mlab/sim/statics.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace mlab::sim {
namespace {

/// Discs whose radii, and walls whose lengths, differ by no more than this factor share a grid.
constexpr double kDiscClass = 4.0;
constexpr double kWallClass = 64.0;
constexpr double kSmallest = 0.05;  // what is smaller counts as this size [m]
/// A table of walls has about so many entries, even for a single wall.
constexpr std::size_t kLeastEntries = 16384;

std::size_t size_class(double size, double factor) {
  return static_cast<std::size_t>(
      std::ceil(std::log(std::max(size, kSmallest) / kSmallest) / std::log(factor)));
}

std::uint64_t next_id() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

/// Puts what is of the same size class together.
template <class Item>
class SizeClasses {
 public:
  void add(std::size_t size_class, const Item& item) {
    if (size_class >= classes_.size()) classes_.resize(size_class + 1);
    classes_[size_class].push_back(item);
  }
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (const std::vector<Item>& items : classes_) {
      if (!items.empty()) visit(items);
    }
  }

 private:
  std::vector<std::vector<Item>> classes_;
};

}  // namespace

WallGrid::WallGrid(std::span<const Item> items) {
  double total_length = 0.0;
  std::vector<double> x;
  std::vector<double> y;
  for (const auto& [segment, index] : items) {
    total_length += distance(segment.a, segment.b);
    x.insert(x.end(), {segment.a.x, segment.b.x});
    y.insert(y.end(), {segment.a.y, segment.b.y});
  }
  // Entries, roughly: memory grows with the number of walls, not with their length.
  const std::size_t budget = kLeastEntries + 4 * items.size();
  cells_.resize(budget, 1.0);
  cells_.resize(budget, std::max({0.01, total_length / static_cast<double>(budget),
                                  spread(x) / cells_.columns(), spread(y) / cells_.rows()}));

  starts_.assign(cells_.size() + 1, 0);
  const auto for_each_entry = [&](auto&& entry) {
    for (const Item& item : items) {
      for_each_run_along(item.segment, HUGE_VAL, [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t place = first; place <= last; ++place) entry(place, item.index);
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
    : id_(next_id()), discs_(std::move(discs)), walls_(std::move(walls)) {
  SizeClasses<PointGrid::Item> disc_classes;
  for (std::uint32_t index = 0; index < discs_.size(); ++index) {
    const Disc& disc = discs_[index];
    disc_classes.add(size_class(disc.radius, kDiscClass),
                     {disc.center.x, disc.center.y, rounded_up(disc.radius), index});
  }
  disc_classes.for_each([&](const std::vector<PointGrid::Item>& items) {
    disc_grids_.emplace_back();
    disc_grids_.back().build(items, 0.01);
  });
  SizeClasses<WallGrid::Item> wall_classes;
  for (std::uint32_t index = 0; index < walls_.size(); ++index) {
    if (!walls_[index].is_solid) continue;  // stops and hides nothing
    const geom::Segment& segment = walls_[index].segment;
    wall_classes.add(size_class(distance(segment.a, segment.b), kWallClass), {segment, index});
  }
  wall_classes.for_each([&](const std::vector<WallGrid::Item>& items) { wall_grids_.emplace_back(items); });
}

bool Statics::in_sight(geom::Point a, geom::Point b) const {
  const geom::Segment line{a, b};
  bool is_free = true;
  for (const WallGrid& grid : wall_grids_) {
    grid.visit_line(
        line, [&](std::uint32_t index) { is_free = is_free && !intersects(line, walls_[index].segment); });
  }
  return is_free;
}

std::uint32_t Statics::walls_between(geom::Point a, geom::Point b, std::vector<std::uint32_t>& met) const {
  const geom::Segment line{a, b};
  met.clear();
  for (const WallGrid& grid : wall_grids_) {
    grid.visit_line(line, [&](std::uint32_t index) {
      if (intersects(line, walls_[index].segment)) met.push_back(walls_[index].group);
    });
  }
  std::ranges::sort(met);
  return static_cast<std::uint32_t>(std::ranges::unique(met).begin() - met.begin());
}

}  // namespace mlab::sim
