// What everything that runs robots' programs has to keep to, wherever they run.

#include <sys/types.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "fleet_of_threads.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/robot/program/program_runners.h"
#include "mlab/robot/program/robot_values.h"
#include "mlab/robot/wire/action_wire.h"
#include "two_agents.h"

namespace mlab::testing {
namespace {

using robot::ProgramRunner;
using robot::RobotProgram;

constexpr std::uint64_t kSeed = 7;

/// A place where programs run.
class Place {
 public:
  virtual ~Place() = default;
  virtual ProgramRunner& runner_of(const RobotProgram& program) = 0;
  virtual bool is_in_own_processes() const { return true; }
};

class Local : public Place {
 public:
  explicit Local(bool is_in_own_processes) : is_in_own_processes_(is_in_own_processes) {}
  ProgramRunner& runner_of(const RobotProgram& program) override { return *runners_.runner_of(program); }
  bool is_in_own_processes() const override { return is_in_own_processes_; }

 private:
  bool is_in_own_processes_;
  robot::ProgramRunners runners_{kSeed, 1};
};

/// Two agents.
class Agents : public Place {
 public:
  ProgramRunner& runner_of(const RobotProgram& /*program*/) override { return *runner_; }
  DirectLink& link(std::size_t agent) { return *links_[agent]; }

 private:
  std::vector<DirectLink*> links_;
  std::unique_ptr<ProgramRunner> runner_ = two_agents(kSeed, &links_);
};

/// Two agents of a fleet, which carry robots for one test after the other.
class Fleet : public Place {
 public:
  ProgramRunner& runner_of(const RobotProgram& /*program*/) override { return *runner_; }

 private:
  std::unique_ptr<ProgramRunner> runner_ = FleetOfThreads::shared().make_runner(kSeed);
};

/// The same in real time, with cycles that are so long that no robot is late on any machine.
class LiveFleet : public Place {
 public:
  ProgramRunner& runner_of(const RobotProgram& /*program*/) override { return *runner_; }

 private:
  std::unique_ptr<ProgramRunner> runner_ = FleetOfThreads::shared().make_runner(kSeed, 10.0);
};

RobotProgram standard_robot(bool in_own_processes, const std::string& base_velocity = "0.2",
                            const RobotProgram* built = nullptr) {
  text::Diagnostics sink;
  const std::vector<robot::Setting> settings = {{"base_velocity", base_velocity, {}, {}}};
  robot::ProgramSources sources{.permission = cell::testing::code_permitted()};
  sources.in_own_processes = in_own_processes;
  auto out = robot::load_program("robot", {}, settings, sources, {}, sink, built);
  EXPECT_TRUE(out) << text::render(sink);
  return out ? std::move(*out) : RobotProgram{};
}

/// A robot on its way to somewhere.
class Traveller {
 public:
  Traveller(ProgramRunner& runner, std::uint32_t id, const RobotProgram& program)
      : runner_(runner), member_(runner.add({id}, program)) {
    percepts_.cycle_duration = 0.1;
    percepts_.order.sequence = 1;
    percepts_.order.task = percept::Task::kMoveTo;
    percepts_.order.goal = {40.0, 30.0};
  }
  ProgramRunner& runner() { return runner_; }
  ProgramRunner::Member member() const { return member_; }
  std::optional<std::string> start() { return runner_.start(member_); }
  ProgramRunner::Turn turn() {
    fault_.clear();
    failure_.clear();
    return {member_, &percepts_, &action_, &fault_, &failure_};
  }
  const percept::Action& action() const { return action_; }
  const std::string& failure() const { return failure_; }
  /// What its wheels would do.
  void move() {
    percepts_.time += 0.1;
    percepts_.pose.position.x += 0.1 * action_.velocity.x;
    percepts_.pose.position.y += 0.1 * action_.velocity.y;
  }
  /// All of them, as people read them: between them in a frame lie bytes of no meaning.
  std::vector<std::string> values() const {
    const robot::Workings workings = runner_.workings(member_);
    std::vector<std::string> out = workings.program->active_states(workings.frame);
    for (const flow::Port& port : workings.program->ports())
      out.push_back(port.path + " " + flow::Program::print(workings.frame, port));
    return out;
  }
  double number(const char* port) const {
    const robot::Workings workings = runner_.workings(member_);
    return flow::Program::number(workings.frame, *workings.program->find(port)).value_or(-1.0);
  }

 private:
  ProgramRunner& runner_;
  ProgramRunner::Member member_;
  percept::Percepts percepts_;
  percept::Action action_;
  std::string fault_;
  std::string failure_;
};

// What the robots did, bit for bit.
std::string cycle(const std::vector<Traveller*>& robots) {
  ProgramRunner& runner = robots[0]->runner();
  std::vector<percept::Needs> needs(robots.size());
  for (Traveller* robot : robots) runner.join(robot->member());
  runner.open();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const ProgramRunner::Member member = robots[i]->member();
    runner.needs({&member, 1}, {&needs[i], 1});
    const ProgramRunner::Turn turn = robots[i]->turn();
    runner.act({&turn, 1});
  }
  runner.ask();
  runner.wait({});
  std::string out;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    wire::Action action;
    robot_wire::encode(robots[i]->action(), action);
    out += action.SerializeAsString() + std::to_string(needs[i][percept::Sensor::kObstacles]) + ";";
    robots[i]->move();
  }
  return out;
}

std::string cycles(const std::vector<Traveller*>& robots, int count) {
  std::string out;
  for (int i = 0; i < count; ++i) out += cycle(robots);
  return out;
}

struct Kind {
  const char* name;
  std::unique_ptr<Place> (*make)();
};

class EveryRunner : public ::testing::TestWithParam<Kind> {
 protected:
  ProgramRunner& runner() { return place_->runner_of(program_); }
  const RobotProgram& program() const { return program_; }
  RobotProgram faster() const { return standard_robot(place_->is_in_own_processes(), "0.5", &program_); }

 private:
  std::unique_ptr<Place> place_ = GetParam().make();
  RobotProgram program_ = standard_robot(place_->is_in_own_processes());
};

TEST_P(EveryRunner, ComputesTheSameBitForBit) {
  Local here(false);
  const RobotProgram embedded = standard_robot(false);
  std::vector<std::string> done;
  for (ProgramRunner* one : {&here.runner_of(embedded), &runner()}) {
    const RobotProgram& kind = one == &runner() ? program() : embedded;
    Traveller first(*one, 1, kind);
    Traveller second(*one, 2, kind);
    ASSERT_EQ(first.start(), std::nullopt);
    ASSERT_EQ(second.start(), std::nullopt);
    done.push_back(cycles({&first, &second}, 100));
    EXPECT_TRUE(first.action().drives);
    EXPECT_NE(first.action().velocity.x, second.action().velocity.x) << "noise of its own";
  }
  EXPECT_EQ(done[0], done[1]);
}

TEST_P(EveryRunner, LetsWhoLooksSeeTheSameValues) {
  Local here(false);
  const RobotProgram embedded = standard_robot(false);
  Traveller known(here.runner_of(embedded), 3, embedded);
  Traveller robot(runner(), 3, program());
  ASSERT_EQ(known.start(), std::nullopt);
  ASSERT_EQ(robot.start(), std::nullopt);
  for (const int count : {1, 1, 5, 1}) {
    cycles({&known}, count);
    cycles({&robot}, count);
    EXPECT_EQ(robot.values(), known.values());
  }
}

TEST_P(EveryRunner, ARestoredRobotGoesOnExactlyFromThere) {
  Traveller robot(runner(), 3, program());
  ASSERT_EQ(robot.start(), std::nullopt);
  cycles({&robot}, 5);
  const flow::Frame saved = runner().save(robot.member());
  cycles({&robot}, 5);
  const flow::Frame later = runner().save(robot.member());
  EXPECT_FALSE(later == saved);
  ASSERT_TRUE(runner().restore(robot.member(), saved));
  EXPECT_TRUE(runner().save(robot.member()) == saved);
  EXPECT_FALSE(runner().restore(robot.member(), flow::Frame(saved.size() + 8))) << "of another program";
}

TEST_P(EveryRunner, WhatAPersonSetOutlivesANewStart) {
  Traveller robot(runner(), 3, program());
  ASSERT_EQ(robot.start(), std::nullopt);
  EXPECT_EQ(runner().set(robot.member(), "base_velocity", "0.7"), std::nullopt);
  EXPECT_EQ(robot.number("base_velocity"), 0.7);
  EXPECT_EQ(robot.start(), std::nullopt);
  EXPECT_EQ(robot.number("base_velocity"), 0.7);
  EXPECT_EQ(runner().set(robot.member(), "no_such", "1"), "the program of robot 3 has no `no_such`");
}

TEST_P(EveryRunner, AnotherVersionOfItsProgramChangesWhatItSetsDifferently) {
  Traveller robot(runner(), 3, program());
  ASSERT_EQ(robot.start(), std::nullopt);
  EXPECT_EQ(runner().set(robot.member(), "max_velocity", "3"), std::nullopt);
  cycles({&robot}, 2);
  const RobotProgram after = faster();
  ASSERT_TRUE(runner().take_over(robot.member(), after, true));
  EXPECT_EQ(robot.number("base_velocity"), 0.5);
  EXPECT_EQ(robot.number("max_velocity"), 3.0) << "both versions say the same, so it is the robot's own";
  EXPECT_FALSE(runner().take_over(robot.member(), RobotProgram{}, true)) << "that is not its program";
  cycles({&robot}, 1);
  EXPECT_EQ(robot.number("base_velocity"), 0.5);
}

TEST_P(EveryRunner, HoldsAValueUntilItIsReleased) {
  Traveller robot(runner(), 3, program());
  ASSERT_EQ(robot.start(), std::nullopt);
  cycles({&robot}, 2);
  EXPECT_NE(runner().hold(robot.member(), "no_such", "1"), std::nullopt);
  ASSERT_EQ(runner().hold(robot.member(), "speed", "0.25"), std::nullopt);
  cycles({&robot}, 2);
  const auto* const interventions = runner().workings(robot.member()).interventions;
  ASSERT_NE(interventions, nullptr);
  EXPECT_EQ(interventions->held().size(), 1U);
  EXPECT_EQ(robot.number("speed"), 0.25);
  EXPECT_NE(runner().release(robot.member(), "max_velocity"), std::nullopt);
  ASSERT_EQ(runner().release(robot.member(), ""), std::nullopt);
  cycles({&robot}, 1);
  EXPECT_NE(robot.number("speed"), 0.25);
}

TEST_P(EveryRunner, GoesOnAsAnotherProgramFromWhereItWas) {
  Traveller before(runner(), 3, program());
  ASSERT_EQ(before.start(), std::nullopt);
  cycles({&before}, 5);
  const RobotProgram after_program = faster();
  Traveller after(runner(), 3, after_program);
  ASSERT_EQ(after.start(), std::nullopt);
  EXPECT_TRUE(runner().go_on_from(after.member(), *runner().values(before.member())).empty());
  EXPECT_EQ(after.number("base_velocity"), 0.5);
  EXPECT_EQ(flow::Program::cycle(runner().workings(after.member()).frame), 5U);
  runner().remove(before.member());
  cycles({&after}, 1);
  EXPECT_EQ(flow::Program::cycle(runner().workings(after.member()).frame), 6U);
}

TEST_P(EveryRunner, ForgetsARobotThatGoes) {
  Traveller first(runner(), 1, program());
  Traveller second(runner(), 2, program());
  ASSERT_EQ(first.start(), std::nullopt);
  ASSERT_EQ(second.start(), std::nullopt);
  cycles({&first, &second}, 3);
  runner().remove(first.member());
  cycles({&second}, 3);
  EXPECT_EQ(flow::Program::cycle(runner().workings(second.member()).frame), 6U);
  Traveller third(runner(), 3, program());
  ASSERT_EQ(third.start(), std::nullopt);
  cycles({&third, &second}, 3);
  EXPECT_EQ(third.failure(), "");
  EXPECT_TRUE(third.action().drives);
}

INSTANTIATE_TEST_SUITE_P(
    Runners, EveryRunner,
    ::testing::Values(Kind{"InThisProcess", [] { return std::unique_ptr<Place>(new Local(false)); }},
                      Kind{"InOwnProcesses", [] { return std::unique_ptr<Place>(new Local(true)); }},
                      Kind{"AtAgents", [] { return std::unique_ptr<Place>(new Agents); }},
                      Kind{"InAFleet", [] { return std::unique_ptr<Place>(new Fleet); }},
                      Kind{"InAFleetInRealTime", [] { return std::unique_ptr<Place>(new LiveFleet); }}),
    [](const auto& test) { return std::string(test.param.name); });

// Processes that this one has started and that are there.
std::vector<pid_t> children() {
  std::vector<pid_t> out;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::ifstream list(task.path() / "children");
    for (pid_t child = 0; list >> child;) out.push_back(child);
  }
  return out;
}

TEST(RobotsInOwnProcesses, GoOnExactlyWhenTheirProcessesAreKilled) {
  const auto seed = static_cast<std::uint32_t>(::testing::UnitTest::GetInstance()->random_seed());
  std::cout << "seed " << seed << "\n";
  Local apart(true);
  const RobotProgram program = standard_robot(true);
  std::vector<std::unique_ptr<Traveller>> robots;
  std::vector<Traveller*> all;
  for (const std::uint32_t id : {1U, 2U, 3U}) {
    robots.push_back(std::make_unique<Traveller>(apart.runner_of(program), id, program));
    all.push_back(robots.back().get());
    ASSERT_EQ(all.back()->start(), std::nullopt);
  }
  std::string done = cycles(all, 1);
  EXPECT_EQ(children().size(), 3U);
  // One strike after the other, each after whole cycles with all three: two in one cycle are more than is
  // borne.
  constexpr int kStrikes = 12;
  std::atomic<int> cycles_done = 1;
  std::atomic<int> kills = 0;
  std::jthread killer([&](const std::stop_token& stop) {
    std::minstd_rand random(seed);
    while (!stop.stop_requested() && kills < kStrikes) {
      const int before = cycles_done;
      std::this_thread::sleep_for(std::chrono::milliseconds(random() % 20));
      while (!stop.stop_requested() && cycles_done < before + 2)
        std::this_thread::sleep_for(std::chrono::microseconds(200));
      const std::vector<pid_t> those = children();
      if (those.size() == 3 && kill(those[random() % those.size()], SIGKILL) == 0) ++kills;
    }
  });
  const auto are_all_well = [&] {
    return std::ranges::all_of(all, [](const Traveller* one) { return one->failure().empty(); });
  };
  for (; are_all_well() && (kills < kStrikes || cycles_done < 100); ++cycles_done) done += cycle(all);
  killer.request_stop();
  killer.join();
  Local here(false);
  const RobotProgram embedded = standard_robot(false);
  std::vector<std::unique_ptr<Traveller>> known;
  for (Traveller*& one : all) {
    EXPECT_EQ(one->failure(), "");
    const auto id = static_cast<std::uint32_t>(&one - all.data()) + 1;
    known.push_back(std::make_unique<Traveller>(here.runner_of(embedded), id, embedded));
    one = known.back().get();
    ASSERT_EQ(one->start(), std::nullopt);
  }
  EXPECT_TRUE(done == cycles(all, cycles_done)) << kills << " kills in " << cycles_done << " cycles";
}

// Two robots at an agent each, of which the second one has ended.
struct OneOfTwoLost {
  OneOfTwoLost() {
    EXPECT_EQ(first.start(), std::nullopt);
    EXPECT_EQ(second.start(), std::nullopt);
    cycles({&first, &second}, 3);
    agents.link(1).end();
    cycles({&first, &second}, 1);
  }
  Agents agents;
  const RobotProgram program = standard_robot(false);
  ProgramRunner& runner = agents.runner_of(program);
  Traveller first{runner, 1, program};
  Traveller second{runner, 2, program};
};

TEST(RobotsAtAgents, AreSharedOutAndFailWithTheirAgent) {
  OneOfTwoLost now;
  auto& [agents, program, runner, first, second] = now;
  EXPECT_EQ(first.failure(), "");
  EXPECT_TRUE(first.action().drives);
  EXPECT_EQ(second.failure(), "can't be reached: the agent on `birch` ended");
  EXPECT_FALSE(second.action().drives);
  EXPECT_FALSE(runner.has_lost(first.member()));
  EXPECT_TRUE(runner.has_lost(second.member()));
  ASSERT_EQ(second.start(), std::nullopt) << "the other agent takes it";
  EXPECT_FALSE(runner.has_lost(second.member()));
  cycles({&first, &second}, 1);
  EXPECT_EQ(second.failure(), "");
  EXPECT_TRUE(second.action().drives);
  agents.link(0).end();
  cycles({&first, &second}, 1);
  EXPECT_EQ(first.start(), "has no agent: the agent on `birch` ended");
}

TEST(RobotsAtAgents, GetWhatWasSetWhileTheirAgentWasLostAtTheirNextStart) {
  OneOfTwoLost now;
  auto& [agents, program, runner, first, second] = now;
  ASSERT_NE(second.failure(), "");
  EXPECT_EQ(runner.set(second.member(), "base_velocity", "0.1"), std::nullopt);
  EXPECT_NE(runner.set(second.member(), "base_velocity", "fast"), std::nullopt);
  EXPECT_NE(runner.release(second.member(), "no_such_port"), std::nullopt);
  ASSERT_EQ(second.start(), std::nullopt);
  cycles({&first, &second}, 1);
  EXPECT_EQ(second.failure(), "");
  EXPECT_EQ(second.number("base_velocity"), 0.1);
  EXPECT_EQ(first.number("base_velocity"), 0.2);
}

TEST(RobotsAtAgents, CanBeLookedAtWhileTheyAct) {
  Agents agents;
  const RobotProgram program = standard_robot(false);
  ProgramRunner& runner = agents.runner_of(program);
  Traveller robot(runner, 1, program);
  ASSERT_EQ(robot.start(), std::nullopt);
  cycles({&robot}, 2);
  agents.link(0).slow_down(std::chrono::milliseconds(100));
  runner.join(robot.member());
  runner.open();
  const ProgramRunner::Turn turn = robot.turn();
  runner.act({&turn, 1});
  runner.ask();
  int looks = 0;
  runner.wait([&] {
    ++looks;
    EXPECT_EQ(robot.number("base_velocity"), 0.2);
    return false;
  });
  EXPECT_GT(looks, 0);
  EXPECT_EQ(robot.failure(), "");
  EXPECT_EQ(flow::Program::cycle(runner.workings(robot.member()).frame), 3U);
}

TEST(RobotsAtAgents, GoWhereTheirProgramSays) {
  Agents agents;
  RobotProgram program = standard_robot(false);
  program.host = "birch";
  Traveller robot(agents.runner_of(program), 1, program);
  ASSERT_EQ(robot.start(), std::nullopt);
  agents.link(1).end();
  cycles({&robot}, 1);
  EXPECT_EQ(robot.failure(), "can't be reached: the agent on `birch` ended");
  RobotProgram other = standard_robot(false);
  other.host = "cedar";
  Traveller lost(agents.runner_of(other), 2, other);
  EXPECT_EQ(lost.start(), "has no agent: nobody of that name is there");
}

TEST(RobotsAtAgents, LetWhoAsksReadWhatWasSaidThere) {
  const std::string folder = ::testing::TempDir() + "mlab_runner_test_" + std::to_string(::getpid());
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/talker.cnl")
      << "procedure Vector Talk with\nheader\nbody\n  std::fprintf(stderr, \"at %.1f s\\n\", time);\n"
         "  output = polar(1.0, 0.0);\npend\n"
         "node talk is Talk with nend\n"
         "node wheels is Drive with v = talk; base_velocity = 1; max_velocity = 5; nend\n";
  text::Diagnostics sink;
  robot::ProgramSources sources{.permission = cell::testing::code_permitted(),
                                .folder = folder,
                                .include_root = base::source_folder() + "/src"};
  const auto program = robot::load_program("talker.cnl", {}, {}, sources, {}, sink);
  ASSERT_TRUE(program) << text::render(sink);
  const auto runner = FleetOfThreads::shared().make_runner(kSeed);
  Traveller robot(*runner, 1, *program);
  ASSERT_EQ(robot.start(), std::nullopt);
  cycles({&robot}, 2);
  const auto said = runner->said(robot.member());
  ASSERT_TRUE(said) << said.error();
  EXPECT_EQ(said->program, "at 0.0 s\nat 0.1 s\n");
  ASSERT_FALSE(said->machine.empty());
  EXPECT_EQ(said->machine.back().text, "a run has begun to talk to this agent");
  EXPECT_LT(said->machine.back().age, 60.0);
  std::filesystem::remove_all(folder);
}

TEST(RobotsAtAgents, KeepNobodyWaitingWhoReadsWhatASlowOneSaid) {
  Agents agents;
  RobotProgram program = standard_robot(false);
  program.host = "alder";
  ProgramRunner& runner = agents.runner_of(program);
  Traveller robot(runner, 1, program);
  ASSERT_EQ(robot.start(), std::nullopt);
  cycles({&robot}, 2);
  agents.link(0).slow_down(std::chrono::milliseconds(1000));
  const auto began = std::chrono::steady_clock::now();
  const auto early = runner.said(robot.member());
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::milliseconds(900));
  ASSERT_FALSE(early);
  EXPECT_EQ(early.error(), "the agent on `alder` has not answered yet: ask again in a moment");
  agents.link(0).slow_down(std::chrono::milliseconds(0));
  cycles({&robot}, 2);
  EXPECT_EQ(robot.failure(), "") << "its answer came before those of the cycles";
  EXPECT_TRUE(runner.said(robot.member())) << "it was kept";
  cycles({&robot}, 1);
  EXPECT_TRUE(runner.said(robot.member())) << "asked anew";
  EXPECT_EQ(robot.failure(), "");
}

TEST(RobotsInRealTime, AreKnownToActOnOldPercepts) {
  FleetOfThreads fleet(100);
  const auto runner = fleet.make_runner(kSeed, 0.02);
  const RobotProgram program = standard_robot(false);
  Traveller robot(*runner, 1, program);
  ASSERT_EQ(robot.start(), std::nullopt);
  bool was_in_time = false;
  for (int i = 0; i < 250 && !was_in_time; ++i) {
    const auto next = std::chrono::steady_clock::now() + std::chrono::milliseconds(20);
    cycle({&robot});
    EXPECT_GE(runner->percept_age(robot.member()), 0.0);
    was_in_time = runner->percept_age(robot.member()) == 0.0;
    std::this_thread::sleep_until(next);
  }
  EXPECT_TRUE(was_in_time);
  std::this_thread::sleep_for(std::chrono::milliseconds(800));
  cycle({&robot});
  EXPECT_LT(runner->percept_age(robot.member()), 0.5) << "nobody asked meanwhile: the run stood";
  EXPECT_EQ(runner->silence(robot.member()), 0.0);
}

TEST(RobotsInRealTime, GoTheirWayThoughNobodyWaitsForThem) {
  constexpr std::chrono::milliseconds kPeriod(20);
  FleetOfThreads fleet(100);
  const auto runner = fleet.make_runner(kSeed, 0.02);
  const RobotProgram program = standard_robot(false);
  Traveller first(*runner, 1, program);
  Traveller second(*runner, 2, program);
  ASSERT_EQ(first.start(), std::nullopt);
  ASSERT_EQ(second.start(), std::nullopt);
  const auto drive = [&](int count) {
    for (int i = 0; i < count; ++i) {
      const auto next = std::chrono::steady_clock::now() + kPeriod;
      cycle({&first, &second});
      EXPECT_EQ(first.failure() + second.failure(), "");
      std::this_thread::sleep_until(next);
    }
  };
  drive(150);
  EXPECT_TRUE(first.action().drives && second.action().drives);
  const robot::Punctuality after = *runner->punctuality();
  EXPECT_EQ(after.asked, 300U);
  EXPECT_LT(after.late, 300U);
  EXPECT_LT(after.stood, 100U);
  std::this_thread::sleep_for(
      std::chrono::milliseconds(700));  // the run rests for longer than an action counts
  drive(1);
  EXPECT_EQ(runner->punctuality()->asked, 302U);
  drive(50);
  EXPECT_TRUE(first.action().drives && second.action().drives) << "they go on";
  EXPECT_EQ(runner->set(first.member(), "base_velocity", "0.4"), std::nullopt);
  drive(10);
  EXPECT_EQ(first.number("base_velocity"), 0.4);
}

TEST(RobotsAtAgents, OfAnotherVersionAreRefused) {
  robot_remote::Agent agent("alder", std::make_unique<DirectLink>(robot::ProgramSources{
                                         .permission = cell::testing::code_permitted(), .version = "test"}));
  const auto problem = agent.open(kSeed, "other");
  ASSERT_TRUE(problem);
  EXPECT_EQ(*problem,
            "the agent on `alder` is missionlab test (protocol 2), and this is other (protocol 2): install "
            "the same");
  EXPECT_NE(agent.failure(), "");
}

}  // namespace
}  // namespace mlab::testing
