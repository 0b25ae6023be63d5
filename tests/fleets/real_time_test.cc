// Robots on other machines that nobody waits for: the world goes on, whatever the network does.

#include <unistd.h>

#include <csignal>
#include <fstream>
#include <sstream>

#include "fleets.h"

namespace mlab::testing {
namespace {

using network::Process;

// What a process has taken of processors until now [s].
double processor_time(const Process& process) {
  std::ifstream file("/proc/" + std::to_string(process.id()) + "/stat");
  std::string line;
  std::getline(file, line);
  // After the name, which may hold blanks: the 12th and 13th word, proc(5).
  std::istringstream words(line.substr(line.rfind(')') + 2));
  std::string word;
  for (int i = 0; i < 11; ++i) words >> word;
  double user = 0.0;
  double system = 0.0;
  words >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

class RealTime : public Fleets {
 protected:
  /// Two robots fetch three objects, in about 20 s.
  Process errand(const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"--real-time"};
    words.insert(words.end(), more.begin(), more.end());
    return run(base::source_folder() + "/tests/fleets/errand/errand.mdl", words);
  }
  /// @return  how well they kept up
  Json ends_well(Process& far) {
    const auto ending = far.wait(2 * kFleetPatience);
    EXPECT_TRUE(ending) << far.output() << far.errors();
    if (!ending) return {};
    EXPECT_EQ(ending->words(), "exit status 0") << far.output() << far.errors();
    const Json told = report();
    EXPECT_TRUE(told.is_object());
    if (!told.is_object()) return {};
    EXPECT_EQ(told["outcome"], "done");
    EXPECT_EQ(told["deliveries"].size(), 3U) << "what a robot asks for once must not be lost";
    EXPECT_TRUE(come_to_be(0)) << "robots end with their run";
    return told["performance"]["real_time"];
  }
};

TEST_F(RealTime, AMissionSucceedsThoughPacketsAreLostAndLate) {
  make_network(21);
  const Process north = agent("north");
  const Process south = agent("south");
  net().set({.loss = 0.2, .delay = 200ms, .jitter = 5ms, .reordering = 0.05, .held_back = 20ms});
  Process far = errand();
  const Json kept_up = ends_well(far);
  EXPECT_GT(kept_up["robot_cycles"], 150) << "cycles of the mission";
  EXPECT_GT(kept_up["late"], 0) << "a cycle's own action takes two delays";
  EXPECT_GT(kept_up["worst_percept_age_s"], 0.15);
  EXPECT_GT(net().total().lost, 100U);
}

TEST_F(RealTime, ACutOffRobotStandsAndGoesOnWhenItIsBack) {
  make_network(22);
  const Process north = agent("north");
  const Process south = agent("south");
  Process far = errand();
  ASSERT_TRUE(come_to_be(2));
  ASSERT_TRUE(far.prints("MOVETO", kFleetPatience));
  net().isolate(net().host("south"));
  const double before = processor_time(south);
  std::this_thread::sleep_for(10s);
  EXPECT_LT(processor_time(south) - before, 3.0) << "an agent that waits does not spin";
  net().join(net().host("south"));
  const Json kept_up = ends_well(far);
  EXPECT_GE(kept_up["stood"], 80) << "ten seconds, but for those in which its last action counts";
}

TEST_F(RealTime, ACutOffRobotDoesWhatItsFailsafeSays) {
  make_network(27);
  const Process north = agent("north");
  Process far =
      run(base::source_folder() + "/tests/fleets/errand/returning.mdl", {"--real-time", "--patience", "20"});
  ASSERT_TRUE(come_to_be(1));
  ASSERT_TRUE(far.prints("MOVETO", kFleetPatience));
  std::this_thread::sleep_for(4s);  // it is on its way
  net().isolate(net().host("north"));
  EXPECT_TRUE(far.prints("robot 1: `FAILSAFE LINK-LOST AFTER 2 RETURN` acts", kFleetPatience))
      << far.output();
  net().join(net().host("north"));
  const auto ending = far.wait(2 * kFleetPatience);
  ASSERT_TRUE(ending) << far.output() << far.errors();
  EXPECT_EQ(ending->words(), "exit status 1") << "it is back where it began, and does not go on by itself";
  const Json robot = report()["robots"][0];
  EXPECT_GT(robot["distance_m"].get<double>(), 10.0) << "it was on its way";
  EXPECT_NEAR(robot["end"]["x_m"].get<double>(), 20.0, 1.0) << robot;
}

// Packets come, all of them: the link is not lost, and what the robot acts on is old all the same.
TEST_F(RealTime, ARobotStandsWhileWhatItActsOnIsTooOld) {
  make_network(28);
  const Process north = agent("north");
  Process far =
      run(base::source_folder() + "/tests/fleets/errand/late.mdl", {"--real-time", "--patience", "20"});
  ASSERT_TRUE(come_to_be(1));
  ASSERT_TRUE(far.prints("MOVETO", kFleetPatience));
  std::this_thread::sleep_for(2s);
  EXPECT_EQ(far.output().find("PERCEPTS-STALE"), std::string::npos) << "here they are in time";
  net().set({.delay = 400ms});
  EXPECT_TRUE(far.prints("robot 1: `FAILSAFE PERCEPTS-STALE AFTER 0.6 HOLD` acts", kFleetPatience))
      << far.output();
  net().set({});
  EXPECT_TRUE(far.prints("robot 1: `FAILSAFE PERCEPTS-STALE AFTER 0.6 HOLD` is over", kFleetPatience))
      << far.output();
  far.signal(SIGTERM);
  EXPECT_TRUE(far.wait(kFleetPatience)) << far.output();
}

TEST_F(RealTime, ARunThatIsStoppedForAWhileGoesOn) {
  make_network(23);
  const Process north = agent("north");
  Process far = errand();
  ASSERT_TRUE(far.prints("MOVETO", kFleetPatience));
  ASSERT_TRUE(far.signal(SIGSTOP));
  std::this_thread::sleep_for(8s);  // longer than the agent remembers its endpoints
  ASSERT_TRUE(far.signal(SIGCONT));
  const Json kept_up = ends_well(far);
  EXPECT_LT(kept_up["stood"], 60) << "they go on at once";
}

TEST_F(RealTime, AnAgentThatIsStoppedForAWhileGoesOn) {
  make_network(26);
  const Process north = agent("north");
  Process far = errand();
  ASSERT_TRUE(far.prints("MOVETO", kFleetPatience));
  ASSERT_TRUE(north.signal(SIGSTOP));
  std::this_thread::sleep_for(5700ms);  // its endpoints are just forgotten there, and the run's not here
  ASSERT_TRUE(north.signal(SIGCONT));
  ends_well(far);
  EXPECT_TRUE(north.prints("a run has gone, and 2 robots with it", kFleetPatience)) << north.output();
}

TEST_F(RealTime, AnAgentThatLeavesIsToldAtOnce) {
  make_network(24);
  const Process north = agent("north");
  Process far = errand({"--patience", "5"});
  ASSERT_TRUE(far.prints("MOVETO", kFleetPatience));
  ASSERT_TRUE(north.signal(SIGTERM));
  const auto ending = far.wait(kFleetPatience);
  ASSERT_TRUE(ending) << far.output() << far.errors();
  EXPECT_EQ(ending->words(), "exit status 1");
  EXPECT_NE(far.output().find("can't be reached: the agent on `north` has left the fleet"), std::string::npos)
      << far.output();
}

}  // namespace
}  // namespace mlab::testing
