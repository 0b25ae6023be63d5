#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "mlab/agents/roster.h"
#include "mlab/robot/program/program_runner.h"

namespace mlab::agents {

/// What a person is told to do where there is no agent: options that a command which starts one needs beside
/// the fleet's name, each with a blank in front.
struct StartHints {
  std::string here = {};
  std::string elsewhere = {};  ///< on another machine
  std::string unseen = {};     ///< who may be there and isn't seen, with `; ` in front; empty: nobody
};

/// For agents that somebody wants and that are not there.
inline constexpr std::chrono::seconds kJoiningPatience(5);

/// Why an agent of another version carries nothing for a run: half a sentence, `the agent on ...`. Empty: it
/// is of the same, or a vehicle, which carries no programs.
/// @param version  of this program
std::string other_version(const wire::AgentPresence& agent, const std::string& version);

/// Runs the robots of one run at the agents of a fleet: those that are there, and those that join while it
/// runs.
/// @param version  of this program; agents of another one are not asked
/// @param hints    how agents are started that reach the fleet, for who has none
/// @param patience  with all agents that are not there when the robots are taken in, together
/// @param period   of a cycle in real time [s]; 0: in lock-step
std::unique_ptr<robot::ProgramRunner> make_fleet_runner(std::shared_ptr<Roster> roster, std::uint64_t seed,
                                                        const std::string& version, double period = 0.0,
                                                        StartHints hints = {},
                                                        Clock::duration patience = kJoiningPatience);

}  // namespace mlab::agents
