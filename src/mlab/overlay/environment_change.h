#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "mlab/overlay/overlay.h"
#include "mlab/overlay/random_obstacles.h"

namespace mlab::overlay {

/// A new obstacle at a place.
struct AddObstacle {
  geom::Point center;
  double radius = 0.0;  ///< [m], > 0
};
/// The obstacle at a place goes: those whose centre lies within kSamePlace in each coordinate.
struct RemoveObstacle {
  geom::Point center;
};
inline constexpr double kSamePlace = 1e-5;  ///< [m]
/// All obstacles whose centre is in the region go, edges included.
struct ClearRegion {
  Region region;
};
/// The region is filled at random, counting the obstacles whose centre is in it already.
struct FillRegion {
  Region region;
  ObstacleField field;
  std::optional<double> seed;   ///< of the first execution; none: from the seed of the run
  double seed_increment = 0.0;  ///< added for each execution after it
};
using EnvironmentChange = std::variant<AddObstacle, RemoveObstacle, ClearRegion, FillRegion>;

/// What happens to the environment at one moment, once or again and again.
/// Files count in cycles of the historic simulator, which are seconds.
struct EnvironmentEvent {
  double start = 0.0;   ///< of the first execution [s]
  double period = 0.0;  ///< from one execution to the next [s]; 0: only once
  std::vector<EnvironmentChange> changes;
  text::Place place;
};

/// In file order, which is the order of events at the same moment.
struct EnvironmentChanges {
  std::vector<EnvironmentEvent> events;
  text::SourcePtr source = nullptr;  ///< what it was read from
};

/// How often an event has happened when `time` seconds have passed. An event is due where this is more than
/// it was a cycle before.
std::uint64_t executions(const EnvironmentEvent& event, double time);

/// Does the changes of an event, in order. Pure: the same arguments give the same obstacles, on every
/// machine.
///
/// @param execution  0 for the first time that the event happens
/// @param run_seed   of the whole run; random fields without a seed of their own are drawn from it
/// @param robots     discs that new random obstacles keep clear of
/// @return false where a random field did not reach its coverage
bool apply(const EnvironmentEvent& event, std::uint64_t execution, std::uint64_t run_seed,
           std::span<const ObstacleDisc> robots, std::vector<ObstacleDisc>& obstacles);

}  // namespace mlab::overlay
