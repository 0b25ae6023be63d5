#include "mlab/cli/vehicle_kinds.h"

#include <array>
#include <fstream>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/angle.h"
#include "mlab/cli/ros2_options.h"
#include "mlab/lang/odl/odl.h"
#include "mlab/mavlink/rover_device.h"
#include "mlab/mavlink/signing.h"
#include "mlab/simulated_vehicle/simulated_device.h"
#include "mlab/text/diagnostic.h"
#include "mlab/vehicle/mrv2/mrv2.h"
#include "mlab/vehicle/stream.h"
#include "mlab/vehicle/text_rover/text_rover.h"

namespace mlab::cli {
namespace {

using Made = std::expected<std::shared_ptr<vehicle::Device>, std::string>;

Made make_simulated(const RobotOptions& options) {
  sim::World world;
  if (!options.world.empty()) {
    overlay::Overlay overlay;
    text::Diagnostics sink;
    if (!odl::load_overlay(options.world, overlay, sink)) return std::unexpected(text::render(sink));
    world = sim::world_of(overlay);
  }
  vehicle::SimulatedDevice::Settings settings;
  const auto at = options.at.value_or(std::array{0.0, 0.0, 0.0});
  settings.start = {{at[0], at[1]}, base::radians(at[2])};
  settings.seed = options.seed.value_or(settings.seed);
  return std::make_shared<vehicle::SimulatedDevice>(std::move(world), settings);
}

/// What its options say of a vehicle that does not say so itself.
void set_speeds(const RobotOptions& options, double& max_speed, double& max_turn_rate) {
  max_speed = options.max_speed.value_or(max_speed);
  if (options.max_turn_rate) max_turn_rate = base::radians(*options.max_turn_rate);
}

Made make_mavlink(const RobotOptions& options) {
  const auto address = vehicle::parse_address(options.device);
  if (!address)
    return std::unexpected(fmt::format("--device {}: {}", options.device, address.error().message));
  mavlink::RoverSettings settings;
  settings.limits.radius = options.radius.value_or(settings.limits.radius);
  set_speeds(options, settings.limits.kinematics.max_speed, settings.limits.kinematics.max_turn_rate);
  if (options.origin) settings.origin = geom::Point{(*options.origin)[0], (*options.origin)[1]};
  if (!options.key_file.empty()) {
    std::ifstream file(options.key_file);
    std::string line;
    std::getline(file, line);
    const auto key = mavlink::parse_key(line);
    if (!key) return std::unexpected(fmt::format("--key-file {}: {}", options.key_file, key.error().message));
    settings.key = *key;
  }
  return std::make_shared<mavlink::RoverDevice>(vehicle::make_stream(*address), settings);
}

Made make_mrv2(const RobotOptions& options) {
  vehicle::Mrv2Settings settings;
  set_speeds(options, settings.max_speed, settings.max_turn_rate);
  return vehicle::make_mrv2(options.device, settings);
}

Made make_text_rover(const RobotOptions& options) {
  vehicle::TextRoverSettings settings;
  set_speeds(options, settings.max_speed, settings.max_turn_rate);
  return vehicle::make_text_rover(options.device, settings);
}

/// An option that not all kinds take.
struct Own {
  std::string_view name;
  bool (*is_given)(const RobotOptions& options);
};

constexpr std::array kOwn = {
    Own{"--device", [](const RobotOptions& o) { return !o.device.empty(); }},
    Own{"--world", [](const RobotOptions& o) { return !o.world.empty(); }},
    Own{"--at", [](const RobotOptions& o) { return o.at.has_value(); }},
    Own{"--seed", [](const RobotOptions& o) { return o.seed.has_value(); }},
    Own{"--key-file", [](const RobotOptions& o) { return !o.key_file.empty(); }},
    Own{"--origin", [](const RobotOptions& o) { return o.origin.has_value(); }},
    Own{"--namespace", [](const RobotOptions& o) { return !o.ros2.robot_namespace.empty(); }},
    Own{"--domain", [](const RobotOptions& o) { return o.ros2.domain.has_value(); }},
    Own{"--scan", [](const RobotOptions& o) { return !o.ros2.scans.empty(); }},
    Own{"--ros-network", [](const RobotOptions& o) { return !o.ros2.interface_name.empty(); }},
    Own{"--ros-peer", [](const RobotOptions& o) { return !o.ros2.peers.empty(); }},
    Own{"--drives", [](const RobotOptions& o) { return !o.ros2.drives.empty(); }},
    Own{"--look-ahead", [](const RobotOptions& o) { return o.ros2.look_ahead.has_value(); }},
    Own{"--map-frame", [](const RobotOptions& o) { return !o.ros2.map_frame.empty(); }},
    Own{"--standstill", [](const RobotOptions& o) { return o.ros2.standstill.has_value(); }},
    Own{"--radius", [](const RobotOptions& o) { return o.radius.has_value(); }},
    Own{"--max-speed", [](const RobotOptions& o) { return o.max_speed.has_value(); }},
    Own{"--max-turn-rate", [](const RobotOptions& o) { return o.max_turn_rate.has_value(); }},
};

/// A kind of vehicle.
struct Kind {
  std::string_view name;
  std::string_view help;
  std::string_view takes;  ///< of kOwn, with blanks between; a device is needed where it is among them
  Made (*make)(const RobotOptions& options);
};

constexpr std::array kKinds = {
    Kind{"simulated", "in a world of its own, for trying missions without a vehicle", "--world --at --seed",
         make_simulated},
    Kind{"mavlink", "a rover under ArduPilot; docs/mavlink.md",
         "--device --key-file --origin --radius --max-speed --max-turn-rate", make_mavlink},
    Kind{"ros2", "a robot under ROS 2; docs/ros2.md", kRos2Takes, make_ros2},
    Kind{"mrv2", "a Denning MRV-2; docs/vehicles_mrv2.md", "--device --max-speed --max-turn-rate", make_mrv2},
    Kind{"text-rover", "spoken with in lines of text, the example of docs/adding_a_vehicle.md",
         "--device --max-speed --max-turn-rate", make_text_rover},
};

bool takes(const Kind& kind, std::string_view option) {
  const std::string words = fmt::format(" {} ", kind.takes);
  return words.find(fmt::format(" {} ", option)) != std::string::npos;
}

// Empty: all is well.
std::string problem_of(const Kind& kind, const RobotOptions& options) {
  for (const Own& own : kOwn) {
    if (own.is_given(options) && !takes(kind, own.name))
      return fmt::format("{}: --binding {} does not take it, but {}", own.name, kind.name, kind.takes);
  }
  return takes(kind, "--device") && options.device.empty()
             ? fmt::format("--binding {} needs --device: where the vehicle is connected", kind.name)
             : "";
}

}  // namespace

std::vector<std::string> vehicle_kinds() {
  std::vector<std::string> out;
  for (const Kind& one : kKinds) out.emplace_back(one.name);
  return out;
}

std::string vehicle_kinds_help() {
  std::string out = "the kind of vehicle:";
  for (const Kind& one : kKinds) out += fmt::format("\n{}: {} ({})", one.name, one.help, one.takes);
  return out;
}

Made make_device(const RobotOptions& options) {
  for (const Kind& one : kKinds) {
    if (one.name != options.binding) continue;
    if (std::string problem = problem_of(one, options); !problem.empty())
      return std::unexpected(std::move(problem));
    return one.make(options);
  }
  return std::unexpected(fmt::format("there is no binding `{}`", options.binding));
}

}  // namespace mlab::cli
