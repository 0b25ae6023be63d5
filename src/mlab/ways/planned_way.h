#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "mlab/geom/pose.h"

namespace mlab::ways {

/// Why a planned way ends where it does.
enum class WayEnd : std::uint32_t {
  kNowhere,     ///< there is no way
  kGoal,        ///< it is there
  kBesideGoal,  ///< something stands at the goal; this is the nearest place to it
  kClosedOff,   ///< no way leads farther towards it
  kFull         ///< it goes on, and has no room for more corners
};

/// A way as it is passed on: of bounded length, copied byte by byte. Most have two or three corners, so what
/// is read of one each cycle stands in its first bytes.
struct PlannedWay {
  static constexpr std::size_t kMostCorners = 48;
  static constexpr double kNotKnown = -1.0;
  static constexpr float kAnother = -1.0F;

  double clearance = 0.0;     ///< that it keeps from all that was known, but for its ends [m]
  double length = kNotKnown;  ///< of its pieces together [m]; who plans one says it, others need not
  std::uint16_t count = 0;    ///< of the corners; 0: there is no way
  std::uint16_t version = 0;  ///< another one: it was planned anew
  WayEnd end = WayEnd::kNowhere;
  float beyond = 0.0F;  ///< how much of the route it leads along is still to come where it ends full [m]
  /// It goes on along the line of the version before it, which began so far before this one [m]; `kAnother`:
  /// it does not.
  float cut_off = kAnother;
  std::array<geom::Point, kMostCorners> corners{};  ///< from where it begins to where it ends [m, world]
  /// How many of the route's corners one has passed at each of them, of those that were to come when it was
  /// planned.
  std::array<std::uint16_t, kMostCorners> passed{};

  /// Becomes another one. Corners that it has no use for stay as they are, so that they are not written.
  void become(const PlannedWay& other) {
    clearance = other.clearance;
    length = other.length;
    count = other.count;
    version = other.version;
    end = other.end;
    beyond = other.beyond;
    cut_off = other.cut_off;
    std::ranges::copy(other.points(), corners.begin());
    std::copy_n(other.passed.begin(), other.points().size(), passed.begin());
  }
  /// Goes on to a corner, unless it is there. Where there is no room it ends full.
  void append(geom::Point corner, std::size_t room = kMostCorners) {
    if (count > 0 && distance(corners[count - 1], corner) < 1e-9) return;
    if (count == room)
      end = WayEnd::kFull;
    else
      corners[count++] = corner;
  }
  /// Whatever somebody else's program has left in `count`.
  std::span<const geom::Point> points() const {
    return std::span(corners).first(count <= kMostCorners ? count : kMostCorners);
  }
};

}  // namespace mlab::ways
