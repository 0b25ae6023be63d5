#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "mlab/assist/service.h"

namespace mlab::assist {
namespace {

using Strings = std::vector<std::string>;

/// A text with `|` where the cursor is.
struct Marked {
  Text text;
  std::uint32_t cursor = 0;
};

Marked marked(std::string text) {
  const std::size_t at = text.find('|');
  text.erase(at, 1);
  return {{std::make_shared<const text::Source>("x.cdl", text), Language::kConfiguration},
          static_cast<std::uint32_t>(at)};
}

Completions offered(const std::string& text) {
  const Marked at = marked(text);
  return complete(at.text, at.cursor, {});
}

Strings names(const std::string& text) {
  Strings out;
  for (const Candidate& one : offered(text).candidates) out.push_back(one.text);
  return out;
}

bool has(const Strings& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

constexpr const char* kWander = R"(
/// Drifts about.
assemblage Wander(curious: gain = 0.8 in 0 .. 1, goal: Point) {
  let drift = Noise(persistence = 10 s);
  cooperate {
    curious: drift;
    1: )";

TEST(CdlCompletion, OffersDeclarationsAtTheTopOfAFile) {
  EXPECT_TRUE(has(names("|"), "assemblage"));
  EXPECT_EQ(names("asse|"), Strings{"assemblage"});
  EXPECT_TRUE(has(names("assemblage A() { Noise() }\n|"), "robot"));
}

TEST(CdlCompletion, OffersComponentsThatGiveWhatIsWanted) {
  const Strings all = names(std::string(kWander) + "|");
  EXPECT_TRUE(has(all, "drift"));
  EXPECT_TRUE(has(all, "Noise"));
  EXPECT_TRUE(has(all, "Wander"));
  EXPECT_FALSE(has(all, "sense_obstacles")) << "gives obstacles, and a vector is wanted";
  EXPECT_FALSE(has(all, "assemblage"));
  EXPECT_EQ(names(std::string(kWander) + "AvoidSt|")[0], "AvoidStaticObstacles");
}

TEST(CdlCompletion, TellsWhatAComponentIs) {
  const Completions all = offered(std::string(kWander) + "Wand|");
  ASSERT_FALSE(all.candidates.empty());
  EXPECT_EQ(all.candidates[0].text, "Wander");
  EXPECT_EQ(all.candidates[0].detail, "(curious: gain = 0.8 in 0 .. 1, goal: Point) -> Vector");
  EXPECT_EQ(all.candidates[0].help, "Drifts about.");
  EXPECT_TRUE(all.candidates[0].is_call);
}

TEST(CdlCompletion, OffersTheInputsOfTheCallThatItIsIn) {
  const Strings all = names(std::string(kWander) + "Noise(|");
  EXPECT_TRUE(has(all, "persistence"));
  EXPECT_EQ(all[0], "persistence");
  EXPECT_FALSE(has(names(std::string(kWander) + "Noise(persistence = 1 s, |"), "persistence"));
  EXPECT_TRUE(has(names(std::string(kWander) + "MoveToGoal(goal, succ|"), "success_radius"));
}

TEST(CdlCompletion, OffersUnitsThatFitTheInput) {
  const Strings all = names(std::string(kWander) + "Noise(persistence = 10 |");
  EXPECT_EQ(all[0], "s");
  EXPECT_TRUE(has(all, "min"));
  EXPECT_FALSE(has(all, "m"));
  EXPECT_EQ(names(std::string(kWander) + "Noise(persistence = 10m|")[0], "min");
  EXPECT_TRUE(names(std::string(kWander) + "Noise(persistence = 10|").empty());
}

TEST(CdlCompletion, OffersTheWordsOfTheWantedType) {
  const std::string call = "assemblage A() { FilterObjectsByClass(sense_objects(), classes = |";
  const Strings all = names(call);
  EXPECT_EQ(all[0], "Basket");
  EXPECT_TRUE(has(all, "Flag"));
  EXPECT_EQ(names("assemblage A() { FilterObjectsByClass(sense_objects(), classes = \"Flag|").size(), 1U);
}

TEST(CdlCompletion, OffersStatesBehindGoto) {
  const Strings all = names(R"(assemblage A() {
  sequence {
    start One: Noise();
      when IsHalted() goto |
    Two: Noise();
  }
})");
  EXPECT_EQ(all, (Strings{"One", "Two"}));
  const Strings words = names("assemblage A() { sequence { start One: Noise(); |");
  EXPECT_TRUE(has(words, "when"));
  EXPECT_TRUE(has(words, "final"));
}

TEST(CdlCompletion, OffersWhatARobotConsistsOf) {
  const std::string file = R"(class Cart { sensor far: DetectObstacles(range = 20 m) binds sense_obstacles;
  actuator wheels: Drive() binds movement; }
robot R is )";
  EXPECT_EQ(names(file + "Ca|"), (Strings{"Cart"}));
  EXPECT_EQ(names(file + "Cart { use |"), (Strings{"far", "wheels"}));
  EXPECT_EQ(names(file + "Cart { use far for |")[0], "sense_obstacles");
  EXPECT_EQ(names(file + "Cart { mov|")[0], "movement");
  EXPECT_EQ(names(file + "Cart { movement = |")[0], "cooperate");
  EXPECT_TRUE(has(names(file + "Cart { }\nsociety S: team of 3 |"), "R"));
  EXPECT_TRUE(has(names("class X { body { |"), "radius"));
}

TEST(CdlCompletion, OffersNothingWhereANewNameStandsAndInComments) {
  EXPECT_TRUE(names("assemblage |").empty());
  EXPECT_TRUE(names("assemblage A(|").empty());
  EXPECT_TRUE(names("// assem|").empty());
  EXPECT_TRUE(names("assemblage A() { let |").empty());
  EXPECT_TRUE(has(names("assemblage A(x: |"), "length"));
}

TEST(CdlHover, TellsTypeUnitDefaultAndRange) {
  const Marked call = marked(std::string(kWander) + "No|ise(persistence = 2 s); } }");
  const auto component = hover(call.text, call.cursor, {});
  ASSERT_TRUE(component);
  EXPECT_NE(component->markdown.find("procedure Noise("), std::string::npos) << component->markdown;
  EXPECT_NE(component->markdown.find("| `persistence` | s |"), std::string::npos) << component->markdown;
  const Marked argument = marked(std::string(kWander) + "Noise(persis|tence = 2 s); } }");
  const auto input = hover(argument.text, argument.cursor, {});
  ASSERT_TRUE(input);
  EXPECT_NE(input->markdown.find("unit s"), std::string::npos) << input->markdown;
  const Marked let = marked(std::string(kWander) + "dri|ft; } }");
  EXPECT_NE(hover(let.text, let.cursor, {})->markdown.find("let drift: Vector"), std::string::npos);
}

TEST(CdlHover, TellsTheTypesThatTheCheckerTells) {
  const auto told = [](const std::string& lets) {
    const Marked let = marked("assemblage A(far: length, v: Vector) {\n" + lets + "\n v }");
    return hover(let.text, let.cursor, {})->markdown;
  };
  const auto has_line = [](const std::string& markdown, const std::string& line) {
    return markdown.find("\n" + line + "\n") != std::string::npos;
  };
  EXPECT_TRUE(has_line(told("let ne|ar = 3 m;"), "let near: double [m]"));
  EXPECT_TRUE(has_line(told("let ne|ar = far;"), "let near: double [m]"));
  EXPECT_TRUE(has_line(told("let la|te = delay(unknown, initial = v);"), "let late: Vector"));
  EXPECT_TRUE(has_line(told("let ei|ther = select by far { case 1: unknown; otherwise: v; };"),
                       "let either: Vector"));
  EXPECT_TRUE(has_line(told("let ro|und = round;"), "let round"));
}

TEST(CdlDefinition, LeadsToLetsParametersAndDeclarations) {
  const Marked let = marked(std::string(kWander) + "dri|ft; } }");
  const auto place = definition(let.text, let.cursor, {});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->source->text(place->span), "drift");
  EXPECT_EQ(place->source->line_column(place->span.begin).line, 4U);
  const Marked library = marked("assemblage A() { AvoidDyn|amicObstacles() }");
  const auto far = definition(library.text, library.cursor, {});
  ASSERT_TRUE(far);
  EXPECT_EQ(far->source->name(), "library/assemblages/avoid_dynamic_obstacles.cdl");
}

constexpr const char* kPatrol =
    "assemblage Patrol(out: Point) {\n  sequence { start Going: Stand(); when IsHalted() goto Waiting;\n"
    "    /// Until somebody comes.\n    final Waiting: Stand(); }\n}\n";

TEST(CdlCompletion, KnowsWhatATestMaySay) {
  const std::string test = std::string(kPatrol) + "test \"x\" of Patrol([1 m, 2 m]) as patrol ";
  EXPECT_TRUE(has(names(test + "|"), "on"));
  EXPECT_TRUE(has(names(test + "on |"), "Scout"));
  EXPECT_TRUE(has(names(test + "{ |"), "given"));
  EXPECT_TRUE(has(names(test + "{ given |"), "obstacle"));
  EXPECT_TRUE(has(names(test + "{ given no |"), "obstacle"));
  EXPECT_TRUE(has(names(test + "{ given obstacle(|"), "radius = "));
  EXPECT_FALSE(has(names(test + "{ given obstacle([1 m, 2 m], |"), "at = "));
  EXPECT_TRUE(has(names(test + "{ given object(|"), "Flag"));
  EXPECT_TRUE(has(names(test + "{ expect |"), "within"));
  EXPECT_TRUE(has(names(test + "{ expect length(|"), "patrol"));
  EXPECT_TRUE(has(names(test + "{ expect state |"), "Waiting"));
  EXPECT_TRUE(has(names(test + "{ expect action |"), "PickUp"));
}

TEST(CdlHover, ExplainsWhatATestSays) {
  const auto hover_of = [](const std::string& steps) {
    const Marked at = marked(std::string(kPatrol) + "test \"x\" of Patrol([1 m, 2 m]) { " + steps + " }");
    const auto out = hover(at.text, at.cursor, {});
    return out ? out->markdown : "";
  };
  EXPECT_NE(hover_of("given obst|acle([1 m, 2 m]);").find("something solid"), std::string::npos);
  EXPECT_NE(hover_of("expect action Pick|Up;").find("picks something up"), std::string::npos);
}

TEST(CdlNames, StatesThatATestExpectsAreThoseOfWhatItTests) {
  const Marked at =
      marked(std::string(kPatrol) + "test \"x\" of Patrol([1 m, 2 m]) { expect no state it.Wai|ting; }");
  const auto place = definition(at.text, at.cursor, {});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->source->line_column(place->span.begin).line, 4U);
  const auto edits = rename(at.text, at.cursor, "Watching", {});
  ASSERT_TRUE(edits) << edits.error().message;
}

}  // namespace
}  // namespace mlab::assist
