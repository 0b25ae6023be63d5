#pragma once

#include <cstddef>
#include <vector>

#include "mlab/geom/pose.h"
#include "mlab/mission/mission.h"
#include "mlab/percept/formation.h"

namespace mlab::mission {

/// Whom the command is for, in rank order: the members of its unit, or the robots that it names. None where
/// the mission has no such unit.
inline const std::vector<base::RobotId>& members_of(const Mission& mission, const UnitCommand& command) {
  static const std::vector<base::RobotId> kNobody;
  if (command.unit == kNoUnit) return command.robots;
  return command.unit < mission.units.size() ? mission.units[command.unit].members : kNobody;
}

/// The formation that the command gives: SWEEPTO sweeps unless a clause says otherwise.
inline percept::Formation formation_of(const UnitCommand& command) {
  if (command.task == Task::kSweepTo && !command.has_formation) return percept::Formation::kSweep;
  return command.formation;
}

/// Where the unit is sent: for FOLLOW the end of the route [m, world].
inline geom::Point goal_of(const UnitCommand& command) {
  const bool follows = command.task == Task::kFollow && !command.route.empty();
  return follows ? command.route.back() : command.goal;
}

/// Where START wants the robot that comes `rank`th in its unit, from 0 [m, rad, world].
inline geom::Pose start_pose(const Mission& mission, const UnitCommand& command, std::size_t rank) {
  return {command.goal + command.start_step * static_cast<double>(rank), mission.overlay.heading};
}

}  // namespace mlab::mission
