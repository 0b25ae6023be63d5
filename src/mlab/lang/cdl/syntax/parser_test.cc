#include "mlab/lang/cdl/syntax/parser.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "mlab/lang/cdl/print/print.h"
#include "mlab/lang/cdl/syntax/cursor.h"

namespace mlab::cdl {
namespace {

Tree parsed(const std::string& text, text::Diagnostics& sink) {
  return parse(std::make_shared<const text::Source>("a.cdl", text), sink);
}

std::string said(const std::string& text) {
  text::Diagnostics sink;
  parsed(text, sink);
  return text::render(sink);
}

std::string reprinted(const std::string& text) {
  text::Diagnostics sink;
  const Tree tree = parsed(text, sink);
  EXPECT_TRUE(sink.items().empty()) << text::render(sink);
  return print(tree);
}

constexpr const char* kForage = R"(use "skills.cdl";
architecture AuRA;

/// Explores: drifts about.
assemblage Wander(curious: gain = 0.8, cautious: gain = 0.5 in 0 .. 100) -> Vector {
  alias "WANDER";
  /// What is in the way.
  let near = sense_obstacles(range = 2 m);
  cooperate {
    curious: Noise(persistence = 10 s) as drift;
    cautious: AvoidStaticObstacles(readings = near, sphere = 50 cm, safety_margin = 0.5 m);
    Probe(near) active LookAt(0 deg);
  }
}

assemblage Forage(attractor: object_class = Orange, home: Text [x] = "Basket") {
  sequence {
    start Searching: Wander();
      when Detect(attractor) and not (Holding(attractor) or Holding(home)) goto Acquiring;
    Acquiring: compete by strength {
      1: Acquire(attractor);
    };
      when not Detect(attractor) goto Searching restart;
    final Done: select by task {
      case MoveTo, -2: Stand();
      otherwise: delay(Stand(), initial = x);
    };
  }
}

assemblage Unknown(a: gain);

binding sense_obstacles(range: length) -> Obstacles;

class MRV2(top: speed = 1 m/s) {
  body {
    radius = 0.35 m;
  }
  sensor sonars: DetectObstacles() binds sense_obstacles;
  actuator base: Drive(max_velocity = top) binds movement;
}

/// Forages.
robot Forager(attractor: object_class = Orange) is MRV2 {
  let all = [a, b];
  use sonars for sense_obstacles;
  movement = coordinate by Arbiter(x = 1) {
    0.5: Forage(attractor = attractor);
  };
}

operator DistinctTargets {
  choose_target = ClaimClosest();
}

society Foragers: caste {
  team of 3 Forager by DistinctTargets;
  Other;
} by Nothing;

layout Wander {
  Noise 120 40;
  Searching.Probe -3.5 160;
  note 40 200 "looks around" "for a while";
  note 40 300 120 60 "sized";
  frame 0 0 400 300;
}

layout {
  Wander 0 0;
}
)";

TEST(CdlParser, ReadsEveryConstructAndThePrinterWritesItAgain) {
  EXPECT_EQ(reprinted(kForage), kForage);
}

TEST(CdlParser, PlacesWhatItReads) {
  text::Diagnostics sink;
  const Tree tree = parsed(kForage, sink);
  const auto& wander = std::get<Assemblage>(tree.items.at(2));
  EXPECT_EQ(wander.help, "Explores: drifts about.");
  const auto& members = std::get<Cooperate>(wander.body->what).members;
  EXPECT_EQ(tree.source->text(members[0].value->place.span), "Noise(persistence = 10 s) as drift");
  EXPECT_EQ(tree.source->text(members[0].weight->place.span), "curious");
}

TEST(CdlParser, TakesAnExponentOnlyWithItsDigits) {
  text::Diagnostics sink;
  const Tree tree = parsed("assemblage A() { Noise(persistence = 2e) }\n", sink);
  const auto& call = std::get<Call>(std::get<Assemblage>(tree.items.at(0)).body->what);
  const auto& number = std::get<Number>(call.arguments.at(0).value->what);
  EXPECT_EQ(number.value, 2.0);
  EXPECT_EQ(number.unit.text, "e") << "which is none, and is told so";
}

TEST(CdlParser, SaysOnceWhatIsMissing) {
  EXPECT_EQ(said("assemblage A() {\n  cooperate {\n    1: Noise()\n    2: Probe();\n  }\n}\n"),
            "a.cdl:3:14: error: expected `;` behind the member [syntax]\n"
            "    3 |     1: Noise()\n"
            "      |              ^ behind this\n");
  EXPECT_EQ(said("assemblage A() {\n  cooperate {\n    1: Noise();\n}\nrobot R { movement = A(); }\n"),
            "a.cdl:3:15: error: expected `}` behind this, to close `cooperate` [unclosed-block]\n"
            "    3 |     1: Noise();\n"
            "      |               ^\n"
            "a.cdl:2:13: note: it opens here\n");
  EXPECT_EQ(said("asemblage A() { Noise() }\nrobot R { movement = A(); }\n"),
            "a.cdl:1:1: error: expected a declaration, found `asemblage` [syntax]\n"
            "    1 | asemblage A() { Noise() }\n"
            "      | ^^^^^^^^^\n"
            "      = hint: did you mean `assemblage`?\n");
  EXPECT_EQ(said("assemblage A() {\n  cooprate { 1: Noise(); }\n}\n"),
            "a.cdl:2:3: error: unknown operator `cooprate` [unknown-operator]\n"
            "    2 |   cooprate { 1: Noise(); }\n"
            "      |   ^^^^^^^^\n"
            "      = hint: did you mean `cooperate`?\n");
}

TEST(CdlParser, RefusesWhatStandsTooDeepAndSaysSoOnce) {
  for (const char* piece : {"(", "[", "not ", "F(", "cooperate { ", "x active "}) {
    std::string text = "assemblage A() { ";
    for (int i = 0; i < 100'000; ++i) text += piece;
    text::Diagnostics sink;
    parsed(text, sink);
    ASSERT_EQ(sink.items().size(), 1U) << piece << text::render(sink);
    EXPECT_EQ(sink.items()[0].kind, "nested-too-deep");
  }
}

TEST(CdlParser, TellsAConfigurationByItsFirstWords) {
  EXPECT_TRUE(looks_like_cdl("// text\nassemblage A() {"));
  EXPECT_TRUE(looks_like_cdl("robot R is MRV2 {"));
  EXPECT_TRUE(looks_like_cdl("use \"a.cdl\";"));
  EXPECT_FALSE(looks_like_cdl("node a is B with nend"));
  EXPECT_FALSE(looks_like_cdl("MISSION NAME \"x\""));
  EXPECT_FALSE(looks_like_cdl(""));
}

PartialFile as_written(const std::string& text) {
  return read_as_written(std::make_shared<const text::Source>("a.cdl", text));
}

const Assemblage& only_assemblage(const PartialFile& written) {
  return std::get<Assemblage>(written.tree.items.at(0));
}

TEST(CdlAsWritten, IsTheSameTreeWhereNothingIsMissing) {
  const PartialFile written = as_written(kForage);
  EXPECT_EQ(print(written.tree), reprinted(kForage));
  EXPECT_FALSE(written.ends_inside);
  EXPECT_EQ(written.next_words.size(), std::size(kDeclarationWords));
}

TEST(CdlAsWritten, HasAHoleWhereAValueIsMissing) {
  const PartialFile written = as_written("assemblage A() { let a = ; cooperate { 1: Noise(x = , y = a); } }");
  const Assemblage& one = only_assemblage(written);
  ASSERT_EQ(one.lets.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<Hole>(one.lets[0].value->what));
  EXPECT_EQ(one.lets[0].value->place.span.begin, 25U);
  const auto& call = std::get<Call>(std::get<Cooperate>(one.body->what).members.at(0).value->what);
  ASSERT_EQ(call.arguments.size(), 2U) << "what stands behind the hole is read as well";
  EXPECT_TRUE(std::holds_alternative<Hole>(call.arguments[0].value->what));
  EXPECT_EQ(call.arguments[1].name.text, "y");
}

TEST(CdlAsWritten, KeepsADeclarationWhoseHeadIsNotWhole) {
  const PartialFile written =
      as_written("assemblage A(a: length, b: ) { a }\nrobot R(c: ) is Cart { movement = A(); }");
  ASSERT_EQ(written.tree.items.size(), 2U);
  EXPECT_EQ(only_assemblage(written).parameters.size(), 2U);
  EXPECT_TRUE(only_assemblage(written).body);
  EXPECT_EQ(std::get<Robot>(written.tree.items[1]).drives.size(), 1U);
}

TEST(CdlAsWritten, GoesOnWhereTheNextLineBeginsAStatement) {
  const PartialFile written = as_written("assemblage A() {\n  let a =\n  let b = Noise();\n  b\n}");
  ASSERT_EQ(only_assemblage(written).lets.size(), 2U);
  EXPECT_EQ(only_assemblage(written).lets[1].name.text, "b");
}

TEST(CdlAsWritten, ComesToAnEndWhereAStatementIsNoneOfItsBlock) {
  for (const char* text :
       {"assemblage A() { cooperate { x\n let b = Noise(); } }", "class C { x\n case A: y\n when z }",
        "assemblage A() { x\n One: two\n start Three: four }"})
    EXPECT_EQ(as_written(text).tree.items.size(), 1U) << text;
}

TEST(CdlAsWritten, TellsWhichWordsCouldFollow) {
  const auto next = [](const std::string& text) { return as_written(text).next_words; };
  using Words = std::vector<std::string>;
  EXPECT_EQ(next("assemblage A() { Noise() "), (Words{"as", "active", "and", "or"}));
  EXPECT_EQ(next("assemblage A() { Noise() as n "), (Words{"active", "and", "or"}));
  EXPECT_EQ(next("assemblage A() { Noise(); "), (Words{"let"}));
  EXPECT_EQ(next("assemblage A() { compete by "), (Words{"priority", "strength"}));
  EXPECT_EQ(next("assemblage A(a: gain "), (Words{"in"}));
  EXPECT_EQ(next("assemblage A() { sequence { start One: Noise(); when x "),
            (Words{"as", "active", "and", "or", "goto"}));
  EXPECT_EQ(next("assemblage A() { sequence { start One: Noise(); "), (Words{"when", "start", "final"}));
  EXPECT_EQ(next("class C { "), (Words{"body", "sensor", "actuator"}));
  EXPECT_EQ(next("assemblage A("), Words{});
  EXPECT_TRUE(as_written("assemblage A(").ends_inside);
}

TEST(CdlAsWritten, KnowsTheWordsOfTheLanguage) {
  const std::string text = "assemblage A() { let in = delay(Noise(), initial = 0); not in }";
  const PartialFile written = as_written(text);
  std::vector<std::string> words;
  for (const text::Span word : written.words) words.push_back(text.substr(word.begin, word.end - word.begin));
  EXPECT_EQ(words, (std::vector<std::string>{"assemblage", "let", "delay", "initial", "not"}));
}

}  // namespace
}  // namespace mlab::cdl
