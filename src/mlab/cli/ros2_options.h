#pragma once

#include <expected>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "mlab/cli/commands.h"
#include "mlab/vehicle/device.h"

namespace mlab::cli {

/// What only a robot under ROS 2 takes.
inline constexpr char kRos2Takes[] =
    "--namespace --domain --scan --ros-network --ros-peer --drives --look-ahead --map-frame --origin "
    "--standstill --radius --max-speed --max-turn-rate";

void add_ros2(CLI::App* c, Ros2Options& o);

/// @errors  a sentence: an option or variable that can't be used, a domain that this machine has no place in
std::expected<std::shared_ptr<vehicle::Device>, std::string> make_ros2(const RobotOptions& options);

}  // namespace mlab::cli
