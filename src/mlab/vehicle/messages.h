#pragma once

#include <cstddef>
#include <expected>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/vehicle.pb.h"
#include "mlab/vehicle/device.h"

/// Vehicles as proto/mlab/vehicle.proto has them. What arrives is checked before it is read further: it may
/// come from anybody.

namespace mlab::vehicle {

wire::OfferedVehicle offered(const std::string& kind, const Limits& limits, bool is_simulated = false);
/// @errors  a sentence: `its max_speed is -1.0, expected 0 to 1000`
std::expected<Limits, std::string> limits_of(const wire::OfferedVehicle& said);

/// All but what concerns runs.
void encode(const Report& report, Clock::time_point now, wire::VehicleReport& out);
/// @param arrived  by the clock of who reads; ages of readings count from there
/// @errors  what is wrong with it, as a sentence. Every number of what comes back is one, and within what a
///          vehicle may say
std::expected<Report, std::string> decode(const wire::VehicleReport& message, Clock::time_point arrived);

/// Of more than kMostChecks those that are too many are left out.
inline constexpr std::size_t kMostChecks = 64;
std::string encode(const std::vector<Check>& checks);
/// @errors  a sentence: it is no such message, or more than a vehicle may say. All texts of what comes back
///          are short, and fit for people
std::expected<std::vector<Check>, std::string> decode_checks(std::string_view message);

/// Whether a vehicle may be told this: all numbers are numbers, and it says whose command it is.
bool is_sound(const wire::VehicleCommand& command);

}  // namespace mlab::vehicle
