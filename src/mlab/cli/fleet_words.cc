#include "mlab/cli/fleet_words.h"

#include <arpa/inet.h>

#include <filesystem>
#include <system_error>

#include <fmt/core.h>

#include "mlab/agents/roster.h"
#include "mlab/cli/fleet_network.h"
#include "mlab/text/member_name.h"
#include "mlab/text/shell_word.h"
#include "mlab/text/shown.h"

namespace mlab::cli {
namespace {

bool is_address(const std::string& text) {
  in_addr address{};
  return ::inet_pton(AF_INET, text.c_str(), &address) == 1;
}

std::string peers_of(const NetworkOptions& options) {
  std::string out;
  for (const std::string& peer : options.peers) out += " --peer " + text::shell_word(peer);
  return out;
}

}  // namespace

std::string fleet_options(const NetworkOptions& options) {
  std::string out;
  if (!options.interface_name.empty()) out += " --network " + text::shell_word(options.interface_name);
  out += peers_of(options);
  if (options.is_secure) out += " --secure";
  if (options.is_secure && !options.identity.empty()) out += " " + text::shell_word(options.identity);
  return out;
}

std::string fleet_options_elsewhere(const NetworkOptions& options) {
  std::string out;
  if (!options.interface_name.empty())
    out += " --network " +
           (is_address(options.interface_name) ? "ADDRESS" : text::shell_word(options.interface_name));
  return out + peers_of(options) + (options.is_secure ? " --secure" : "");
}

std::string nobody_is_there(const std::string& fleet, const NetworkOptions& options) {
  return fmt::format("fleet `{0}`: nobody is there; `mlab agent --fleet {0}{1}` starts an agent{2}", fleet,
                     fleet_options(options), who_is_not_seen(options));
}

std::string who_is_not_seen(const NetworkOptions& options) {
  std::string out;
  if (options.interface_name.empty())
    out +=
        "; whoever takes part over another interface than loopback is seen with the same `--network` as his";
  NetworkOptions secured = options;
  secured.is_secure = true;
  std::error_code failure;
  if (!options.is_secure && std::filesystem::exists(identity_folder(secured), failure))
    out += "; this machine has an identity of that fleet: its secured members are seen with `--secure`";
  return out;
}

std::string release_command(const NetworkOptions& options) {
  return fmt::format("mlab fleet {}{} --release", fleet_of(options.fleet), fleet_options(options));
}

std::string refuse_unless_name(const std::string& text) {
  // `--fleet --secure`: a fleet of that name would not be secured.
  if (text.starts_with('-'))
    return fmt::format("`{}` can't be a name here: it begins as an option does", text::shown(text));
  if (agents::is_agent_name(text)) return "";
  return fmt::format("`{}` can't be a name here: expected {}", text::shown(text), text::kMemberNameRule);
}

}  // namespace mlab::cli
