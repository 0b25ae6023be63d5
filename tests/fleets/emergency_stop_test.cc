// The emergency stop of a fleet: it reaches every machine that can be reached, stays in force whatever is
// started anew, and only a person releases it.

#include <csignal>

#include "fleets.h"

namespace mlab::testing {
namespace {

using network::Process;

class EmergencyStop : public Fleets {
 protected:
  struct Said {
    std::string ending;
    std::string output;
    std::string errors;
  };
  Said fleet(const std::vector<std::string>& more) {
    std::vector<std::string> words = {MLAB_COMMAND, "fleet", "alpha", "--network", base().address()};
    words.insert(words.end(), more.begin(), more.end());
    Process out = base().start(words);
    const auto ending = out.wait(kFleetPatience);
    return {ending ? ending->words() : "none", out.output(), out.errors()};
  }
  void stop_and_release(const std::vector<const Process*>& agents) {
    EXPECT_EQ(fleet({"--stop"}).ending, "exit status 0");
    EXPECT_EQ(fleet({"--release"}).ending, "exit status 0");
    for (const Process* one : agents)
      EXPECT_TRUE(one->prints("the emergency stop was released by base", kFleetPatience)) << one->output();
  }
  bool both_stand() {
    for (const auto end = network::Clock::now() + kFleetPatience; network::Clock::now() < end;) {
      const std::string table = fleet({"--once"}).output;
      const auto first = table.find("STOPPED");
      if (first != std::string::npos && table.find("STOPPED", first + 1) != std::string::npos) return true;
    }
    return false;
  }
  Process errand(const std::vector<std::string>& more) {
    return run(base::source_folder() + "/tests/fleets/errand/errand.mdl", more);
  }
};

TEST_F(EmergencyStop, HoldsARunInRealTimeUntilItIsReleased) {
  make_network(31);
  const Process north = agent("north");
  const Process south = agent("south");
  net().set({.loss = 0.2});
  Process far = errand({"--real-time"});
  ASSERT_TRUE(far.prints("MOVETO", kFleetPatience));
  const Said stopped = fleet({"--stop"});
  EXPECT_EQ(stopped.ending, "exit status 0") << stopped.errors;
  EXPECT_NE(stopped.output.find("agents of the fleet `alpha` have confirmed"), std::string::npos)
      << stopped.output;
  EXPECT_TRUE(north.prints("EMERGENCY STOP by base: all robots here stand", kFleetPatience))
      << north.output();
  EXPECT_TRUE(south.prints("EMERGENCY STOP by base: all robots here stand", kFleetPatience))
      << south.output();
  EXPECT_TRUE(far.prints("EMERGENCY STOP by base: all robots stand", kFleetPatience)) << far.output();
  EXPECT_NE(fleet({"--once"}).output.find("STOPPED"), std::string::npos);
  EXPECT_FALSE(far.wait(3s)) << "the mission stands, too: " << far.output();
  const Said released = fleet({"--release"});
  EXPECT_EQ(released.ending, "exit status 0") << released.errors;
  EXPECT_TRUE(far.prints("the emergency stop was released by base", kFleetPatience));
  const auto ending = far.wait(2 * kFleetPatience);
  ASSERT_TRUE(ending) << far.output();
  EXPECT_EQ(ending->words(), "exit status 0") << far.output();
  EXPECT_EQ(report()["deliveries"].size(), 3U);
}

TEST_F(EmergencyStop, HoldsARunInLockStep) {
  make_network(32);
  const Process north = agent("north");
  Process far = errand({"--speed", "real"});
  ASSERT_TRUE(far.prints("MOVETO", kFleetPatience));
  EXPECT_EQ(fleet({"--stop"}).ending, "exit status 0");
  EXPECT_TRUE(far.prints("EMERGENCY STOP by base: all robots stand", kFleetPatience)) << far.output();
  EXPECT_EQ(fleet({"--release"}).ending, "exit status 0");
  const auto ending = far.wait(2 * kFleetPatience);
  ASSERT_TRUE(ending) << far.output();
  EXPECT_EQ(ending->words(), "exit status 0") << far.output();
}

TEST_F(EmergencyStop, IsSaidBeforeTheFirstCycleOfARunInLockStep) {
  make_network(39);
  const Process north = agent("north");
  EXPECT_EQ(fleet({"--stop"}).ending, "exit status 0");
  Process far = errand({});
  const std::string release = "mlab fleet alpha --network " + base().address() + " --release";
  EXPECT_TRUE(
      far.prints("[      0.0 s] EMERGENCY STOP by base: all robots stand; `" + release + "` releases it",
                 kFleetPatience))
      << far.output();
  EXPECT_FALSE(far.wait(2s)) << far.output();
  EXPECT_EQ(fleet({"--release"}).ending, "exit status 0");
  const auto ending = far.wait(2 * kFleetPatience);
  ASSERT_TRUE(ending) << far.output();
  EXPECT_EQ(ending->words(), "exit status 0") << far.output();
  EXPECT_EQ(report()["deliveries"].size(), 3U);
}

TEST_F(EmergencyStop, LeavesNothingOnTheDiskWhereAllHaveReleasedIt) {
  make_network(40);
  const Process north = agent("north");
  const auto file = net().host("north").path(std::string(kAgentState) + "/mlab/agents/alpha@north.stop");
  const auto seen = net().host("north").path(std::string(kAgentState) + "/mlab/agents/alpha@north.seen");
  while (!std::filesystem::exists(seen)) std::this_thread::sleep_for(20ms);  // just after it is ready
  const auto began = std::filesystem::last_write_time(seen);
  EXPECT_EQ(fleet({"--stop"}).ending, "exit status 0");
  EXPECT_NE(std::filesystem::last_write_time(seen), began) << "when it was stopped it was there";
  EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_EQ(fleet({"--release"}).ending, "exit status 0");
  for (const auto end = network::Clock::now() + kFleetPatience;
       std::filesystem::exists(file) && network::Clock::now() < end;)
    std::this_thread::sleep_for(20ms);
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(EmergencyStop, OutlivesAgentsAndRuns) {
  make_network(33);
  const auto stopped_agent = [&](const std::string& host) {
    Process out = agent(host);
    EXPECT_TRUE(out.prints("EMERGENCY STOP by base: it still holds", kFleetPatience)) << out.output();
    return out;
  };
  {
    const Process north = agent("north");
    EXPECT_EQ(fleet({"--stop"}).ending, "exit status 0");
    EXPECT_TRUE(north.signal(SIGKILL));
  }
  const Process north = stopped_agent("north");
  const Process south = agent("south");
  EXPECT_TRUE(south.prints("EMERGENCY STOP by base: all robots here stand", kFleetPatience))
      << "it hears of it from the other agent: " << south.output();
  Process far = errand({"--real-time"});
  EXPECT_TRUE(far.prints("EMERGENCY STOP by base: all robots stand", kFleetPatience)) << far.output();
  EXPECT_EQ(fleet({"--release"}).ending, "exit status 0");
  EXPECT_TRUE(south.prints("the emergency stop was released by base", kFleetPatience));
  const auto ending = far.wait(2 * kFleetPatience);
  ASSERT_TRUE(ending) << far.output();
  EXPECT_EQ(ending->words(), "exit status 0") << far.output();
}

TEST_F(EmergencyStop, NamesWhomItCannotReachAndReachesHimLater) {
  make_network(34);
  const Process north = agent("north");
  const Process south = agent("south");
  Process far = errand({"--real-time"});
  ASSERT_TRUE(far.prints("MOVETO", kFleetPatience));
  net().isolate(net().host("south"));
  fleet({"--stop"});
  EXPECT_TRUE(north.prints("EMERGENCY STOP", kFleetPatience));
  EXPECT_TRUE(far.prints("the emergency stop is not confirmed by `south`", kFleetPatience)) << far.output();
  net().join(net().host("south"));
  EXPECT_TRUE(south.prints("EMERGENCY STOP", kFleetPatience)) << south.output();
  EXPECT_TRUE(far.prints("the emergency stop is confirmed by all", kFleetPatience)) << far.output();
  EXPECT_EQ(fleet({"--release"}).ending, "exit status 0");
  EXPECT_TRUE(far.prints("the emergency stop was released by base", kFleetPatience)) << far.output();
}

TEST_F(EmergencyStop, NamesAnAgentThatOnlyOthersHaveHeard) {
  make_network(36);
  const Process north = agent("north");
  const Process south = agent("south");
  const Said before = fleet({"--once"});  // so both have been heard, and hear each other
  ASSERT_TRUE(before.output.contains("north") && before.output.contains("south")) << before.output;
  net().isolate(net().host("south"));
  const Said stopped = fleet({"--stop"});
  EXPECT_EQ(stopped.ending, "exit status 1");
  EXPECT_NE(stopped.output.find("1 of 2 agents of the fleet `alpha` have confirmed"), std::string::npos)
      << stopped.output;
  EXPECT_NE(stopped.errors.find("not confirmed by `south` (known by agent north, last heard "),
            std::string::npos)
      << stopped.errors;
  net().join(net().host("south"));
  EXPECT_TRUE(south.prints("EMERGENCY STOP by base: all robots here stand", kFleetPatience));
  const Said again = fleet({"--stop"});
  EXPECT_EQ(again.ending, "exit status 0") << again.errors;
}

// Agents of one machine do not meet on its network.
TEST_F(EmergencyStop, IsToldByAgentsOfOneMachineToEachOther) {
  make_network(44);
  const Process north = agent("north");
  const Process near = called("near", "north");
  ASSERT_TRUE(near.prints("waits for runs", kFleetPatience)) << near.output() << near.errors();
  Process list = net().host("north").start(
      {MLAB_COMMAND, "fleet", "alpha", "--network", net().host("north").address(), "--once"});
  ASSERT_TRUE(list.wait(kFleetPatience));
  EXPECT_TRUE(list.output().contains("north") && list.output().contains("near"))
      << "both are seen on their own machine, too: " << list.output() << list.errors();
  const auto while_it_sleeps = [&](const std::string& option) {
    ASSERT_TRUE(near.signal(SIGSTOP));
    fleet({option});
    net().isolate(net().host("north"));  // nobody else can tell it
    ASSERT_TRUE(near.signal(SIGCONT));
  };
  while_it_sleeps("--stop");
  EXPECT_TRUE(north.prints("EMERGENCY STOP by base: all robots here stand", kFleetPatience));
  EXPECT_TRUE(near.prints("EMERGENCY STOP by base: all robots here stand", kFleetPatience)) << near.output();
  net().join(net().host("north"));
  while_it_sleeps("--release");
  EXPECT_TRUE(north.prints("the emergency stop was released by base", kFleetPatience));
  EXPECT_TRUE(near.prints("the emergency stop was released by base", kFleetPatience)) << near.output();
  net().join(net().host("north"));
}

TEST_F(EmergencyStop, NamesAnAgentThatWasKilledBeforeByWhatAnotherOneOfItsMachineSays) {
  make_network(45);
  const Process north = agent("north");
  {
    Process near = called("near", "north");
    ASSERT_TRUE(near.prints("waits for runs", kFleetPatience)) << near.output() << near.errors();
    const auto seen = net().host("north").path(std::string(kAgentState) + "/mlab/agents/alpha@near.seen");
    while (!std::filesystem::exists(seen)) std::this_thread::sleep_for(20ms);  // just after it is ready
    ASSERT_TRUE(near.signal(SIGKILL));
    ASSERT_TRUE(near.wait(kFleetPatience));
  }
  Said stopped;
  for (const auto end = network::Clock::now() + kFleetPatience;
       stopped.errors.find("`near`") == std::string::npos && network::Clock::now() < end;)
    stopped = fleet({"--stop"});
  EXPECT_EQ(stopped.ending, "exit status 1");
  EXPECT_NE(stopped.errors.find("not confirmed by `near` (known by agent north, last heard "),
            std::string::npos)
      << stopped.errors;
  fleet({"--release"});
  EXPECT_TRUE(north.prints("the emergency stop was released by base", kFleetPatience)) << north.output();
}

TEST_F(EmergencyStop, NamesAnAgentThatARunHasRobotsAt) {
  make_network(37);
  const Process south = agent("south");
  Process far = errand({"--real-time"});
  ASSERT_TRUE(far.prints("MOVETO", kFleetPatience));
  net().isolate(net().host("south"));
  const Said stopped = fleet({"--stop"});
  EXPECT_EQ(stopped.ending, "exit status 1");
  EXPECT_NE(stopped.errors.find("not confirmed by `south` (known by run errand on base, last heard "),
            std::string::npos)
      << stopped.errors;
}

TEST_F(EmergencyStop, MissesNobodyWhoLeftInOrder) {
  make_network(38);
  const Process north = agent("north");
  Process south = agent("south");
  ASSERT_TRUE(fleet({"--once"}).output.contains("south"));
  ASSERT_TRUE(south.signal(SIGTERM));
  ASSERT_TRUE(south.wait(kFleetPatience));
  const Said stopped = fleet({"--stop"});
  EXPECT_EQ(stopped.ending, "exit status 0") << stopped.errors;
  EXPECT_NE(stopped.output.find("1 of 1 agents"), std::string::npos) << stopped.output;
}

TEST_F(EmergencyStop, IsNotReleasedByAReleaseOfAnEarlierOne) {
  make_network(41);
  const Process north = agent("north");
  Process before = agent("south");
  stop_and_release({&north, &before});
  net().isolate(net().host("north"));
  ASSERT_TRUE(before.signal(SIGTERM));
  ASSERT_TRUE(before.wait(kFleetPatience));
  const Process south = agent("south");  // it knows of nothing any more
  const Said stopped = fleet({"--stop"});
  EXPECT_NE(stopped.output.find("1 of 1 agents"), std::string::npos) << stopped.output;
  net().join(net().host("north"));
  EXPECT_TRUE(both_stand()) << north.output() << south.output();
  EXPECT_EQ(south.output().find("released"), std::string::npos) << south.output();
  EXPECT_EQ(fleet({"--release"}).ending, "exit status 0");
}

TEST_F(EmergencyStop, ThatCannotBeReadAnyMoreIsNotReleasedByWhatWasBefore) {
  make_network(42);
  const Process north = agent("north");
  Process before = agent("south");
  stop_and_release({&north, &before});
  net().isolate(net().host("north"));
  fleet({"--stop"});
  ASSERT_TRUE(before.signal(SIGKILL));
  ASSERT_TRUE(before.wait(kFleetPatience));
  std::ofstream(net().host("south").path(std::string(kAgentState) + "/mlab/agents/alpha@south.stop"))
      << "garbage";
  const Process south = agent("south");
  EXPECT_TRUE(south.prints("can't be read: it still holds", kFleetPatience)) << south.output();
  net().join(net().host("north"));
  EXPECT_TRUE(both_stand()) << north.output() << south.output();
  EXPECT_EQ(south.output().find("released"), std::string::npos) << south.output();
  EXPECT_EQ(fleet({"--release"}).ending, "exit status 0");
  EXPECT_TRUE(south.prints("the emergency stop was released by base", kFleetPatience)) << south.output();
}

TEST_F(EmergencyStop, ThatAnAgentCannotKeepIsSaidToBeSo) {
  make_network(43);
  // No file takes a byte there, as on a disk that is full.
  const Process north = net().host("north").start(
      {"sh", "-c", "trap '' XFSZ; ulimit -f 0; exec \"$0\" \"$@\"", MLAB_COMMAND, "agent", "--fleet", "alpha",
       "--name", "north", "--network", net().host("north").address()},
      {.environment = {{"XDG_STATE_HOME", kAgentState}}});
  ASSERT_TRUE(north.prints("warning: an emergency stop will not outlive this agent", kFleetPatience))
      << north.output() << north.errors();
  const Process south = agent("south");
  const Said stopped = fleet({"--stop"});
  EXPECT_EQ(stopped.ending, "exit status 0") << stopped.errors;
  EXPECT_NE(stopped.output.find("2 of 2 agents"), std::string::npos) << stopped.output;
  EXPECT_NE(stopped.errors.find("not kept by `north` ("), std::string::npos) << stopped.errors;
  EXPECT_EQ(stopped.errors.find("`south`"), std::string::npos) << stopped.errors;
  EXPECT_NE(fleet({"--once"}).output.find("STOPPED, not kept"), std::string::npos);
  Process far = errand({"--real-time"});
  EXPECT_TRUE(far.prints("alert: the emergency stop is not kept by `north`", kFleetPatience)) << far.output();
  EXPECT_EQ(fleet({"--release"}).ending, "exit status 0");
}

TEST_F(EmergencyStop, OfNobodyIsSaidToBeSo) {
  make_network(35);
  const Said nobody = fleet({"--stop"});
  EXPECT_EQ(nobody.ending, "exit status 1");
  EXPECT_NE(nobody.errors.find("nobody is there in the fleet `alpha`"), std::string::npos) << nobody.errors;
  EXPECT_EQ(nobody.errors.find("loopback"), std::string::npos) << "it is not on loopback: " << nobody.errors;
  const Process north = agent("north");
  const Said nothing = fleet({"--release"});
  EXPECT_EQ(nothing.ending, "exit status 0");
  EXPECT_NE(nothing.output.find("the fleet `alpha` is not stopped"), std::string::npos) << nothing.output;
}

}  // namespace
}  // namespace mlab::testing
