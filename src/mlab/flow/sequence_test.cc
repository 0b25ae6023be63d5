#include <gtest/gtest.h>

#include "mlab/flow/testing/behaviors.h"

namespace mlab::flow {
namespace {

using namespace mlab::flow::test;

State state(std::string state_name, std::string member, std::vector<Transition> transitions,
            bool is_start = false) {
  return {std::move(state_name), name(std::move(member)), std::move(transitions), is_start, false, {}};
}
Transition go(std::string trigger, std::string target, bool restarts = false) {
  return {name(std::move(trigger)), false, std::move(target), restarts, {}};
}

// Two members that count, two triggers that count: t0 true in its third firing, t1 in its second.
Network two_states() {
  Network network;
  network.nodes.push_back(node("a", "Count"));
  network.nodes.push_back(node("b", "Count", {{"start", constant("50")}}));
  network.nodes.push_back(node("t0", "After", {{"at", constant("3")}}));
  network.nodes.push_back(node("t1", "After", {{"at", constant("2")}}));
  Node sequence = node("job", "int");
  sequence.kind = Node::Kind::kSequence;
  sequence.states = {state("A", "a", {go("t0", "B")}, true), state("B", "b", {go("t1", "A")})};
  network.nodes.push_back(sequence);
  network.nodes.push_back(node("sink", "Show", {{"value", name("job")}}));
  return network;
}

TEST(Sequence, MakesATransitionAndRunsTheNewMemberInTheSameCycle) {
  Runner run(two_states());
  ASSERT_TRUE(run.program) << text::render(run.sink);
  std::vector<double> seen;
  for (int i = 0; i < 8; ++i) {
    run.step();
    seen.push_back(run.action.velocity.x);
  }
  // Cycle 3: t0 fires the third time, B's member starts at once. Cycle 5: t1's second firing, back to A,
  // which restarts.
  EXPECT_EQ(seen, (std::vector<double>{1, 2, 51, 52, 1, 2, 3, 51}));
}

TEST(Sequence, TellsItsActiveState) {
  Runner run(two_states());
  run.step();
  EXPECT_EQ(run.program->active_states(run.frame.data()), (std::vector<std::string>{"job.A"}));
  run.step();
  run.step();
  EXPECT_EQ(run.program->active_states(run.frame.data()), (std::vector<std::string>{"job.B"}));
}

TEST(Sequence, TellsTheWaysOutOfItsState) {
  Runner run(two_states());
  EXPECT_TRUE(run.program->ways_out(run.frame.data()).empty()) << "nothing has run";
  run.step();
  const std::uint64_t key = run.program->states_key(run.frame.data());
  const auto ways = run.program->ways_out(run.frame.data());
  ASSERT_EQ(ways.size(), 1U);
  EXPECT_EQ(ways[0].sequence, "job");
  EXPECT_EQ(ways[0].state, "A");
  EXPECT_EQ(ways[0].trigger, "t0");
  EXPECT_EQ(ways[0].target, "B");
  EXPECT_FALSE(ways[0].trigger_value);
  run.step();
  EXPECT_EQ(run.program->states_key(run.frame.data()), key);
  run.step();
  EXPECT_NE(run.program->states_key(run.frame.data()), key);
}

TEST(Sequence, AMemberThatBothStatesNeedGoesOn) {
  Network network = two_states();
  network.nodes[4].states[1].member = name("a");
  network.nodes.erase(network.nodes.begin() + 1);
  Runner run(network);
  ASSERT_TRUE(run.program) << text::render(run.sink);
  for (const double expected : {1.0, 2.0, 3.0, 4.0, 5.0}) {
    run.step();
    EXPECT_DOUBLE_EQ(run.action.velocity.x, expected);
  }
}

TEST(Sequence, ATransitionToTheSameStateRestartsOnlyIfItSaysSo) {
  for (const bool restarts : {false, true}) {
    Network network;
    network.nodes.push_back(node("a", "Count"));
    network.nodes.push_back(node("t", "After", {{"at", constant("3")}}));
    Node sequence = node("job", "int");
    sequence.kind = Node::Kind::kSequence;
    sequence.states = {state("A", "a", {go("t", "A", restarts)}, true)};
    network.nodes.push_back(sequence);
    network.nodes.push_back(node("sink", "Show", {{"value", name("job")}}));
    Runner run(network);
    ASSERT_TRUE(run.program);
    run.step();
    run.step();
    run.step();
    EXPECT_DOUBLE_EQ(run.action.velocity.x, restarts ? 1.0 : 3.0);
  }
}

TEST(Sequence, ARestartReachesWhatRunsInsideOfWhatItRestarts) {
  const auto nested = [](const char* own, const char* member, std::vector<Transition> ways) {
    Node sequence = node(own, "int");
    sequence.kind = Node::Kind::kSequence;
    sequence.states = {state("A", member, std::move(ways), true)};
    return sequence;
  };
  Network network;
  network.nodes.push_back(node("a", "Count"));
  network.nodes.push_back(node("t", "After", {{"at", constant("3")}}));
  network.nodes.push_back(nested("inner", "a", {}));
  network.nodes.push_back(nested("middle", "inner", {}));
  network.nodes.push_back(nested("job", "middle", {go("t", "A", true)}));
  network.nodes.push_back(node("sink", "Show", {{"value", name("job")}}));
  Runner run(network);
  ASSERT_TRUE(run.program) << text::render(run.sink);
  for (const double expected : {1.0, 2.0, 1.0, 1.0}) {
    run.step();
    EXPECT_DOUBLE_EQ(run.action.velocity.x, expected);
  }
}

TEST(Sequence, ANodeSharedByTwoConsumersFiresOnce) {
  Network network = two_states();
  network.nodes.push_back(node("also", "Show", {{"value", name("a")}}));  // needs `a` in every cycle
  Runner run(network);
  ASSERT_TRUE(run.program);
  for (const double expected : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}) {
    run.step();
    EXPECT_DOUBLE_EQ(run.number("a"), expected) << "fires once a cycle, never restarts";
  }
}

TEST(Sequence, ANestedOneRestartsAtItsStartWhenItBecomesNeededAgain) {
  Network network = two_states();
  network.nodes.pop_back();
  network.nodes.push_back(node("rest", "Count", {{"start", constant("-100")}}));
  network.nodes.push_back(node("o0", "After", {{"at", constant("4")}}));
  network.nodes.push_back(node("o1", "After", {{"at", constant("2")}}));
  Node outer = node("outer", "int");
  outer.kind = Node::Kind::kSequence;
  outer.states = {state("Work", "job", {go("o0", "Rest")}, true), state("Rest", "rest", {go("o1", "Work")})};
  network.nodes.push_back(outer);
  network.nodes.push_back(node("sink", "Show", {{"value", name("outer")}}));
  Runner run(network);
  ASSERT_TRUE(run.program) << text::render(run.sink);
  std::vector<double> seen;
  for (int i = 0; i < 8; ++i) {
    run.step();
    seen.push_back(run.action.velocity.x);
  }
  // Cycle 4: o0 fires the fourth time. Cycle 5 is o1's first firing, cycle 6 its second: back to Work, from
  // its start.
  EXPECT_EQ(seen, (std::vector<double>{1, 2, 51, -99, -98, 1, 2, 51}));
}

TEST(Select, RunsOnlyTheChosenMember) {
  Network network;
  network.parameters.push_back({"which", "int", "", "", {}, constant("0"), 0, 9, {}});
  network.nodes.push_back(node("a", "Count"));
  network.nodes.push_back(node("b", "Count", {{"start", constant("50")}}));
  Node select = node("chosen", "int");
  select.kind = Node::Kind::kSelect;
  select.selector = name("which");
  select.cases = {{{0, 1}, name("a"), {}}, {{2}, name("b"), {}}};
  network.nodes.push_back(select);
  network.nodes.push_back(node("sink", "Show", {{"value", name("chosen")}}));
  Runner run(network);
  ASSERT_TRUE(run.program) << text::render(run.sink);
  run.step();
  run.step();
  EXPECT_DOUBLE_EQ(run.action.velocity.x, 2.0);
  EXPECT_DOUBLE_EQ(run.number("b"), 0.0);
  run.program->set(run.frame.data(), *run.program->find("which"), "2");
  run.step();
  EXPECT_DOUBLE_EQ(run.action.velocity.x, 51.0);
  run.program->set(run.frame.data(), *run.program->find("which"), "7");
  run.step();
  EXPECT_DOUBLE_EQ(run.action.velocity.x, 0.0) << "no case holds 7, and there is no otherwise";
  run.program->set(run.frame.data(), *run.program->find("which"), "1");
  run.step();
  EXPECT_DOUBLE_EQ(run.action.velocity.x, 1.0) << "restarted after the pause";
}

TEST(Select, KnowsEveryValueSmallLargeOrBelowZero) {
  Network network;
  network.parameters.push_back({"which", "int", "", "", {}, constant("0"), -1e6, 1e6, {}});
  Node select = node("chosen", "int");
  select.kind = Node::Kind::kSelect;
  select.selector = name("which");
  const std::vector<std::int64_t> values = {-5, 3, 255, 256, 100'000};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string member = "m" + std::to_string(i);
    network.nodes.push_back(node(member, "Count", {{"start", constant(std::to_string(10 * (i + 1)))}}));
    select.cases.push_back({{values[i]}, name(member), {}});
  }
  network.nodes.push_back(node("other", "Count", {{"start", constant("90")}}));
  select.cases.push_back({{}, name("other"), {}});
  network.nodes.push_back(select);
  network.nodes.push_back(node("sink", "Show", {{"value", name("chosen")}}));
  Runner run(network);
  ASSERT_TRUE(run.program) << text::render(run.sink);
  const auto chosen = [&](std::int64_t value) {
    run.program->set(run.frame.data(), *run.program->find("which"), std::to_string(value));
    run.step();
    return run.action.velocity.x;
  };
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_EQ(chosen(values[i]), 10.0 * static_cast<double>(i + 1) + 1.0) << values[i];
  for (const std::int64_t none : {-6, 0, 4, 254, 257, 99'999}) EXPECT_GT(chosen(none), 90.0) << none;
}

// The outer ones go on where the inner ones end, however many are open at once.
TEST(Select, AHundredDeepBuildsAndRuns) {
  Network network;
  network.parameters.push_back({"which", "int", "", "", {}, constant("0"), 0, 200, {}});
  network.nodes.push_back(node("s0", "Count"));
  network.nodes.push_back(node("other", "Count", {{"start", constant("50")}}));
  for (int i = 1; i <= 100; ++i) {
    Node select = node("s" + std::to_string(i), "int");
    select.kind = Node::Kind::kSelect;
    select.selector = name("which");
    select.cases = {{{i}, name("other"), {}}, {{}, name("s" + std::to_string(i - 1)), {}}};
    network.nodes.push_back(select);
  }
  network.nodes.push_back(node("sink", "Show", {{"value", name("s100")}}));
  Runner run(network);
  ASSERT_TRUE(run.program) << text::render(run.sink);
  run.step();
  run.step();
  EXPECT_DOUBLE_EQ(run.action.velocity.x, 2.0);
  EXPECT_DOUBLE_EQ(run.number("s17"), 2.0);
  run.program->set(run.frame.data(), *run.program->find("which"), "40");
  run.step();
  EXPECT_DOUBLE_EQ(run.action.velocity.x, 51.0);
  EXPECT_DOUBLE_EQ(run.number("s39"), 2.0) << "not evaluated";
}

TEST(Sequence, AHundredDeepBuildsAndRuns) {
  Network network;
  network.nodes.push_back(node("s0", "Count"));
  network.nodes.push_back(node("never", "After", {{"at", constant("1000")}}));
  for (int i = 1; i <= 100; ++i) {
    Node sequence = node("s" + std::to_string(i), "int");
    sequence.kind = Node::Kind::kSequence;
    const std::string inner = "s" + std::to_string(i - 1);
    sequence.states = {state("On", inner, {go("never", "Off")}, true),
                       state("Off", inner, {go("never", "On")})};
    network.nodes.push_back(sequence);
  }
  network.nodes.push_back(node("sink", "Show", {{"value", name("s100")}}));
  Runner run(network);
  ASSERT_TRUE(run.program);
  EXPECT_LT(run.program->instruction_count(), 1000U) << "each sequence is laid out once";
  run.step();
  run.step();
  EXPECT_DOUBLE_EQ(run.action.velocity.x, 2.0);
}

TEST(Select, NeedsWhatItsCasesNeedInTheStatesInWhichTheyAre) {
  Network network;
  network.nodes.push_back(node("far", "Look", {{"range", constant("4")}}));
  network.nodes.push_back(node("near", "Look", {{"range", constant("3")}}));
  network.nodes.push_back(node("t", "After", {{"at", constant("2")}}));
  Node sequence = node("job", "int");
  sequence.kind = Node::Kind::kSequence;
  sequence.states = {state("Far", "far", {go("t", "Near")}, true), state("Near", "near", {})};
  network.nodes.push_back(sequence);
  network.nodes.push_back(node("other", "Look", {{"range", constant("2")}}));
  Node select = node("which", "int");
  select.kind = Node::Kind::kSelect;
  select.selector = name("which_case");
  select.cases = {{{0}, name("job"), {}}, {{}, name("other"), {}}};
  network.parameters.push_back({"which_case", "int", "", "", {}, constant("0"), 0, 9, {}});
  network.nodes.push_back(select);
  network.nodes.push_back(node("sink", "Show", {{"value", name("which")}}));
  Runner run(network);
  ASSERT_TRUE(run.program) << text::render(run.sink);
  const auto reach = [&] { return run.program->needs(run.frame.data())[percept::Sensor::kObstacles]; };
  EXPECT_EQ(reach(), 4.0);
  run.step();
  EXPECT_EQ(reach(), 4.0) << "still in the same state";
  run.step();
  EXPECT_EQ(reach(), 3.0) << "it is near now";
  ASSERT_FALSE(run.program->set(run.frame.data(), *run.program->find("other.range"), "9"));
  EXPECT_EQ(reach(), 9.0) << "the selector may choose the other case";
}

// What the case `which` gives is kept for the next cycle and comes back into that case.
TEST(Select, ALoopMayLeadThroughACaseAndADelay) {
  for (const bool is_nested : {false, true}) {
    Network network;
    network.parameters.push_back({"which", "int", "", "", {}, constant("0"), 0, 9, {}});
    Node delay = node("before", "double", {{"value", name("next")}, {"initial", constant("5")}});
    delay.kind = Node::Kind::kDelay;
    network.nodes.push_back(delay);
    network.nodes.push_back(node("one_more", "Add", {{"a", name("before")}, {"b", constant("1")}}));
    network.nodes.push_back(node("ten_more", "Add", {{"a", name("before")}, {"b", constant("10")}}));
    Node inner = node("inner", "double");
    inner.kind = Node::Kind::kSelect;
    inner.selector = name("which");
    inner.cases = {{{0}, name("one_more"), {}}, {{}, name("ten_more"), {}}};
    network.nodes.push_back(inner);
    Node outer = node("outer", "double");
    outer.kind = Node::Kind::kSelect;
    outer.selector = name("which");
    outer.cases = {{{0, 1}, name("inner"), {}}, {{}, name("before"), {}}};
    if (is_nested) network.nodes.push_back(outer);
    network.nodes.push_back(
        node("next", "Add", {{"a", name(is_nested ? "outer" : "inner")}, {"b", constant("100")}}));
    network.nodes.push_back(node("sink", "Show", {{"value", name("next")}}));
    Runner run(network);
    ASSERT_TRUE(run.program) << text::render(run.sink);
    const auto expect = [&](double expected) {
      run.step();
      EXPECT_DOUBLE_EQ(run.action.velocity.x, expected) << is_nested;
    };
    expect(106);
    expect(207);
    run.program->set(run.frame.data(), *run.program->find("which"), "1");
    expect(317);
    run.program->set(run.frame.data(), *run.program->find("which"), "2");
    expect(is_nested ? 417 : 427);
    EXPECT_EQ(run.program->needs(run.frame.data())[percept::Sensor::kObstacles], 0.0);
  }
}

}  // namespace
}  // namespace mlab::flow
