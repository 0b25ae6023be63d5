#include <array>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "mlab/base/testing/processor_time.h"
#include "mlab/base/testing/source_folder.h"
#include "mlab/difference/tell.h"
#include "mlab/lang/cdl/syntax/signs.h"

namespace mlab::difference {
namespace {

/// A text, read without a library.
class Text {
 public:
  explicit Text(std::string text) {
    text::Diagnostics sink;
    configuration_ = cdl::load(std::make_shared<const text::Source>("a.cdl", std::move(text)), {}, sink);
    has_errors_ = sink.has_errors();
    elaboration_ = std::make_unique<cdl::Elaboration>(configuration_, library_);
  }
  Version version() const { return {*configuration_.trees.front(), *elaboration_, has_errors_}; }

 private:
  bool has_errors_ = false;
  flow::Library library_;
  cdl::Configuration configuration_;
  std::unique_ptr<cdl::Elaboration> elaboration_;
};

std::vector<std::string> told(const std::vector<Difference>& all) {
  std::vector<std::string> out;
  for (const Difference& one : all)
    out.push_back(fmt::format("{} {}| {}", sign_of(one.what), place_of(one), sentence(one)));
  return out;
}

using Lines = std::vector<std::string>;

Lines differences(const std::string& before, const std::string& after) {
  const Text one(before);
  const Text other(after);
  return told(compare(one.version(), other.version()).meaning);
}

Lines moves(const std::string& before, const std::string& after) {
  const Text one(before);
  const Text other(after);
  const Comparison all = compare(one.version(), other.version());
  EXPECT_TRUE(all.is_same());
  Lines out = told(all.layout);
  for (std::string& remark : remarks(all)) out.push_back(std::move(remark));
  return out;
}

std::string forager() {
  std::ifstream in(base::source_folder() + "/missions/forage/forager.cdl");
  std::stringstream out;
  out << in.rdbuf();
  return out.str();
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

TEST(Difference, IsOfAPartWhereOneOfBothCouldNotBeReadAsAWhole) {
  const Text whole("assemblage A() {\n  Noise();\n}\n");
  const Text broken("assemblage A() {\n  Noise();\n}\nassemblage B( {\n}\n");
  EXPECT_FALSE(compare(whole.version(), whole.version()).is_partial);
  EXPECT_TRUE(compare(broken.version(), whole.version()).is_partial);
  EXPECT_TRUE(compare(whole.version(), broken.version()).is_partial);
}

constexpr const char* kDrift = R"(assemblage Drift(curious: gain = 0.8) -> Vector {
  cooperate {
    curious: Noise(persistence = 12 s);
    1: Avoid(sphere = 2 m) as clear;
    0.5: Swirl(sphere = 3 m);
  }
}
)";

TEST(Difference, OfATextToItselfIsNothing) {
  EXPECT_EQ(differences(forager(), forager()), Lines{});
  EXPECT_EQ(moves(forager(), forager()), Lines{});
}

TEST(Difference, NamesTheInputAndBothItsValues) {
  EXPECT_EQ(differences(kDrift, replaced(kDrift, "12 s", "6 s")),
            (Lines{"~ Drift| Noise: persistence 12 s -> 6 s"}));
}

TEST(Difference, SaysNothingOfWiresThatCameWithTheirNode) {
  EXPECT_EQ(differences(kDrift, replaced(kDrift, "    0.5: Swirl", "    2: Wall();\n    0.5: Swirl")),
            (Lines{"+ Drift| Wall"}));
  EXPECT_EQ(differences(kDrift, replaced(kDrift, "    1: Avoid(sphere = 2 m) as clear;\n", "")),
            (Lines{"- Drift| clear (Avoid)"}));
}

TEST(Difference, TellsWeightsByTheMemberThatTheyAreOf) {
  EXPECT_EQ(differences(kDrift, replaced(kDrift, "0.5: Swirl", "0.7: Swirl")),
            (Lines{"~ Drift| cooperate: weight of Swirl 0.5 -> 0.7"}));
}

TEST(Difference, TakesTheSecondOfTwoForItselfWhenTheFirstHasGone) {
  const std::string two = R"(assemblage A() -> Vector {
  cooperate {
    1: Noise(persistence = 1 s);
    1: Noise(persistence = 2 s);
  }
}
)";
  EXPECT_EQ(differences(two, replaced(two, "    1: Noise(persistence = 1 s);\n", "")), (Lines{"- A| Noise"}));
}

TEST(Difference, KnowsWhatWasRenamedByWhatItSays) {
  EXPECT_EQ(differences(kDrift, replaced(kDrift, "as clear", "as keep_off")),
            (Lines{"~ Drift| clear (Avoid) is now called keep_off"}));
  const std::string uses = std::string(kDrift) + "assemblage B() -> Vector { Drift(curious = 1) }\n";
  const std::string renamed =
      replaced(replaced(uses, "assemblage Drift", "assemblage Float"), "{ Drift(", "{ Float(");
  EXPECT_EQ(differences(uses, renamed), (Lines{"~ | assemblage Drift is now called Float"}));
}

TEST(Difference, KnowsWhatWasGivenTheNameOfWhatItReads) {
  const std::string before = "assemblage A() -> Vector { Seek(Filter(Sense() as a)) }";
  const std::string after = "assemblage A() -> Vector { Seek(Filter(Sense() as a) as a) }";
  EXPECT_EQ(differences(before, after), (Lines{"~ A| Filter is now called a"}));
  EXPECT_EQ(differences(after, before), (Lines{"~ A| a (Filter) is now called Filter"}));
}

TEST(Difference, TellsAnActivePartBesideAName) {
  const std::string before =
      "assemblage A() -> Vector { let far = Sense(); let near = far; Seek(far, near) }";
  const std::string beside_let = replaced(before, "= far;", "= far active LookAround();");
  EXPECT_EQ(differences(before, beside_let),
            (Lines{"~ A| near (value): value far -> far active LookAround()"}));
  const std::string beside_input = replaced(before, "(far,", "(far active LookAround(),");
  EXPECT_EQ(differences(before, beside_input),
            (Lines{"~ A| Seek: argument 1 far -> far active LookAround()"}));
}

TEST(Difference, TellsTheNameOfAFormulaOnce) {
  const std::string before = "assemblage A(x: number) -> Vector { let y = 1; Seek((x + y) * 2) }";
  EXPECT_EQ(differences(before, replaced(before, "(x + y) * 2", "((x + y) * 2) as twice")),
            (Lines{"~ A| Multiply is now called twice"}));
  EXPECT_EQ(differences(before, replaced(before, "(x + y) * 2", "((x + y) * 3) as twice")),
            (Lines{"~ A| twice (Multiply): name Multiply -> twice; formula (x + y) * 2 -> (x + y) * 3"}));
}

TEST(Difference, FollowsANameIntoFormulas) {
  const std::string sense = "assemblage Sight() -> Vector { Sense() }\n";
  const std::string before =
      sense +
      "assemblage A(x: number) -> Vector { let y = Noise(); cooperate { x * y * y: Seek(Sight() + y); } }";
  EXPECT_EQ(differences(before, replaced(replaced(before, "let y", "let z"), "x * y * y: Seek(Sight() + y)",
                                         "x * z * z: Seek(Sight() + z)")),
            (Lines{"~ A| y (Noise) is now called z"}));
  EXPECT_EQ(
      differences(before, replaced(replaced(before, "blage Sight", "blage View"), "k(Sight()", "k(View()")),
      (Lines{"~ | assemblage Sight is now called View"}));
}

TEST(Difference, FollowsAParameterToWhereItIsUsedAndGiven) {
  const std::string uses = std::string(kDrift) + "assemblage B() -> Vector { Drift(curious = 1) }\n";
  std::string renamed = replaced(uses, "curious: gain", "eager: gain");
  renamed = replaced(renamed, "curious: Noise", "eager: Noise");
  renamed = replaced(renamed, "Drift(curious = 1)", "Drift(eager = 1)");
  EXPECT_EQ(differences(uses, renamed), (Lines{"~ Drift| parameter curious is now called eager"}));
}

TEST(Difference, KeepsTheMembersOfAnOperatorThatBecameAnother) {
  const std::string after = replaced(
      replaced(replaced(replaced(kDrift, "cooperate", "compete by priority"), "curious: Noise", "Noise"),
               "1: Avoid", "Avoid"),
      "0.5: Swirl", "Swirl");
  const Lines all = differences(kDrift, after);
  ASSERT_EQ(all.size(), 1U) << fmt::format("{}", fmt::join(all, "\n"));
  EXPECT_TRUE(all.front().starts_with("~ Drift| compete (compete by priority): component cooperate -> "))
      << all.front();
}

TEST(Difference, TellsAnotherOrderOfMembersOnce) {
  const std::string members = R"(assemblage A() -> Vector {
  compete by priority { One(); Two(); Three(); }
}
)";
  EXPECT_EQ(
      differences(members, replaced(members, "One(); Two();", "Two(); One();")),
      (Lines{"~ A| compete (compete by priority): order of members One, Two, Three -> Two, One, Three"}));
}

TEST(Difference, TellsAWireThatLeadsElsewhere) {
  const std::string wired = R"(assemblage A() -> Vector {
  let near = Sense(range = 1 m);
  let far = Sense(range = 9 m);
  cooperate { 1: Go(to = near); 1: Flee(from = far); }
}
)";
  EXPECT_EQ(differences(wired, replaced(wired, "Go(to = near)", "Go(to = far)")),
            (Lines{"~ A| Go: to near -> far"}));
}

constexpr const char* kStates = R"(assemblage Seek() -> Vector {
  sequence {
    start Look: Wander();
      when Seen() goto Fetch;
      when Wait(delay = 9 s) goto Home;
    Fetch: Go();
      when Held() goto Home;
    Home: Return();
  }
}
)";

TEST(Difference, TellsStatesAndTransitions) {
  EXPECT_EQ(differences(kStates, replaced(kStates, "delay = 9 s", "delay = 5 s")),
            (Lines{"~ Seek| transition from Look to Home: trigger Wait(delay = 9 s) -> "
                   "Wait(delay = 5 s)"}));
  EXPECT_EQ(differences(kStates, replaced(kStates, "      when Held() goto Home;\n", "")),
            (Lines{"- Seek| transition from Fetch: Held() -> Home"}));
  EXPECT_EQ(differences(kStates, replaced(kStates, "Home: Return();", "final Home: Return();")),
            (Lines{"~ Seek| state Home: final no -> yes"}));
  EXPECT_EQ(differences(kStates, replaced(kStates, "Fetch: Go()", "Fetch: Run()")),
            (Lines{"- Seek.Fetch| Go", "+ Seek.Fetch| Run"}));
}

std::string asks_with(std::string_view sign) {
  return replaced(kStates, "Seen()", fmt::format("level {} 2", sign));
}

TEST(Difference, TellsEverySignOfAFormula) {
  EXPECT_EQ(differences(asks_with("<"), asks_with(">=")),
            (Lines{"~ Seek| transition from Look to Fetch: trigger level < 2 -> level >= 2"}));
  for (const cdl::Sign& was : cdl::kSigns) {
    for (const cdl::Sign& is : cdl::kSigns) {
      if (was.operation == cdl::Operation::kNegate || is.operation == cdl::Operation::kNegate) continue;
      EXPECT_EQ(differences(asks_with(was.text), asks_with(is.text)).empty(), was.text == is.text)
          << was.text << " -> " << is.text;
    }
  }
  const std::string weighed = replaced(kDrift, "curious: Noise", "curious - 2 + 3: Noise");
  EXPECT_EQ(differences(weighed, replaced(weighed, "- 2", "+ 2")),
            (Lines{"~ Drift| cooperate: weight of Noise curious - 2 + 3 -> curious + 2 + 3"}));
  EXPECT_EQ(differences(replaced(kDrift, "12 s", "-curious"), replaced(kDrift, "12 s", "curious")),
            (Lines{"~ Drift| Noise: persistence -curious -> curious"}));
}

TEST(Difference, KnowsAStateThatWasRenamedAndWhatLeadsToIt) {
  std::string after = replaced(kStates, "Fetch: Go", "Grab: Go");
  after = replaced(after, "goto Fetch", "goto Grab");
  EXPECT_EQ(differences(kStates, after), (Lines{"~ Seek| state Fetch is now called Grab"}));
}

TEST(Difference, TellsWhichTransitionIsAskedFirst) {
  const std::string after =
      replaced(replaced(kStates, "      when Seen() goto Fetch;\n", ""), "goto Home;\n    Fetch",
               "goto Home;\n      when Seen() goto Fetch;\n    Fetch");
  EXPECT_EQ(differences(kStates, after),
            (Lines{"~ Seek| state Look: order of transitions to Fetch, to Home -> to Home, to Fetch"}));
}

constexpr const char* kRobots = R"(class Body(speed: speed = 1 m/s) {
  body { radius = 0.3 m; }
  sensor ring: DetectObstacles() binds sense_obstacles;
  actuator base: Drive(max_velocity = speed) binds movement;
}
robot Scout() is Body {
  movement = Stand();
}
society Band: caste { team of 3 Scout; Scout; };
)";

TEST(Difference, TellsBodiesDevicesAndSocieties) {
  EXPECT_EQ(differences(kRobots, replaced(kRobots, "0.3 m", "0.5 m")),
            (Lines{"~ Body| body radius: value 0.3 m -> 0.5 m"}));
  EXPECT_EQ(differences(kRobots, replaced(kRobots, "DetectObstacles()", "Sonar(range = 3 m)")),
            (Lines{"~ Body| sensor ring: served by DetectObstacles -> Sonar(range = 3 m)"}));
  EXPECT_EQ(differences(kRobots, replaced(kRobots, "sensor ring", "sensor sonars")),
            (Lines{"~ Body| sensor ring is now called sonars"}));
  EXPECT_EQ(differences(kRobots, replaced(kRobots, "team of 3", "team of 5")),
            (Lines{"~ | society Band: members team of 3 Scout -> team of 5 Scout"}));
  EXPECT_EQ(differences(kRobots, replaced(kRobots, "  movement = Stand();\n", "")),
            (Lines{"- Scout| movement (actuator)", "- Scout| movement (Stand)"}));
}

TEST(Difference, KeepsApartWhatWasOnlyMoved) {
  const std::string laid = std::string(kDrift) + R"(
layout Drift {
  Noise 40 40;
  clear 40 160;
  note 300 20 "mind the gap";
}
)";
  EXPECT_EQ(moves(laid, replaced(laid, "clear 40 160", "clear 80 160")),
            (Lines{"> Drift| clear: place 40, 160 -> 80, 160",
                   "both mean the same; what differs: the layout (1 moved or noted)"}));
  EXPECT_EQ(moves(laid, replaced(laid, "mind", "close")),
            (Lines{"~ Drift| note \"close the gap\": words mind the gap -> close the gap",
                   "both mean the same; what differs: the layout (1 moved or noted)"}));
  EXPECT_EQ(moves(laid, kDrift).size(), 2U);
}

TEST(Difference, SaysThatOnlyCommentsBlanksOrWordsAreOthers) {
  EXPECT_EQ(moves(kDrift, std::string("// hello\n") + kDrift),
            (Lines{"both mean the same; what differs: comments"}));
  EXPECT_EQ(moves(kDrift, std::string("\n\n") + kDrift), (Lines{"both mean the same; what differs: blanks"}));
  EXPECT_EQ(
      moves(kDrift, replaced(kDrift, "    0.5: Swirl(sphere = 3 m);", "    0.50: (Swirl(sphere = 3 m));")),
      (Lines{"both mean the same; what differs: the way it is written"}));
}

TEST(Difference, ComparesWhatCouldBeRead) {
  const std::string torn = replaced(kDrift, "0.5: Swirl(sphere = 3 m);", "0.5: Swirl(sphere = ;");
  const Lines all = differences(kDrift, torn);
  EXPECT_FALSE(all.empty());
  EXPECT_EQ(moves(kDrift, std::string(kDrift) + "assemblage {\n"),
            (Lines{"only what could be read was compared, and that is the same"}));
}

// Of two texts each that `before` and `after` make, of `few` and of eight times as many things, of which so
// many are `differing`.
double growth_of_comparing(std::size_t few, std::string (*before)(std::size_t),
                           std::string (*after)(std::size_t), std::size_t (*differing)(std::size_t)) {
  const std::array<Text, 2> small = {Text(before(few)), Text(after(few))};
  const std::array<Text, 2> large = {Text(before(8 * few)), Text(after(8 * few))};
  const auto compare_them = [&](std::size_t count) {
    const auto& [one, other] = count == few ? small : large;
    EXPECT_EQ(compare(one.version(), other.version()).meaning.size(), differing(count));
  };
  return base::growth(compare_them, few);
}

std::string alike(std::size_t count) {
  std::string out = "assemblage A() -> Vector {\n  cooperate {\n";
  for (std::size_t i = 0; i < count; ++i) out += "    1: Stand();\n";
  return out + "  }\n}\n";
}

TEST(Difference, OfThousandsThatAreAllAlikeTakesNoSquare) {
  EXPECT_LT(growth_of_comparing(
                base::examples(10'000), alike, [](std::size_t count) { return alike(count - 1); },
                [](std::size_t) { return std::size_t{1}; }),
            base::kGrowthOfLine);
}

std::string many(const std::string& name, std::size_t count) {
  std::string out;
  for (std::size_t i = 0; i < count; ++i)
    out += fmt::format("assemblage {}{}() -> Vector {{ Noise(persistence = {} s) }}\n", name, i, i);
  return out;
}

TEST(Difference, OfThousandsThatWereRenamedTakesNoSquare) {
  EXPECT_LT(growth_of_comparing(
                base::examples(1'000), [](std::size_t count) { return many("A", count); },
                [](std::size_t count) { return many("B", count); }, [](std::size_t count) { return count; }),
            base::kGrowthOfLine);
}

TEST(Difference, TellsWhichLetOfATestSaysSomethingElse) {
  const std::string before = "test \"x\" of Stand() { let a = Noise(); let b = Stand(); expect a == b; }\n";
  const Lines told = differences(before, replaced(before, "a = Noise()", "a = Wander()"));
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("let a Noise() -> Wander()"), std::string::npos) << told[0];
  const Lines gone = differences(before, replaced(before, "let b = Stand(); ", ""));
  ASSERT_EQ(gone.size(), 1U);
  EXPECT_NE(gone[0].find("let b"), std::string::npos) << gone[0];
}

}  // namespace
}  // namespace mlab::difference
