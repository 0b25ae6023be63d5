#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "mlab/geom/pose.h"
#include "mlab/mission/mission.h"
#include "mlab/mission/parameter.h"
#include "mlab/percept/percepts.h"

namespace mlab::fleet {

/// Robots under one order, and what they know in common: computed once per cycle, the same for all of them.
struct Group {
  percept::Order order;
  std::shared_ptr<const mission::UnitCommand> command;  ///< keeps the route alive
  std::vector<std::uint32_t> members;  ///< indices of robots in the fleet, in the order of their stations
  geom::Point center;                  ///< [m, world]
  geom::Offset center_step;            ///< in the last cycle [m]
  double formation_heading = 0.0;      ///< [rad, world]
  double spacing = mission::kDefaultSpacing;  ///< between neighbours [m]
  double slop = mission::kDefaultSlop;        ///< station error that counts as out of formation [m]
  double heading_trigger =
      mission::kDefaultTrigger;  ///< nearer to the goal the formation no longer turns [m]
  percept::FormationReference reference =
      percept::FormationReference::kUnitCenter;  ///< what its members measure their stations from
  bool has_center = false;
  bool assigns_stations = false;  ///< members take the stations that need the least way
};

/// Updates centre, its step and the formation heading from where the members are.
void update_group(Group& group, const std::vector<geom::Pose>& poses);

/// What the member of this rank knows of its group.
percept::UnitPercept unit_percept(const Group& group, std::size_t rank, const std::vector<geom::Pose>& poses);

/// Whether the member of this rank has a station: there is a formation, and it is not the one that others
/// measure theirs from.
bool has_station(const Group& group, std::size_t rank);

/// How far the member of this rank is from its station, which is measured from the group's reference [m]; in
/// a sweep only along the heading. Zero where it has none.
double station_error(const Group& group, std::size_t rank, const std::vector<geom::Pose>& poses);

/// Where the formation wants the member of this rank [m, world]; in a sweep beside where it is. Nothing where
/// it has no station.
std::optional<geom::Point> station_place(const Group& group, std::size_t rank,
                                         const std::vector<geom::Pose>& poses);

}  // namespace mlab::fleet
