#pragma once

#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/dds/security.h"

namespace mlab::dds {

/// Which fleet a participant belongs to, and how it reaches the others.
struct Network {
  /// 1 to 64 letters, digits, `-`, `_` and `.`. Fleets hear nothing of each other.
  std::string fleet;
  /// The name of an interface of this machine (`eth0`), or its IPv4 address. Empty: nothing leaves this
  /// machine.
  std::string interface_name;
  /// IPv4 addresses of machines to look for others at, where the network carries no multicast. This machine
  /// is always looked at.
  std::vector<std::string> peers;
  /// For trials: of a thousand packets that this participant sends, so many are dropped by chance.
  int lost_of_thousand = 0;
  /// It does not meet those of this machine of which this is true, too, but everybody else: fifty agents of
  /// one machine would be busy with each other alone, at rest as well.
  bool avoids_neighbours = false;
  /// By what it proves who it is; then it talks to those only who prove it, too, and all is encrypted.
  std::optional<Security> security = std::nullopt;
};

/// How many participants of one fleet (and of those whose domain is the same) have place on one machine.
inline constexpr int kMaxParticipants = 120;

/// DDS's number for what a fleet shares: 1 to 100, so that all its ports lie between 7650 and 32649, below
/// those that Linux hands out by itself. It is the same on every machine, and two fleets may have the same.
int domain_of(std::string_view fleet);

/// What tells fleets apart whose domain is the same: participants of another one are not even discovered
/// (DDS's domain tag), and none of their topics would match (DDS's partition).
std::string partition_of(std::string_view fleet);

/// This machine's address on the network; empty: it has none at present.
std::string own_address_on(const Network& network);

/// Whether the network is this machine alone: no interface is named, or the loopback is.
bool is_loopback_only(const Network& network);

/// The whole configuration of Cyclone for a participant in this network. Nothing is taken from the
/// environment (CYCLONEDDS_URI), so that a setting for other programs opens no fleet to strangers.
///
/// @param place  of kMaxParticipants on this machine, from 0 on; nothing: the first one that is free
/// @errors  a sentence for a person: a name, an address or an interface that can't be used
std::expected<std::string, std::string> configuration_of(const Network& network,
                                                         std::optional<int> place = std::nullopt);

}  // namespace mlab::dds
