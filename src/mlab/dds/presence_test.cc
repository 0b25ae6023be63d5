// Who is there, who is not, and how soon that is known.

#include <csignal>
#include <set>
#include <thread>

#include <gtest/gtest.h>

#include "mlab/dds/participant.h"
#include "mlab/dds/testing/fleet.h"

namespace mlab::dds {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;
using Kind = Arrival::Kind;

TEST(DdsPresence, OfAProcessThatIsKilledIsLostWithinASecond) {
  Participant here = participant();
  Waiter waits = waiter();
  Reader life = reader(here, "life", ChannelKind::kSignsOfLife, waits);
  Peer peer({"presence", "veh-1"});
  const Arrival came = first_of(arrivals(waits, life, Kind::kMessage), Kind::kMessage);
  ASSERT_EQ(came.key, "veh-1");
  const auto killed = Clock::now();
  peer.signal(SIGKILL);
  const auto all = arrivals(waits, life, Kind::kSilent);
  const Arrival silent = first_of(all, Kind::kSilent);
  EXPECT_EQ(silent.sender, came.sender);
  EXPECT_LT(silent.noticed - killed, milliseconds(1000));
  EXPECT_TRUE(life.senders().empty());
  // Its keys are told as well, beside or after it.
  const auto keys = first_of(all, Kind::kOrphaned).key.empty() ? arrivals(waits, life, Kind::kOrphaned) : all;
  EXPECT_EQ(first_of(keys, Kind::kOrphaned).key, "veh-1");
  EXPECT_EQ(first_of(arrivals(waits, life, Kind::kUnmatched), Kind::kUnmatched).sender, came.sender);
}

TEST(DdsPresence, OfAProcessThatIsStoppedIsLostAndComesBackWithIt) {
  Participant here = participant();
  Waiter waits = waiter();
  Reader life = reader(here, "life", ChannelKind::kSignsOfLife, waits);
  const Peer peer({"presence", "veh-1"});
  const Arrival came = first_of(arrivals(waits, life, Kind::kMessage), Kind::kMessage);
  for (int i = 0; i < 2; ++i) {
    const auto stopped = Clock::now();
    peer.signal(SIGSTOP);
    const auto gone = arrivals(waits, life, Kind::kSilent);
    EXPECT_EQ(first_of(gone, Kind::kSilent).sender, came.sender);
    EXPECT_LT(first_of(gone, Kind::kSilent).noticed - stopped, milliseconds(1000));
    peer.signal(SIGCONT);
    // On a busy machine it may have been silent, and come back, just before it was stopped.
    const bool was_back = first_of(gone, Kind::kAlive).sender == came.sender;
    const auto back = was_back ? gone : arrivals(waits, life, Kind::kAlive);
    EXPECT_EQ(first_of(back, Kind::kAlive).sender, came.sender);
    EXPECT_TRUE(comes_true(waits, [&] {
      life.take();
      return life.senders() == std::vector{came.sender};
    }));
  }
}

TEST(DdsPresence, OfAProcessThatWasStoppedForLongIsFoundAnew) {
  Participant here = participant();
  Waiter waits = waiter();
  Reader life = reader(here, "life", ChannelKind::kSignsOfLife, waits);
  const Peer peer({"presence", "veh-1"});
  ASSERT_FALSE(bodies(arrivals(waits, life, Kind::kMessage)).empty());
  peer.signal(SIGSTOP);
  arrivals(waits, life, Kind::kUnmatched);
  peer.signal(SIGCONT);
  const auto again = arrivals(waits, life, Kind::kMessage);
  EXPECT_EQ(first_of(again, Kind::kMessage).key, "veh-1");
  EXPECT_NE(first_of(again, Kind::kMatched).sender, Guid{});
}

TEST(DdsPresence, OfTwentyProcessesIsKnownWithinFiveSeconds) {
  constexpr std::size_t kProcesses = 20;
  Participant here = participant();
  Waiter waits = waiter();
  Reader presence = reader(here, "presence", ChannelKind::kPresence, waits);
  const auto began = Clock::now();
  std::vector<Peer> peers;
  for (std::size_t i = 0; i < kProcesses; ++i)
    peers.emplace_back(std::vector<std::string>{"presence", "veh-" + std::to_string(i)});
  std::set<std::string> found;
  EXPECT_TRUE(comes_true(waits, [&] {
    for (const Arrival& arrival : presence.take()) {
      if (arrival.kind == Kind::kMessage) found.insert(arrival.key);
    }
    return found.size() == kProcesses;
  }));
  const auto took = std::chrono::duration_cast<milliseconds>(Clock::now() - began);
  RecordProperty("milliseconds", static_cast<int>(took.count()));
  EXPECT_LT(took, milliseconds(5000));
}

TEST(DdsPresence, IsNotLostWhileEveryFifthPacketIs) {
  Participant here = participant(200);
  Waiter waits = waiter();
  Reader life = reader(here, "life", ChannelKind::kSignsOfLife, waits);
  const Peer peer({"presence", "veh-1"}, 200);
  const auto all = arrivals(waits, life, Kind::kMessage);
  ASSERT_EQ(first_of(all, Kind::kMessage).key, "veh-1");
  const auto later = arrivals(waits, life, Kind::kUnmatched, 1, milliseconds(6000));
  EXPECT_EQ(first_of(later, Kind::kUnmatched).sender, Guid{});
}

}  // namespace
}  // namespace mlab::dds
