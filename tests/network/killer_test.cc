#include "network/killer.h"

#include <csignal>

#include <gtest/gtest.h>

#include "network/test_network.h"

namespace mlab::network {
namespace {

using namespace std::chrono_literals;

TEST(PlannedStrikes, AreTheSameForASeedAndEvenOverSpanVictimsAndKinds) {
  const KillerSetup setup{.seed = 4, .span = 10s, .strikes = 1000, .shortest_stop = 1s, .longest_stop = 2s};
  const std::vector<Strike> strikes = planned_strikes(setup, 4);
  const std::vector<Strike> again = planned_strikes(setup, 4);
  ASSERT_EQ(strikes.size(), 1000U);
  int stops = 0;
  int early = 0;
  std::array<int, 4> struck{};
  for (std::size_t i = 0; i < strikes.size(); ++i) {
    const Strike& one = strikes[i];
    EXPECT_EQ(one.at, again[i].at);
    EXPECT_EQ(one.victim, again[i].victim);
    EXPECT_LT(one.at, 10s);
    EXPECT_GE(one.at, i > 0 ? strikes[i - 1].at : Duration(0));
    stops += one.is_stop ? 1 : 0;
    early += one.at < 5s ? 1 : 0;
    ++struck.at(one.victim);
    EXPECT_EQ(one.is_stop, one.stopped_for >= 1s);
    EXPECT_LE(one.stopped_for, 2s);
  }
  EXPECT_NEAR(stops, 500, 80);
  EXPECT_NEAR(early, 500, 80);
  for (const int count : struck) EXPECT_NEAR(count, 250, 70);
  EXPECT_NE(planned_strikes({.seed = 5}, 1).front().at, planned_strikes({.seed = 6}, 1).front().at);
}

TEST(PlannedStrikes, AreOnlyOfTheKindsThatAreWanted) {
  for (const Strike& one : planned_strikes({.strikes = 50, .stops = false}, 2)) EXPECT_FALSE(one.is_stop);
  for (const Strike& one : planned_strikes({.strikes = 50, .kills = false}, 2)) EXPECT_TRUE(one.is_stop);
  EXPECT_TRUE(planned_strikes({.kills = false, .stops = false}, 2).empty());
  EXPECT_TRUE(planned_strikes({}, 0).empty());
}

class KillerTest : public testing::Test {
 protected:
  void SetUp() override {
    MLAB_NEEDS_HOSTS();
    network_ = std::make_unique<TestNetwork>(NetworkSetup{.hosts = {{"alpha"}}});
  }
  Process start_sleep() const { return network_->host("alpha").start({"sleep", "1000"}); }

  std::unique_ptr<TestNetwork> network_;
};

TEST_F(KillerTest, KillsWhatIsPlanned) {
  Process one = start_sleep();
  Process other = start_sleep();
  const KillerSetup setup{.seed = 9, .span = 100ms, .strikes = 1, .stops = false};
  const bool is_one = planned_strikes(setup, 2).front().victim == 0;
  Killer killer(setup, {one.victim(), other.victim()});
  killer.wait();
  EXPECT_EQ((is_one ? one : other).wait(10s)->words(), "killed by SIGKILL");
  EXPECT_TRUE((is_one ? other : one).is_running());
  ASSERT_EQ(killer.done().size(), 1U);
  EXPECT_NE(killer.done()[0].find("SIGKILL to sleep"), std::string::npos);
}

TEST_F(KillerTest, WhoIsStoppedGoesOn) {
  Process process = start_sleep();
  Killer killer({.span = 10ms, .strikes = 3, .kills = false, .shortest_stop = 20ms, .longest_stop = 50ms},
                {process.victim()});
  killer.wait();
  EXPECT_EQ(killer.done().size(), 6U);
  for (const Seen& one : network_->host("alpha").processes()) EXPECT_NE(one.state, 'T');
}

TEST_F(KillerTest, StrikesNoMoreOnceItIsGoneAndLetsWhoIsStoppedGoOn) {
  Process process = start_sleep();
  const Time begin = Clock::now();
  {
    Killer killer({.span = 1ms, .strikes = 1, .kills = false, .shortest_stop = 1000s, .longest_stop = 1001s},
                  {process.victim()});
    const Killer never({.seed = 2, .span = 1000s}, {process.victim()});
    while (killer.done().empty()) std::this_thread::sleep_for(1ms);
  }
  EXPECT_LT(Clock::now() - begin, 100s);
  EXPECT_TRUE(process.is_running());
  for (const Seen& one : network_->host("alpha").processes()) EXPECT_NE(one.state, 'T');
}

TEST_F(KillerTest, StrikesProcessesThatOthersStarted) {
  const Process process =
      network_->host("alpha").start({"sh", "-c", "sleep 1000 & echo ready; wait; exec sleep 1000"});
  ASSERT_TRUE(process.prints("ready", 10s));
  std::vector<Victim> victims;
  for (int i = 0; i < 500 && victims.empty(); ++i) {
    for (const Seen& one : descendants_of(process.id())) {
      if (one.name == "sleep") victims.emplace_back(one);
    }
    std::this_thread::sleep_for(10ms);
  }
  ASSERT_EQ(victims.size(), 1U);
  Killer({.span = 1ms, .stops = false}, victims).wait();
  for (int i = 0; i < 500 && victims[0].is_alive(); ++i) std::this_thread::sleep_for(10ms);
  EXPECT_FALSE(victims[0].is_alive());
}

}  // namespace
}  // namespace mlab::network
