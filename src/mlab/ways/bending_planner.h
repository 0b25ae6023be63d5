#pragma once

#include <cstdint>
#include <expected>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "mlab/ways/clearances.h"
#include "mlab/ways/planner.h"

namespace mlab::ways {

/// The shortest ways at the widest clearance at which there is one. Belongs to one thread at a time; what it
/// finds does not depend on what it was asked before.
class BendingPlanner {
 public:
  /// @param ground  outlives this
  BendingPlanner(const Ground& ground, const Clearances& clearances);

  /// At the widest clearance.
  const Clearing& clearing() const { return planners_.front().clearing(); }
  /// The nearest place that is free at the widest clearance, or at the least one where something is between;
  /// nothing where none was found.
  std::optional<geom::Point> nearest_free(geom::Point p) const;

  /// In which part of the ground a place is, where parts hang together at the widest clearance; negative:
  /// not known.
  using RoomOf = std::function<std::int32_t(geom::Point)>;
  /// From here on it remembers at which clearance ways lead from room to room, so that wider ones are not
  /// looked for in vain again and again.
  void know_rooms(RoomOf room_of) { room_of_ = std::move(room_of); }

  /// As Planner's.
  /// @param from, to  free places at the least clearance
  std::expected<Way, Planner::NoWay> find(geom::Point from, geom::Point to,
                                          std::uint64_t most_effort = Planner::kNoLimit);
  std::uint64_t effort() const;

 private:
  using Rooms = std::pair<std::int32_t, std::int32_t>;
  std::optional<Rooms> rooms_of(geom::Point from, geom::Point to) const;

  std::vector<Planner> planners_;  // widest first
  RoomOf room_of_;
  std::map<Rooms, std::size_t> first_;  // the planner that finds ways between them; one more: none does
};

}  // namespace mlab::ways
