#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mlab/geom/pose.h"
#include "mlab/ways/ground.h"
#include "mlab/ways/open_arcs.h"

namespace mlab::ways {

/// What is left of a ground for a point that keeps a clearance from everything on it: each disc has grown by
/// it, and each wall has become a band with round ends.
class Clearing {
 public:
  /// Nearer than this to the edge of what has grown still counts as outside [m].
  static constexpr double kTolerance = 1e-6;

  /// @param ground     outlives this
  /// @param clearance  [m], >= 0
  Clearing(const Ground& ground, double clearance);

  double clearance() const { return clearance_; }
  /// What ways go round: the grown discs, and the ends of walls. Not all of them have a free place.
  std::span<const Round> rounds() const { return rounds_; }

  bool is_free(geom::Point p) const;
  /// Of the whole piece between two points.
  bool is_free(geom::Segment s) const;
  /// What a straight piece meets first: index of a disc of the ground, or of a wall behind them; nothing: no
  /// thing is on it. Bounds are none.
  std::optional<std::uint32_t> first_hit(geom::Segment s) const;
  /// The nearest free place; nothing where none was found near it. A free one is its own.
  std::optional<geom::Point> nearest_free(geom::Point p) const;
  /// Free places at edges of what is around a place, nearest first: so many, or all that there are. At each
  /// edge the place that is nearest, and where two meet.
  std::vector<geom::Point> free_places(geom::Point p, std::size_t most) const;

  /// Calls visit(disc) for each disc of the ground, by its index, that comes so near to a place, and for some
  /// others; none twice, in whatever order. Without the clearance.
  /// @param p      finite
  /// @param reach  [m], >= 0
  template <class Visit>
  void visit_discs(geom::Point p, double reach, Visit&& visit) const;

  /// Of a round, where nothing is in the way.
  std::vector<Arc> free_arcs(std::uint32_t round) const;

 private:
  struct Cell {
    std::int32_t x, y;
  };
  Cell cell_of(geom::Point p) const;
  std::span<const std::uint32_t> items(Cell cell) const;
  template <class Visit>
  bool walk(geom::Segment s, Visit&& visit) const;
  void enter_items();
  bool blocks(std::uint32_t item, geom::Point p) const;
  /// How far along the piece it is met, 0 .. 1; kNotMet: it isn't.
  double met_at(std::uint32_t item, geom::Segment s) const;
  std::vector<std::uint32_t> items_near(geom::Point p, double reach) const;
  std::vector<geom::Point> edge_points(geom::Point p, double reach) const;
  bool is_all(geom::Point p, double reach) const;

  const Ground& ground_;
  double clearance_;
  std::vector<Round> rounds_;  // first the discs of the ground
  // The cells of a grid over all that has grown, with what touches each.
  double cell_ = 1.0;
  double x0_ = 0.0, y0_ = 0.0;
  std::int32_t columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> starts_;  // by cell: where its items begin; one more for the end
  std::vector<std::uint32_t> items_;   // discs, and walls behind them
};

template <class Visit>
void Clearing::visit_discs(geom::Point p, double reach, Visit&& visit) const {
  const Cell low = cell_of({p.x - reach, p.y - reach});
  const Cell high = cell_of({p.x + reach, p.y + reach});
  for (std::int32_t y = low.y; y <= high.y; ++y) {
    for (std::int32_t x = low.x; x <= high.x; ++x) {
      for (const std::uint32_t item : items({x, y})) {
        if (item >= ground_.discs.size()) break;  // walls come behind them
        // A disc stands in all cells that its box touches: it counts in the first of them.
        const auto& [center, radius] = rounds_[item];
        const Cell first = cell_of({center.x - radius, center.y - radius});
        if (std::max(first.x, low.x) == x && std::max(first.y, low.y) == y) visit(item);
      }
    }
  }
}

}  // namespace mlab::ways
