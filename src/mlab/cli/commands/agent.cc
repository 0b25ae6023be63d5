#include <cstdio>
#include <stop_token>
#include <thread>

#include <fmt/core.h>

#include "mlab/agents/agent_process.h"
#include "mlab/cli/clock.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/files.h"
#include "mlab/cli/fleet_network.h"
#include "mlab/cli/interrupt.h"
#include "mlab/cli/output.h"
#include "mlab/cli/permission.h"
#include "mlab/cli/version.h"

namespace mlab::cli {
namespace {

// A line of the agent's log, at once.
void say(const std::string& line) {
  write_output_now(fmt::format("{}  {}\n", print(wall_clock()), line));
}

// One for each name in each fleet on this machine.
std::string stop_file(const std::string& fleet, const std::string& name) {
  const std::string folder = state_folder();
  return folder.empty() ? "" : fmt::format("{}/agents/{}@{}.stop", folder, fleet, name);
}

}  // namespace

int agent(const AgentOptions& options) {
  agents::AgentSettings settings;
  settings.network = network_of(options.network);
  settings.name = options.name.empty() ? agents::machine_name() : options.name;
  settings.sources = program_sources("", permission_to_carry(options));
  settings.sources.limits = options.limits;
  settings.stop_file = stop_file(settings.network.fleet, settings.name);
  settings.tell = say;
  settings.tell_ready = [&] {
    say(fmt::format("agent `{}` of fleet `{}`, {}: waits for runs", settings.name, settings.network.fleet,
                    options.network.interface_name.empty()
                        ? "which nothing outside of this machine can reach"
                        : fmt::format("reachable over {}", options.network.interface_name)));
    if (!options.network.interface_name.empty())
      fmt::print(stderr, "mlab agent: warning: whoever reaches this network can have robots computed here\n");
  };
  note_interrupts();
  std::stop_source stop;
  const std::jthread watch([&](const std::stop_token& over) {
    while (!over.stop_requested() && !was_interrupted())
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    stop.request_stop();
  });
  if (const auto problem = agents::serve_as_agent(settings, stop.get_token())) {
    fmt::print(stderr, "mlab agent: {}\n", *problem);
    return kBadInput;
  }
  say("has left the fleet");
  return kDone;
}

}  // namespace mlab::cli
