#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mlab/mission/turn.h"

namespace mlab::mission {

/// A part of a unit, as its command begins.
struct PlannedPart {
  std::vector<base::RobotId> members;  ///< in rank order, never empty
  CommandRef command;                  ///< the unit's, or with a route of its own
  geom::Point goal;                    ///< of its first order [m, world]
  geom::Point end;                     ///< its own place at the end [m, world]
  double ahead = 0.0;                  ///< of the unit's goal, where the part ends [m]
  bool halted = false;
  std::string warning = {};  ///< for the operator; empty: none
};

/// Divides the unit as its command's technique needs it, and sets the run's technique and distance.
///
/// The parts are the unit's own parts, or else its two halves by rank. A unit of one robot, and a command
/// that goes nowhere, travel: one part. Under BOUNDING-OVERWATCH the parts have lanes side by side, so that
/// one can pass the other, and end beside each other. Under TRAVELING-OVERWATCH, and where there is no room
/// for lanes, they end one behind the other. The middle of all is the unit's goal.
/// @return  empty for a unit without robots
std::vector<PlannedPart> plan_parts(const State& state, Run& run);

/// Whose centre: of all, or of those that run.
enum class Whose : std::uint8_t { kAll, kRunning };
/// Mean position of those that report; nothing where none does [m, world].
std::optional<geom::Point> centre(const State& state, const std::vector<base::RobotId>& members,
                                  Whose whose = Whose::kAll);

}  // namespace mlab::mission
