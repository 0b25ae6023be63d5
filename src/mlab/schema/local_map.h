#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "mlab/geom/pose.h"

namespace mlab::schema {

/// What a robot remembers of the obstacles around it: a square of cells that goes along with it. Trivially
/// copyable, so it can be the state of a procedure.
class LocalMap {
 public:
  static constexpr int kSize = 64;  ///< cells to a side

  /// Moves the square so that the robot is in its middle; what leaves it is forgotten.
  /// @param cell  side of a cell [m], > 0; the same in all calls
  void center(geom::Point robot, double cell);
  /// Marks the cells whose middle lies in a disc.
  void block(geom::Point center, double radius, double cell);
  bool is_blocked(geom::Point place, double cell) const;

  /// Where to go first on a shortest way round what is blocked: the farthest cell of that way that is in
  /// sight.
  /// @return  the goal itself, or the place of the square that is nearest to it, where nothing is in the way;
  ///          the robot's own place where there is no way
  geom::Point first_stop(geom::Point robot, geom::Point goal, double cell) const;

 private:
  bool is_free(int x, int y) const { return (rows_[static_cast<std::size_t>(y)] >> x & 1U) == 0; }
  bool sees(geom::Point from, geom::Point to, double cell) const;
  geom::Point middle(int x, int y, double cell) const;
  bool cuts_corner(int x, int y, int dx, int dy) const;
  static constexpr std::size_t kCells = std::size_t{kSize} * kSize;
  // How long the way to a cell is, from each cell [tenths of a cell]; kNoWay where there is none.
  using Ways = std::array<int, kCells>;
  static constexpr int kNoWay = std::numeric_limits<int>::max();
  Ways ways_to(int x, int y) const;

  std::int64_t x0_ = 0;  ///< of the lower left cell, counted in cells from the world's origin
  std::int64_t y0_ = 0;
  std::array<std::uint64_t, kSize> rows_{};  ///< a bit for each cell; set: blocked
};

}  // namespace mlab::schema
