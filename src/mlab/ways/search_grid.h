#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "mlab/ways/bending_planner.h"
#include "mlab/ways/clearing.h"
#include "mlab/ways/lanes.h"
#include "mlab/ways/sight.h"

/// For sources of this module only.
namespace mlab::ways {

/// An area as cells in rows along the lanes: which of them are to be seen, which of them can be, where a
/// robot may be, and how many pieces of a way see each. A piece sees a cell where no wall stands between the
/// cell and the nearest point of the piece, or one of its ends. Lanes run through the middles of cells.
class SearchGrid {
 public:
  static constexpr std::size_t kMostCells = 4'000'000;

  /// Nothing: it would have too many cells.
  static std::optional<SearchGrid> over(const Lanes& lanes, double swath);

  /// Enters what is to be seen, where a robot may be, and what it can see from there.
  /// @param opaque  walls that hide what is behind them
  /// @param from  where it may be is where the planner knows a way to from there; without, in the part of the
  ///              ground in which it sees most [m, world]
  /// @param most_effort  of the planner
  /// @return  false: given up, since that was not enough
  bool enter(std::span<const geom::Point> outline, const Ground& ground,
             std::span<const geom::Segment> opaque, BendingPlanner& planner, std::optional<geom::Point> from,
             std::uint64_t most_effort);

  const Lanes& lanes() const { return lanes_; }
  double swath() const { return swath_; }
  double cell_area() const { return step_along_ * step_across_; }
  double step() const { return step_along_; }
  std::size_t to_search() const { return to_search_; }  ///< cells inside of the outline, outside of things
  std::size_t visible() const { return visible_; }      ///< of these that can be seen
  std::size_t to_see() const { return to_see_; }        ///< of these that can be, for sure
  std::size_t unseen() const { return unseen_; }        ///< of these that aren't yet

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  geom::Point middle(int column, int row) const { return lanes_.to_world(place(column, row)); }
  int column_of(LanePlace p) const { return cell_of(p.along / step_along_, columns_); }
  int row_of(LanePlace p) const { return cell_of(p.across / step_across_, rows_); }
  /// The row through whose middles a lane runs, and how many rows on either side are its own.
  int row_of_lane(int lane) const { return margin_rows_ + lane * rows_of_lane_ + rows_of_lane_ / 2; }
  int rows_beside_lane() const { return rows_of_lane_ / 2; }

  bool can_be_seen(std::size_t cell) const { return can_be_seen_[cell] != 0; }
  bool is_unseen(std::size_t cell) const { return can_be_seen_[cell] != 0 && seen_[cell] == 0; }
  bool may_be_at(std::size_t cell) const { return part_[cell] == kMain; }
  /// Whether a robot comes there from a cell beside it.
  bool may_be_at(geom::Point at, const Clearing& clearing) const;
  /// The number of the cells that hang together among which a place for a robot is; -1: not known.
  std::int32_t room_of(geom::Point at, const Clearing& clearing) const;
  /// A place from which a cell can be seen, if there is one; the nearest of those that are known.
  std::optional<geom::Point> lookout(int column, int row) const;

  /// Whether no wall hides anything.
  bool sees_all_round() const { return sight_.is_open(); }
  /// Cells side by side in a row: the first and the last of them.
  using Run = std::pair<std::size_t, std::size_t>;
  /// Adds the cells that are seen from a straight piece.
  void add_seen(geom::Segment piece, std::vector<Run>& out) const;
  /// Counts what is seen once more, or, with -1, once less: from a straight piece, and cells.
  void see(geom::Segment piece, int by);
  void see(std::span<const Run> runs, int by);

 private:
  static constexpr std::int32_t kMain = 1;

  static int cell_of(double at, int count);
  void count(std::size_t first, std::size_t last, int by);
  /// A cell for robots that a place is in or beside, with nothing in between.
  template <class IsFor>
  std::optional<std::size_t> cell_beside(geom::Point at, const Clearing& clearing, IsFor&& is_for) const;
  LanePlace place(int column, int row) const {
    return {(column - margin_columns_ + 0.5) * step_along_, (row - margin_rows_ + 0.5) * step_across_};
  }
  void enter_inside(std::span<const geom::Point> outline);
  bool enter_parts(BendingPlanner& planner, std::optional<geom::Point> from, std::uint64_t most_effort);
  std::size_t fill_part(int column, int row, std::int32_t part, const Clearing& clearing);
  bool join_parts(const std::vector<std::size_t>& sizes, const std::vector<geom::Point>& places,
                  BendingPlanner& planner, std::optional<geom::Point> from, std::uint64_t most_effort);
  void enter_edges(const Ground& ground, const Clearing& clearing);
  void enter_edge(geom::Point at, const Clearing& clearing);
  void look_from(LanePlace at);
  bool is_rim(int column, int row) const;
  /// visit(first, last): cells in a row whose middles are within reach of the piece.
  template <class Visit>
  void each_span(LanePlace a, LanePlace b, double reach, Visit&& visit) const;
  /// The same without what walls hide.
  template <class Visit>
  void each_seen(LanePlace a, LanePlace b, double reach, Visit&& visit) const;

  Lanes lanes_;
  Sight sight_;
  double swath_ = 0.0;
  double reach_ = 0.0;  // half a swath, less what cells aren't sure of
  double step_along_ = 0.0;
  double step_across_ = 0.0;
  int columns_ = 0, rows_ = 0;
  int margin_columns_ = 0, margin_rows_ = 0;
  int rows_of_lane_ = 1;
  std::vector<std::uint8_t> is_inside_;
  std::vector<std::uint8_t> is_visible_;
  std::vector<std::uint16_t> can_be_seen_;  // as wide as what is counted: faster
  std::vector<std::uint16_t> seen_;
  std::vector<std::int32_t> part_;     // 0: no place for a robot
  std::vector<std::int32_t> room_;     // cells that hang together have the same; 0: no place for a robot
  std::vector<geom::Point> on_edges_;  // places for a robot close to things
  std::size_t to_search_ = 0, visible_ = 0, to_see_ = 0, unseen_ = 0;
};

}  // namespace mlab::ways
