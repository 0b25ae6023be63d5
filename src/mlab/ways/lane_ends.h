#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "mlab/ways/bending_planner.h"

/// For sources of this module only.
namespace mlab::ways {

/// A piece of a lane that a robot can follow, as it does: from a to b.
using LanePiece = geom::Segment;

/// An end of a piece: twice its number, and 1 where it is b. As a directed piece: that begins there, so the
/// other end is `end ^ 1`.
using PieceEnd = std::uint32_t;

/// Pieces of lanes, and the ways between their ends, each planned once.
class LaneEnds {
 public:
  static constexpr double kNoWay = 1e7;  ///< longer than any [m]

  /// @param planner  outlives this
  explicit LaneEnds(BendingPlanner& planner) : planner_(planner) {}

  void add(const LanePiece& piece) { pieces_.push_back(piece); }
  std::size_t count() const { return pieces_.size(); }  ///< of pieces
  geom::Point place(PieceEnd end) const { return end % 2 == 0 ? pieces_[end / 2].a : pieces_[end / 2].b; }
  /// As a robot follows it that begins there.
  LanePiece piece(PieceEnd begin) const { return {place(begin), place(begin ^ 1U)}; }
  double length(PieceEnd end) const { return distance(pieces_[end / 2].a, pieces_[end / 2].b); }  ///< [m]
  double straight(PieceEnd a, PieceEnd b) const { return distance(place(a), place(b)); }          ///< [m]
  /// Of the planned way between two ends; kNoWay: there is none [m].
  double way(PieceEnd a, PieceEnd b);
  /// Of the planner, so far.
  std::uint64_t effort() const { return planner_.effort(); }

 private:
  BendingPlanner& planner_;
  std::vector<LanePiece> pieces_;
  std::unordered_map<std::uint64_t, double> ways_;
};

/// Turns round what stands in an order from `first` to before `end`.
void turn_part(std::vector<PieceEnd>& order, std::size_t first, std::size_t end);

}  // namespace mlab::ways
