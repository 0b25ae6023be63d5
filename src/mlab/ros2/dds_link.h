#pragma once

#include <expected>
#include <memory>
#include <string>
#include <vector>

#include "mlab/ros2/link.h"
#include "mlab/ros2/participant.h"

namespace mlab::ros2 {

/// What a link is to, and what is made for it.
struct LinkSettings {
  RosNetwork network;
  std::string robot_namespace;        ///< `/veh1`; empty: none
  std::vector<std::string> scanners;  ///< topics in full, `/veh1/scan`
  bool has_goals = false;             ///< the navigator is spoken with
};

/// Over DDS, as a node `missionlab` in the robot's namespace.
/// @errors  a sentence
std::expected<std::unique_ptr<Link>, std::string> open_link(const LinkSettings& settings);

}  // namespace mlab::ros2
