#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "mlab/overlay/overlay.h"
#include "mlab/percept/percepts.h"
#include "mlab/ways/clearing.h"
#include "mlab/ways/ground.h"

namespace mlab::fleet {

/// What a team knows to stand on the ground: what the map says, and what its robots have sensed besides;
/// without what they saw to be gone. What moves is in it only where it doesn't go away from its place. Never
/// changed, so checkpoints share it.
class TeamGround {
 public:
  /// So many sensed things are remembered, at most.
  static constexpr std::size_t kMostSensed = 4'000;

  /// What is smaller may be overlooked, so it is never missed [m].
  static constexpr double kSmallest = 0.25;

  /// Who is sensed so near to something known is that: sensors and the place of the robot are not exact [m].
  static constexpr double kSame = 0.2;

  explicit TeamGround(const overlay::Overlay& map);

  /// Valid as long as this is.
  percept::KnownGround view() const { return {revision_, ground_.discs, ground_.walls, bounds_, edges_}; }
  /// Whether something that is known stands there. May be asked by several threads.
  bool knows(geom::Point place) const;
  /// With what was sensed besides; nothing: all of it is known, or there is no room for more.
  std::shared_ptr<const TeamGround> with(std::span<const ways::Round> sensed) const;
  /// The middles of round things that are known, but not among what a robot sees that would see them [m,
  /// world]. What is as small as a place of a wall is never missed.
  /// @param reach  how far it sees everything [m]
  /// @return  in the order of the view's discs
  std::vector<geom::Point> missed(const geom::Pose& pose, double reach,
                                  std::span<const percept::Obstacle> seen) const;
  /// Without those whose middles are there, whoever knew of them; nothing: it knows none of them.
  std::shared_ptr<const TeamGround> without(std::span<const geom::Point> gone) const;

 private:
  /// @param edges  as the field
  /// @param mapped  of the discs; nothing: all of them
  TeamGround(ways::Ground ground, ways::Bounds bounds, std::size_t edges, std::optional<std::size_t> mapped);
  /// The same with other discs, of which so many are the map's.
  std::shared_ptr<const TeamGround> with_discs(std::vector<ways::Round> discs, std::size_t mapped) const;

  const ways::Clearing& things() const;

  ways::Ground ground_;  // without bounds: things beyond them are known, too
  ways::Bounds bounds_;
  std::size_t edges_ = 0;  // so many of the last walls are edges of areas to keep out of
  /// Middles of those in which something moves: whoever looks there may not see it.
  std::vector<geom::Point> swaying_;
  std::size_t mapped_ = 0;  // discs that the map has; those behind them were sensed
  std::uint64_t revision_ = 0;
  mutable std::once_flag looked_;  // most robots never ask
  mutable std::optional<ways::Clearing> things_;
};

}  // namespace mlab::fleet
