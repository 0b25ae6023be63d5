#include "mlab/dds/network.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "mlab/dds/channel.h"
#include "mlab/dds/loopback_multicast.h"

namespace mlab::dds {
namespace {

std::string refusal(const Network& network) {
  const auto made = configuration_of(network);
  return made ? "" : made.error();
}

Network fleet_called(const std::string& name) {
  return {.fleet = name, .interface_name = {}, .peers = {}, .lost_of_thousand = 0};
}

TEST(DdsNetwork, EveryPortOfEveryFleetLiesBelowThoseThatLinuxHandsOut) {
  for (int i = 0; i < 2000; ++i) {
    const int domain = domain_of("fleet" + std::to_string(i));
    ASSERT_GE(domain, 1);
    const int last_port = 7400 + 250 * domain + 11 + 2 * (kMaxParticipants - 1);
    ASSERT_LT(last_port, 32768);
    ASSERT_LT(last_port, 7400 + 250 * (domain + 1)) << "in the ports of the next domain";
  }
}

TEST(DdsNetwork, AFleetHasTheSameDomainOnEveryMachine) {
  EXPECT_EQ(domain_of("alpha"), domain_of("alpha"));
  EXPECT_EQ(domain_of("alpha"), 50);
  EXPECT_EQ(domain_of("bravo"), 34);
  EXPECT_EQ(partition_of("alpha"), "mlab/alpha");
}

TEST(DdsNetwork, NothingLeavesTheMachineUnlessAnInterfaceIsNamed) {
  const std::string words = configuration_of(fleet_called("alpha")).value();
  // Those that listen to no multicast are found by looking at all ports.
  const bool is_multicast = carries_loopback_multicast();
  EXPECT_NE(
      words.find(fmt::format("<NetworkInterface address=\"127.0.0.1\" multicast=\"{}\"/>", is_multicast)),
      std::string::npos);
  EXPECT_NE(words.find(fmt::format("<AllowMulticast>{}</AllowMulticast>", is_multicast)), std::string::npos);
  EXPECT_NE(words.find("<Peers><Peer address=\"127.0.0.1\"/></Peers>"), std::string::npos);
  EXPECT_NE(words.find("<SharedMemory><Enable>false</Enable></SharedMemory>"), std::string::npos);
  EXPECT_NE(words.find("<ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>119<"),
            std::string::npos);
}

TEST(DdsNetwork, AnInterfaceMayBeToldByNameOrAddress) {
  Network network = fleet_called("alpha");
  network.interface_name = "lo";
  EXPECT_EQ(configuration_of(network), configuration_of(fleet_called("alpha")));
  network.interface_name = "127.0.0.1";
  EXPECT_TRUE(is_loopback_only(network));
  EXPECT_EQ(own_address_on(network), "127.0.0.1");
  EXPECT_EQ(own_address_on(fleet_called("alpha")), "127.0.0.1");
  network.peers = {"127.0.0.2"};
  EXPECT_NE(configuration_of(network).value().find("<Peer address=\"127.0.0.2\"/>"), std::string::npos);
}

TEST(DdsNetwork, WhoAvoidsItsNeighboursLooksAtNoPlaceOfItsMachine) {
  Network network = fleet_called("alpha");
  network.avoids_neighbours = true;
  network.peers = {"127.0.0.1", "127.0.0.2"};
  const std::string words = configuration_of(network).value();
  // It says to those who listen that it is there, and does not listen.
  EXPECT_NE(words.find(carries_loopback_multicast() ? "<Peers><Peer address=\"239.255.0.1\"/></Peers>"
                                                    : "<Peers></Peers>"),
            std::string::npos);
  EXPECT_NE(words.find("<AllowMulticast>false</AllowMulticast>"), std::string::npos);
}

TEST(DdsNetwork, FleetsWithoutAProperNameAreRefused) {
  EXPECT_EQ(refusal(fleet_called("")), "the fleet has no name");
  EXPECT_EQ(refusal(fleet_called(std::string(65, 'a'))), "the fleet's name has 65 letters: 64 at most");
  // A partition with a star would be one with all fleets; the others would be words of the configuration.
  for (const std::string name : {"a*", "a?", "a,b", "a b", "<a>", "${HOME}", "a/b", "\xc3\xa4", "a\nb"}) {
    EXPECT_NE(refusal(fleet_called(name)).find("letters, digits"), std::string::npos) << name;
  }
  EXPECT_EQ(refusal(fleet_called("a*")),
            "the fleet's name `a*` has a `*`: letters, digits, `-`, `_` and `.` it may have");
  EXPECT_EQ(refusal(fleet_called("Alpha-2_b.c")), "");
}

TEST(DdsNetwork, InterfacesThatAreNotThereAreRefusedByNameWithThoseThatAre) {
  Network network = fleet_called("alpha");
  network.interface_name = "nosuch0";
  EXPECT_NE(refusal(network).find("no network interface `nosuch0` with an IPv4 address: there is"),
            std::string::npos);
  EXPECT_NE(refusal(network).find("(127.0.0.1)"), std::string::npos);
  for (const std::string name : {"203.0.113.77", "::1", "lo\"/>", "300.1.1.1"}) {
    network.interface_name = name;
    EXPECT_NE(refusal(network).find("no network interface"), std::string::npos) << name;
  }
}

TEST(DdsNetwork, PeersThatAreNoAddressesOrOutOfReachAreRefused) {
  Network network = fleet_called("alpha");
  network.peers = {"localhost"};
  EXPECT_EQ(refusal(network), "`localhost` is no IPv4 address such as 10.0.0.7: names are not looked up");
  network.peers = {"10.0.0.7"};
  EXPECT_EQ(refusal(network),
            "`10.0.0.7` can't be reached: without a network interface nothing leaves this machine");
  network.peers = std::vector<std::string>(101, "127.0.0.1");
  EXPECT_EQ(refusal(network), "101 machines are to be looked at: 100 at most");
}

TEST(DdsNetwork, MoreThanAllPacketsCantBeDropped) {
  Network network = fleet_called("alpha");
  network.lost_of_thousand = 1000;
  EXPECT_EQ(refusal(network), "1000 of a thousand packets can't be dropped: 0 to 999");
  network.lost_of_thousand = -1;
  EXPECT_EQ(refusal(network), "-1 of a thousand packets can't be dropped: 0 to 999");
}

TEST(DdsChannels, HaveNamesOfTheirOwnAndTellLossFast) {
  for (const ChannelInfo& one : kChannels) {
    EXPECT_FALSE(one.reason.empty());
    EXPECT_LE(one.longest_wait.count(), 100) << one.name;
    // Only what is sent again can be kept for who comes late, or has to wait for place.
    EXPECT_TRUE(one.is_reliable || (!one.is_for_latecomers && one.longest_wait.count() == 0)) << one.name;
    EXPECT_TRUE(one.is_reliable || !one.is_asked_after) << one.name;
    for (const ChannelInfo& other : kChannels) EXPECT_TRUE(&one == &other || one.name != other.name);
  }
  EXPECT_EQ(info(ChannelKind::kSignsOfLife).lease.count(), 600);
}

}  // namespace
}  // namespace mlab::dds
