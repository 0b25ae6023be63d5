// Missions whose robots are on other machines: whatever the network does, and whoever is killed, the mission
// ends as it should, or says why not, and nothing is left behind.

#include "fleets.h"

#include <csignal>

#include "network/victim.h"

namespace mlab::testing {
namespace {

using network::Process;

// What a run tells of itself but for how fast it was.
Json but_for_its_cost(Json report) {
  if (report.is_object()) report.erase("performance");
  return report;
}

Json embedded_report(const std::string& name) {
  const std::string file = ::testing::TempDir() + "mlab_fleets_" + name + ".json";
  const std::string line = std::string(MLAB_COMMAND) + " run " + mission(name) +
                           " --headless --proceed --quiet --threads 1 --report " + file + " > /dev/null";
  // NOLINTNEXTLINE(concurrency-mt-unsafe): a test program has one thread
  EXPECT_EQ(std::system(line.c_str()), 0);
  const Json out = but_for_its_cost(report_in(file));
  std::filesystem::remove(file);
  return out;
}

TEST_F(Fleets, RobotsOnTwoMachinesGiveTheReportOfTheEmbeddedRunThoughPacketsAreLost) {
  make_network(7);
  net().set({.loss = 0.1,
             .delay = 1ms,
             .jitter = 500us,
             .reordering = 0.05,
             .held_back = 3ms,
             .duplication = 0.05});
  const Process north = agent("north");
  const Process south = agent("south");
  Process far = run(mission("patrol"));
  const auto ending = far.wait(kFleetPatience);
  ASSERT_TRUE(ending) << far.output() << far.errors();
  EXPECT_EQ(ending->words(), "exit status 0") << far.output() << far.errors();
  Json expected = embedded_report("patrol");
  EXPECT_EQ(expected.dump(2), but_for_its_cost(report()).dump(2));
  EXPECT_GT(net().total().lost, 100U);
  EXPECT_TRUE(come_to_be(0)) << "robots end with their run";
}

TEST_F(Fleets, OfTwoAgentsOfOneNameThatBeginAtTheSameMomentOneIsLeft) {
  make_network(12);
  Process north = called("same", "north");
  Process south = called("same", "south");
  std::vector<Process*> ended;
  for (const auto last = network::Clock::now() + kFleetPatience;
       ended.empty() && network::Clock::now() < last;) {
    for (Process* one : {&north, &south}) {
      if (one->wait(100ms)) ended.push_back(one);
    }
  }
  ASSERT_EQ(ended.size(), 1U) << north.output() << south.output();
  EXPECT_EQ(ended[0]->wait(1s)->words(), "exit status 2");
  EXPECT_NE(ended[0]->errors().find("the fleet `alpha` has an agent `same` already"), std::string::npos)
      << ended[0]->errors();
  Process& left = ended[0] == &north ? south : north;
  EXPECT_FALSE(left.wait(3s)) << left.output() << left.errors();
}

TEST_F(Fleets, OfTwoOfOneNameThatMeetLateTheLaterOneLeavesAndMeanwhileIsLeftOut) {
  make_network(15);
  Process north = called("same", "north");
  ASSERT_TRUE(north.prints("waits for runs", kFleetPatience)) << north.output() << north.errors();
  net().cut(net().host("north"), net().host("south"));
  std::this_thread::sleep_for(5s);
  Process south = called("same", "south");
  ASSERT_TRUE(south.prints("waits for runs", kFleetPatience)) << "nobody has told it" << south.errors();
  const std::string first_counts = "call themselves `same`, and have not found each other: that on `north`";
  const std::string second_counts = "call themselves `same`, and have not found each other: that on `south`";

  // It looks for some seconds only, in which one on a busy machine may not have been heard.
  std::string listed;
  const auto tells_of_both = [&] {
    return listed.find(first_counts) != std::string::npos || listed.find(second_counts) != std::string::npos;
  };
  for (const auto last = network::Clock::now() + kFleetPatience;
       !tells_of_both() && network::Clock::now() < last;) {
    Process list = base().start({MLAB_COMMAND, "fleet", "alpha", "--network", base().address()});
    ASSERT_TRUE(list.wait(kFleetPatience));
    listed = list.output() + list.errors();
  }
  EXPECT_TRUE(tells_of_both()) << listed;
  Process stops = base().start({MLAB_COMMAND, "fleet", "alpha", "--network", base().address(), "--stop"});
  EXPECT_EQ(stops.wait(kFleetPatience).value().words(), "exit status 1") << stops.output();
  EXPECT_NE(stops.errors().find("two agents call themselves `same`"), std::string::npos) << stops.errors();
  for (Process* one : {&north, &south}) EXPECT_TRUE(one->prints("EMERGENCY STOP by", kFleetPatience));
  Process goes = base().start({MLAB_COMMAND, "fleet", "alpha", "--network", base().address(), "--release"});
  EXPECT_TRUE(goes.wait(kFleetPatience));
  for (Process* one : {&north, &south}) EXPECT_TRUE(one->prints("was released by", kFleetPatience));

  Process far = run(mission("patrol"), {"--speed", "20"});
  EXPECT_TRUE(far.prints("two agents call themselves `same`", kFleetPatience))
      << far.output() << far.errors();
  ASSERT_TRUE(far.wait(kFleetPatience));
  EXPECT_EQ(embedded_report("patrol").dump(2), but_for_its_cost(report()).dump(2));
  const auto count = [](const Process& one) {
    return one.output().find("a run has begun to talk") == std::string::npos ? 0 : 1;
  };
  EXPECT_EQ(count(north) + count(south), 1) << north.output() << south.output();

  net().join(net().host("north"), net().host("south"));
  const auto ending = south.wait(kFleetPatience);
  ASSERT_TRUE(ending) << south.output() << north.output();
  EXPECT_EQ(ending->words(), "exit status 2");
  EXPECT_NE(south.errors().find("the fleet `alpha` has an agent `same` already, on `north`"),
            std::string::npos)
      << south.errors();
  EXPECT_TRUE(north.prints("another agent that is called `same`, too, is there, on `south`", kFleetPatience))
      << north.output();
  EXPECT_FALSE(north.wait(1s)) << north.errors();
}

TEST_F(Fleets, ANameIsTakenOnceOnAMachineWhateverNetworkItIsOn) {
  make_network(16);
  const Process north = agent("north");
  Process second = net().host("north").start({MLAB_COMMAND, "agent", "--fleet", "alpha", "--name", "north"},
                                             {.environment = {{"XDG_STATE_HOME", kAgentState}}});
  const auto ending = second.wait(kFleetPatience);
  ASSERT_TRUE(ending) << second.output();
  EXPECT_EQ(ending->words(), "exit status 2");
  EXPECT_NE(second.errors().find("`north` of the fleet `alpha` runs on this machine already (process "),
            std::string::npos)
      << second.errors();
}

TEST_F(Fleets, AnAgentThatHangsWhenItIsToEndEndsItsRobotsFirst) {
  make_network(18);
  Process north = net().host("north").start(
      {MLAB_COMMAND, "agent", "--fleet", "alpha", "--name", "north", "--network",
       net().host("north").address()},
      {.environment = {{"XDG_STATE_HOME", kAgentState}, {"LD_PRELOAD", MLAB_HANGING_DDS}}});
  ASSERT_TRUE(north.prints("waits for runs", kFleetPatience)) << north.output() << north.errors();
  Process far = run(mission("patrol"), {"--speed", "4"});
  ASSERT_TRUE(come_to_be(2)) << far.output();
  ASSERT_TRUE(north.signal(SIGTERM));
  EXPECT_TRUE(come_to_be(0));
  EXPECT_EQ(north.errors().find("ended by force"), std::string::npos) << "robots end before that";
  ASSERT_TRUE(north.wait(kFleetPatience)) << north.output();
  EXPECT_NE(north.errors().find("mlab agent: has not ended"), std::string::npos) << north.errors();
  far.signal(SIGTERM);
  EXPECT_TRUE(far.wait(kFleetPatience));
}

TEST_F(Fleets, ARunThatWasStoppedForTooLongSaysThatItWasGivenUp) {
  make_network(17);
  const Process north = agent("north");
  Process far = run(mission("patrol"), {"--speed", "4"});
  ASSERT_TRUE(come_to_be(2)) << far.output();
  ASSERT_TRUE(far.signal(SIGSTOP));
  ASSERT_TRUE(north.prints("a run has gone, and 2 robots with it", kFleetPatience)) << north.output();
  std::this_thread::sleep_for(1s);
  ASSERT_TRUE(far.signal(SIGCONT));
  EXPECT_TRUE(
      far.prints("the agent on `north` gave this run up, which itself stood still for", kFleetPatience))
      << far.output() << far.errors();
  EXPECT_EQ(far.output().find("has left the fleet"), std::string::npos) << far.output();
  far.signal(SIGTERM);
  EXPECT_TRUE(far.wait(kFleetPatience));
}

TEST_F(Fleets, AMachineThatIsCutOffForAWhileIsWaitedFor) {
  make_network(8);
  const Process north = agent("north");
  const Process south = agent("south");
  Process far = run(mission("patrol"), {"--speed", "40"});
  ASSERT_TRUE(come_to_be(2));
  net().isolate(net().host("south"));
  std::this_thread::sleep_for(2s);
  net().join(net().host("south"));
  const auto ending = far.wait(kFleetPatience);
  ASSERT_TRUE(ending) << far.output() << far.errors();
  EXPECT_EQ(ending->words(), "exit status 0") << far.output() << far.errors();
  EXPECT_EQ(embedded_report("patrol").dump(2), but_for_its_cost(report()).dump(2));
}

TEST_F(Fleets, RobotsOfAMachineThatIsLostStandAndTheReasonIsTold) {
  make_network(9);
  const Process north = agent("north");
  const Process south = agent("south");
  Process far = run(mission("patrol"), {"--speed", "20", "--patience", "60"});
  ASSERT_TRUE(come_to_be(2));
  ASSERT_TRUE(south.signal(SIGKILL));
  const auto ending = far.wait(kFleetPatience);
  ASSERT_TRUE(ending) << far.output() << far.errors();
  EXPECT_EQ(ending->words(), "exit status 1");
  EXPECT_NE(far.output().find("can't be reached: the agent on `south` was silent for 5 s"), std::string::npos)
      << far.output();
  const Json told = report();
  ASSERT_TRUE(told.is_object());
  EXPECT_EQ(told["outcome"], "failed");
  EXPECT_TRUE(come_to_be(0)) << "an agent takes its robots with it";
}

// Of the run that has just ended, recorded on the base: it is computed again as it was, though nobody is lost
// there.
void expect_replayed(network::Host& base, const Json& report) {
  Process again = base.start(
      {MLAB_COMMAND, "replay", "/tmp/run.mcap", "--headless", "--quiet", "--report", "/tmp/replayed.json"});
  const auto ending = again.wait(kFleetPatience);
  ASSERT_TRUE(ending) << again.output() << again.errors();
  EXPECT_EQ(ending->words(), "exit status 0") << again.output() << again.errors();
  Json replayed = but_for_its_cost(report_in(base.path("/tmp/replayed.json")));
  ASSERT_TRUE(replayed.is_object());
  replayed["mission"]["file"] = report["mission"]["file"];  // its name begins where the mission lies
  EXPECT_EQ(replayed.dump(2), but_for_its_cost(report).dump(2));
}

TEST_F(Fleets, ARunThatLostAMachineIsReplayedAsItWas) {
  make_network(14);
  const Process north = agent("north");
  const Process south = agent("south");
  Process far = run(mission("patrol"), {"--speed", "40", "--patience", "100", "--record", "/tmp/run.mcap"});
  ASSERT_TRUE(come_to_be(2));
  ASSERT_TRUE(south.signal(SIGKILL));
  ASSERT_TRUE(far.wait(kFleetPatience)) << far.output() << far.errors();
  ASSERT_NE(far.output().find("can't be reached"), std::string::npos) << far.output();
  expect_replayed(base(), report());
}

// Whoever takes the place of a process that was killed is killed as well, until a robot stands because of it.
TEST_F(Fleets, ARunThatLostRobotsProcessesIsReplayedAsItWas) {
  make_network(15);
  Process run = base().start({MLAB_COMMAND, "run", mission("patrol"), "--headless", "--proceed", "--robots",
                              "process", "--threads", "1", "--speed", "40", "--patience", "100", "--record",
                              "/tmp/run.mcap", "--report", "/tmp/report.json"});
  ASSERT_TRUE(come_to_be(2));
  const auto end = network::Clock::now() + kFleetPatience;
  while (run.output().find("ended with signal 9") == std::string::npos && network::Clock::now() < end) {
    for (const network::Seen& one : base().processes()) {
      if (one.name == "mlab-robots") network::Victim(one).signal(SIGKILL);
    }
  }
  ASSERT_TRUE(run.wait(kFleetPatience)) << run.output() << run.errors();
  ASSERT_NE(run.output().find("ended with signal 9"), std::string::npos) << run.output();
  expect_replayed(base(), report());
}

TEST_F(Fleets, RobotsOfARunThatIsKilledEnd) {
  make_network(10);
  const Process north = agent("north");
  Process far = run(mission("patrol"), {"--speed", "40"});
  ASSERT_TRUE(come_to_be(2));
  ASSERT_TRUE(far.signal(SIGKILL));
  EXPECT_TRUE(come_to_be(0));
  EXPECT_TRUE(north.prints("a run has gone, and 2 robots with it", kFleetPatience)) << north.output();
  EXPECT_EQ(leftovers(), "");
  Process again = run(mission("patrol"));
  const auto ending = again.wait(kFleetPatience);
  ASSERT_TRUE(ending);
  EXPECT_EQ(ending->words(), "exit status 0") << again.output();
}

TEST_F(Fleets, TellHowLongTheWayIsAndWhatClocksSay) {
  make_network(13);
  const Process north = agent("north");
  net().set({.delay = 20ms});
  Process list = base().start({MLAB_COMMAND, "fleet", "alpha", "--json", "--network", base().address()});
  ASSERT_TRUE(list.wait(kFleetPatience));
  const Json told = Json::parse(list.output(), nullptr, false);
  ASSERT_TRUE(told.is_object()) << list.output() << list.errors();
  ASSERT_EQ(told["agents"].size(), 1U) << told;
  const Json link = told["agents"][0]["link"];
  ASSERT_TRUE(link.is_object()) << told;
  EXPECT_GE(link["round_trip_s"], 0.04);
  EXPECT_LT(std::abs(link["clock_offset_s"].get<double>()), link["round_trip_s"].get<double>() / 2.0 + 0.001)
      << "it is the same machine's clock";
}

TEST_F(Fleets, AnAgentThatHungBeforeSomebodyLooksIsNamed) {
  make_network(16);
  const Process north = agent("north");
  const std::string seen =
      net().host("north").path(std::string(kAgentState) + "/mlab/agents/alpha@north.seen");
  for (const auto last = network::Clock::now() + kFleetPatience;
       !std::filesystem::exists(seen) && network::Clock::now() < last;)
    std::this_thread::sleep_for(10ms);
  ASSERT_TRUE(north.signal(SIGSTOP));
  const auto said_on = [&](const std::string& host, const std::vector<std::string>& more) {
    std::vector<std::string> words = {MLAB_COMMAND, "fleet", "alpha", "--network",
                                      net().host(host).address()};
    words.insert(words.end(), more.begin(), more.end());
    Process out = net().host(host).start(words, {.environment = {{"XDG_STATE_HOME", kAgentState}}});
    const auto ending = out.wait(kFleetPatience);
    return (ending ? ending->words() : "none") + "\n" + out.output() + out.errors();
  };
  const std::string there = said_on("north", {"--once"});
  EXPECT_NE(there.find("nobody is there"), std::string::npos) << there;
  EXPECT_NE(there.find("`north`, on `north`, is silent: its process "), std::string::npos) << there;
  EXPECT_NE(there.find("is stopped: `kill -CONT` lets it go on"), std::string::npos) << there;
  const std::string stopped = said_on("north", {"--stop"});
  EXPECT_EQ(stopped.find("exit status 1"), 0U) << stopped;
  EXPECT_NE(stopped.find("0 of 1 agents"), std::string::npos) << stopped;
  EXPECT_NE(stopped.find("not confirmed by `north`"), std::string::npos) << stopped;
  EXPECT_EQ(said_on("south", {"--once"}).find("`north`"), std::string::npos) << "nobody there has met it";
  ASSERT_TRUE(north.signal(SIGCONT));
  std::string again;
  for (const auto last = network::Clock::now() + kFleetPatience;
       again.find(" there ") == std::string::npos && network::Clock::now() < last;)
    again = said_on("north", {"--once"});
  EXPECT_EQ(again.find("silent"), std::string::npos) << again;
}

TEST_F(Fleets, OfDifferentNamesDontHearEachOther) {
  make_network(11);
  const Process north = agent("north", "alpha");
  const Process south = agent("south", "beta");
  for (const auto& [fleet, there, absent] :
       {std::tuple("alpha", "north", "south"), std::tuple("beta", "south", "north")}) {
    Process list = base().start({MLAB_COMMAND, "fleet", fleet, "--network", base().address()});
    ASSERT_TRUE(list.wait(kFleetPatience));
    EXPECT_NE(list.output().find(there), std::string::npos) << list.output() << list.errors();
    EXPECT_EQ(list.output().find(absent), std::string::npos) << list.output();
  }
}

TEST_F(Fleets, ANameIsTakenOnce) {
  make_network(12);
  const Process north = agent("north");
  Process second = called("north", "south");
  const auto ending = second.wait(kFleetPatience);
  ASSERT_TRUE(ending);
  EXPECT_EQ(ending->words(), "exit status 2");
  EXPECT_NE(second.errors().find("the fleet `alpha` has an agent `north` already, on `north`"),
            std::string::npos)
      << second.errors();
}

// Debian's C library computes as on a processor without FMA where it is told so.
TEST_F(Fleets, AMachineThatComputesOtherwiseCarriesRobotsInRealTimeOnly) {
#ifdef __x86_64__
  if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "this processor has no FMA to be without";
#else
  GTEST_SKIP() << "every processor of this kind has FMA";
#endif
  make_network(14);
  const Process north = net().host("north").start(
      {MLAB_COMMAND, "agent", "--fleet", "alpha", "--name", "north", "--network",
       net().host("north").address()},
      {.environment = {{"XDG_STATE_HOME", kAgentState},
                       {"GLIBC_TUNABLES", "glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2,-FMA_Usable,-AVX2_Usable"}}});
  ASSERT_TRUE(north.prints("waits for runs", kFleetPatience)) << north.output() << north.errors();
  Process exact = run(mission("patrol"), {"--patience", "50"});
  auto ending = exact.wait(kFleetPatience);
  ASSERT_TRUE(ending);
  EXPECT_EQ(ending->words(), "exit status 1");
  EXPECT_NE(exact.output().find(
                "the agent on `north` computes sines and the like otherwise than this machine does"),
            std::string::npos)
      << exact.output();
  Process live = run(mission("patrol"), {"--real-time", "--limit", "2"});
  ending = live.wait(kFleetPatience);
  ASSERT_TRUE(ending) << live.output() << live.errors();
  EXPECT_TRUE(north.prints("2 robots with it", kFleetPatience)) << north.output() << live.output();
}

TEST_F(Fleets, WithoutAnAgentTheMissionSaysWhatIsMissing) {
  make_network(13);
  Process far = run(mission("patrol"), {"--quiet"});
  const auto ending = far.wait(kFleetPatience);
  ASSERT_TRUE(ending);
  EXPECT_EQ(ending->words(), "exit status 1");
  EXPECT_NE(far.output().find("has no agent: none has joined the fleet `alpha`: `mlab agent --fleet alpha "
                              "--network " +
                              base().address() + "` starts one"),
            std::string::npos)
      << far.output();
}

}  // namespace
}  // namespace mlab::testing
