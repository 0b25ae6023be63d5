#pragma once

#include <expected>
#include <memory>
#include <string>
#include <vector>

#include "mlab/cli/commands.h"
#include "mlab/vehicle/device.h"

namespace mlab::cli {

/// What `--binding` may be.
std::vector<std::string> vehicle_kinds();
/// A line for each of them.
std::string vehicle_kinds_help();

/// The vehicle that the options name; it need not be there yet.
/// @errors  a sentence: an option that its kind needs or does not take, an address that is none
std::expected<std::shared_ptr<vehicle::Device>, std::string> make_device(const RobotOptions& options);

}  // namespace mlab::cli
