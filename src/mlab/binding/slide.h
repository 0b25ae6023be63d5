#pragma once

#include <array>
#include <cstdint>

#include "mlab/geom/pose.h"

namespace mlab::binding {

/// A half-plane that a motion must not leave: dot(motion, toward) <= gap.
struct Blocker {
  geom::Offset toward;      ///< unit vector, from the body to what is in the way
  double gap = 0.0;         ///< how far the body may go that way; less than 0: it should back off [m]
  std::uint32_t thing = 0;  ///< what it is, for telling contacts apart
};

/// In so many rounds a body that meets something goes on along it within a cycle.
inline constexpr int kSlideRounds = 4;
/// What is left of a motion counts from here on [m].
inline constexpr double kLeastRest = 1e-9;

/// What a body touches. Only the nearest are kept where there are too many; the sweep keeps the others out.
class Blockers {
 public:
  static constexpr std::size_t kMost = 10;
  void add(const Blocker& blocker);
  /// Keeps a body off something, where it touches it.
  /// @param nearest     the place of the thing from which the distance counts [m]
  /// @param radius      that has to be between them [m]
  /// @param going_away  so far the thing itself goes that way [m]
  void keep_off(geom::Point body, geom::Point nearest, double radius, double going_away, std::uint32_t thing);
  /// Keeps a body's centre in a box that it might leave by a motion of this length [m].
  void keep_within(geom::Point low, geom::Point high, geom::Point body, double way, std::uint32_t thing);
  /// The same, but nobody has to back off.
  Blockers without_backing_off() const;
  const Blocker* begin() const { return list_.data(); }
  const Blocker* end() const { return list_.data() + count_; }

 private:
  std::array<Blocker, kMost> list_;  ///< by gap, then by thing
  std::size_t count_ = 0;
};

/// The motion nearest to the wanted one that no blocker forbids: what a body that is pushed against things
/// does when it slides without friction. Zero where there is none.
geom::Offset slide(geom::Offset wanted, const Blockers& blockers);

}  // namespace mlab::binding
