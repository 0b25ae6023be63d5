#pragma once

#include <string>

#include "mlab/binding/vehicle_state.h"
#include "mlab/vehicle/device.h"

namespace mlab::vehicle {

/// What a report says of its vehicle, for people: how it is, its place, battery and sensors. The rest stands
/// in no report.
/// @param now  on the clock of the times in it
binding::VehicleState state_of(const Report& report, Clock::time_point now);

/// As a sentence without its subject; where the report itself says nothing, what its readiness means.
std::string why_not_ready(const Report& report);

}  // namespace mlab::vehicle
