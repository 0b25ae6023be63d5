#pragma once

#include <string>
#include <vector>

#include "mlab/preflight/preflight.h"

namespace mlab::preflight {

/// What a mission wants of one of its vehicles.
struct Wants {
  std::vector<std::uint32_t> robots;           ///< whose body it is to be
  std::optional<geom::Pose> start;             ///< of the first of them [m, rad, world]; nothing: no START
  double speed = 0.0;                          ///< the fastest that is asked for [m/s]; 0: none is
  std::vector<const mission::Failsafe*> rows;  ///< of the mission's table, that concern it
};

/// All items of a vehicle, in the order in which they are shown.
/// @param version  of missionlab here
std::vector<Item> items_of(const VehicleFacts& vehicle, const Wants& wants, const std::string& version);

}  // namespace mlab::preflight
