#include "mlab/flow/carry_over.h"

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/flow/testing/behaviors.h"

namespace mlab::flow {
namespace {

using namespace mlab::flow::test;

// A sequence whose members count, a delay, a parameter, and a node that all states share.
Network counting(const std::string& start = "50") {
  Network network;
  network.parameters.push_back({"bias", "double", "", "", {}, constant("1000"), -1e308, 1e308, {}});
  network.nodes.push_back(node("a", "Count"));
  network.nodes.push_back(node("b", "Count", {{"start", constant(start)}}));
  network.nodes.push_back(node("t0", "After", {{"at", constant("3")}}));
  network.nodes.push_back(node("t1", "After", {{"at", constant("4")}}));
  Node job = node("job", "int");
  job.kind = Node::Kind::kSequence;
  job.states = {State{"A", name("a"), {{name("t0"), false, "B", false, {}}}, true, false, {}},
                State{"B", name("b"), {{name("t1"), false, "A", false, {}}}, false, false, {}}};
  network.nodes.push_back(job);
  Node before = node("before", "double", {{"value", name("sum")}, {"initial", constant("0")}});
  before.kind = Node::Kind::kDelay;
  network.nodes.push_back(before);
  network.nodes.push_back(node("sum", "Add", {{"a", name("job")}, {"b", name("bias")}}));
  network.nodes.push_back(node("both", "Add", {{"a", name("sum")}, {"b", name("before")}}));
  network.nodes.push_back(node("sink", "Show", {{"value", name("both")}}));
  return network;
}

struct CarryingRobot {
  Runner runner;

  explicit CarryingRobot(const Network& network) : runner(network) {
    EXPECT_TRUE(runner.program) << text::render(runner.sink);
  }
  double step() {
    runner.step();
    return runner.action.velocity.x;
  }
  std::vector<double> steps(int count) {
    std::vector<double> out;
    for (int i = 0; i < count; ++i) out.push_back(step());
    return out;
  }
  ProgramVersion version() const { return {*runner.program, runner.program->initial_frame()}; }
  std::string state() const { return runner.program->active_states(runner.frame.data()).front(); }
  // Goes on with the values of another one.
  std::vector<Restart> take_over(const CarryingRobot& other, bool has_same_code = true) {
    CarriedOver carried = carry_over(other.version(), other.runner.frame.data(), version(), has_same_code);
    runner.frame = std::move(carried.frame);
    runner.percepts = other.runner.percepts;
    return std::move(carried.restarts);
  }
};

TEST(CarryOver, ToTheSameProgramIsTheSameBitForBitInEveryCycle) {
  for (int cycle = 0; cycle < 30; ++cycle) {
    CarryingRobot robot(counting());
    robot.steps(cycle);
    CarryingRobot built_again(counting());
    EXPECT_TRUE(built_again.take_over(robot).empty());
    EXPECT_TRUE(built_again.runner.frame == robot.runner.frame) << "cycle " << cycle;
    const CarriedOver same = carry_over(robot.version(), robot.runner.frame.data(), robot.version(), false);
    EXPECT_TRUE(same.frame == robot.runner.frame);
    EXPECT_TRUE(same.restarts.empty());
  }
}

// Nodes that are new stand between the others, so that all have other places in the frame.
Network with_more(Network network, std::mt19937& random) {
  const int count = 1 + static_cast<int>(random() % 5);
  for (int i = 0; i < count; ++i) {
    const std::string number = std::to_string(i);
    const auto at = static_cast<std::ptrdiff_t>(random() % (network.nodes.size() + 1));
    network.nodes.insert(network.nodes.begin() + at,
                         node("more" + number, "Count", {{"start", constant(number)}}));
    network.nodes.push_back(node("shown" + number, "Heading", {{"angle", constant("0.5")}}));
    network.nodes.back().is_public = true;
    for (Node& one : network.nodes) {
      if (one.name == "more" + number) one.is_public = true;
    }
  }
  return network;
}

TEST(CarryOver, ARunWithASwapAtAnyCycleIsTheSameAsOneWithout) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    CarryingRobot without(counting());
    CarryingRobot with(counting());
    const int swap = static_cast<int>(random() % 40);
    EXPECT_EQ(with.steps(swap), without.steps(swap));
    CarryingRobot larger(with_more(counting(), random));
    EXPECT_TRUE(larger.take_over(with).empty());
    EXPECT_EQ(larger.steps(20), without.steps(20)) << "round " << round;
    // And back: an undo.
    CarryingRobot again(counting());
    EXPECT_TRUE(again.take_over(larger).empty());
    EXPECT_EQ(again.steps(20), without.steps(20)) << "round " << round;
  }
}

TEST(CarryOver, TheTextsValuesHoldUnlessSomebodyHasSetThem) {
  CarryingRobot robot(counting());
  robot.steps(4);
  ASSERT_EQ(robot.state(), "job.B");
  const Port& bias = *robot.runner.program->find("bias");
  ASSERT_EQ(robot.runner.program->set(robot.runner.frame.data(), bias, "2000"), std::nullopt);
  CarryingRobot changed(counting("70"));
  changed.take_over(robot);
  EXPECT_EQ(changed.runner.number("bias"), 2000.0) << "set by a person";
  EXPECT_EQ(changed.runner.number("b.start"), 70.0) << "changed in the text";
  changed.step();
  EXPECT_EQ(changed.runner.number("b"), 73.0) << "it goes on counting";
}

TEST(CarryOver, WhatSomebodyHasSetIsNotKeptWhereItIsOutOfRangeNow) {
  CarryingRobot robot(counting());
  robot.steps(4);
  const Port& bias = *robot.runner.program->find("bias");
  ASSERT_EQ(robot.runner.program->set(robot.runner.frame.data(), bias, "2000"), std::nullopt);
  Network narrow = counting();
  narrow.parameters[0].max = 1500.0;
  CarryingRobot changed(narrow);
  EXPECT_EQ(changed.take_over(robot), (std::vector<Restart>{{"bias", kOutOfRange}}));
  EXPECT_EQ(changed.runner.number("bias"), 1000.0);
  narrow.parameters[0].max = 2000.0;
  CarryingRobot wide(narrow);
  EXPECT_TRUE(wide.take_over(robot).empty());
  EXPECT_EQ(wide.runner.number("bias"), 2000.0);
}

TEST(CarryOver, ASequenceWhoseStateIsGoneBeginsAndSaysSo) {
  CarryingRobot robot(counting());
  robot.steps(4);
  ASSERT_EQ(robot.state(), "job.B");
  Network renamed = counting();
  renamed.nodes[4].states[1].name = "Later";
  renamed.nodes[4].states[0].transitions[0].target = "Later";
  CarryingRobot other(renamed);
  EXPECT_EQ(other.take_over(robot), (std::vector<Restart>{{"job", "begins in A: its state B is gone"}}));
  EXPECT_EQ(other.state(), "job.A");
  other.step();
  EXPECT_EQ(other.runner.number("a"), 1.0) << "its member starts as in any state that is entered";
}

TEST(CarryOver, ASequenceStaysInItsStateWhereStatesAreReordered) {
  CarryingRobot robot(counting());
  robot.steps(4);
  Network reordered = counting();
  std::swap(reordered.nodes[4].states[0], reordered.nodes[4].states[1]);
  CarryingRobot other(reordered);
  EXPECT_TRUE(other.take_over(robot).empty());
  EXPECT_EQ(other.state(), "job.B");
  EXPECT_EQ(other.steps(10), robot.steps(10));
}

TEST(CarryOver, AnotherComponentOfTheSameNameBeginsAndSaysSo) {
  CarryingRobot robot(counting());
  robot.steps(2);
  Network changed = counting();
  changed.nodes[2] = node("t0", "After", {{"at", constant("3")}});
  changed.nodes[0] = node("a", "Count", {{"start", constant("7")}});
  EXPECT_TRUE(CarryingRobot(changed).take_over(robot).empty()) << "the same component, differently fed";
  // What counted is a trigger now.
  Network other = counting();
  other.nodes[0] = node("a", "After", {{"at", constant("2")}});
  other.nodes[4].states[0].member = name("b");
  other.nodes[0].is_public = true;
  CarryingRobot swapped(other);
  EXPECT_EQ(swapped.take_over(robot), (std::vector<Restart>{{"a", "is another component now"}}));
  swapped.step();
  EXPECT_EQ(swapped.runner.number("a"), 0.0);
}

TEST(CarryOver, WhatWasBeingComputedBesidesIsComputedAnew) {
  Network network;
  network.nodes.push_back(node("slow", "SlowSquare", {{"x", constant("3")}}));
  network.nodes.push_back(node("sink", "Show", {{"value", name("slow")}}));
  CarryingRobot robot(network);
  robot.steps(5);
  EXPECT_EQ(robot.runner.number("slow"), 1009.0);
  CarryingRobot other(network);
  const std::vector<Restart> restarts = other.take_over(robot);
  ASSERT_EQ(restarts.size(), 1U);
  EXPECT_EQ(restarts[0].path, "slow");
  EXPECT_EQ(other.steps(3), (std::vector<double>{1009, 1009, 1009})) << "until then what it had";
  EXPECT_EQ(other.step(), 2009.0) << "its state is kept";
}

TEST(CarryOver, TakesAnyBytes) {
  std::mt19937 random(3);
  const CarryingRobot before(counting());
  CarryingRobot after(counting("60"));
  for (int round = 0; round < 500; ++round) {
    Frame frame = before.runner.frame;
    for (std::size_t i = 0; i < frame.size(); ++i) frame.data()[i] = static_cast<std::byte>(random());
    const CarriedOver carried = carry_over(before.version(), frame.data(), after.version(), true);
    EXPECT_EQ(carried.frame.size(), after.runner.frame.size());
  }
}

}  // namespace
}  // namespace mlab::flow
