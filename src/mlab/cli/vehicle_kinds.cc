#include "mlab/cli/vehicle_kinds.h"

#include <array>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/angle.h"
#include "mlab/lang/odl/odl.h"
#include "mlab/text/diagnostic.h"
#include "mlab/vehicle/simulated/simulated_device.h"

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

/// A kind of vehicle.
struct Kind {
  std::string_view name;
  std::string_view help;
  Made (*make)(const RobotOptions& options);
};

constexpr std::array kKinds = {
    Kind{"simulated", "in a world of its own (--world, --at, --seed), for trying missions without a vehicle",
         make_simulated},
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
