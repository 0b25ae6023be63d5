#include "mlab/sim/point_grid.h"

#include <array>

namespace mlab::sim {
namespace {

/// Mean numbers of items in a cell that is not empty: above the first, cells are halved, below the second
/// doubled.
constexpr double kCrowded = 3.5;
constexpr double kSparse = 1.05;
constexpr int kMostHalvings = 40;
/// Fewer, and what stands in clumps far from each other shares places.
constexpr std::size_t kPlacesPerItem = 4;
constexpr std::size_t kSamples = 256;
/// So many are looked at one by one.
constexpr std::size_t kHandful = 16;

/// How wide items spread, told by at most kSamples of them.
template <class Coordinate>
double spread_of(std::span<const PointGrid::Item> items, Coordinate coordinate) {
  std::array<double, kSamples> sample;
  const std::size_t count = std::min(kSamples, items.size());
  for (std::size_t i = 0; i < count; ++i) sample[i] = coordinate(items[i * items.size() / count]);
  return spread({sample.data(), count});
}

constexpr std::size_t kMostRows = 512;  // of a question, in cells

}  // namespace

void LatticeCells::resize(std::size_t places, double cell) {
  cell_ = cell;
  per_metre_ = 1.0 / cell;
  int bits = 2;
  while ((std::size_t{1} << bits) < places && bits < 30) ++bits;
  const std::uint32_t mask = (std::uint32_t{1} << bits) - 1;
  if (mask == mask_) return;
  mask_ = mask;
  // The golden section keeps runs of rows near each other apart. 11 modulo 16: then rows, columns, diagonals
  // and what is twice or three times as steep come to at least every eighth place.
  constexpr double kGoldenSection = 0.6180339887498949;
  const auto section = static_cast<std::uint32_t>(kGoldenSection * static_cast<double>(mask_));
  stride_ = ((section & ~std::uint32_t{15}) | 11U) & mask_;
  gaps_.assign(1, mask_);
  for (std::uint32_t rows = 1, at = 0; rows < std::min<std::size_t>(kMostRows, size()); ++rows) {
    at = (at + stride_) & mask_;
    gaps_.push_back(std::min({gaps_.back(), at, (mask_ - at) + 1}));
  }
}

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
  // Where a place begins stands one place on until its items are there.
  starts_.assign(cells_.size() + 2, 0);
  places_.resize(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    places_[i] = cells_.place(items[i].x, items[i].y);
    ++starts_[places_[i] + 2];
  }
  std::size_t used = 0;
  for (std::size_t place = 0; place < cells_.size(); ++place) {
    used += starts_[place + 2] != 0 ? 1 : 0;
    starts_[place + 2] += starts_[place + 1];
  }
  sorted_.resize(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) sorted_[starts_[places_[i] + 1]++] = items[i];
  return used;
}

void PointGrid::build(std::span<const Item> items, double smallest_cell) {
  ++builds_;
  max_radius_ = 0.0;
  for (const Item& item : items) max_radius_ = std::max(max_radius_, static_cast<double>(item.radius));
  has_cells_ = items.size() > kHandful;
  if (!has_cells_) {
    sorted_.assign(items.begin(), items.end());
    return;
  }
  const double wide = spread_of(items, [](const Item& item) { return item.x; });
  const double high = spread_of(items, [](const Item& item) { return item.y; });
  const double count = std::max(1.0, static_cast<double>(items.size()));
  const double covering = std::max(std::sqrt(wide * high / count), std::max(wide, high) / count);
  for (;;) {
    const double cell = std::max(smallest_cell, std::ldexp(covering, -halvings_));
    cells_.resize(kPlacesPerItem * items.size(), cell);
    const double used = static_cast<double>(std::max<std::size_t>(1, sort(items)));
    const double per_cell = static_cast<double>(items.size()) / used;
    if (per_cell < kSparse && halvings_ > 0) --halvings_;  // from the next time on
    if (per_cell <= kCrowded || cell <= smallest_cell || halvings_ >= kMostHalvings) return;
    ++halvings_;
  }
}

}  // namespace mlab::sim
