#include "mlab/sim/point_grid.h"

#include <array>

namespace mlab::sim {
namespace {

/// Mean numbers of items in a cell that is not empty: above the first, cells are halved, below the second
/// doubled.
constexpr double kCrowded = 3.5;
constexpr double kSparse = 1.05;
constexpr int kMostHalvings = 40;
constexpr std::size_t kSamples = 256;

/// How wide items spread, told by at most kSamples of them.
template <class Coordinate>
double spread_of(std::span<const PointGrid::Item> items, Coordinate coordinate) {
  std::array<double, kSamples> sample;
  const std::size_t count = std::min(kSamples, items.size());
  for (std::size_t i = 0; i < count; ++i) sample[i] = coordinate(items[i * items.size() / count]);
  return spread({sample.data(), count});
}

}  // namespace

double spread(std::span<double> coordinates) {
  if (coordinates.size() < 2) return 0.0;
  const auto quartile = [&](std::size_t rank) {
    std::nth_element(coordinates.begin(), coordinates.begin() + static_cast<std::ptrdiff_t>(rank),
                     coordinates.end());
    return coordinates[rank];
  };
  return 2.0 * (quartile(coordinates.size() * 3 / 4) - quartile(coordinates.size() / 4));
}

std::size_t PointGrid::sort(std::span<const Item> items) {
  starts_.assign(cells_.size() + 1, 0);
  places_.resize(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    places_[i] = cells_.place(items[i].x, items[i].y);
    ++starts_[places_[i] + 1];
  }
  std::size_t used = 0;
  for (std::size_t place = 0; place < cells_.size(); ++place) {
    used += starts_[place + 1] != 0 ? 1 : 0;
    starts_[place + 1] += starts_[place];
  }
  sorted_.resize(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) sorted_[starts_[places_[i]]++] = items[i];
  for (std::size_t place = cells_.size(); place > 0; --place) starts_[place] = starts_[place - 1];
  starts_[0] = 0;
  return used;
}

void PointGrid::build(std::span<const Item> items, double smallest_cell) {
  max_radius_ = 0.0;
  for (const Item& item : items) max_radius_ = std::max(max_radius_, static_cast<double>(item.radius));
  cells_.resize(items.size(), 1.0);
  const double covering =
      std::max(spread_of(items, [](const Item& item) { return item.x; }) / cells_.columns(),
               spread_of(items, [](const Item& item) { return item.y; }) / cells_.rows());
  for (;;) {
    const double cell = std::max(smallest_cell, std::ldexp(covering, -halvings_));
    cells_.resize(items.size(), cell);
    const double used = static_cast<double>(std::max<std::size_t>(1, sort(items)));
    const double per_cell = static_cast<double>(items.size()) / used;
    if (per_cell < kSparse && halvings_ > 0) --halvings_;  // from the next time on
    if (per_cell <= kCrowded || cell <= smallest_cell || halvings_ >= kMostHalvings) return;
    ++halvings_;
  }
}

}  // namespace mlab::sim
