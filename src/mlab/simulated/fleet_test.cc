#include "mlab/fleet/fleet.h"

#include <cstring>

#include <gtest/gtest.h>

#include "mlab/base/testing/count_allocations.h"
#include "mlab/flow/testing/behaviors.h"
#include "mlab/sim/simulated_binding.h"

namespace mlab::run {
namespace {

// A mission of `count` robots of one type, and a program that drives at the speed `speed`.
struct TestFleet {
  mission::Mission mission;
  std::vector<robot::RobotProgram> programs;
  sim::SimulatedBinding bodies;
  fleet::Fleet fleet;

  explicit TestFleet(std::uint32_t count, int threads = 1)
      : mission(mission_of(count)),
        programs(program()),
        bodies(sim::World{}, {1, threads}),
        fleet(mission, programs, {binding::BodySpec{}}, bodies, 1) {
    for (std::uint32_t i = 1; i <= count; ++i) EXPECT_TRUE(fleet.start({i}, {{0.0, 10.0 * i}, 0.0}));
  }

  static mission::Mission mission_of(std::uint32_t count) {
    mission::Mission out;
    out.types.emplace_back();
    for (std::uint32_t i = 1; i <= count; ++i) out.robots.push_back({{i}, 0, {}});
    return out;
  }
  // Drives at twice the parameter `speed`.
  static std::vector<robot::RobotProgram> program() {
    using flow::test::constant;
    using flow::test::node;
    const auto from = [](const char* path) { return flow::test::name(path); };
    flow::Network network;
    network.parameters.push_back({"speed", "double", "", "", {}, constant("1"), -1e308, 1e308, {}});
    network.nodes.push_back(node("twice", "Add", {{"a", from("speed")}, {"b", from("speed")}}));
    network.nodes.push_back(node("sink", "Show", {{"value", from("twice")}}));
    text::Diagnostics sink;
    robot::RobotProgram out;
    out.name = "test";
    out.program = flow::build_program(network, flow::test::library(), sink);
    out.initial = out.program->make_frame();
    std::vector<robot::RobotProgram> all;
    all.push_back(std::move(out));
    return all;
  }
  void set_speed(std::uint32_t robot, double speed) {
    const fleet::FleetRobot& changed = *fleet.find({robot});
    flow::Frame frame = changed.runner->save(changed.member);
    std::memcpy(frame.data() + programs[0].program->find("speed")->offset, &speed, sizeof speed);
    EXPECT_TRUE(changed.runner->restore(changed.member, frame));
  }
};

// What a robot calls when its program does as `acts` says.
std::vector<fleet::RobotCall> calls_of(void (*acts)(flow::Call&)) {
  static flow::Behavior behavior;
  behavior = {};
  behavior.name = "Act";
  behavior.fire = acts;
  flow::Library library;
  library.add(std::vector<const flow::Behavior*>{&behavior});
  flow::Network network;
  network.nodes.push_back(flow::test::node("act", "Act", {}));
  text::Diagnostics sink;
  std::vector<robot::RobotProgram> programs(1);
  programs[0].program = flow::build_program(network, library, sink);
  EXPECT_TRUE(programs[0].program) << text::render(sink);
  programs[0].initial = programs[0].program->make_frame();
  const mission::Mission mission = TestFleet::mission_of(1);
  sim::SimulatedBinding bodies(sim::World{});
  fleet::Fleet fleet(mission, programs, {binding::BodySpec{}}, bodies, 1);
  EXPECT_TRUE(fleet.start({1}, {}));
  fleet.step(0.1);
  return fleet.take_calls();
}

TEST(Fleet, PassesOnWhatARobotCalls) {
  const std::vector<fleet::RobotCall> calls = calls_of([](flow::Call& call) {
    percept::Action& action = *call.cycle->action;
    action.alert = {'f', 'i', 'r', 'e'};
    percept::Request halt;
    halt.kind = percept::Request::Kind::kHalt;
    action.ask(halt);
  });
  ASSERT_EQ(calls.size(), 2U);
  EXPECT_EQ(calls[0].kind, fleet::RobotCall::Kind::kAlert);
  EXPECT_EQ(calls[0].text, "fire");
  EXPECT_EQ(calls[1].kind, fleet::RobotCall::Kind::kHalt);
  EXPECT_TRUE(calls_of([](flow::Call&) {}).empty());
}

TEST(Fleet, DrivesEveryRobotByItsProgram) {
  TestFleet t(2);
  t.fleet.step(0.1);
  EXPECT_NEAR(t.fleet.pose(*t.fleet.find({1})).position.x, 0.2, 1e-12);
  EXPECT_NEAR(t.fleet.pose(*t.fleet.find({2})).position.x, 0.2, 1e-12);
}

TEST(Fleet, ARobotWhoseProgramGoesWrongStandsAndTheOthersGoOn) {
  TestFleet t(3);
  t.set_speed(2, 1e308);  // twice that is infinite
  t.fleet.step(0.1);
  t.fleet.step(0.1);
  EXPECT_EQ(t.fleet.find({2})->life, fleet::RobotLife::kFaulted);
  EXPECT_EQ(t.fleet.find({2})->fault, "twice");
  EXPECT_EQ(t.fleet.pose(*t.fleet.find({2})).position.x, 0.0);
  EXPECT_NEAR(t.fleet.pose(*t.fleet.find({3})).position.x, 0.4, 1e-12);
  EXPECT_EQ(t.fleet.take_new_faults(), (std::vector<base::RobotId>{{2}}));
  EXPECT_TRUE(t.fleet.take_new_faults().empty()) << "told once";
}

TEST(Fleet, AnotherRobotTakesThePlaceOfOneThatStandsBecauseOfAFault) {
  TestFleet t(3);
  mission::effect::Order order;
  order.members = {{1}, {2}, {3}};
  order.order.sequence = 7;
  t.fleet.order(order);
  t.fleet.step(0.1);
  t.set_speed(2, 1e308);
  t.fleet.step(0.1);
  const double where = t.fleet.pose(*t.fleet.find({2})).position.x;
  EXPECT_EQ(t.fleet.take_new_faults().size(), 1U);

  ASSERT_EQ(t.fleet.replace({2}), std::nullopt);
  EXPECT_EQ(t.fleet.find({2})->life, fleet::RobotLife::kRunning);
  EXPECT_EQ(t.fleet.find({2})->fault, "");
  ASSERT_NE(t.fleet.group(*t.fleet.find({2})), nullptr);
  EXPECT_EQ(t.fleet.group(*t.fleet.find({2}))->order.sequence, 7U) << "the order of its unit";
  t.fleet.step(0.1);
  EXPECT_NEAR(t.fleet.pose(*t.fleet.find({2})).position.x, where + 0.2, 1e-12);

  EXPECT_EQ(t.fleet.replace({2}), "robot 2 has no fault that another one would be needed for: running");
  t.fleet.stop({3});
  EXPECT_EQ(t.fleet.replace({3}), "robot 3 has no fault that another one would be needed for: stopped");
  EXPECT_EQ(t.fleet.replace({9}), "there is no robot 9");
}

TEST(Fleet, AStoppedRobotKeepsStanding) {
  TestFleet t(1);
  t.fleet.stop({1});
  t.fleet.step(0.1);
  EXPECT_EQ(t.fleet.find({1})->life, fleet::RobotLife::kStopped);
  EXPECT_EQ(t.fleet.pose(*t.fleet.find({1})).position.x, 0.0);
}

TEST(Fleet, ReportsWhatTheExecutiveNeeds) {
  TestFleet t(2);
  t.fleet.stop({2});
  std::vector<mission::RobotReport> reports;
  t.fleet.report(reports);
  ASSERT_EQ(reports.size(), 2U);
  EXPECT_TRUE(reports[0].is_running);
  EXPECT_FALSE(reports[1].is_running);
}

TEST(Fleet, AnOrderTakesRobotsOverFromAnotherGroup) {
  TestFleet t(4);
  mission::effect::Order order;
  order.members = {{1}, {2}, {3}, {4}};
  order.order.sequence = 1;
  t.fleet.order(order);
  order.members = {{3}, {1}};
  order.order.sequence = 2;
  t.fleet.order(order);
  EXPECT_EQ(t.fleet.group(*t.fleet.find({3}))->members, (std::vector<std::uint32_t>{2, 0}));
  EXPECT_EQ(t.fleet.find({3})->rank, 0U);
  EXPECT_EQ(t.fleet.find({1})->rank, 1U);
  EXPECT_EQ(t.fleet.group(*t.fleet.find({4}))->members, (std::vector<std::uint32_t>{1, 3}));
  EXPECT_EQ(t.fleet.find({4})->rank, 1U);
  EXPECT_EQ(t.fleet.group(*t.fleet.find({4}))->order.sequence, 1U);
}

TEST(Fleet, UsesNoHeapInTheCycle) {
  TestFleet t(20);
  for (int i = 0; i < 5; ++i) t.fleet.step(0.1);
  const std::size_t before = base::allocation_count();
  for (int i = 0; i < 50; ++i) t.fleet.step(0.1);
  EXPECT_EQ(base::allocation_count(), before);
}

TEST(Fleet, StepsTheSameWithOneThreadAndWithEight) {
  TestFleet one(50, 1);
  TestFleet eight(50, 8);
  for (int i = 0; i < 20; ++i) {
    one.fleet.step(0.1);
    eight.fleet.step(0.1);
  }
  for (const fleet::FleetRobot& robot : one.fleet.robots()) {
    EXPECT_EQ(one.fleet.pose(robot), eight.fleet.pose(*eight.fleet.find(robot.id)));
    const fleet::FleetRobot& same = *eight.fleet.find(robot.id);
    EXPECT_EQ(robot.runner->save(robot.member), same.runner->save(same.member));
  }
}

}  // namespace
}  // namespace mlab::run
