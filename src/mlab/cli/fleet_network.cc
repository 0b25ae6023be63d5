#include "mlab/cli/fleet_network.h"

#include <filesystem>
#include <system_error>

#include <fmt/core.h>

#include "mlab/cli/places.h"
#include "mlab/keys/fleet_keys.h"
#include "mlab/keys/identity.h"

namespace mlab::cli {

std::string agents_folder() {
  const std::string folder = state_folder();
  return folder.empty() ? "" : folder + "/agents";
}

std::string kept_file(const std::string& fleet, const std::string& name, const char* what) {
  const std::string folder = agents_folder();
  return folder.empty() ? "" : fmt::format("{}/{}@{}.{}", folder, fleet, name, what);
}

std::string keys_folder(const std::string& fleet) {
  const std::string folder = state_folder();
  return folder.empty() ? "" : fmt::format("{}/keys/{}", folder, fleet);
}

std::string identity_folder(const NetworkOptions& options) {
  if (!options.is_secure || !options.identity.empty()) return options.identity;
  const std::string folder = keys_folder(fleet_of(options.fleet));
  return folder.empty() ? "" : fmt::format("{}/{}", folder, keys::kOwnIdentity);
}

std::expected<dds::Network, std::string> network_of(const NetworkOptions& options) {
  dds::Network out{
      .fleet = fleet_of(options.fleet), .interface_name = options.interface_name, .peers = options.peers};
  if (!options.is_secure) return out;
  const std::string folder = identity_folder(options);
  std::error_code failure;
  if (folder.empty())
    return std::unexpected(
        "--secure: there is no folder for keys, since HOME is not set: --secure FOLDER names one");
  const std::filesystem::file_type type = std::filesystem::status(folder, failure).type();
  if (type == std::filesystem::file_type::none)  // of one above it
    return std::unexpected(fmt::format("--secure: `{}` can't be read: {}", folder, failure.message()));
  const bool is_missing = type != std::filesystem::file_type::directory;
  if (is_missing && options.identity.empty() && keys::FleetKeys::are_there(keys_folder(out.fleet)))
    return std::unexpected(fmt::format(
        "--secure: there is no folder `{}`: this machine has the fleet's keys, and `mlab keys {} --add {}` "
        "makes its identity",
        folder, out.fleet, keys::kOwnIdentity));
  if (is_missing && !options.identity.empty() && !options.identity.contains('/'))
    return std::unexpected(fmt::format(
        "--secure: there is no folder `{}`: what follows --secure is the folder of an identity", folder));
  if (is_missing)
    return std::unexpected(
        fmt::format("--secure: there is no folder `{}`: `mlab keys {}` makes one, or `mlab keys {} --add "
                    "NAME` on the machine "
                    "that has the fleet's keys",
                    folder, out.fleet, out.fleet));
  if (const auto identity = keys::check_identity(folder, out.fleet); !identity)
    return std::unexpected(fmt::format("--secure: {}", identity.error()));
  out.security = keys::security_in(folder);
  if (dds::time_left(*out.security).count() == 0)
    return std::unexpected(fmt::format("--secure: the identity in `{}` runs out at this moment", folder));
  return out;
}

}  // namespace mlab::cli
