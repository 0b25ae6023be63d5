#include "mlab/lang/cdl/formula/formula.h"

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/lang/cdl/formula/formula_term.h"
#include "mlab/lang/cdl/print/print.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/lang/cdl/testing/any_sentence.h"

namespace mlab::cdl {
namespace {

text::SourcePtr source(const std::string& text) {
  return std::make_shared<const text::Source>("a.formula", text);
}

Formula formula_of(Tree tree) {
  text::Diagnostics sink;
  const Configuration configuration =
      configuration_of(std::make_shared<const Tree>(std::move(tree)), {}, sink);
  Formula out = formula(configuration, flow::Library(), sink);
  EXPECT_FALSE(sink.has_errors()) << text::render(sink);
  return out;
}

std::string sentence_of(const std::string& cdl) {
  text::Diagnostics sink;
  std::string out;
  for (const std::string& sentence : formula_of(parse(source(cdl), sink)).sentences) out += sentence + "\n";
  EXPECT_FALSE(sink.has_errors()) << text::render(sink);
  return out;
}

std::string said_of_sentence(const std::string& sentence) {
  text::Diagnostics sink;
  parse_formula(source(sentence), sink);
  return text::render(sink);
}

std::string rewritten(const std::string& sentence) {
  text::Diagnostics sink;
  const Formula out = formula_of(parse_formula(source(sentence), sink));
  EXPECT_FALSE(sink.has_errors()) << text::render(sink);
  std::string text;
  for (const std::string& one : out.sentences) text += (text.empty() ? "" : "\n") + one;
  return text;
}

// Motor schemas and percepts of the examples; without a body they are processes.
constexpr const char* kDeclarations = R"(
assemblage Noise() -> Vector;
assemblage Avoid(readings: Obstacles) -> Vector;
assemblage GoTo(place: double, near: Obstacles) -> Vector;
assemblage Far(near: Obstacles) -> bool;
assemblage Turn(to: double) -> Vector;
binding obstacles() -> Obstacles;
binding target() -> double;
)";

TEST(Formula, WritesEveryOperatorOfTheGrammar) {
  EXPECT_EQ(sentence_of(std::string(kDeclarations) + R"(
assemblage Wander() {
  let near = obstacles();
  cooperate {
    Noise();
    Avoid(near);
  }
}
robot Scout {
  movement = sequence {
    start A: Wander();
      when Far(obstacles()) goto B;
    B: compete by priority {
      GoTo(target(), obstacles());
      Avoid(fuse by Nearest() { obstacles(); obstacles(); }) active Turn(target());
    };
      when Far(obstacles()) goto A;
  };
  camera = Turn(target());
}
robot Tug { movement = cooperate { 2: Noise(); }; }
society Team: team of 2 Tug;
society All: caste { Scout; Team; };
)"),
            "'/1 {[@1 [%1 [+1 <p0 m1> <p1 m2>] [-1 <(#1 p2 p3) m3> <a1 (#2 (#3 p4 p5) p6) m4>]] <p7 m5>]} "
            "'*1 {<p0 m6>} {<p0 m6>}''\n");
}

TEST(Formula, GivesANodeWithSeveralReadersOneNumber) {
  EXPECT_EQ(
      sentence_of(
          std::string(kDeclarations) +
          "robot R { let near = obstacles(); movement = cooperate { Avoid(near); GoTo(target(), near); }; }"),
      "{[+1 <p1 m1> <(#1 p2 p1) m2>]}\n");
}

TEST(Formula, SaysWhatItsNamesStandFor) {
  text::Diagnostics sink;
  const Tree tree =
      parse(source(std::string(kDeclarations) + "assemblage Drift() { cooperate { Noise(); "
                                                "Avoid(obstacles()); } } robot R { movement = Drift(); }"),
            sink);
  EXPECT_EQ(print(formula_of(tree)),
            "{[+1 <p0 m1> <p1 m2>]}\n"
            "\n"
            "// +1  cooperate, in Drift\n"
            "// m1  Noise, in Drift\n"
            "// p1  obstacles, in Drift\n"
            "// m2  Avoid, in Drift\n");
}

TEST(Formula, ReadsWhatItWrites) {
  for (const char* sentence :
       {"{<p1 m1>}", "{<p0 m1>}", "{<p0>}", "{<p4>}", "{<a2 p1>}", "{<a1 (=1 p1 p2) m7>}",
        "{[+2 <p1 m1> <p1 m2> [-3 <p2 m3> [%1 <p0 m4> <(#1 p1 p1 (=2 p3 p0)) m5>] [@9 <p1> <a1 p1>]]]}",
        "'/1 {<p1 m1>} '*2 {<p3 m2>} {<p3 m2>}''", "'/1 {<p1 m1>} {<p1 m1>}'", "{[+1 <p1 m1> <p1 m1>]}",
        "{<p1 m1>}\n'*1 {<p2 m2>} {<p2 m2>}'"}) {
    EXPECT_EQ(rewritten(sentence), sentence);
  }
}

TEST(Formula, ReadsTheSignsOfTheReport) {
  EXPECT_EQ(rewritten("‘*_1 {⟨p_1 m_1⟩}\n{⟨p_1 m_1⟩}’ // two of them"), "'*1 {<p1 m1>} {<p1 m1>}'");
}

TEST(Formula, ItsTreeIsAConfigurationInText) {
  text::Diagnostics sink;
  const Tree tree = parse_formula(source("'*1 {[%1 <p1 m1> <p1 m2>]} {[%1 <p1 m1> <p1 m2>]}'"), sink);
  const std::string text = print(tree);
  EXPECT_EQ(print(parse(source(text), sink)), text);
  EXPECT_EQ(sentence_of(text), "'*1 {[%1 <p1 m1> <p1 m2>]} {[%1 <p1 m1> <p1 m2>]}'\n");
  EXPECT_FALSE(sink.has_errors()) << text::render(sink);
}

TEST(Formula, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(said_of_sentence("{[+1 <p1 m1> <p2 m2>}"),
            "a.formula:1:21: error: expected an assemblage `[...]`, a behavior `<...>` or `]`, found `}` "
            "[formula-syntax]\n"
            "    1 | {[+1 <p1 m1> <p2 m2>}\n"
            "      |                     ^\n"
            "a.formula:1:2: note: a cooperation opens here\n");
  EXPECT_EQ(said_of_sentence("{<m1>}"),
            "a.formula:1:3: error: a motor process without perception [formula-syntax]\n"
            "    1 | {<m1>}\n"
            "      |   ^\n"
            "      = hint: `p0` is the empty percept: `<p0 m1>`\n");
  EXPECT_EQ(said_of_sentence("{<p1 p2 m1>}"),
            "a.formula:1:6: error: expected a motor process `m1` or `>`, found `p2` [formula-syntax]\n"
            "    1 | {<p1 p2 m1>}\n"
            "      |      ^\n"
            "      = hint: several percepts are a fusion: `(#1 p1 p2)`\n"
            "a.formula:1:2: note: the behavior opens here\n");
  EXPECT_EQ(said_of_sentence("{[+1 <p1 m1>]}"),
            "a.formula:1:2: error: `+1` has one member [too-few-members]\n"
            "    1 | {[+1 <p1 m1>]}\n"
            "      |  ^^^^^^^^^^^^\n"
            "      = hint: a cooperation is of two or more; one alone stands without it\n");
  EXPECT_EQ(
      said_of_sentence("{[+1 <p1 m1> <p2 m1>]}"),
      "a.formula:1:14: error: `m1` stands for two different things [two-meanings]\n"
      "    1 | {[+1 <p1 m1> <p2 m1>]}\n"
      "      |              ^^^^^^^\n"
      "      = hint: an instance may be used several times, each time alike; another one has another number\n"
      "a.formula:1:6: note: it stands there first\n");
  EXPECT_EQ(said_of_sentence("'/1 {<p1 m1>} {<p1 m2>}'"),
            "a.formula:1:17: error: `p1` is an instance of another robot [instance-of-another-robot]\n"
            "    1 | '/1 {<p1 m1>} {<p1 m2>}'\n"
            "      |                 ^^\n"
            "      = hint: robots share no instances: give this one a number of its own\n"
            "a.formula:1:7: note: it stands there first\n");
  EXPECT_EQ(said_of_sentence("'*1 {<p1 m1>} {<p2 m2>}'"),
            "a.formula:1:15: error: the members of team `*1` differ [unlike-team]\n"
            "    1 | '*1 {<p1 m1>} {<p2 m2>}'\n"
            "      |               ^^^^^^^^^ this is not like the first\n"
            "      = hint: a caste, `'/1 ...'`, is of different ones\n"
            "a.formula:1:5: note: the first is here\n");
  EXPECT_EQ(said_of_sentence("{<p m1>}"),
            "a.formula:1:3: error: `p` has no number [formula-syntax]\n"
            "    1 | {<p m1>}\n"
            "      |   ^\n"
            "      = hint: each instance has one: `p1`\n");
  EXPECT_EQ(said_of_sentence("{<p1 m0>}"),
            "a.formula:1:6: error: `0` is no number of an instance [number-out-of-range]\n"
            "    1 | {<p1 m0>}\n"
            "      |      ^^ they are counted from 1 to 999999999\n");
  EXPECT_EQ(said_of_sentence(""),
            "a.formula:1:1: error: expected a society `'...'` or a robot `{...}`, found the end of the text "
            "[formula-syntax]\n"
            "    1 | \n"
            "      | ^\n");
}

TEST(Formula, RefusesWhatStandsTooDeep) {
  for (const char* piece : {"[+1 ", "'/1 "}) {
    std::string text = *piece == '[' ? "{" : "";
    for (int i = 0; i < 100'000; ++i) text += piece;
    text::Diagnostics sink;
    parse_formula(source(text), sink);
    ASSERT_EQ(sink.items().size(), 1U);
    EXPECT_EQ(sink.items().front().kind, "nested-too-deep");
  }
}

TEST(Formula, IsToldByItsStart) {
  EXPECT_TRUE(looks_like_formula(" {[+1 <p1 m1> <p2 m2>]}"));
  EXPECT_TRUE(looks_like_formula("// a team\n'*1 {<p1 m1>} {<p1 m1>}'"));
  EXPECT_TRUE(looks_like_formula("{⟨p1 m1⟩}"));
  EXPECT_FALSE(looks_like_formula("robot R { movement = A(); }"));
  EXPECT_FALSE(looks_like_formula("{\"version\": 1}"));
  EXPECT_FALSE(looks_like_formula(""));
}

RC_GTEST_PROP(Formula, ASentenceGivesAConfigurationThatPrintsAsTheSentence, ()) {
  const auto pick = [](int low, int end) { return *rc::gen::inRange(low, end); };
  const std::string sentence = print(testing::AnySentence(pick).society(2));
  text::Diagnostics sink;
  const Tree tree = parse_formula(source(sentence), sink);
  RC_ASSERT(text::render(sink) == "");
  const Formula again = formula_of(tree);
  RC_ASSERT(again.sentences == std::vector<std::string>{sentence});
  // And so does its text.
  const Tree reread = parse(source(print(tree)), sink);
  RC_ASSERT(text::render(sink) == "");
  RC_ASSERT(formula_of(reread).sentences == again.sentences);
}

}  // namespace
}  // namespace mlab::cdl
