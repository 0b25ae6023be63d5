#pragma once

#include "mlab/cli/commands.h"

namespace CLI {  // NOLINT(readability-identifier-naming): of the library
class App;
}

namespace mlab::cli {

inline constexpr const char* kAgentDescription =
    "Carry robots for runs of a fleet, each in a process of its own (docs/robots_of_their_own.md).";

/// What can be said to an agent, by the command `mlab agent` and by the program `mlab-agent`.
void add_agent_options(CLI::App* c, AgentOptions& o);

}  // namespace mlab::cli
