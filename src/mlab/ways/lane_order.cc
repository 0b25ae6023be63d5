#include "mlab/ways/lane_order.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace mlab::ways {
namespace {

// Shares of a swath: how far inside of the area lanes end; up to which gaps lanes go on behind what stands
// there.
constexpr double kDrawnIn = 0.2;
constexpr double kNarrowGap = 2.5;
constexpr std::size_t kWindow = 60;    // of the order, in which it is improved
constexpr std::size_t kMostMoved = 3;  // pieces at once
constexpr int kMostImprovements = 12;  // times that all of the order is gone through
// Of the planner, after which the order is improved no more: some seconds.
constexpr std::uint64_t kMostOrderEffort = 12'000'000;

/// A part of a lane with pieces whose gaps are narrow: [from, to] along the lane [m].
struct Stretch {
  int lane = 0;
  double from = 0.0;
  double to = 0.0;
  std::vector<std::uint32_t> pieces;  // from low to high
  std::size_t cell = 0;
};
/// Of one lane and the next, of which each has just one beside it.
using LaneCell = std::vector<std::size_t>;

bool sees_something(const SearchGrid& grid, int column, int lane) {
  const int row = grid.row_of_lane(lane);
  if (!grid.may_be_at(grid.index(column, row))) return false;
  for (int y = row - grid.rows_beside_lane(); y <= row + grid.rows_beside_lane(); ++y) {
    if (grid.can_be_seen(grid.index(column, y))) return true;
  }
  return false;
}

/// From the first to the last column, drawn in where it doesn't end at something that stands there.
LanePiece piece_of(const SearchGrid& grid, int first, int last, int lane) {
  const int row = grid.row_of_lane(lane);
  const LanePiece all{grid.middle(first, row), grid.middle(last, row)};
  const double most = 0.5 * distance(all.a, all.b);
  const double in = std::clamp(kDrawnIn * grid.swath() - 0.5 * grid.step(), 0.0, most);
  const auto goes_on = [&](int column) {
    return column >= 0 && column < grid.columns() && grid.may_be_at(grid.index(column, row));
  };
  const geom::Offset along = grid.lanes().direction;
  return {all.a + along * (goes_on(first - 1) ? in : 0.0), all.b - along * (goes_on(last + 1) ? in : 0.0)};
}

class LaneOrder {
 public:
  LaneOrder(const SearchGrid& grid, BendingPlanner& planner) : grid_(grid), ends_(planner) {
    for (int lane = 0; lane < grid.lanes().count; ++lane) enter_lane(lane);
    make_cells();
    line_up_cells();
    most_effort_ = ends_.effort() + kMostOrderEffort;
    for (int i = 0; i < kMostImprovements && improve(); ++i) {
    }
  }

  std::vector<LanePiece> pieces() const {
    std::vector<LanePiece> out;
    for (const PieceEnd end : order_) out.push_back(ends_.piece(end));
    return out;
  }

 private:
  void enter_lane(int lane) {
    const std::size_t first_stretch = stretches_.size();
    for (int column = 0; column < grid_.columns(); ++column) {
      if (!sees_something(grid_, column, lane)) continue;
      const int first = column;
      while (column + 1 < grid_.columns() && sees_something(grid_, column + 1, lane)) ++column;
      const LanePiece piece = piece_of(grid_, first, column, lane);
      const double from = grid_.lanes().to_lanes(piece.a).along;
      const double to = grid_.lanes().to_lanes(piece.b).along;
      if (stretches_.size() == first_stretch || from - stretches_.back().to > kNarrowGap * grid_.swath())
        stretches_.push_back({lane, from, to, {}, 0});
      stretches_.back().to = to;
      stretches_.back().pieces.push_back(static_cast<std::uint32_t>(ends_.count()));
      ends_.add(piece);
    }
  }

  /// Those of a lane that lie beside a stretch.
  std::vector<std::size_t> beside(const Stretch& one, int lane) const {
    std::vector<std::size_t> out;
    const auto first = std::ranges::lower_bound(stretches_, lane, {}, &Stretch::lane);
    for (auto other = first; other != stretches_.end() && other->lane == lane; ++other) {
      if (other->from <= one.to && other->to >= one.from)
        out.push_back(static_cast<std::size_t>(other - stretches_.begin()));
    }
    return out;
  }

  void make_cells() {
    for (std::size_t i = 0; i < stretches_.size(); ++i) {
      Stretch& one = stretches_[i];
      const auto before = beside(one, one.lane - 1);
      const bool goes_on = before.size() == 1 && beside(stretches_[before[0]], one.lane).size() == 1;
      one.cell = goes_on ? stretches_[before[0]].cell : cells_.size();
      if (!goes_on) cells_.emplace_back();
      cells_[one.cell].push_back(i);
    }
  }

  /// The order of a cell that is begun with its last lane or its first, at its higher end or its lower.
  std::vector<PieceEnd> order_of(const LaneCell& cell, bool from_last, bool from_high) const {
    std::vector<PieceEnd> out;
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const auto& pieces = stretches_[cell[from_last ? cell.size() - 1 - i : i]].pieces;
      const bool is_down = from_high == (i % 2 == 0);
      for (std::size_t k = 0; k < pieces.size(); ++k)
        out.push_back(is_down ? 2 * pieces[pieces.size() - 1 - k] + 1 : 2 * pieces[k]);
    }
    return out;
  }

  /// After each the one that begins nearest to its end.
  void line_up_cells() {
    std::vector<LaneCell> left = cells_;
    while (!left.empty()) {
      std::size_t nearest = 0;
      std::vector<PieceEnd> best;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < left.size(); ++i) {
        for (int way = 0; way < 4; ++way) {
          const auto order = order_of(left[i], way / 2 == 1, way % 2 == 1);
          const double far = order_.empty() ? 0.0 : ends_.straight(order_.back() ^ 1U, order.front());
          if (far >= least) continue;
          least = far;
          nearest = i;
          best = order;
        }
      }
      order_.insert(order_.end(), best.begin(), best.end());
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(nearest));
    }
  }

  /// Ways between ends, each pair of them once.
  using Joints = std::vector<std::pair<PieceEnd, PieceEnd>>;
  bool is_shorter(const Joints& than, const Joints& joints) {
    double most = -1e-6;
    for (const auto& [a, b] : than) most += ends_.way(a, b);
    double least = 0.0;
    for (const auto& [a, b] : joints) least += ends_.straight(a, b);
    if (!(least < most)) return false;
    double length = 0.0;
    for (const auto& [a, b] : joints) length += ends_.way(a, b);
    return length < most;
  }

  /// Adds the joint of two places of the order, if it has both: the end of one, and the begin of the other.
  void join(Joints& joints, std::size_t before, std::size_t after) const {
    if (before < order_.size() && after < order_.size())
      joints.emplace_back(order_[before] ^ 1U, order_[after]);
  }

  bool improve() {
    bool out = false;
    for (std::size_t i = 0; i < order_.size() && ends_.effort() < most_effort_; ++i) {
      for (std::size_t j = i; j < std::min(order_.size(), i + kWindow); ++j) out |= turn_round(i, j);
      for (std::size_t j = i; j < std::min(order_.size(), i + kMostMoved); ++j) out |= move(i, j);
    }
    return out;
  }

  /// From i to j.
  bool turn_round(std::size_t i, std::size_t j) {
    Joints before;
    Joints after;
    join(before, i - 1, i);
    join(before, j, j + 1);
    if (i > 0) after.emplace_back(order_[i - 1] ^ 1U, order_[j] ^ 1U);
    if (j + 1 < order_.size()) after.emplace_back(order_[i], order_[j + 1]);
    if (!is_shorter(before, after)) return false;
    turn_part(order_, i, j + 1);
    return true;
  }

  /// What is from i to j to somewhere else, turned round or not.
  bool move(std::size_t i, std::size_t j) {
    const std::size_t low = i > kWindow ? i - kWindow : 0;
    const std::size_t high = std::min(order_.size(), j + 1 + kWindow);
    for (std::size_t to = low; to <= high; ++to) {  // in front of that
      if (to >= i && to <= j + 1) continue;
      for (const bool is_turned : {false, true}) {
        if (move(i, j, to, is_turned)) return true;
      }
    }
    return false;
  }
  bool move(std::size_t i, std::size_t j, std::size_t to, bool is_turned) {
    Joints before;
    Joints after;
    join(before, i - 1, i);
    join(before, j, j + 1);
    join(before, to - 1, to);
    join(after, i - 1, j + 1);
    const PieceEnd begin = is_turned ? order_[j] ^ 1U : order_[i];
    const PieceEnd end = is_turned ? order_[i] : order_[j] ^ 1U;
    if (to > 0) after.emplace_back(order_[to - 1] ^ 1U, begin);
    if (to < order_.size()) after.emplace_back(end, order_[to]);
    if (!is_shorter(before, after)) return false;
    if (is_turned) turn_part(order_, i, j + 1);
    const auto at = [&](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
    if (to < i)
      std::rotate(at(to), at(i), at(j + 1));
    else
      std::rotate(at(i), at(j + 1), at(to));
    return true;
  }

  const SearchGrid& grid_;
  std::uint64_t most_effort_ = 0;  // of the planner
  LaneEnds ends_;                  // of pieces from low to high
  std::vector<Stretch> stretches_;
  std::vector<LaneCell> cells_;
  std::vector<PieceEnd> order_;
};

}  // namespace

std::vector<LanePiece> lane_pieces_in_order(const SearchGrid& grid, BendingPlanner& planner) {
  return LaneOrder(grid, planner).pieces();
}

}  // namespace mlab::ways
