#pragma once

#include <memory>

#include "mlab/agents/roster.h"
#include "mlab/run/mission_run.h"

namespace mlab::cli {

/// Has robots whose host is a vehicle of the fleet be driven there; in real time only.
void settle_vehicles(const std::shared_ptr<agents::Roster>& roster, run::RunSettings& settings);

}  // namespace mlab::cli
