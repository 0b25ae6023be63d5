#include "mlab/lang/cnl/parser.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace mlab::cnl {
namespace {

struct Parsed {
  text::Diagnostics sink;
  Tree tree;
  explicit Parsed(std::string text) {
    tree = parse(std::make_shared<const text::Source>("a.cnl", std::move(text)), sink);
  }
  template <class Kind>
  const Kind& only() const {
    const auto all = items_of<Kind>(tree);
    EXPECT_EQ(all.size(), 1U) << text::render(sink);
    return *all.at(0);
  }
};

std::string text_of(const std::optional<Code>& code) {
  return code ? std::string(code->text()) : "no section";
}

TEST(ParseProcedure, ReadsTheDocumentationAboveIt) {
  const Parsed p(R"(/// not this

/// Pulls the robot to the goal.
/// Full strength.
/// @source Arkin 1989,
/// section IV
procedure Vector MoveToGoal with
  /// where to
  Vector [m] goal;
  double [m] radius = 5 in 0 .. 1e6;  ///< within this
                                      ///< it is reached
  list int several;  // no help
header
body
pend
)");
  const auto& procedure = p.only<Procedure>();
  EXPECT_EQ(procedure.help, "Pulls the robot to the goal. Full strength.");
  EXPECT_EQ(procedure.source, "Arkin 1989, section IV");
  ASSERT_EQ(procedure.inputs.size(), 3U);
  EXPECT_EQ(procedure.inputs[0].help, "where to");
  EXPECT_EQ(procedure.inputs[0].unit.text, "m");
  EXPECT_EQ(procedure.inputs[1].help, "within this it is reached");
  EXPECT_EQ(procedure.inputs[1].initial.value_or(flow::Source{}).text, "5");
  EXPECT_EQ(procedure.inputs[1].high, 1e6);
  EXPECT_TRUE(procedure.inputs[2].is_list);
  EXPECT_EQ(procedure.inputs[2].help, "");
}

TEST(ParseProcedure, ReadsAttributesInAnyOrder) {
  const Parsed p(R"(procedure double [rad] Turn
  alias TURN [deg] (angle [deg] = a, old = none)
  senses obstacles within 5
  latency 3
  alias OTHER
  senses ranges
with
  double [rad] a;
header
body
pend
)");
  const auto& procedure = p.only<Procedure>();
  EXPECT_EQ(p.sink.error_count(), 0U) << text::render(p.sink);
  EXPECT_EQ(procedure.output_unit.text, "rad");
  EXPECT_EQ(procedure.latency, 3);
  ASSERT_EQ(procedure.aliases.size(), 2U);
  EXPECT_EQ(procedure.aliases[0].output_unit.text, "deg");
  EXPECT_EQ(procedure.aliases[0].ports.at(0).unit.text, "deg");
  EXPECT_EQ(procedure.aliases[0].ports.at(1).input.text, "none");
  EXPECT_EQ(procedure.needs.size(), 2U);
}

TEST(ParseProcedure, SectionWordsCountOnlyAloneOnTheirLine) {
  const Parsed p(
      "procedure int A with int x; once int header = 1; // header\n"
      "\t header \t\r\n  body(x); pend\n  // body\nbody\r\n  header;\n\tpend\t\n");
  const auto& procedure = p.only<Procedure>();
  EXPECT_EQ(p.sink.items().size(), 0U) << text::render(p.sink);
  EXPECT_EQ(text_of(procedure.once), " int header = 1; // header\n");
  EXPECT_EQ(text_of(procedure.header), "  body(x); pend\n  // body\n");
  EXPECT_EQ(text_of(procedure.body), "  header;\n");
}

TEST(ParseProcedure, PlacesDoNotDriftBehindSections) {
  const Parsed p(
      "procedure int A with\nheader\nbody\npend\nprocedure int B with\nheader\nbody\npend\nwrong\n");
  ASSERT_EQ(p.sink.items().size(), 1U);
  const auto& place = p.sink.items()[0].place;
  EXPECT_EQ(place.source->line_column(place.span.begin).line, 9U);
}

TEST(ParseProcedure, WordsOfTheLanguageMayBeNames) {
  const Parsed p(
      "procedure int list with\n  int list;\n  int with;\n  list int node;\nheader\nbody\npend\n"
      "node parameter is list with\n  list = 1;\n  with = 2;\n  delay = 3;\n  node = 4;\nnend\n");
  EXPECT_EQ(p.sink.items().size(), 0U) << text::render(p.sink);
  EXPECT_EQ(p.only<Procedure>().inputs.size(), 3U);
  EXPECT_EQ(p.only<NodeDecl>().node.links.size(), 4U);
}

TEST(ParseNode, ReadsEveryKindOfSource) {
  const Parsed p(R"(public node a is $B-2 |what for| with
  n = 007;  n = (.5);  n = -2e3;  n = 5.;  c = 'c';  i = {1, {2}};  s = "Flag|Basket"; t = {"text"};
  e = {}; x = other-node; q = "a \" b";
nend
)");
  const auto& decl = p.only<NodeDecl>();
  EXPECT_EQ(p.sink.items().size(), 0U) << text::render(p.sink);
  EXPECT_TRUE(decl.is_public);
  EXPECT_EQ(decl.description, "what for");
  EXPECT_EQ(decl.node.behavior, "$B-2");
  std::string all;
  for (const auto& link : decl.node.links) {
    all += (link.source.kind == flow::Source::Kind::kName ? "@" : "") + link.source.text + ";";
  }
  EXPECT_EQ(all, "7;0.5;-2e3;5;99;{1, {2}};Flag|Basket;text;{};@other-node;a \\\" b;");
}

TEST(ParseNode, ReadsSequencesSelectsAndDelays) {
  const Parsed p(R"(sequence job of Vector with
  start state Searching is wander;
    when seen goto Acquiring;
    when not seen goto Searching restart;
  state Acquiring is acquire;
  final state Done is {0, 0};
nend
select active of Vector by task with
  case 2, -4, 'a': navigate;
  otherwise: rest;
nend
delay before of Vector with initial = {0, 0}; value = pull; nend
)");
  EXPECT_EQ(p.sink.items().size(), 0U) << text::render(p.sink);
  const auto nodes = items_of<NodeDecl>(p.tree);
  ASSERT_EQ(nodes.size(), 3U);
  const flow::Node& job = nodes[0]->node;
  ASSERT_EQ(job.states.size(), 3U);
  EXPECT_TRUE(job.states[0].is_start);
  EXPECT_TRUE(job.states[2].is_final);
  ASSERT_EQ(job.states[0].transitions.size(), 2U);
  EXPECT_TRUE(job.states[0].transitions[1].is_negated);
  EXPECT_TRUE(job.states[0].transitions[1].restarts);
  const flow::Node& active = nodes[1]->node;
  EXPECT_EQ(active.selector.text, "task");
  EXPECT_EQ(active.cases.at(0).values, (std::vector<std::int64_t>{2, -4, 97}));
  EXPECT_TRUE(active.cases.at(1).values.empty());
  EXPECT_EQ(nodes[2]->node.links.at(0).input, "value");
}

TEST(ParseParameter, ReadsUnitRangeAndHelp) {
  const Parsed p("/// above\nparameter double [m/s] base_velocity = 5 in 0..100;  ///< speed\n");
  const auto& parameter = p.only<ParameterDecl>().parameter;
  EXPECT_EQ(parameter.unit, "m/s");
  EXPECT_EQ(parameter.initial.text, "5");
  EXPECT_EQ(parameter.max, 100.0);
  EXPECT_EQ(parameter.help, "speed");
}

TEST(Parse, PassesOverAByteOrderMark) {
  const Parsed p("\xef\xbb\xbfnode a is A with nend\r\n");
  EXPECT_EQ(p.sink.items().size(), 0U) << text::render(p.sink);
  EXPECT_EQ(p.only<NodeDecl>().node.name, "a");
}

TEST(Parse, GoesOnBehindEveryError) {
  const Parsed p(
      "procedure int A with\n  int ;\n  int x;\nheader\nbody\npend\nnode a is with\nnode b is A with\n  x = "
      ";\n  x = 1;\nnend\n");
  EXPECT_GE(p.sink.error_count(), 3U);
  EXPECT_EQ(p.only<Procedure>().inputs.size(), 1U);
  EXPECT_EQ(p.only<NodeDecl>().node.links.size(), 1U);
}

}  // namespace
}  // namespace mlab::cnl
