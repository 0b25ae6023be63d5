#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "mlab/geom/pose.h"

namespace mlab::ways {

/// Why a planned way ends where it does.
enum class WayEnd : std::uint16_t {
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
  WayEnd end_beyond = WayEnd::kGoal;  ///< where it ends full: what is at the end of all of it
  float beyond = 0.0F;                ///< and how much of it is still to come [m]
  /// It goes on along the line of the version before it, which began so far before this one [m]; `kAnother`:
  /// it does not.
  float cut_off = kAnother;
  std::array<geom::Point, kMostCorners> corners{};  ///< from where it begins to where it ends [m, world]
  /// How many of the route's corners one has passed at each of them, of those that were to come when it was
  /// planned.
  std::array<std::uint16_t, kMostCorners> passed{};
  geom::Point last_beyond;  ///< where it ends full: where all of it ends [m, world]

  /// What is at the end of all of it, whether it has room for that or not.
  WayEnd whole_end() const { return end == WayEnd::kFull ? end_beyond : end; }
  bool is_closed_off() const { return whole_end() == WayEnd::kClosedOff || whole_end() == WayEnd::kNowhere; }
  /// Where all of it ends; it has at least one corner.
  geom::Point whole_last() const { return end == WayEnd::kFull ? last_beyond : points().back(); }
  /// So long is what it has no room for [m].
  double length_beyond() const { return end == WayEnd::kFull ? static_cast<double>(beyond) : 0.0; }

  /// Becomes another one. Corners that it has no use for stay as they are, so that they are not written.
  void become(const PlannedWay& other) {
    clearance = other.clearance;
    length = other.length;
    count = other.count;
    version = other.version;
    end_as(other);
    cut_off = other.cut_off;
    std::ranges::copy(other.points(), corners.begin());
    std::copy_n(other.passed.begin(), other.points().size(), passed.begin());
  }
  /// Ends where another one ends, with what that has no room for.
  void end_as(const PlannedWay& other) {
    end = other.end;
    end_beyond = other.end_beyond;
    beyond = other.beyond;
    last_beyond = other.last_beyond;
  }
  /// Goes on to a corner, unless it is there. Where there is no room it ends full, and what comes then counts
  /// as what is beyond.
  void append(geom::Point corner, std::size_t room = kMostCorners) {
    const geom::Point last = end == WayEnd::kFull ? last_beyond : count > 0 ? corners[count - 1] : corner;
    const double piece = distance(last, corner);
    if (count > 0 && piece < 1e-9) return;
    if (count < room && end != WayEnd::kFull) {
      corners[count++] = corner;
      return;
    }
    append_beyond(piece, corner);
  }
  /// It ends full, and goes on for so long, to there [m].
  void append_beyond(double more, geom::Point last) {
    if (end != WayEnd::kFull) end_beyond = end;
    end = WayEnd::kFull;
    beyond += static_cast<float>(more);
    last_beyond = last;
  }
  /// Says what is at the end of all of it.
  void set_whole_end(WayEnd is) { (end == WayEnd::kFull ? end_beyond : end) = is; }
  /// Whatever somebody else's program has left in `count`.
  std::span<const geom::Point> points() const {
    return std::span(corners).first(count <= kMostCorners ? count : kMostCorners);
  }
};

}  // namespace mlab::ways
