#include "mlab/flow/program.h"

#include <algorithm>
#include <cstring>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/testing/count_allocations.h"
#include "mlab/flow/testing/behaviors.h"

namespace mlab::flow {
namespace {

using namespace mlab::flow::test;

Network chain_network() {
  Network network;
  network.parameters.push_back({"gain", "double", "", "", {}, constant("2"), 0.0, 10.0, {}});
  network.nodes.push_back(node("sink", "Show", {{"value", name("total")}}));  // uses what comes later
  network.nodes.push_back(node("total", "Add", {{"a", name("counted")}, {"b", name("gain")}}));
  network.nodes.push_back(node("counted", "Count", {{"start", constant("10")}}));
  return network;
}

TEST(Program, RunsEveryNodeAfterItsSourcesInTheSameCycle) {
  Runner run(chain_network());
  ASSERT_TRUE(run.program);
  run.step();
  EXPECT_DOUBLE_EQ(run.action.velocity.x, 11.0 + 2.0);
  run.step();
  EXPECT_DOUBLE_EQ(run.action.velocity.x, 12.0 + 2.0);
  EXPECT_EQ(Program::cycle(run.frame.data()), 2U);
}

TEST(Program, ReadsAndSetsPortsByTheirPath) {
  Runner run(chain_network());
  run.step();
  EXPECT_DOUBLE_EQ(run.number("counted"), 11.0);
  EXPECT_DOUBLE_EQ(run.number("gain"), 2.0);
  EXPECT_DOUBLE_EQ(run.number("counted.start"), 10.0);
  EXPECT_EQ(run.program->find("nobody"), nullptr);
  EXPECT_EQ(run.program->set(run.frame.data(), *run.program->find("gain"), "5"), std::nullopt);
  run.step();
  EXPECT_DOUBLE_EQ(run.action.velocity.x, 12.0 + 5.0);
}

TEST(Program, RefusesAValueThatIsOutOfRangeOrOfTheWrongType) {
  Runner run(chain_network());
  const Port& gain = *run.program->find("gain");
  EXPECT_EQ(run.program->set(run.frame.data(), gain, "11"), "11 is out of range: `gain` takes 0 .. 10");
  EXPECT_EQ(run.program->set(run.frame.data(), gain, "fast"),
            "`fast` is no number: `gain` takes a number, 0 .. 10");
  EXPECT_TRUE(run.program->set(run.frame.data(), gain, "nan"));
  EXPECT_TRUE(run.program->set(run.frame.data(), *run.program->find("total"), "1"));
  EXPECT_DOUBLE_EQ(run.number("gain"), 2.0);
}

TEST(Program, ACopyOfTheFrameIsACheckpoint) {
  Runner run(chain_network());
  for (int i = 0; i < 5; ++i) run.step();
  const Frame checkpoint = run.frame;
  run.step();
  run.step();
  const double later = run.action.velocity.x;
  run.frame = checkpoint;
  run.step();
  run.step();
  EXPECT_DOUBLE_EQ(run.action.velocity.x, later);
}

TEST(Program, UsesNoHeapInTheCycle) {
  Runner run(chain_network());
  run.step();
  const std::size_t before = base::allocation_count();
  for (int i = 0; i < 100; ++i) run.step();
  EXPECT_EQ(base::allocation_count(), before);
}

TEST(Program, GivesASharedCallNoPlaceOfItsOwnForItsFirstValue) {
  static Behavior sum = add();
  sum.name = "AddFromSeven";
  sum.write_initial_output = [](void* out) { *static_cast<double*>(out) = 7.0; };
  Library own = library();
  own.add(std::vector<const Behavior*>{&sum});
  Network network;
  network.parameters.push_back({"p", "double", "", "", {}, constant("1"), -kNoLimit, kNoLimit, {}});
  network.nodes.push_back(node("a", "AddFromSeven", {{"a", name("p")}, {"b", name("p")}}));
  network.nodes.push_back(node("b", "AddFromSeven", {{"a", name("p")}, {"b", name("p")}}));
  network.nodes.push_back(node("both", "Sum", {{"values", name("a")}, {"values", name("b")}}));
  network.nodes.push_back(node("sink", "Show", {{"value", name("both")}}));
  text::Diagnostics sink;
  const auto program = build_program(network, own, sink);
  ASSERT_TRUE(program) << text::render(sink);
  const std::byte* const frame = program->initial_frame().data();
  EXPECT_EQ(Program::number(frame, *program->find("p")), 1.0);
  EXPECT_EQ(Program::number(frame, *program->find("a")), 7.0);
}

TEST(Program, SharesAPureCallOnlyWhenItsInputsAreTheSameSources) {
  Network network;
  network.parameters.push_back({"p", "double", "", "", {}, constant("1"), -kNoLimit, kNoLimit, {}});
  network.nodes.push_back(node("c", "Count"));
  network.nodes.push_back(node("a", "Add", {{"a", name("c")}, {"b", name("p")}}));
  network.nodes.push_back(node("b", "Add", {{"a", name("c")}, {"b", name("p")}}));
  network.nodes.push_back(node("k1", "Add", {{"a", name("c")}, {"b", constant("1")}}));
  network.nodes.push_back(node("k2", "Add", {{"a", name("c")}, {"b", constant("1")}}));
  network.nodes.push_back(
      node("all", "Sum",
           {{"values", name("a")}, {"values", name("b")}, {"values", name("k1")}, {"values", name("k2")}}));
  network.nodes.push_back(node("sink", "Show", {{"value", name("all")}}));
  Runner run(network);
  run.step();
  EXPECT_DOUBLE_EQ(run.action.velocity.x, 4 * 2.0);
  EXPECT_EQ(run.program->find("a")->offset, run.program->find("b")->offset);
  EXPECT_NE(run.program->find("k1")->offset, run.program->find("k2")->offset)
      << "equal constants are different sliders";
  run.program->set(run.frame.data(), *run.program->find("k2.b"), "100");
  run.step();
  EXPECT_DOUBLE_EQ(run.action.velocity.x, 3 * 3.0 + 102.0);
}

TEST(Program, ConvertsDegreesOfAHistoricNameToRadians) {
  Network network;
  network.nodes.push_back(node("h", "HEADING", {{"angle_degrees", constant("90")}}));
  network.nodes.push_back(
      node("again", "HEADING", {{"angle_d", name("h")}}));  // degrees to degrees: nothing to do
  network.nodes.push_back(node("native", "Heading", {{"angle", name("h")}}));  // radians inside all the time
  network.nodes.push_back(
      node("plain", "Add", {{"a", name("h")}}));  // says no unit: gets what the author of `h` sees
  network.nodes.push_back(node("s1", "Show", {{"value", name("plain")}}));
  for (const char* n : {"again", "native"})
    network.nodes.push_back(node(std::string("s") + n, "Show", {{"value", name(n)}}));
  Runner run(network);
  ASSERT_TRUE(run.program) << text::render(run.sink);
  run.step();
  EXPECT_DOUBLE_EQ(run.number("h"), std::numbers::pi / 2.0);
  EXPECT_DOUBLE_EQ(run.number("again"), std::numbers::pi / 2.0);
  EXPECT_DOUBLE_EQ(run.number("native"), std::numbers::pi / 2.0);
  EXPECT_DOUBLE_EQ(run.number("plain"), 90.0);
  EXPECT_EQ(Program::print(run.frame.data(), *run.program->find("h.angle_degrees")), "90");
}

TEST(Program, ADelayPutsOutTheValueOfTheCycleBefore) {
  Network network;
  Node delay = node("before", "double", {{"value", name("next")}, {"initial", constant("5")}});
  delay.kind = Node::Kind::kDelay;
  network.nodes.push_back(delay);
  network.nodes.push_back(
      node("next", "Add", {{"a", name("before")}, {"b", constant("1")}}));  // a loop through the delay
  network.nodes.push_back(node("sink", "Show", {{"value", name("before")}}));
  Runner run(network);
  ASSERT_TRUE(run.program) << text::render(run.sink);
  for (const double expected : {5.0, 6.0, 7.0}) {
    run.step();
    EXPECT_DOUBLE_EQ(run.action.velocity.x, expected);
  }
}

TEST(Program, ANodeThatNobodyUsesNeverRuns) {
  Network network;
  network.nodes.push_back(node("idle", "Count"));
  network.nodes.push_back(node("watched", "Count"));
  network.nodes.back().is_public = true;
  network.nodes.push_back(node("c", "Count"));
  network.nodes.push_back(node("sink", "Show", {{"value", name("c")}}));
  Runner run(network);
  run.step();
  EXPECT_DOUBLE_EQ(run.number("idle"), 0.0);
  EXPECT_DOUBLE_EQ(run.number("watched"), 1.0);
}

TEST(Program, SaysWhatEachValueIsMadeFrom) {
  Runner run(chain_network());
  const auto offset = [&](const char* path) { return run.program->find(path)->offset; };
  const std::vector<NodeWires>& wires = run.program->wires();
  const auto total = std::ranges::find(wires, offset("total"), &NodeWires::output);
  ASSERT_NE(total, wires.end());
  EXPECT_EQ(total->behavior->name, "Add");
  ASSERT_EQ(total->sources.size(), 2U);
  EXPECT_EQ(total->sources[1], offset("gain"));
  // A whole number goes through a conversion.
  const auto converted = std::ranges::find(wires, total->sources[0], &NodeWires::output);
  ASSERT_NE(converted, wires.end());
  EXPECT_EQ(converted->sources, std::vector{offset("counted")});
  const auto counted = std::ranges::find(wires, offset("counted"), &NodeWires::output);
  ASSERT_NE(counted, wires.end());
  EXPECT_EQ(counted->sources, std::vector{offset("counted.start")});
}

TEST(Program, FindsThePortThatWentWrongFirst) {
  Network network;
  network.nodes.push_back(node("big", "Add", {{"a", constant("1e308")}, {"b", constant("1e308")}}));
  network.nodes.push_back(node("worse", "Add", {{"a", name("big")}}));
  network.nodes.push_back(node("sink", "Show", {{"value", name("worse")}}));
  // 2e308 overflows; the range of the inputs alone does not keep it out.
  network.nodes[0].links[0].source.text = "1e300";
  network.nodes[0].links[1].source.text = "1e300";
  Runner run(network);
  run.step();
  EXPECT_EQ(run.program->find_fault(run.frame.data()), nullptr);
  const double huge = 1.7e308;
  std::memcpy(run.frame.data() + run.program->find("big.a")->offset, &huge, sizeof huge);
  std::memcpy(run.frame.data() + run.program->find("big.b")->offset, &huge, sizeof huge);
  run.step();
  ASSERT_NE(run.program->find_fault(run.frame.data()), nullptr);
  EXPECT_EQ(run.program->find_fault(run.frame.data())->path, "big");
}

TEST(Program, AChainOfTenThousandNodesBuildsAndRuns) {
  Network network;
  network.nodes.push_back(node("n0", "Count"));
  for (int i = 1; i <= 10'000; ++i) {
    network.nodes.push_back(node("n" + std::to_string(i), "Add",
                                 {{"a", name("n" + std::to_string(i - 1))}, {"b", constant("1")}}));
  }
  network.nodes.push_back(node("sink", "Show", {{"value", name("n10000")}}));
  Runner run(network);
  ASSERT_TRUE(run.program);
  run.step();
  EXPECT_DOUBLE_EQ(run.action.velocity.x, 10'001.0);
}

}  // namespace
}  // namespace mlab::flow
