#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "mlab/sim/point_grid.h"
#include "mlab/sim/world.h"

namespace mlab::sim {

/// Nothing is ever outside.
inline constexpr Box kWholeWorld{-World::kFarthest, -World::kFarthest, World::kFarthest, World::kFarthest};

/// Walls of about the same length, sorted into the cells that they touch.
class WallGrid {
 public:
  struct Item {
    geom::Segment segment;
    std::uint32_t index;  ///< what visitors are told
  };

  explicit WallGrid(std::span<const Item> items);
  /// Calls visit(index) for all walls that touch the box, and some others. One may come several times.
  template <class Visit>
  void visit(const Box& box, Visit&& visit) const {
    cells_.for_each_run(box,
                        [&](std::uint32_t first, std::uint32_t last) { visit_places(first, last, visit); });
  }
  /// The same for all walls that touch the line.
  template <class Visit>
  void visit_line(const geom::Segment& line, Visit&& visit) const {
    for_each_run_along(line, 2.0 * cells_.rows(),
                       [&](std::uint32_t first, std::uint32_t last) { visit_places(first, last, visit); });
  }

 private:
  template <class Visit>
  void visit_places(std::uint32_t first, std::uint32_t last, Visit& visit) const {
    for (std::uint32_t i = starts_[first]; i < starts_[last + 1]; ++i) visit(indices_[i]);
  }
  /// Runs of places that hold all cells which the line touches, row by row; of the box around the line where
  /// it goes through more than most_rows.
  template <class Run>
  void for_each_run_along(const geom::Segment& line, double most_rows, Run&& run) const;

  TorusCells cells_;
  std::vector<std::uint32_t> starts_;
  std::vector<std::uint32_t> indices_;
};

/// All that stands still, laid out to find what is near a place.
class Statics {
 public:
  Statics(std::vector<Disc> discs, std::vector<Wall> walls);

  /// Another one: it is not the same, and may hold something else.
  std::uint64_t id() const { return id_; }
  std::span<const Disc> discs() const { return discs_; }
  std::span<const Wall> walls() const { return walls_; }
  /// Calls visit(index, disc) for all discs that touch the box, and some others; none twice.
  template <class Visit>
  void visit_discs(const Box& box, Visit&& visit) const {
    for (const PointGrid& grid : disc_grids_) {
      const double r = grid.max_radius();
      grid.visit({box.x0 - r, box.y0 - r, box.x1 + r, box.y1 + r},
                 [&](const PointGrid::Item& item) { visit(item.id, discs_[item.id]); });
    }
  }
  /// Calls visit(index, wall) for all walls that touch the box, and some others. One may come several times.
  template <class Visit>
  void visit_walls(const Box& box, Visit&& visit) const {
    for (const WallGrid& grid : wall_grids_) {
      grid.visit(box, [&](std::uint32_t index) { visit(index, walls_[index]); });
    }
  }
  /// True where no wall has a point in common with the line.
  bool in_sight(geom::Point a, geom::Point b) const;
  /// How many walls have a point in common with the line: each polyline counts once, however often it is met.
  /// Edges of areas that only robots keep out of are none.
  /// @param met  memory for them
  std::uint32_t walls_between(geom::Point a, geom::Point b, std::vector<std::uint32_t>& met) const;

 private:
  std::uint64_t id_;
  std::vector<Disc> discs_;
  std::vector<Wall> walls_;
  /// One for things of about the same size each, so that a single huge one makes no difference to the others.
  std::vector<PointGrid> disc_grids_;
  std::vector<WallGrid> wall_grids_;
};

template <class Run>
void WallGrid::for_each_run_along(const geom::Segment& line, double most_rows, Run&& run) const {
  const geom::Point low = line.a.y <= line.b.y ? line.a : line.b;
  const geom::Point high = line.a.y <= line.b.y ? line.b : line.a;
  // Wider than any rounding of the crossing points below.
  const double margin = 1e-6 * cells_.cell() +
                        1e-12 * (std::abs(low.x) + std::abs(high.x) + std::abs(low.y) + std::abs(high.y));
  const std::int64_t y0 = cells_.index(low.y - margin);
  const std::int64_t y1 = cells_.index(high.y + margin);
  const double slope = high.y > low.y ? (high.x - low.x) / (high.y - low.y) : 0.0;
  if (y1 == y0 || static_cast<double>(y1 - y0) >= most_rows) {
    cells_.for_each_run(Box::spanned(low.x, low.y, high.x, high.y, margin), run);
    return;
  }
  for (std::int64_t y = y0; y <= y1; ++y) {
    const double bottom = std::clamp(static_cast<double>(y) * cells_.cell() - margin, low.y, high.y);
    const double top = std::clamp(static_cast<double>(y + 1) * cells_.cell() + margin, low.y, high.y);
    double xa = low.x + slope * (bottom - low.y);
    double xb = low.x + slope * (top - low.y);
    if (bottom == low.y) xa = low.x;
    if (top == high.y) xb = high.x;
    cells_.for_each_run_of_row(y, cells_.index(std::min(xa, xb) - margin),
                               cells_.index(std::max(xa, xb) + margin), run);
  }
}

}  // namespace mlab::sim
