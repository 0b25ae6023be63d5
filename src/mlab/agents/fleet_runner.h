#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "mlab/agents/roster.h"
#include "mlab/robot/program/program_runner.h"

namespace mlab::agents {

/// Runs the robots of one run at the agents of a fleet: those that are there, and those that join while it
/// runs.
/// @param version  of this program; agents of another one are not asked
std::unique_ptr<robot::ProgramRunner> make_fleet_runner(std::shared_ptr<Roster> roster, std::uint64_t seed,
                                                        const std::string& version);

}  // namespace mlab::agents
