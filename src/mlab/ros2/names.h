#pragma once

#include <expected>
#include <string>
#include <string_view>

namespace mlab::ros2 {

/// A namespace as ROS has it, with a `/` before it: `veh1` and `/veh1/` are `/veh1`; `/` and nothing are
/// empty.
/// @errors  a sentence: what ROS would not take
std::expected<std::string, std::string> namespace_of(std::string_view written);

/// A name in full: `scan` in `/veh1` is `/veh1/scan`; what begins with a `/` is in full already.
/// @errors  likewise
std::expected<std::string, std::string> full_name(std::string_view robot_namespace, std::string_view name);

}  // namespace mlab::ros2
