#pragma once

#include <expected>
#include <memory>
#include <numbers>
#include <string>
#include <string_view>

#include "mlab/vehicle/device.h"
#include "mlab/vehicle/stream.h"

namespace mlab::vehicle {

/// What may be said of a Denning MRV-2 besides where it is. docs/vehicles_mrv2.md explains them.
struct Mrv2Settings {
  double max_speed = 0.1;                         ///< it is not driven faster [m/s], > 0
  double max_turn_rate = std::numbers::pi / 2.0;  ///< nor turned [rad/s], > 0
  /// It has to brake at least so hard; one that says that it can't is not ready [m/s^2], > 0
  double braking = 0.5;
  /// A command is obeyed so long after it was given, however long it was under way [s], > 0.2
  double hold = 0.8;
};

/// What it reports was said at most so long ago [s].
inline constexpr double kMrv2SilentAfter = 1.0;

/// A Denning MRV-2 over a line as docs/vehicles_mrv2.md describes it.
/// @param address  of the line: `serial:/dev/ttyS0:9600`; see `Address`
/// @errors  what is wrong with the address or a setting: what was seen, what is expected
std::expected<std::unique_ptr<Device>, std::string> make_mrv2(std::string_view address,
                                                              const Mrv2Settings& settings = {});
/// The same over any stream.
/// @errors  as above, of the settings
std::expected<std::unique_ptr<Device>, std::string> make_mrv2_over(std::unique_ptr<Stream> stream,
                                                                   const Mrv2Settings& settings = {});

}  // namespace mlab::vehicle
