#include <cstdio>
#include <memory>
#include <utility>

#include <fmt/core.h>

#include "mlab/cli/commands.h"
#include "mlab/cli/fleet_member.h"
#include "mlab/cli/vehicle_kinds.h"
#include "mlab/cli/version.h"
#include "mlab/vehicles/vehicle_process.h"

namespace mlab::cli {

int robot(const RobotOptions& options) {
  auto device = make_device(options);
  if (!device) {
    fmt::print(stderr, "mlab robot: {}\n", device.error());
    return kBadInput;
  }
  agents::AgentSettings settings = member_settings(options.network, options.name);
  settings.sources.version = kVersion;
  const std::string kind = fmt::format("vehicle ({})", (*device)->name());
  settings.vehicle = vehicles::offer(std::move(*device), settings.name, settings.log);
  return take_part(std::move(settings), options.network,
                   {"mlab robot", kind, "waits for a run to drive it", "can drive this vehicle"});
}

}  // namespace mlab::cli
