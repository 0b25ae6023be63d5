#pragma once

#include <expected>
#include <memory>
#include <string>
#include <string_view>

#include "mlab/vehicle/device.h"
#include "mlab/vehicle/stream.h"

namespace mlab::vehicle {

/// What may be said of a text rover besides where it is.
struct TextRoverSettings {
  double max_speed = 0.5;      ///< [m/s], > 0
  double max_turn_rate = 1.0;  ///< [rad/s], > 0
};

/// A small rover that is spoken with in lines of text, the worked example of docs/adding_a_vehicle.md.
/// @param address  of the line: `serial:/dev/ttyUSB0:57600`; see `Address`
/// @errors  what is wrong with the address or a setting: what was seen, what is expected
std::expected<std::unique_ptr<Device>, std::string> make_text_rover(std::string_view address,
                                                                    const TextRoverSettings& settings = {});
/// The same over any stream.
/// @errors  as above, of the settings
std::expected<std::unique_ptr<Device>, std::string> make_text_rover_over(
    std::unique_ptr<Stream> stream, const TextRoverSettings& settings = {});

}  // namespace mlab::vehicle
