// `mlab keys`: who belongs to a secured fleet.

#include <algorithm>
#include <cstdio>
#include <expected>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "mlab/cli/commands.h"
#include "mlab/cli/fleet_network.h"
#include "mlab/dds/network.h"
#include "mlab/keys/fleet_keys.h"
#include "mlab/keys/identity.h"

namespace mlab::cli {
namespace {

int refuse(const std::string& problem) {
  fmt::print(stderr, "mlab keys: {}\n", problem);
  return kBadInput;
}

std::string listed(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& one : names) out += fmt::format("{}`{}`", out.empty() ? "" : ", ", one);
  return out.empty() ? "none" : out;
}

bool has(const keys::FleetKeys& keys, const std::string& name) {
  return std::ranges::count(keys.names(), name) > 0 && std::ranges::count(keys.half_made(), name) == 0;
}

int show(const keys::FleetKeys& keys, const std::string& fleet, const std::string& folder) {
  fmt::print(
      "The keys of the fleet `{0}` are in {1}\n"
      "  authority/  makes members: whoever has it has the fleet. It stays here; keep a copy in a safe "
      "place\n"
      "  own/        {3}\n"
      "Members: {2}\n"
      "`mlab keys {0} --add NAME` makes the identity of another machine.\n",
      fleet, folder, listed(keys.names()),
      has(keys, keys::kOwnIdentity)
          ? "this machine's identity, which --secure uses"
          : fmt::format("is not there: `mlab keys {} --add {}` makes this machine's identity", fleet,
                        keys::kOwnIdentity));
  const std::vector<std::string> broken = keys.half_made();
  for (const std::string& one : broken)
    fmt::print(stderr,
               "mlab keys: the identity `{1}` is half made, and can't be used: `mlab keys {0} --add {1}` "
               "makes it anew\n",
               fleet, one);
  for (const keys::FleetKeys::RunningOut& one : keys.running_out())
    fmt::print(
        stderr,
        "mlab keys: the identity `{1}` {2}: `mlab keys {0} --withdraw {1}` and then `mlab keys {0} --add "
        "{1}` make another\n",
        fleet, one.name, one.when);
  return broken.empty() ? kDone : kFailed;
}

int add(keys::FleetKeys& keys, const std::string& fleet, const std::string& name) {
  const auto folder = keys.add(name);
  if (!folder) return refuse(folder.error());
  if (name == keys::kOwnIdentity) {
    fmt::print("This machine's identity of the fleet `{}` is in {}: --secure uses it\n", fleet,
               folder->string());
    return kDone;
  }
  fmt::print(
      "The identity `{0}` of the fleet `{1}` is in {2}\n"
      "Move that folder to its machine, as ~/.local/state/mlab/keys/{1}/{3}, by a way that nobody reads "
      "along.\n"
      "There `mlab agent --fleet {1} --secure` uses it; in another place, `--secure FOLDER`.\n",
      name, fleet, folder->string(), keys::kOwnIdentity);
  return kDone;
}

int withdraw(keys::FleetKeys& keys, const std::string& fleet, const std::string& name) {
  if (const auto done = keys.withdraw(name); !done) return refuse(done.error());
  fmt::print(
      "`{}` belongs to the fleet `{}` no more. Machines know that by {}\n"
      "Copy that file into the identity's folder of each other machine. Agents there take it over within 5 "
      "s.\n",
      name, fleet, keys.withdrawn_file().string());
  if (name == keys::kOwnIdentity)
    fmt::print("This machine has no identity now: `mlab keys {} --add {}` makes another.\n", fleet,
               keys::kOwnIdentity);
  return kDone;
}

}  // namespace

int keys(const KeysOptions& options) {
  const std::string fleet = fleet_of(options.fleet);
  if (const auto usable = dds::configuration_of({.fleet = fleet, .interface_name = {}, .peers = {}}); !usable)
    return refuse(usable.error());
  const std::string folder = keys_folder(fleet);
  if (folder.empty()) return refuse("there is no folder for keys: neither XDG_STATE_HOME nor HOME is set");
  if (!keys::FleetKeys::are_there(folder) && !options.withdraw.empty())
    return refuse(fmt::format("there are no keys of the fleet `{}` in {}", fleet, folder));
  if (!options.add.empty()) {
    if (const auto problem = keys::why_no_identity_name(options.add)) return refuse(*problem);
  }
  const bool is_new = !keys::FleetKeys::are_there(folder);
  auto keys = keys::FleetKeys::open(folder, fleet);
  if (!keys) return refuse(keys.error());
  if (!options.withdraw.empty()) return withdraw(*keys, fleet, options.withdraw);
  // An own one that was withdrawn does not come back by itself; one that could not be made at first does.
  if (options.add.empty() && !has(*keys, keys::kOwnIdentity) && !keys->was_withdrawn(keys::kOwnIdentity)) {
    if (const auto own = keys->add(keys::kOwnIdentity); !own) return refuse(own.error());
  }
  if (options.add.empty()) return show(*keys, fleet, folder);
  if (is_new)
    fmt::print(
        stderr,
        "mlab keys: there were no keys of a fleet `{}` here: it is a new one, with an authority of its own\n",
        fleet);
  return add(*keys, fleet, options.add);
}

}  // namespace mlab::cli
