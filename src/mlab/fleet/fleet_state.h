#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "mlab/base/id.h"
#include "mlab/fleet/failsafes.h"
#include "mlab/fleet/fleet_robot.h"
#include "mlab/fleet/group.h"
#include "mlab/fleet/known_ground.h"
#include "mlab/fleet/messages.h"
#include "mlab/geom/pose.h"
#include "mlab/overlay/overlay.h"
#include "mlab/percept/percepts.h"
#include "mlab/robot/program/robot_memory.h"

namespace mlab::fleet {

/// What failsafes of a robot sensed in a cycle.
struct SeenByFailsafes {
  bool touches = false;
  std::vector<percept::Obstacle> obstacles;
  std::vector<percept::RobotReading> others;
};

/// All that a fleet keeps from one cycle to the next, but for what its robots' programs and bodies do. It is
/// copied whole: what is to be known after a cycle stands here, or follows from it.
struct FleetState {
  std::vector<FleetRobot> robots;  ///< by id, ascending
  std::vector<geom::Pose> poses;   ///< likewise, at the start of the cycle
  Messages messages;
  std::shared_ptr<const Failsafes> failsafes = std::make_shared<const Failsafes>();
  std::vector<SeenByFailsafes> seen;      ///< by index of `robots`, where there are failsafes
  overlay::Area area;                     ///< of the mission
  std::optional<bool> assigns_stations;   ///< as the mission sets it
  std::shared_ptr<const TeamGround> map;  ///< what teams know of the ground that have sensed nothing besides
  std::map<std::uint32_t, std::shared_ptr<const TeamGround>> grounds;  ///< by team: what the others know
  std::vector<Group> groups;                                           ///< slots are used again
  std::vector<std::uint32_t> free_groups;
  std::vector<RobotCall> calls;
  std::vector<base::RobotId> new_faults;
};

/// A fleet between two cycles, from where it can go on. Never changed, so it may be shared.
struct FleetCheckpoint {
  FleetState state;                          ///< its robots know no runner
  std::vector<robot::RobotMemory> memories;  ///< of `state.robots`; of parked ones an empty one
};

}  // namespace mlab::fleet
