// What arrives where packets are lost, or nobody takes them.

#include <algorithm>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>

#include "mlab/dds/participant.h"
#include "mlab/dds/testing/fleet.h"

namespace mlab::dds {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;
using Kind = Arrival::Kind;

constexpr int kOneInFive = 200;

TEST(DdsLoss, ReliableChannelsBringAllInOrderThoughEveryFifthPacketIsLost) {
  constexpr std::size_t kMessages = 10'000;
  Participant here = participant(kOneInFive);
  Waiter waits = waiter();
  Reader events = reader(here, "events", ChannelKind::kEvents, waits);
  const Peer peer({"send", "events", std::to_string(kMessages)}, kOneInFive);
  const auto all = bodies(arrivals(waits, events, Kind::kMessage, kMessages, std::chrono::seconds(120)));
  for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(all[i], std::to_string(i));
  ASSERT_EQ(all.size(), kMessages);
}

TEST(DdsLoss, LockStepGoesOnThoughEveryFifthPacketIsLost) {
  Participant here = participant(kOneInFive);
  Waiter waits = waiter();
  Writer percepts = writer(here, "veh-1/percepts", ChannelKind::kLockStepPercepts, &waits);
  Reader actions = reader(here, "actions", ChannelKind::kActions, waits);
  const Peer peer({"echo", "veh-1/percepts", "actions"}, kOneInFive);
  ASSERT_TRUE(comes_true(waits, [&] { return !percepts.readers().empty() && !actions.senders().empty(); }));
  const auto began = Clock::now();
  constexpr int kCycles = 200;
  for (int i = 0; i < kCycles; ++i) {
    write_surely(percepts, "veh-1", std::to_string(i));
    ASSERT_EQ(bodies(arrivals(waits, actions, Kind::kMessage)), std::vector{std::to_string(i)})
        << testing::PrintToString(here.complaints());
  }
  const double each = std::chrono::duration<double, std::milli>(Clock::now() - began).count() / kCycles;
  RecordProperty("milliseconds_for_a_cycle", std::to_string(each));
  EXPECT_LT(each, 200.0);
}

TEST(DdsLoss, WhatIsWrittenOnceAReaderIsKnownArrives) {
  for (int i = 0; i < 10; ++i) {
    Participant here = participant(kOneInFive);
    Participant there = participant(kOneInFive);
    Waiter waits = waiter();
    Waiter waits_there = waiter();
    Writer percepts = writer(here, "percepts", ChannelKind::kLockStepPercepts, &waits);
    Reader reads = reader(there, "percepts", ChannelKind::kLockStepPercepts, waits_there);
    ASSERT_TRUE(comes_true(waits, [&] { return !percepts.readers().empty(); }));
    write_surely(percepts, "", "first");
    ASSERT_EQ(bodies(arrivals(waits_there, reads, Kind::kMessage)), std::vector<std::string>{"first"});
  }
}

TEST(DdsLoss, ALongBodyArrivesThoughEveryFifthPacketIsLost) {
  Participant here = participant(kOneInFive);
  Waiter waits = waiter();
  Writer percepts = writer(here, "veh-1/percepts", ChannelKind::kLockStepPercepts, &waits);
  Reader actions = reader(here, "actions", ChannelKind::kActions, waits);
  const Peer peer({"echo", "veh-1/percepts", "actions"}, kOneInFive);
  ASSERT_TRUE(comes_true(waits, [&] { return !percepts.readers().empty() && !actions.senders().empty(); }));
  const std::string body(300'000, 'x');
  write_surely(percepts, "veh-1", body);
  const auto back = bodies(arrivals(waits, actions, Kind::kMessage));
  ASSERT_EQ(back.size(), 1U);
  EXPECT_TRUE(back.front() == body);
}

TEST(DdsLoss, WritingToAReaderThatIsStoppedIsRefusedInTimeAndGoesOnAfterwards) {
  Participant here = participant();
  Waiter waits = waiter();
  Writer commands = writer(here, "veh-1/commands", ChannelKind::kCommands, &waits);
  const Peer peer({"read", "veh-1/commands"});
  ASSERT_TRUE(comes_true(waits, [&] { return !commands.readers().empty(); }));
  peer.signal(SIGSTOP);
  const std::string body(1000, 'x');
  bool is_full = false;
  milliseconds longest{0};
  for (int i = 0; i < 100'000 && !is_full; ++i) {
    const auto began = Clock::now();
    is_full = commands.write("", body) == Written::kFull;
    longest = std::max(longest, std::chrono::duration_cast<milliseconds>(Clock::now() - began));
  }
  EXPECT_TRUE(is_full);
  EXPECT_LT(longest.count(), 2000) << "20 where the machine has nothing else to do";
  peer.signal(SIGCONT);
  EXPECT_TRUE(comes_true(waits, [&] { return commands.write("", body) == Written::kDone; }));
}

TEST(DdsLoss, WritingToAReaderThatIsGoneIsRefusedOnlyUntilItIsGivenUp) {
  Participant here = participant();
  Waiter waits = waiter();
  Writer commands = writer(here, "veh-1/commands", ChannelKind::kCommands, &waits);
  {
    const Peer peer({"read", "veh-1/commands"});
    ASSERT_TRUE(comes_true(waits, [&] { return !commands.readers().empty(); }));
  }
  const auto killed = Clock::now();
  ASSERT_TRUE(comes_true(waits, [&] { return commands.readers().empty(); }));
  EXPECT_LT(Clock::now() - killed, std::chrono::seconds(10));
  EXPECT_EQ(commands.write("", "to nobody"), Written::kDone);
}

TEST(DdsLoss, NobodyWaitsForAReaderWhoseOwnerTakesNothing) {
  Participant here = participant();
  Participant there = participant();
  Waiter waits = waiter();
  Writer events = writer(there, "events", ChannelKind::kEvents, &waits);
  Writer others = writer(there, "others", ChannelKind::kEvents, &waits);
  Reader sleeps = reader(here, "events", ChannelKind::kEvents, waits);
  Reader reads = reader(here, "others", ChannelKind::kEvents, waits);
  ASSERT_TRUE(comes_true(waits, [&] { return !events.readers().empty() && !others.readers().empty(); }));
  const std::string body(kMaxBody, 'x');
  const std::size_t too_many = Reader::kMaxWaitingBytes / kMaxBody + 5;
  for (std::size_t i = 0; i < too_many; ++i) write_surely(events, "", body);
  write_surely(others, "", "heard");
  EXPECT_EQ(bodies(arrivals(waits, reads, Kind::kMessage)), std::vector<std::string>{"heard"});
  std::size_t got = 0;
  ASSERT_TRUE(comes_true(waits, [&] {
    for (const Arrival& arrival : sleeps.take()) {
      if (arrival.kind == Kind::kMessage) ++got;
      if (arrival.kind == Kind::kLost) got += arrival.lost;
    }
    return got == too_many;
  }));
}

TEST(DdsLoss, OfLivePerceptsOnlyTheNewestWaits) {
  Participant here = participant();
  Participant there = participant();
  Waiter waits = waiter();
  Writer percepts = writer(there, "percepts", ChannelKind::kLivePercepts, &waits);
  Reader reads = reader(here, "percepts", ChannelKind::kLivePercepts, waits);
  ASSERT_TRUE(comes_true(waits, [&] { return !percepts.readers().empty() && !reads.senders().empty(); }));
  reads.take();
  for (int i = 0; i < 50; ++i) ASSERT_EQ(percepts.write("veh-1", std::to_string(i)), Written::kDone);
  // Best effort: written again, as who senses does, the last one comes.
  ASSERT_TRUE(comes_true(waits, [&] {
    EXPECT_EQ(percepts.write("veh-1", "last"), Written::kDone);
    std::this_thread::sleep_for(milliseconds(20));
    const auto all = reads.take();
    EXPECT_LE(all.size(), 1U);
    return !all.empty() && all.back().body == "last";
  }));
}

}  // namespace
}  // namespace mlab::dds
