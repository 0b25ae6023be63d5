#include "mlab/cli/vehicle_kinds.h"

#include <array>
#include <fstream>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/angle.h"
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
  if (!options.device.empty()) return std::unexpected("--device: a simulated vehicle has none");
  sim::World world;
  if (!options.world.empty()) {
    overlay::Overlay overlay;
    text::Diagnostics sink;
    if (!odl::load_overlay(options.world, overlay, sink)) return std::unexpected(text::render(sink));
    world = sim::world_of(overlay);
  }
  vehicle::SimulatedDevice::Settings settings;
  settings.start = {{options.at[0], options.at[1]}, base::radians(options.at[2])};
  settings.seed = options.seed;
  return std::make_shared<vehicle::SimulatedDevice>(std::move(world), settings);
}

// What its options say of a vehicle that does not say so itself.
vehicle::Limits limits_of(const RobotOptions& options, vehicle::Limits out) {
  if (options.radius) out.radius = *options.radius;
  if (options.max_speed) out.kinematics.max_speed = *options.max_speed;
  if (options.max_turn_rate) out.kinematics.max_turn_rate = base::radians(*options.max_turn_rate);
  return out;
}

// Empty: all is well.
std::string lack_of_device(const RobotOptions& options) {
  return options.device.empty()
             ? fmt::format("--binding {} needs --device: where the vehicle is connected", options.binding)
             : "";
}

std::expected<std::unique_ptr<vehicle::Stream>, std::string> stream_to(const RobotOptions& options) {
  if (std::string lack = lack_of_device(options); !lack.empty()) return std::unexpected(std::move(lack));
  const auto address = vehicle::parse_address(options.device);
  if (!address)
    return std::unexpected(fmt::format("--device {}: {}", options.device, address.error().message));
  return vehicle::make_stream(*address);
}

Made make_mavlink(const RobotOptions& options) {
  auto stream = stream_to(options);
  if (!stream) return std::unexpected(stream.error());
  mavlink::RoverSettings settings;
  settings.limits = limits_of(options, settings.limits);
  if (options.origin) settings.origin = geom::Point{(*options.origin)[0], (*options.origin)[1]};
  if (!options.key_file.empty()) {
    std::ifstream file(options.key_file);
    std::string line;
    std::getline(file, line);
    const auto key = mavlink::parse_key(line);
    if (!key) return std::unexpected(fmt::format("--key-file {}: {}", options.key_file, key.error().message));
    settings.key = *key;
  }
  return std::make_shared<mavlink::RoverDevice>(std::move(*stream), settings);
}

Made make_mrv2(const RobotOptions& options) {
  if (std::string lack = lack_of_device(options); !lack.empty()) return std::unexpected(std::move(lack));
  vehicle::Mrv2Settings settings;
  settings.max_speed = options.max_speed.value_or(settings.max_speed);
  if (options.max_turn_rate) settings.max_turn_rate = base::radians(*options.max_turn_rate);
  return vehicle::make_mrv2(options.device, settings);
}

Made make_text_rover(const RobotOptions& options) {
  if (std::string lack = lack_of_device(options); !lack.empty()) return std::unexpected(std::move(lack));
  vehicle::TextRoverSettings settings;
  settings.max_speed = options.max_speed.value_or(settings.max_speed);
  if (options.max_turn_rate) settings.max_turn_rate = base::radians(*options.max_turn_rate);
  return vehicle::make_text_rover(options.device, settings);
}

/// A kind of vehicle.
struct Kind {
  std::string_view name;
  std::string_view help;
  Made (*make)(const RobotOptions& options);
};

constexpr std::array kKinds = {
    Kind{"simulated", "in a world of its own (--world, --at, --seed), for trying missions without a vehicle",
         make_simulated},
    Kind{"mavlink",
         "a rover under ArduPilot (--device, --key-file, --origin, --radius, --max-speed, --max-turn-rate); "
         "docs/mavlink.md",
         make_mavlink},
    Kind{"mrv2", "a Denning MRV-2 (--device, --max-speed, --max-turn-rate); docs/vehicles_mrv2.md",
         make_mrv2},
    Kind{"text-rover",
         "a rover that is spoken with in lines of text, the example of docs/adding_a_vehicle.md (--device, "
         "--max-speed, --max-turn-rate)",
         make_text_rover},
};

}  // namespace

std::vector<std::string> vehicle_kinds() {
  std::vector<std::string> out;
  for (const Kind& one : kKinds) out.emplace_back(one.name);
  return out;
}

std::string vehicle_kinds_help() {
  std::string out = "the kind of vehicle:";
  for (const Kind& one : kKinds) out += fmt::format("\n{}: {}", one.name, one.help);
  return out;
}

Made make_device(const RobotOptions& options) {
  for (const Kind& one : kKinds) {
    if (one.name == options.binding) return one.make(options);
  }
  return std::unexpected(fmt::format("there is no binding `{}`", options.binding));
}

}  // namespace mlab::cli
