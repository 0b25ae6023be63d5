#pragma once

#include <memory>
#include <string>

#include "mlab/agents/roster.h"
#include "mlab/cli/commands.h"
#include "mlab/preflight/gate.h"
#include "mlab/run/mission_run.h"
#include "mlab/vehicles/fleet_facts.h"

namespace mlab::cli {

/// Before the vehicles of a fleet, for runs and for who makes a checklist.
/// @param facts      what is known of them
/// @param mission    file, as the command that makes a checklist is to name it; empty: none is known
/// @param unchecked  as preflight::Gate
std::shared_ptr<preflight::Gate> make_gate(const std::shared_ptr<vehicles::FleetFacts>& facts,
                                           const NetworkOptions& network, const std::string& mission,
                                           const std::string& unchecked);

/// Has robots whose host is a vehicle of the fleet be driven there; in real time only.
/// @return  who has to be asked before a run starts
std::shared_ptr<preflight::Gate> settle_vehicles(const std::shared_ptr<agents::Roster>& roster,
                                                 const RunOptions& options, run::RunSettings& settings);

}  // namespace mlab::cli
