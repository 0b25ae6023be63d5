#include "mlab/dds/network.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "mlab/base/hash.h"
#include "mlab/dds/loopback_multicast.h"
#include "mlab/dds/message.h"
#include "mlab/text/shown.h"

namespace mlab::dds {
namespace {

constexpr std::size_t kMaxFleetName = 64;
constexpr std::size_t kMaxPeers = 100;
constexpr int kDomains = 100;
/// What a body is wrapped in, at most [bytes].
constexpr std::size_t kEnvelopeBytes = 4096;

using std::chrono::milliseconds;
/// A participant of which nothing is heard is forgotten: writers wait for it no longer.
constexpr milliseconds kGivenUpAfter{5000};
/// How often a participant says that it is there to those that have not heard of it.
constexpr milliseconds kSaysItIsThereEvery{2000};
/// The same where those of its machine that avoid their neighbours can't say so to it by themselves, and
/// answer only.
constexpr milliseconds kAsksNeighboursEvery{500};
/// At which DDS says to all who listen that somebody is there.
constexpr const char* kGroupAsPeer = "<Peer address=\"239.255.0.1\"/>";
/// How soon what was lost is sent again once that is known, and how often it is asked for. Cyclone's own
/// figures (100 ms, 3 s) spare a busy network; here somebody waits.
constexpr milliseconds kAsksAgainAfter{2};
constexpr milliseconds kAsksAgainEvery{50};

/// How participants keep each other informed of what has arrived.
struct Confirming {
  milliseconds confirms_after{};  ///< what was confirmed a moment ago is not confirmed again
  /// How soon writers ask all readers what they have, those of discovery among them. Who joins has some ten
  /// of each other participant and all ask each: at 2 ms fifty of them were asked more than two processors
  /// can answer, and what came late was asked for again. Where somebody waits, Prompter makes up for it.
  milliseconds asks{};
  milliseconds asks_at_least{};
};
constexpr Confirming kUnsecured{milliseconds{2}, milliseconds{200}, milliseconds{400}};
/// Who proves who he is takes longer, has more writers to ask, and each answer is encrypted: at the intervals
/// above, fifty who join at once are asked some forty times by each writer before they are through.
constexpr Confirming kSecured{milliseconds{10}, milliseconds{500}, milliseconds{2000}};

bool is_fleet_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
         c == '.';
}

std::optional<in_addr> address_in(const std::string& text) {
  in_addr address{};
  if (inet_pton(AF_INET, text.c_str(), &address) != 1) return std::nullopt;
  return address;
}

std::string text_of(in_addr address) {
  char text[INET_ADDRSTRLEN] = {};
  inet_ntop(AF_INET, &address, text, sizeof text);
  return text;
}

/// An interface of this machine as it is now.
struct Interface {
  std::string name;
  in_addr address{};
  bool is_up = false;
  bool is_loopback = false;
  bool has_multicast = false;
};

/// Those with an IPv4 address.
std::vector<Interface> interfaces() {
  ifaddrs* first = nullptr;
  if (getifaddrs(&first) != 0) return {};
  const std::unique_ptr<ifaddrs, decltype(&freeifaddrs)> all(first, &freeifaddrs);
  std::vector<Interface> found;
  for (const ifaddrs* at = first; at != nullptr; at = at->ifa_next) {
    if (at->ifa_addr == nullptr || at->ifa_addr->sa_family != AF_INET) continue;
    found.push_back({.name = at->ifa_name,
                     .address = reinterpret_cast<const sockaddr_in*>(at->ifa_addr)->sin_addr,
                     .is_up = (at->ifa_flags & IFF_UP) != 0,
                     .is_loopback = (at->ifa_flags & IFF_LOOPBACK) != 0,
                     .has_multicast = (at->ifa_flags & IFF_MULTICAST) != 0});
  }
  return found;
}

std::string names_of(const std::vector<Interface>& all) {
  std::string names;
  for (const Interface& one : all) {
    if (one.is_up)
      names += fmt::format("{}`{}` ({})", names.empty() ? "" : ", ", one.name, text_of(one.address));
  }
  return names.empty() ? "none" : names;
}

std::expected<Interface, std::string> interface_called(const std::string& name) {
  const auto all = interfaces();
  const auto address = address_in(name);
  const auto found = std::ranges::find_if(all, [&](const Interface& one) {
    if (name.empty()) return one.is_loopback;
    return address ? one.address.s_addr == address->s_addr : one.name == name;
  });
  if (found != all.end() && found->is_up) return *found;
  if (name.empty())
    return std::unexpected(
        "this machine has no loopback interface that is up: `ip link set lo up` mends that");
  const std::string shown = text::shown(name);
  if (found != all.end()) return std::unexpected(fmt::format("the network interface `{}` is down", shown));
  return std::unexpected(fmt::format(
      "this machine has no network interface `{}` with an IPv4 address: there is {}", shown, names_of(all)));
}

/// How participants find each other, and what is sent to all at once.
struct Finding {
  bool has_multicast = false;     // of the interface, as Cyclone is told
  const char* allowed = "false";  // multicast, as Cyclone calls it
  bool is_heard_here = true;      // what goes to the group, by this machine, too
  std::string peers = {};         // addresses that it says to that it is there
  milliseconds says_it_is_there = kSaysItIsThereEvery;
};

std::string peer_at(in_addr address) {
  return fmt::format("<Peer address=\"{}\"/>", text_of(address));
}

/// On the loopback. Multicast spares a packet for each participant of the machine. Who avoids its neighbours
/// listens to none, so it hears of those only who knock at all places of the machine; to the others it says
/// that it is there.
Finding finding_on_loopback(const Interface& own, bool avoids_neighbours) {
  const bool is_multicast = carries_loopback_multicast();
  Finding out{.has_multicast = is_multicast};
  if (avoids_neighbours) {
    if (is_multicast) out.peers = kGroupAsPeer;
    return out;
  }
  out.peers = peer_at(own.address);
  if (is_multicast)
    out.allowed = "true";
  else
    out.says_it_is_there = kAsksNeighboursEvery;
  return out;
}

/// On a network others are found by multicast, where there is any, and data goes to each by itself, since
/// radio sends multicast slowly and once.
Finding finding_on_network(const Interface& own, bool avoids_neighbours) {
  Finding out{.has_multicast = own.has_multicast};
  if (own.has_multicast) out.allowed = "spdp";
  out.is_heard_here = !avoids_neighbours;
  if (!own.has_multicast && !avoids_neighbours) out.peers = peer_at(own.address);
  if (!avoids_neighbours) out.says_it_is_there = kAsksNeighboursEvery;
  return out;
}

std::string repetition(const Confirming& how) {
  return fmt::format(
      "<NackDelay>{0} ms</NackDelay><AckDelay>{1} ms</AckDelay><AutoReschedNackDelay>{2} "
      "ms</AutoReschedNackDelay>"
      "<HeartbeatInterval min=\"{3} ms\" minsched=\"{3} ms\" max=\"{4} ms\">{3} ms</HeartbeatInterval>",
      kAsksAgainAfter.count(), how.confirms_after.count(), kAsksAgainEvery.count(), how.asks.count(),
      how.asks_at_least.count());
}

std::expected<void, std::string> check_fleet(const std::string& fleet) {
  if (fleet.empty()) return std::unexpected("the fleet has no name");
  if (fleet.size() > kMaxFleetName)
    return std::unexpected(
        fmt::format("the fleet's name has {} letters: {} at most", fleet.size(), kMaxFleetName));
  const auto bad = std::ranges::find_if_not(fleet, is_fleet_letter);
  if (bad == fleet.end()) return {};
  return std::unexpected(
      fmt::format("the fleet's name `{}` has a `{}`: letters, digits, `-`, `_` and `.` it may have",
                  text::shown(fleet), text::shown(std::string(1, *bad))));
}

bool is_of_this_machine(in_addr address) {
  if ((ntohl(address.s_addr) >> 24U) == 127U) return true;
  return std::ranges::any_of(interfaces(),
                             [&](const Interface& one) { return one.address.s_addr == address.s_addr; });
}

/// The addresses at which others are looked for as the network names them, as they stand in the
/// configuration.
std::expected<std::string, std::string> peers_of(const Network& network, const Interface& own) {
  if (network.peers.size() > kMaxPeers)
    return std::unexpected(
        fmt::format("{} machines are to be looked at: {} at most", network.peers.size(), kMaxPeers));
  std::string peers;
  for (const std::string& peer : network.peers) {
    const auto address = address_in(peer);
    if (!address)
      return std::unexpected(fmt::format("`{}` is no IPv4 address such as 10.0.0.7: names are not looked up",
                                         text::shown(peer)));
    if (own.is_loopback && (ntohl(address->s_addr) >> 24U) != 127U)
      return std::unexpected(
          fmt::format("`{}` can't be reached: without a network interface nothing leaves this "
                      "machine",
                      text::shown(peer)));
    if (!network.avoids_neighbours || !is_of_this_machine(*address)) peers += peer_at(*address);
  }
  return peers;
}

}  // namespace

int domain_of(std::string_view fleet) {
  return 1 + static_cast<int>(base::mix_bits(base::hash_text(fleet)) % kDomains);
}

std::string partition_of(std::string_view fleet) {
  return fmt::format("mlab/{}", fleet);
}

std::string own_address_on(const Network& network) {
  const auto own = interface_called(network.interface_name);
  return own ? text_of(own->address) : std::string();
}

bool is_loopback_only(const Network& network) {
  const auto own = interface_called(network.interface_name);
  return own && own->is_loopback;
}

std::expected<std::string, std::string> configuration_of(const Network& network, std::optional<int> place) {
  if (const auto fleet = check_fleet(network.fleet); !fleet) return std::unexpected(fleet.error());
  if (network.lost_of_thousand < 0 || network.lost_of_thousand >= 1000)
    return std::unexpected(
        fmt::format("{} of a thousand packets can't be dropped: 0 to 999", network.lost_of_thousand));
  const auto own = interface_called(network.interface_name);
  if (!own) return std::unexpected(own.error());
  const auto peers = peers_of(network, *own);
  if (!peers) return std::unexpected(peers.error());
  const Finding finding = own->is_loopback ? finding_on_loopback(*own, network.avoids_neighbours)
                                           : finding_on_network(*own, network.avoids_neighbours);
  return fmt::format(
      "<CycloneDDS><Domain Id=\"any\">"
      "<General><Interfaces><NetworkInterface address=\"{}\" multicast=\"{}\"/></Interfaces>"
      "<AllowMulticast>{}</AllowMulticast><EnableMulticastLoopback>{}</EnableMulticastLoopback></General>"
      "<Discovery><ExternalDomainId>{}</ExternalDomainId><Tag>{}</Tag>"
      "<ParticipantIndex>{}</ParticipantIndex><MaxAutoParticipantIndex>{}</MaxAutoParticipantIndex>"
      "<Peers>{}{}</Peers>"
      "<LeaseDuration>{} ms</LeaseDuration><SPDPInterval>{} ms</SPDPInterval></Discovery>"
      "<Internal><MaxSampleSize>{} "
      "B</MaxSampleSize>{}<Test><XmitLossiness>{}</XmitLossiness></Test></Internal>"
      "<SharedMemory><Enable>false</Enable></SharedMemory>"
      "<Tracing><Verbosity>none</Verbosity></Tracing>"
      "</Domain></CycloneDDS>",
      text_of(own->address), finding.has_multicast, finding.allowed, finding.is_heard_here,
      domain_of(network.fleet), network.fleet, place ? std::to_string(*place) : "auto", kMaxParticipants - 1,
      finding.peers, *peers, kGivenUpAfter.count(), finding.says_it_is_there.count(),
      kMaxBody + kEnvelopeBytes, repetition(network.security ? kSecured : kUnsecured),
      network.lost_of_thousand);
}

}  // namespace mlab::dds
