#pragma once

#include <memory>

#include "mlab/agents/agent_process.h"
#include "mlab/vehicle/device.h"

namespace mlab::vehicles {

/// A vehicle of a fleet, for AgentSettings: its process takes part as an agent does, and lets one run at a
/// time drive the device. On a thread of its own, which has the device stop when it ends.
/// @param log  as of the settings; gets what people at the vehicle are to know
agents::OfferedVehicle offer(std::shared_ptr<vehicle::Device> device, std::string name,
                             std::shared_ptr<agents::AgentLog> log);

}  // namespace mlab::vehicles
