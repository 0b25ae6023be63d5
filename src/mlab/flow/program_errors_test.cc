#include <gtest/gtest.h>

#include "mlab/flow/testing/behaviors.h"

namespace mlab::flow {
namespace {

using namespace mlab::flow::test;

// `kind: message` of everything that building says, one a line.
std::string said_of(const Network& network) {
  text::Diagnostics sink;
  const auto program = build_program(network, library(), sink);
  std::string out;
  for (const text::Diagnostic& d : sink.items()) {
    out += d.kind + ": " + d.message + (d.hints.empty() ? "" : " (" + d.hints.front() + ")") + "\n";
  }
  EXPECT_EQ(program == nullptr, sink.has_errors());
  return out;
}

Network with_sink(std::vector<Node> nodes, std::string shown) {
  Network network;
  network.nodes = std::move(nodes);
  network.nodes.push_back(node("sink", "Show", {{"value", name(std::move(shown))}}));
  return network;
}

TEST(BuildProgram, NamesABehaviorThatItDoesNotKnow) {
  EXPECT_EQ(said_of(with_sink({node("a", "Ad", {{"a", constant("1")}})}, "a")),
            "unknown-behavior: unknown behavior `Ad` (did you mean `Add`?)\n");
}

TEST(BuildProgram, NamesUnknownMissingAndDoubleInputs) {
  EXPECT_EQ(said_of(with_sink({node("a", "Add", {{"c", constant("1")}})}, "a")),
            "unknown-input: `Add` has no input `c` (its inputs are a, b)\n"
            "missing-input: input `a` of `a` is not linked (`a` takes a number)\n");
  EXPECT_EQ(said_of(with_sink({node("a", "Add", {{"a", constant("1")}, {"a", constant("2")}})}, "a")),
            "double-link: input `a` is linked twice\n");
}

TEST(BuildProgram, NamesAnUnknownSource) {
  EXPECT_EQ(said_of(with_sink({node("first", "Add", {{"a", name("frist")}})}, "first")),
            "unknown-source: unknown node or parameter `frist` (did you mean `first`?)\n");
}

TEST(BuildProgram, RefusesTypesThatDoNotAgree) {
  EXPECT_EQ(said_of(with_sink({node("t", "After"), node("a", "Add", {{"a", name("t")}})}, "a")),
            "wrong-type: a truth value is linked where a number is expected\n");
  EXPECT_EQ(said_of(with_sink({node("a", "Add", {{"a", constant("fast")}})}, "a")),
            "wrong-type: `fast` is no number\n");
  EXPECT_EQ(said_of(with_sink(
                {node("s", "Show", {{"value", constant("1")}}), node("a", "Add", {{"a", name("s")}})}, "a")),
            "sink-as-source: `s` has no output: Show is a sink\n");
}

TEST(BuildProgram, RefusesAConstantOutOfRange) {
  EXPECT_EQ(said_of(with_sink({node("c", "Count", {{"start", constant("101")}})}, "c")),
            "out-of-range: 101 is out of range\n");
}

TEST(BuildProgram, ShowsThePathOfALoop) {
  EXPECT_EQ(said_of(with_sink({node("a", "Add", {{"a", name("c")}}), node("b", "Add", {{"a", name("a")}}),
                               node("c", "Add", {{"a", name("b")}})},
                              "a")),
            "dataflow-loop: values run in a loop: b -> c -> a -> b (a `delay` on the way breaks it: what "
            "comes out is the value of the cycle before)\n");
  EXPECT_EQ(said_of(with_sink({node("a", "Add", {{"a", name("a")}})}, "a")).substr(0, 52),
            "dataflow-loop: values run in a loop: a -> a (a `dela");
}

TEST(BuildProgram, WarnsAboutWhatIsNeverEvaluated) {
  EXPECT_EQ(said_of(with_sink({node("idle", "Count"), node("c", "Count")}, "c")),
            "unused-node: node `idle` is never evaluated: nothing uses its output\n");
  Network no_sink;
  no_sink.nodes.push_back(node("c", "Count"));
  EXPECT_NE(said_of(no_sink).find("no-sink"), std::string::npos);
}

TEST(BuildProgram, WarnsAboutAListWithoutMembers) {
  EXPECT_EQ(said_of(with_sink({node("s", "Sum")}, "s")), "empty-list: list `values` of `s` has no members\n");
}

TEST(BuildProgram, RefusesTheSameNameTwice) {
  EXPECT_EQ(said_of(with_sink({node("c", "Count"), node("c", "Count")}, "c")),
            "duplicate-name: `c` is declared twice\n");
}

TEST(BuildProgram, ChecksTheStatesOfASequence) {
  Node sequence = node("job", "int");
  sequence.kind = Node::Kind::kSequence;
  sequence.states = {{"A", name("c"), {{name("t"), false, "Bee", false, {}}}, false, false, {}},
                     {"B", name("c"), {}, false, false, {}}};
  const std::string said = said_of(with_sink({node("c", "Count"), node("t", "After"), sequence}, "job"));
  EXPECT_NE(said.find("unknown-state: `job` has no state `Bee` (did you mean `B`?)"), std::string::npos)
      << said;
  EXPECT_NE(said.find("no-way-out: no transition leaves state `B`"), std::string::npos);
  EXPECT_NE(said.find("no-start-state: sequence `job` has no start state"), std::string::npos);
  EXPECT_NE(said.find("unreachable-state: no transition leads to state `B`"), std::string::npos);
}

}  // namespace
}  // namespace mlab::flow
