// The relay's thread, between sockets of this process instead of hosts: without namespaces, so on any
// machine.

#include "network/relay.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <set>
#include <thread>

#include <gtest/gtest.h>

namespace mlab::network {
namespace {

using std::chrono::milliseconds;

using Frame = std::vector<std::uint8_t>;

// A UDP packet of IPv4 to 10.77.0.HOST, as much of it as the relay looks at.
Frame frame_to(int host, std::uint8_t number, std::uint8_t protocol = 17) {
  Frame out(60);
  out[12] = 0x08;
  out[14] = 0x45;
  out[23] = protocol;
  const std::array<std::uint8_t, 4> address = {10, 77, 0, static_cast<std::uint8_t>(host)};
  std::ranges::copy(address, out.begin() + 30);
  out[59] = number;
  return out;
}

/// Three hosts that are sockets.
class RelayTest : public testing::Test {
 protected:
  RelayTest() {
    for (int host = 1; host <= 3; ++host) {
      std::array<int, 2> ends{};
      EXPECT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends.data()), 0);
      relay_.attach(host, Descriptor(ends[0]));
      ends_.emplace_back(ends[1]);
    }
  }

  void send(int from, const Frame& frame) const {
    ASSERT_EQ(::write(end(from), frame.data(), frame.size()), static_cast<ssize_t>(frame.size()));
  }
  // The last byte of the next frame; -1: none came.
  int receive(int host, int patience_ms = 5000) const {
    pollfd wanted{end(host), POLLIN, 0};
    Frame frame(2000);
    if (::poll(&wanted, 1, patience_ms) <= 0 || ::read(end(host), frame.data(), frame.size()) != 60)
      return -1;
    EXPECT_EQ(frame[5], host) << "addressed to its hardware";
    return frame[59];
  }
  int end(int host) const { return ends_.at(static_cast<std::size_t>(host) - 1).number(); }

  Relay relay_{11};
  std::vector<Descriptor> ends_;
};

TEST_F(RelayTest, HandsEachPacketToWhomItIsForAndNobodyElse) {
  send(1, frame_to(2, 42));
  EXPECT_EQ(receive(2), 42);
  EXPECT_EQ(receive(3, 50), -1);
  EXPECT_EQ(relay_.counters(1, 2).delivered, 1U);
  EXPECT_EQ(relay_.counters(1, 2).bytes, 60U);
  EXPECT_EQ(relay_.total().sent, 1U);
}

TEST_F(RelayTest, IgnoresWhatIsForNobody) {
  send(1, frame_to(9, 1));
  send(1, frame_to(1, 2));
  send(1, frame_to(2, 3, 2));  // IGMP
  send(1, Frame(20));
  Frame arp = frame_to(2, 4);
  arp[13] = 0x06;
  send(1, arp);
  send(1, frame_to(2, 5));
  EXPECT_EQ(receive(2), 5);
  EXPECT_EQ(relay_.ignored(), 5U);
}

TEST_F(RelayTest, DelaysAndKeepsTheOrder) {
  relay_.set({.delay = milliseconds(80), .jitter = milliseconds(40)});
  const Time begin = Clock::now();
  for (std::uint8_t i = 0; i < 20; ++i) send(1, frame_to(2, i));
  for (int i = 0; i < 20; ++i) ASSERT_EQ(receive(2), i);
  EXPECT_GE(Clock::now() - begin, milliseconds(80));  // the longest of twenty is hardly below the middle
  EXPECT_EQ(relay_.counters(1, 2).delayed, 20U);
}

TEST_F(RelayTest, DropsWhatIsUnderWayOnceTheLinkIsCut) {
  relay_.set(1, 2, {.delay = milliseconds(100)});
  send(1, frame_to(2, 1));
  send(1, frame_to(3, 2));
  EXPECT_EQ(receive(3), 2);  // so the relay has both
  relay_.cut(1, 2, true);
  EXPECT_EQ(receive(2, 200), -1);
  relay_.cut(1, 2, false);
  send(1, frame_to(2, 3));
  EXPECT_EQ(receive(2), 3);
  EXPECT_EQ(relay_.counters(1, 2).cut, 1U);
}

TEST_F(RelayTest, DropsWhatIsUnderWayToAHostThatGoes) {
  relay_.set({.delay = milliseconds(50)});
  send(1, frame_to(2, 1));
  send(1, frame_to(3, 2));
  EXPECT_EQ(receive(3), 2);
  send(1, frame_to(2, 3));
  std::this_thread::sleep_for(milliseconds(10));
  relay_.detach(2);
  send(1, frame_to(2, 4));
  send(1, frame_to(3, 5));
  EXPECT_EQ(receive(3), 5);
  EXPECT_EQ(relay_.counters(1, 2).sent, 3U);
  EXPECT_EQ(relay_.counters(1, 2).cut, 2U);
}

TEST_F(RelayTest, LosesTheSamePacketsWithTheSameSeedAndCountsEachOnce) {
  relay_.set({.loss = 0.3, .reordering = 0.1, .held_back = milliseconds(1), .duplication = 0.1});
  std::set<int> expected;
  Wire wire(11, 1, 2);
  for (int i = 0; i < 200; ++i) {
    if (wire.next(relay_.link(1, 2), 60, Clock::now()).end == Fate::End::kArrives) expected.insert(i);
  }
  std::set<int> found;
  for (int i = 0; i < 200; ++i) send(1, frame_to(2, static_cast<std::uint8_t>(i)));
  for (int one = receive(2); one >= 0; one = receive(2, 200)) found.insert(one);
  EXPECT_EQ(found, expected);
  const Counters counters = relay_.counters(1, 2);
  EXPECT_EQ(counters.sent, 200U);
  EXPECT_EQ(counters.delivered + counters.lost, 200U) << counters.words();
  EXPECT_GT(counters.duplicated, 0U);
  EXPECT_GT(counters.reordered, 0U);
}

TEST_F(RelayTest, TakesSettingsFromManyThreadsWhilePacketsGo) {
  std::vector<std::thread> threads;
  threads.emplace_back([&] {
    for (int i = 0; i < 300; ++i) relay_.set({.delay = std::chrono::microseconds(i)});
  });
  threads.emplace_back([&] {
    for (int i = 0; i < 300; ++i) relay_.cut(1, 3, i % 2 == 0);
  });
  for (int i = 0; i < 200; ++i) {
    send(1, frame_to(2, static_cast<std::uint8_t>(i)));
    ASSERT_EQ(receive(2), i);
    ASSERT_LE(relay_.total().delivered, 200U);
  }
  for (std::thread& one : threads) one.join();
}

}  // namespace
}  // namespace mlab::network
