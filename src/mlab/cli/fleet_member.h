#pragma once

#include <string>

#include "mlab/agents/agent_process.h"
#include "mlab/cli/commands.h"

namespace mlab::cli {

/// The settings that a member of a fleet has whatever it is for: name, log, and where its stop is kept.
/// @param name  empty: the machine's
agents::AgentSettings member_settings(const NetworkOptions& network, const std::string& name);

/// How a member speaks of itself.
struct MemberWords {
  std::string command;  ///< in front of errors: `mlab agent`
  std::string kind;     ///< `agent`
  std::string does;     ///< once it has joined: `waits for runs`
  std::string warning;  ///< where anybody may reach it: what he can do then
};
/// Takes part in a fleet until it is interrupted; joins anew where somebody was withdrawn from it.
/// @param settings  all but the network
/// @return  exit status
int take_part(agents::AgentSettings settings, const NetworkOptions& options, const MemberWords& words);

}  // namespace mlab::cli
