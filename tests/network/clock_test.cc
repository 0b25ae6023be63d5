// Clocks of hosts: the wall clock by a preloaded library, the monotonic one by a namespace.

#include <cstdlib>
#include <optional>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "network/test_network.h"

namespace mlab::network {
namespace {

using namespace std::chrono_literals;

struct Clocks {
  double wall = 0.0;       ///< [ms]
  double monotonic = 0.0;  ///< [ms]
};

class ClockTest : public testing::Test {
 protected:
  void SetUp() override { MLAB_NEEDS_HOSTS(); }

  static Clocks clocks_of(Host& host, bool follows_clock) {
    Process process = host.start({MLAB_NETWORK_TALK, "clocks"}, {.follows_clock = follows_clock});
    EXPECT_TRUE(process.wait(10s)) << process.errors();
    Clocks out;
    std::istringstream(process.output()) >> out.wall >> out.monotonic;
    return out;
  }
  static double seconds_of(auto time) {
    return std::chrono::duration<double, std::milli>(time.time_since_epoch()).count();
  }
  static double wall() { return seconds_of(std::chrono::system_clock::now()); }
  static double monotonic() { return seconds_of(Clock::now()); }
};

constexpr double kPatience = 20'000.0;  // for a process to start on a busy machine [ms]

TEST_F(ClockTest, IsSetBackForThoseThatFollowItAndNobodyElse) {
  TestNetwork network({.hosts = {{"alpha"}, {"bravo"}}});
  network.host("alpha").set_clock(-1h);
  EXPECT_NEAR(clocks_of(network.host("alpha"), true).wall, wall() - 3'600'000.0, kPatience);
  EXPECT_NEAR(clocks_of(network.host("alpha"), false).wall, wall(), kPatience);
  EXPECT_NEAR(clocks_of(network.host("bravo"), true).wall, wall(), kPatience);
  EXPECT_NEAR(clocks_of(network.host("alpha"), true).monotonic, monotonic(), kPatience);
}

TEST_F(ClockTest, IsSetWhileProgramsRun) {
  TestNetwork network({.hosts = {{"alpha"}}});
  Process process =
      network.host("alpha").start({"sh", "-c", "while read x; do date +%s; done"}, {.follows_clock = true});
  process.write("\n");
  ASSERT_TRUE(process.prints("\n", 10s)) << process.errors();
  network.host("alpha").set_clock(24h);
  process.write("\n");
  process.close_input();
  ASSERT_TRUE(process.wait(10s));
  double before = 0.0;
  double after = 0.0;
  std::istringstream(process.output()) >> before >> after;
  EXPECT_NEAR(after - before, 86'400.0, kPatience / 1000.0);
}

TEST_F(ClockTest, AWaitIsAsLongAsItWasMeantIfTheClockWasSetBefore) {
  TestNetwork network({.hosts = {{"alpha"}}});
  network.host("alpha").set_clock(-1h);
  Process process = network.host("alpha").start({MLAB_NETWORK_TALK, "wait", "0.2"}, {.follows_clock = true});
  ASSERT_TRUE(process.wait(20s)) << process.errors();
  const std::string text = process.output();
  EXPECT_GE(std::atof(text.c_str() + text.find("waited ") + 7), 200.0);
}

TEST_F(ClockTest, AWaitGetsLongerOrShorterIfTheClockIsSetMeanwhile) {
  TestNetwork network({.hosts = {{"alpha"}}});
  Host& host = network.host("alpha");
  Process process = host.start({MLAB_NETWORK_TALK, "wait", "1000"}, {.follows_clock = true});
  ASSERT_TRUE(process.prints("ready", 10s)) << process.errors();
  host.set_clock(900s);
  EXPECT_FALSE(process.prints("waited", 200ms));
  host.set_clock(1001s);
  EXPECT_TRUE(process.prints("waited", 20s)) << process.output();
}

TEST_F(ClockTest, MachinesHaveRunForDifferentTimes) {
  std::optional<TestNetwork> made;
  try {
    made.emplace(NetworkSetup{.hosts = {{"alpha"}, {"bravo", 36h}}});
  } catch (const std::runtime_error& failure) {
    GTEST_SKIP() << failure.what();  // a kernel without time namespaces
  }
  TestNetwork& network = *made;
  EXPECT_NEAR(clocks_of(network.host("alpha"), false).monotonic, monotonic(), kPatience);
  EXPECT_NEAR(clocks_of(network.host("bravo"), false).monotonic, monotonic() + 36.0 * 3'600'000.0, kPatience);
}

}  // namespace
}  // namespace mlab::network
