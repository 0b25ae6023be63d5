#include "mlab/flow/interventions.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/testing/count_allocations.h"
#include "mlab/flow/carry_over.h"
#include "mlab/flow/testing/behaviors.h"

namespace mlab::flow {
namespace {

using namespace mlab::flow::test;

// Counts in A from 1, in B from 51; t0 leads to B in the third cycle of A, t1 back in the second of B. C is
// where no way leads.
Network three_states() {
  Network network;
  network.nodes.push_back(node("a", "Count"));
  network.nodes.push_back(node("b", "Count", {{"start", constant("50")}}));
  network.nodes.push_back(node("c", "Count", {{"start", constant("90")}}));
  network.nodes.push_back(node("t0", "After", {{"at", constant("3")}}));
  network.nodes.push_back(node("t1", "After", {{"at", constant("2")}}));
  Node job = node("job", "int");
  job.kind = Node::Kind::kSequence;
  job.states = {
      State{"A", name("a"), {{name("t0"), false, "B", false, {}}}, true, false, {}},
      State{"B", name("b"), {{name("t1"), false, "A", false, {}}}, false, false, {}},
      State{"C", name("c"), {}, false, true, {}},
  };
  network.nodes.push_back(job);
  network.nodes.push_back(node("sum", "Add", {{"a", name("job")}, {"b", constant("1000")}}));
  network.nodes.push_back(node("sink", "Show", {{"value", name("sum")}}));
  return network;
}

/// A robot that somebody may interfere with.
class HandledRobot {
 public:
  explicit HandledRobot(const Network& network) : runner_(network) {
    EXPECT_TRUE(runner_.program) << text::render(runner_.sink);
  }

  /// @return  what the robot does
  double step() {
    runner_.action = {};
    program().sequence_states(frame(), before_);
    program().step(frame(), runner_.percepts, runner_.action, 1, 1, nullptr,
                   hands_.is_empty() ? nullptr : &hands_);
    hands_.finish();
    runner_.percepts.time += runner_.percepts.cycle_duration;
    return runner_.action.velocity.x;
  }
  std::vector<double> steps(int count) {
    std::vector<double> out;
    for (int i = 0; i < count; ++i) out.push_back(step());
    return out;
  }
  std::string force(std::string_view sequence, std::string_view state) {
    return hands_.force(program(), frame(), sequence, state).value_or("");
  }
  std::string hold(std::string_view port, std::string_view value) {
    return hands_.hold(program(), frame(), port, value).value_or("");
  }
  std::string release(std::string_view port) { return hands_.release(program(), frame(), port).value_or(""); }
  std::vector<Program::Transit> transits() const { return program().transits(frame(), before_, &hands_); }
  bool ran(std::string_view port) const {
    const std::vector<std::uint32_t> all = program().ran(frame(), before_, &hands_);
    return std::ranges::binary_search(all, program().find(port)->offset);
  }
  double number(std::string_view port) const { return runner_.number(port); }

  const Program& program() const { return *runner_.program; }
  std::byte* frame() { return runner_.frame.data(); }
  const std::byte* frame() const { return runner_.frame.data(); }
  const Frame& values() const { return runner_.frame; }
  Interventions& hands() { return hands_; }

 private:
  Runner runner_;
  Interventions hands_;
  std::vector<Program::SequenceState> before_;
};

TEST(Interventions, ASequenceGoesToTheStateInTheNextCycleAndAsksNoTrigger) {
  HandledRobot robot(three_states());
  EXPECT_EQ(robot.steps(2), (std::vector<double>{1001, 1002}));
  EXPECT_EQ(robot.force("job", "B"), "");
  EXPECT_EQ(robot.step(), 1051) << "B begins";
  EXPECT_FALSE(robot.ran("t0")) << "A's trigger was not asked";
  EXPECT_EQ(robot.number("t0"), 0.0) << "the third firing would have made it true";
  // From there on it goes its own way: t1 fires for the second time in the second cycle after.
  EXPECT_EQ(robot.steps(3), (std::vector<double>{1052, 1001, 1002}));
}

TEST(Interventions, AStateCanBeReachedWhereNoWayLeads) {
  HandledRobot robot(three_states());
  robot.step();
  EXPECT_EQ(robot.force("job", "C"), "");
  EXPECT_EQ(robot.steps(3), (std::vector<double>{1091, 1092, 1093}));
  EXPECT_EQ(robot.force("job", "A"), "");
  EXPECT_EQ(robot.step(), 1001);
}

TEST(Interventions, AStateThatIsForcedWhileItIsActiveBeginsAnew) {
  HandledRobot robot(three_states());
  EXPECT_EQ(robot.steps(2), (std::vector<double>{1001, 1002}));
  EXPECT_EQ(robot.force("job", "A"), "");
  EXPECT_EQ(robot.step(), 1001);
}

TEST(Interventions, TheLastWordBeforeTheCycleCounts) {
  HandledRobot robot(three_states());
  robot.step();
  EXPECT_EQ(robot.force("job", "B"), "");
  EXPECT_EQ(robot.force("job", "C"), "");
  EXPECT_EQ(robot.step(), 1091);
}

TEST(Interventions, AForcedTransitionIsToldAsWhatItWas) {
  HandledRobot robot(three_states());
  robot.step();
  robot.force("job", "B");
  robot.step();
  ASSERT_EQ(robot.transits().size(), 1U);
  EXPECT_TRUE(robot.transits()[0].is_forced);
  EXPECT_EQ(robot.transits()[0].from, 0U);
  EXPECT_EQ(robot.transits()[0].to, 1U);
  EXPECT_EQ(robot.transits()[0].way, 0U) << "the way that is drawn from A to B";
  robot.force("job", "C");
  robot.step();
  ASSERT_EQ(robot.transits().size(), 1U);
  EXPECT_EQ(robot.transits()[0].way, Program::kNone) << "none leads to C";
  robot.step();
  EXPECT_TRUE(robot.transits().empty());
}

TEST(Interventions, NothingWasForcedInAFrameThatBeginsAnew) {
  HandledRobot robot(three_states());
  robot.step();
  EXPECT_EQ(robot.force("job", "C"), "");
  robot.step();
  EXPECT_EQ(robot.hands().forced().size(), 1U);
  robot.hands().begin_anew(robot.frame());
  EXPECT_TRUE(robot.hands().forced().empty());
  EXPECT_TRUE(robot.hands().is_empty());
}

TEST(Interventions, RefuseWhatCanNotBeForced) {
  HandledRobot robot(three_states());
  EXPECT_EQ(robot.force("jib", "B"), "there is no sequence `jib`");
  EXPECT_EQ(robot.force("job", "D"), "`job` has no state `D`");
  Network inner = three_states();
  Node outer = node("outer", "int");
  outer.kind = Node::Kind::kSequence;
  outer.states = {State{"First", name("c"), {}, true, true, {}},
                  State{"Second", name("job"), {}, false, true, {}}};
  inner.nodes[6].links[0].source = name("outer");
  inner.nodes.push_back(outer);
  HandledRobot nested(inner);
  nested.step();
  EXPECT_EQ(nested.force("job", "B"), "`job` does not run now");
  EXPECT_EQ(nested.force("outer", "Second"), "");
  EXPECT_EQ(nested.step(), 1001);
  EXPECT_EQ(nested.force("job", "B"), "");
  // What it is part of ends in the same cycle: it is not sent anywhere, and that can be told.
  EXPECT_EQ(nested.force("outer", "First"), "");
  nested.step();
  ASSERT_EQ(nested.hands().forced().size(), 2U);
  EXPECT_FALSE(nested.hands().forced()[0].was_done);
  EXPECT_TRUE(nested.hands().forced()[1].was_done);
  EXPECT_EQ(nested.step(), 1092);
}

TEST(Interventions, WhoReadsAHeldOutputSeesTheValueAndTheNodeGoesOn) {
  HandledRobot robot(three_states());
  robot.step();
  EXPECT_EQ(robot.hold("job", "7"), "");
  EXPECT_EQ(robot.steps(3), (std::vector<double>{1007, 1007, 1007}));
  EXPECT_EQ(robot.number("job"), 7.0);
  EXPECT_EQ(robot.number("b"), 52.0) << "the sequence makes its transitions meanwhile";
  EXPECT_EQ(robot.hold("job", "8"), "") << "another value";
  EXPECT_EQ(robot.step(), 1008);
  EXPECT_EQ(robot.release("job"), "");
  EXPECT_EQ(robot.number("job"), 1.0) << "at once what it has computed last";
  EXPECT_EQ(robot.step(), 1002);
  EXPECT_TRUE(robot.hands().is_empty());
}

TEST(Interventions, AHeldTriggerDecides) {
  HandledRobot robot(three_states());
  EXPECT_EQ(robot.hold("t0", "false"), "");
  EXPECT_EQ(robot.steps(5), (std::vector<double>{1001, 1002, 1003, 1004, 1005}));
  EXPECT_EQ(robot.hold("t0", "true"), "");
  EXPECT_EQ(robot.step(), 1051);
}

TEST(Interventions, ANodeThatGoesOnFromItsOwnOutputDoesSo) {
  // y = x + y of the cycle before: held at 100, it has gone on counting when it is released.
  Network network;
  Node before = node("before", "double", {{"value", name("y")}, {"initial", constant("0")}});
  before.kind = Node::Kind::kDelay;
  network.nodes.push_back(before);
  network.nodes.push_back(node("y", "Add", {{"a", constant("1")}, {"b", name("before")}}));
  network.nodes.push_back(node("sink", "Show", {{"value", name("before")}}));
  HandledRobot robot(network);
  EXPECT_EQ(robot.steps(3), (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(robot.hold("before", "100"), "");
  EXPECT_EQ(robot.step(), 100.0);
  EXPECT_EQ(robot.number("y"), 101.0) << "it reads the held value";
  EXPECT_EQ(robot.release("before"), "");
  EXPECT_EQ(robot.number("before"), 3.0);
  EXPECT_EQ(robot.step(), 101.0);
}

TEST(Interventions, RefuseWhatCanNotBeHeld) {
  HandledRobot robot(three_states());
  EXPECT_EQ(robot.hold("nobody", "1"), "the program has no `nobody`");
  EXPECT_EQ(robot.hold("b.start", "1"), "`b.start` is not computed: set it instead of holding it");
  EXPECT_EQ(robot.hold("job", "much"), "`much` is no whole number: `job` takes a whole number");
  EXPECT_EQ(robot.hold("sum", "inf"), "`inf` is no number: `sum` takes a number");
  EXPECT_EQ(robot.release("job"), "`job` is not held");
  EXPECT_EQ(robot.release("nobody"), "`nobody` is not held");
  EXPECT_TRUE(robot.hands().is_empty());
}

TEST(Interventions, WhetherAValueIsFreshCanNotBeHeldButTheValueCan) {
  Network network;
  network.nodes.push_back(node("slow", "SlowSquare", {{"x", constant("3")}}));
  network.nodes.push_back(node("sink", "Show", {{"value", name("slow")}}));
  HandledRobot robot(network);
  EXPECT_EQ(robot.hold("slow.fresh", "true"),
            "`slow.fresh` says when a value has come, and can't be held: hold the value");
  EXPECT_TRUE(robot.hands().is_empty());
  EXPECT_EQ(robot.hold("slow", "7"), "");
  EXPECT_EQ(robot.step(), 7.0);
}

using Losses = std::vector<std::string>;

// The robot's interventions with another program, whose `frame` it goes on with.
Losses carried_over(HandledRobot& robot, HandledRobot& other, bool has_same_code = true) {
  Frame free = robot.values();
  robot.hands().let_go(free.data());
  const CarriedOver carried = carry_over({robot.program(), robot.program().initial_frame()}, free.data(),
                                         {other.program(), other.program().initial_frame()}, has_same_code);
  std::memcpy(other.frame(), carried.frame.data(), carried.frame.size());
  other.hands() = robot.hands();
  Losses out;
  for (const auto& [path, why] : other.hands().carry_over(robot.program(), robot.frame(), other.program(),
                                                          other.frame(), has_same_code))
    out.push_back(path + " " + why);
  return out;
}

TEST(Interventions, AnotherProgramGoesOnWithThemBitForBit) {
  for (int cycles = 0; cycles < 6; ++cycles) {
    HandledRobot robot(three_states());
    robot.steps(2);
    robot.hold("job", "7");
    robot.steps(cycles);
    robot.hold("job", "8");
    robot.force("job", "C");
    HandledRobot other(three_states());
    EXPECT_EQ(carried_over(robot, other), Losses());
    EXPECT_TRUE(other.values() == robot.values());
    EXPECT_EQ(other.steps(3), robot.steps(3));
    robot.release("");
    other.release("");
    EXPECT_TRUE(other.values() == robot.values());
    EXPECT_EQ(other.steps(3), robot.steps(3));
  }
}

TEST(Interventions, ThatAnotherProgramHasNoPlaceForAreTold) {
  HandledRobot robot(three_states());
  robot.step();
  robot.hold("sum", "7");
  robot.hold("t0", "false");
  robot.force("job", "C");
  Network changed = three_states();
  changed.nodes[3] = node("t0", "Count");
  changed.nodes[3].is_public = true;
  changed.nodes[5].states[0].transitions.clear();
  changed.nodes[5].states[2].name = "D";
  changed.nodes[6].name = "total";
  changed.nodes[7].links[0].source = name("total");
  HandledRobot other(changed);
  EXPECT_EQ(carried_over(robot, other), (Losses{"sum is not held any more: nothing of that name is left",
                                                "t0 is not held any more: it is a whole number now",
                                                "job is not sent to C any more: `job` has no state `C`"}));
  EXPECT_TRUE(other.hands().is_empty());
}

TEST(Interventions, ANodeThatBeginsAnewIsReleasedToItsOwnValue) {
  HandledRobot robot(three_states());
  robot.steps(2);
  robot.hold("sum", "7");
  robot.step();
  Network changed = three_states();
  changed.nodes[6] = node("sum", "Heading", {{"angle", constant("0.5")}});
  HandledRobot other(changed);
  const double before = other.number("sum");
  EXPECT_EQ(carried_over(robot, other), Losses());
  EXPECT_EQ(other.number("sum"), 7.0);
  EXPECT_EQ(other.release("sum"), "");
  EXPECT_EQ(other.number("sum"), before) << "not what another component has computed";
}

TEST(Interventions, HoldAsManyValuesAsThereIsRoomForAndSaySo) {
  Network network;
  for (int i = 0; i < 20; ++i) {
    const std::string number = std::to_string(i);
    network.nodes.push_back(node("n" + number, "Count", {{"start", constant(number)}}));
    network.nodes.push_back(node("s" + number, "Show", {{"value", name("n" + number)}}));
  }
  HandledRobot robot(network);
  for (int i = 0; i < 16; ++i) EXPECT_EQ(robot.hold("n" + std::to_string(i), "5"), "");
  EXPECT_EQ(robot.hold("n16", "5"), "16 values are held already, and no more can be");
  EXPECT_EQ(robot.release("n3"), "");
  EXPECT_EQ(robot.hold("n16", "5"), "");
  robot.step();
  EXPECT_EQ(robot.number("n3"), 4.0);
  EXPECT_EQ(robot.number("n15"), 5.0);
  EXPECT_EQ(robot.number("n16"), 5.0);
  EXPECT_EQ(robot.release(""), "");
  EXPECT_TRUE(robot.hands().held().empty());
  EXPECT_EQ(robot.number("n15"), 16.0);
}

TEST(Interventions, WithoutAnyACycleIsTheSameBitForBit) {
  HandledRobot looked_at(three_states());
  HandledRobot alone(three_states());
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(looked_at.step(), alone.step());
    // Through the code that looks for interventions, and finds none.
    looked_at.hands().hold(looked_at.program(), looked_at.frame(), "sum", "3");
    looked_at.hands().release(looked_at.program(), looked_at.frame(), "sum");
    ASSERT_TRUE(looked_at.values() == alone.values()) << "cycle " << i;
  }
  Interventions none;
  Frame with = alone.program().make_frame();
  Frame without = alone.program().make_frame();
  percept::Percepts percepts;
  for (int i = 0; i < 50; ++i) {
    percept::Action a;
    percept::Action b;
    alone.program().step(with.data(), percepts, a, 1, 1, nullptr, &none);
    alone.program().step(without.data(), percepts, b, 1, 1);
    ASSERT_TRUE(with == without) << "cycle " << i;
  }
}

TEST(Interventions, OfAProcessThatIsNotTrustedOnlyNotesAreTaken) {
  HandledRobot robot(three_states());
  robot.hold("job", "7");
  robot.force("job", "B");
  Interventions theirs = robot.hands();
  std::memset(static_cast<void*>(&theirs), 0x5a, sizeof theirs);
  robot.hands().take_notes_of(theirs);
  robot.hands().finish();
  ASSERT_EQ(robot.hands().held().size(), 1U);
  EXPECT_EQ(robot.hands().held()[0].offset, robot.program().find("job")->offset);
  EXPECT_EQ(robot.hands().held()[0].computed[0], std::byte{0x5a});
  ASSERT_EQ(robot.hands().forced().size(), 1U);
  EXPECT_EQ(robot.hands().forced()[0].state, 1U);
  EXPECT_TRUE(robot.hands().forced()[0].was_done);
}

TEST(Interventions, TakeNoHeapInTheCycle) {
  HandledRobot robot(three_states());
  robot.hold("job", "7");
  percept::Percepts percepts;
  percept::Action action;
  Interventions& hands = robot.hands();
  robot.force("job", "B");
  const std::size_t before = base::allocation_count();
  for (int i = 0; i < 100; ++i) {
    robot.program().step(robot.frame(), percepts, action, 1, 1, nullptr, &hands);
    hands.finish();
  }
  EXPECT_EQ(base::allocation_count(), before);
}

}  // namespace
}  // namespace mlab::flow
