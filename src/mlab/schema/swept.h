#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "mlab/geom/pose.h"
#include "mlab/percept/percepts.h"

namespace mlab::schema {

/// Where a robot has been, as a line: of what is nearly straight only the ends are kept, and the oldest is
/// forgotten. A value of a frame.
class Trail {
 public:
  static constexpr std::size_t kMostCorners = 128;

  /// @param tolerance  the line is nowhere farther from where the robot was [m], > 0
  void go_to(geom::Point here, double tolerance);
  std::size_t pieces() const { return count_; }
  /// 0: the newest one.
  geom::Segment piece(std::size_t back) const {
    const std::size_t i = count_ - 1 - back;
    return {corners_[i], back == 0 ? last_ : corners_[i + 1]};
  }

 private:
  std::array<geom::Point, kMostCorners> corners_{};
  std::size_t count_ = 0;
  geom::Point last_;        // where the newest piece ends
  bool is_open_ = true;     // that may lead in any direction yet
  double direction_ = 0.0;  // else all that it may lead in lie round this one [rad]
  double right_ = 0.0;      // from so much [rad]
  double left_ = 0.0;       // to so much
  double farthest_ = 0.0;   // the piece's length [m]
};

/// Whether all of a leg, or of a way, lies so deep under things that nobody who stays beside them sees it.
/// @param reach  so far they see [m]
bool is_covered(const percept::KnownGround& ground, geom::Segment leg, double reach);
bool is_covered(const percept::KnownGround& ground, std::span<const geom::Point> way, double reach);

/// What a robot that goes along a piece of a SEARCH has left unseen beside it, since something stood there
/// that the way leads through. Told by places beside each leg that the robot has come past: by where it has
/// been since the command began. Discs hide nothing, walls do. A value of a frame.
class Swept {
 public:
  static constexpr std::size_t kMostMissed = 64;

  /// Goes along another piece.
  void begin();
  /// Once in a cycle. What is seen now isn't missed any more.
  /// @param reach  so far the robot sees [m], > 0
  void look(const percept::KnownGround& ground, geom::Point here, double reach);
  /// Looks at what lies beside the way up to there, as far as it has not yet; so much in a cycle, and no more
  /// than there is room for.
  /// @param leg, along  the one that ends at that corner of the way, and so far along it [m]
  /// @param margin      that the way keeps from the edges of what was known when it was planned [m]
  /// @return  whether all of it has been looked at
  bool pass(const percept::KnownGround& ground, std::span<const geom::Point> way, std::size_t leg,
            double along, double margin, double reach);

  std::span<const geom::Point> missed() const { return std::span(missed_).first(count_); }
  bool misses(geom::Point place) const;
  bool is_nearly_full() const { return count_ + kMostAcross > kMostMissed; }
  /// It comes to none of those that are so near to a place.
  void give_up(geom::Point place, double within);

 private:
  static constexpr int kAcross = 4;  // places to either side of the lane
  static constexpr std::size_t kMostAcross = 2 * kAcross + 1;

  bool has_seen(const percept::KnownGround& ground, geom::Point place, double reach) const;
  void add_missed(const percept::KnownGround& ground, geom::Segment leg, double along, double margin,
                  double reach);

  Trail trail_;
  std::array<geom::Point, kMostMissed> missed_{};
  std::size_t count_ = 0;
  std::size_t leg_ = 1;  // looked at next
  double along_ = 0.0;   // that leg [m]
};

}  // namespace mlab::schema
