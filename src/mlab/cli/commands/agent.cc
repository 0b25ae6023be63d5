#include <filesystem>
#include <system_error>
#include <utility>

#include "mlab/cli/commands.h"
#include "mlab/cli/fleet_member.h"
#include "mlab/cli/permission.h"
#include "mlab/cli/places.h"

namespace mlab::cli {

int agent(const AgentOptions& options) {
  agents::AgentSettings settings = member_settings(options.network, options.name);
  settings.sources = program_sources("", permission_to_carry(options));
  settings.sources.limits = options.limits;
  if (!options.offer.empty()) {
    std::error_code failure;
    settings.offered = std::filesystem::absolute(options.offer, failure).string();
  }
  return take_part(std::move(settings), options.network,
                   {"mlab agent", "agent", "waits for runs", "can have robots computed here"});
}

}  // namespace mlab::cli
