#include "mlab/component_test/component_test.h"

#include <filesystem>
#include <string>
#include <string_view>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"

namespace mlab::component_test {
namespace {

Tests tests_in(const std::string& text, text::Diagnostics& sink) {
  return load(std::make_shared<const text::Source>("tests.cdl", text), {}, sink);
}

Outcome outcome_of(const std::string& text, std::uint64_t seed = 1) {
  text::Diagnostics sink;
  const Tests all = tests_in(text, sink);
  EXPECT_TRUE(sink.items().empty()) << text::render(sink);
  EXPECT_EQ(all.tests.size(), 1U);
  return all.tests.empty() ? Outcome{} : run(all.tests.front(), {.seed = seed});
}

std::string failure_of(const std::string& text) {
  const Outcome outcome = outcome_of(text);
  EXPECT_FALSE(outcome.has_passed());
  if (!outcome.failure) return "";
  std::string out = text::render(told(*outcome.failure));
  for (const std::string& one : findings(*outcome.failure)) out += one + '\n';
  return out;
}

std::string errors_of(const std::string& text) {
  text::Diagnostics sink;
  tests_in(text, sink);
  return text::render(sink);
}

constexpr const char* kFetching = R"(
assemblage Fetching() -> Vector {
  sequence {
    start Searching: Noise(persistence = 1 s);
      when Detect(Mine, range = 10 m) goto Fetching;
    Fetching: PickUpObject(reach = 2 m);
      when Holding(Mine) goto Resting;
      when not Detect(Mine, range = 10 m) goto Searching;
    final Resting: Stand();
  }
}
)";

TEST(ComponentTest, APassingTestRunsAsManyCyclesAsItSays) {
  const Outcome outcome = outcome_of(R"(
test "keeps off" of AvoidStaticObstacles(sense_obstacles(range = 10 m), sphere = 5 m, safety_margin = 1 m) {
  given obstacle(at = [3 m, 0 m]);
  expect abs(direction(it)) > 170 deg;
  expect for 2 s: length(it) > 0.1;
  after 5 cycles;
  given no obstacle;
  expect length(it) == 0;
}
)");
  EXPECT_TRUE(outcome.has_passed()) << text::render(told(*outcome.failure));
  EXPECT_EQ(outcome.cycles, 1U + 19 + 5 + 1);
}

TEST(ComponentTest, AFailureSaysWhereWhenAndWhatItCameFrom) {
  const std::string told = failure_of(R"(
test "flees" of MoveToGoal(DetectGoal([4 m, 0 m]), success_radius = 1 m) as pull {
  given self(at = [1 m, 0 m], heading = 90 deg);
  expect direction(pull) > 0 deg;
}
)");
  EXPECT_NE(told.find("tests.cdl:4:10: error: `direction(pull) > 0 deg` is false in cycle 1"),
            std::string::npos)
      << told;
  EXPECT_NE(told.find("direction(pull) is -1.571 rad\npull is [0, -1]\n"), std::string::npos) << told;
}

TEST(ComponentTest, ThingsAreSensedFromWhereTheRobotIs) {
  const Outcome outcome = outcome_of(R"(
test "nearest first" of ObjectLocation(NearestObject(Mine, range = 50 m)) {
  given self(at = [10 m, 0 m], heading = 90 deg);
  given object(Mine, at = [10 m, 30 m]);
  given object(Mine, at = [10 m, 20 m]);
  given object(Flag, at = [10 m, 1 m]);
  expect distance(it, [19.8 m, 0 m]) < 1 cm;
}
)");
  EXPECT_TRUE(outcome.has_passed()) << testing::PrintToString(findings(*outcome.failure));
}

TEST(ComponentTest, StatesAndActionsCanBeExpected) {
  const Outcome outcome = outcome_of(std::string(kFetching) + R"(
test "fetches" of Fetching() {
  expect for 5 cycles: state Searching;
  given object(Mine, at = [1 m, 0 m]);
  expect state Fetching;
  expect action PickUp;
  expect no state Searching;
  given carrying(Mine);
  given no object;
  expect within 3 cycles: state Resting;
  expect no action PickUp;
}
)");
  EXPECT_TRUE(outcome.has_passed()) << text::render(told(*outcome.failure));
}

TEST(ComponentTest, AFailedStateSaysWhichOneItIsIn) {
  const std::string told = failure_of(std::string(kFetching) +
                                      "test \"x\" of Fetching() { expect within 4 cycles: state Resting; }");
  EXPECT_NE(told.find("`state Resting` is false in cycle 4"), std::string::npos) << told;
  EXPECT_NE(told.find("as in all 4 cycles up to here"), std::string::npos) << told;
  EXPECT_NE(told.find("in state it.Searching"), std::string::npos) << told;
}

TEST(ComponentTest, ForEachOfSomeCyclesFailsAtTheFirstThatIsNot) {
  const std::string told = failure_of(R"(
test "waits" of Wait(delay = 0.5 s) {
  expect for 20 cycles: not it;
}
)");
  EXPECT_NE(told.find("of 20 in which it has to be so"), std::string::npos) << told;
}

TEST(ComponentTest, TheSeedDecidesWhatIsRandom) {
  const std::string text = "test \"x\" of Noise(persistence = 1 s) { expect direction(it) > 0 deg; }";
  int passed = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const bool has_passed = outcome_of(text, seed).has_passed();
    EXPECT_EQ(has_passed, outcome_of(text, seed).has_passed());
    passed += has_passed ? 1 : 0;
  }
  EXPECT_GT(passed, 5);
  EXPECT_LT(passed, 35);
}

TEST(ComponentTest, NamedPlacesLieWhereTheTestSays) {
  EXPECT_TRUE(outcome_of(R"(
test "to the gate" of MoveToGoal(DetectGoal(place("Gate"))) {
  given place("Gate", at = [0 m, 9 m]);
  expect abs(direction(it) - 90 deg) < 1 deg;
}
)")
                  .has_passed());
  EXPECT_NE(errors_of("test \"x\" of DetectGoal(place(\"Gate\")) { expect length(it) > 1 m; }")
                .find("the test doesn't say where the place `Gate` is"),
            std::string::npos);
}

TEST(ComponentTest, EveryPerceptAndActionIsKnown) {
  for (const cdl::TestPerceptInfo& one : cdl::kTestPercepts) {
    const std::string text =
        fmt::format("test \"x\" of Noise() {{ given no {}; expect length(it) >= 0; }}", one.name);
    EXPECT_TRUE(outcome_of(text).has_passed()) << one.name;
  }
  for (const cdl::TestAction& one : cdl::test_actions()) {
    const std::string text = fmt::format("test \"x\" of Noise() {{ expect no action {}; }}", one.name);
    EXPECT_TRUE(outcome_of(text).has_passed()) << one.name;
  }
}

TEST(ComponentTest, TellsWhatTheBodyTouches) {
  EXPECT_TRUE(outcome_of(R"(
test "x" of BackOff(duration = 0.3 s) {
  expect length(it) == 0;
  given touch(direction = 90 deg);
  expect abs(direction(it) + 90 deg) < 1 deg;
  given no touch;
  expect length(it) > 0.9;
  after 10 cycles;
  expect length(it) == 0;
}
)")
                  .has_passed());
}

TEST(ComponentTest, TellsWhomTheRobotHears) {
  EXPECT_TRUE(outcome_of(R"(
test "x" of SeekSignal(method = 1) {
  expect length(it) == 0;
  given self(at = [10 m, 0 m]);
  given radio(at = [10 m, 30 m], strength = 10);
  given radio(at = [40 m, 0 m], strength = 25);
  expect abs(direction(it)) < 1 deg and abs(length(it) - 0.5) < 0.01;
  given no radio;
  expect length(it) == 0;
}
)")
                  .has_passed());
}

TEST(ComponentTest, WithoutItsUnitARobotIsItsOwnMiddle) {
  EXPECT_TRUE(outcome_of(R"(
test "x" of DetectUnitCenter() {
  given unit(size = 2, center = [5 m, 0 m]);
  expect length(it) > 4 m;
  given no unit;
  given self(at = [3 m, 0 m]);
  expect length(it) < 1 cm;
}
)")
                  .has_passed());
}

TEST(ComponentTest, EveryInputOfAPerceptIsTakenAndBoundToItsType) {
  const std::string outcome = errors_of(R"(
test "x" of Noise() {
  given self(at = [1 m, 2 m], heading = 3 deg);
  given obstacle([1 m, 2 m], 30 cm);
  given robot(at = [1 m, 2 m], heading = 1 rad, radius = 1 m, mate = true, class = EnemyRobot, id = 7);
  given object(Flag, at = [1 m, 2 m], style = "container", radius = 1 m, id = 3);
  given carrying(Mine, id = 4);
  given order(MoveTo, goal = [1 m, 2 m], formation = Wedge, heading = 1 deg, speed = 1 m/s, halted = false);
  given waypoint([3 m, 4 m]);
  given unit(size = 3, rank = 1, center = [0 m, 1 m], leader = [1 m, 1 m], neighbor = [1 m, 1 m], heading = 0);
  given stick(x = 0.5, y = -1, magnitude = 1, ahead = true, complete = false);
  given message("GO");
  given camera(pan = 10 deg, field_of_view = 90 deg);
  given beam(angle = 0 deg, distance = 2 m, hit = false);
  given shared_place(Mine, at = [1 m, 2 m], from = 3, object = 1);
  given asked_passage(to = [1 m, 2 m], from = 3, cost = 6);
  given claim(object = 3, robot = 2);
  given door(from = [0 m, 0 m], to = [1 m, 0 m], marked = true);
  given hallway(from = [0 m, 0 m], to = [9 m, 0 m], width = 2 m);
  given place("Gate", at = [1 m, 2 m]);
  given radio(at = [1 m, 2 m], strength = 40, robot = 3, mate = true);
  expect length(it) >= 0;
}
)");
  EXPECT_EQ(outcome, "");
}

TEST(ComponentTest, SlipsAreToldAtTheirPlaces) {
  const auto expect_told = [](const std::string& steps, std::string_view kind) {
    const std::string told = errors_of("test \"x\" of Noise() { " + steps + " expect length(it) >= 0; }");
    EXPECT_NE(told.find(fmt::format("[{}]", kind)), std::string::npos) << steps << "\n" << told;
  };
  expect_told("given obstacel(at = [1 m, 2 m]);", "unknown-percept");
  expect_told("given no obstacel;", "unknown-percept");
  expect_told("given obstacle();", "missing-argument");
  expect_told("given obstacle(at = [1 m, 2 m], size = 2 m);", "unknown-argument");
  expect_told("given obstacle(at = [1 m, 2 m], radius = 2 s);", "wrong-unit");
  expect_told("given obstacle(at = [1 m, 2 m], radius = -2 m);", "out-of-range");
  expect_told("given obstacle(at = Noise());", "wrong-type");
  expect_told("given object(Mine, at = [1 m, 2 m], style = \"soft\");", "unknown-name");
  expect_told("after 3 m;", "wrong-unit");
  expect_told("after 3;", "wrong-unit");
  expect_told("after 0 cycles;", "out-of-range");
  expect_told("after 1.5 cycles;", "out-of-range");
  expect_told("after 1e9 s;", "out-of-range");
  expect_told("expect state Nowhere;", "unknown-state");
  expect_told("expect action Dance;", "unknown-action");
  expect_told("expect it;", "wrong-type");
  expect_told("expect nothing_known > 3;", "unknown-name");
  expect_told("wait 3 s;", "syntax");
  EXPECT_NE(errors_of("test \"x\" of Noise() { }").find("[expects-nothing]"), std::string::npos);
  EXPECT_NE(errors_of("test \"x\" of Noise() on Nobody { expect length(it) > 0; }").find("[unknown-class]"),
            std::string::npos);
  EXPECT_NE(errors_of("test \"x\" of Noise() { expect length(it) >= 0; }\n"
                      "test \"x\" of Noise() { expect length(it) >= 0; }")
                .find("[duplicate-declaration]"),
            std::string::npos);
}

TEST(ComponentTest, WhatIsSensedIsAConstantAndOneThing) {
  const auto expect_told = [](const std::string& steps, std::string_view message) {
    const std::string told =
        errors_of("test \"x\" of Noise() { let here = GetPose(); " + steps + " expect length(it) >= 0; }");
    EXPECT_NE(told.find(message), std::string::npos) << steps << "\n" << told;
  };
  expect_told("given obstacle(at = here);",
              "`here` is computed by the test, and what is sensed is a constant");
  expect_told("given obstacle(at = [1 m, 0 m], radius = length(it));", "`it` is computed by the test");
  expect_told("given obstacle(at = [1 m, 0 m], radius = length(it));",
              "write the value itself: `radius = ...`");
  expect_told("given obstacle(at = [[1 m, 0 m], [2 m, 0 m]]);", "write `given obstacle(...);` once for each");
  expect_told("given obstacle([1 m, 0 m], [2 m, 0 m]);", "`radius` is one length, not a list");
  expect_told("given self(at = [[1 m, 0 m], [2 m, 0 m]]);", "there is one `self` at a time");
  expect_told("given object(3, at = [1 m, 0 m]);", "a number is no class of objects");
}

TEST(ComponentTest, AStateMayStandOnALineOfItsOwn) {
  EXPECT_TRUE(outcome_of(std::string(kFetching) + R"(
test "x" of Fetching() {
  expect
    state
      Searching;
  expect no action
    PickUp;
})")
                  .has_passed());
}

TEST(ComponentTest, ARunEndsWhereItIsToldToWithTheValuesOfThatCycle) {
  text::Diagnostics sink;
  const Tests all = tests_in(
      "test \"x\" of Noise() { expect for 20 cycles: length(it) < 0; }\n"
      "test \"y\" of Noise() { expect for 20 cycles: length(it) >= 0; }",
      sink);
  ASSERT_EQ(all.tests.size(), 2U) << text::render(sink);
  const Outcome failed = run(all.tests[0], {});
  EXPECT_EQ(failed.cycles, 1U);
  EXPECT_EQ(flow::Program::cycle(failed.last.frame.data()), 1U);
  const Outcome part = run(all.tests[1], {.last_cycle = 7});
  EXPECT_EQ(part.cycles, 7U);
  EXPECT_TRUE(part.was_stopped);
  EXPECT_FALSE(part.has_passed());
  EXPECT_EQ(flow::Program::cycle(part.last.frame.data()), 7U);
  EXPECT_TRUE(run(all.tests[1], {.last_cycle = 20}).has_passed());
  int asked = 0;
  const Outcome stopped = run(all.tests[1], {.is_stopped = [&] { return ++asked > 4; }});
  EXPECT_EQ(stopped.cycles, 4U);
  EXPECT_FALSE(stopped.has_passed());
}

TEST(ComponentTest, WhatIsNoNumberIsToldAsSuch) {
  const std::string told = failure_of(R"(
test "x" of DivideVector(Noise(), 0) { expect length(it) > 100; }
)");
  EXPECT_NE(told.find("is no number"), std::string::npos) << told;
}

TEST(ComponentTest, WhatIsNoNumberOnTheWayToAConditionIsToldAsSuch) {
  const std::string told = failure_of(R"(
test "x" of Stand() { let n = 1 / length(it); expect not (n > 1); }
)");
  EXPECT_NE(told.find("`n` is no number"), std::string::npos) << told;
}

TEST(ComponentTest, ALetRunsThoughNobodyReadsIt) {
  const std::string kComing = R"(
assemblage S() { sequence { start P: Stand(); when Detect(Mine) goto Q; Q: Wander(); } }
test "x" of Wander() {
  let other = S();
  expect state P;
  given object(Mine, [2 m, 0 m]);
)";
  EXPECT_TRUE(outcome_of(kComing + "  expect state other.Q;\n}\n").has_passed());
  EXPECT_NE(failure_of(kComing + "  expect no state Q;\n}\n"), "");
}

TEST(ComponentTest, MayRunAsManyCyclesAsAreAllowed) {
  const std::string given = "given obstacle([2 m, 0 m]); given no obstacle; given object(Mine, [1 m, 0 m]);";
  for (const std::string& steps : {given + " after 99999 cycles; expect length(it) == 0;",
                                   std::string("after 100000 cycles; expect for 1 cycle: length(it) == 0;")})
    EXPECT_TRUE(outcome_of("test \"x\" of Stand() { " + steps + " }").has_passed()) << steps;
  EXPECT_NE(errors_of("test \"x\" of Stand() { after 100000 cycles; given no obstacle; expect it == it; }"),
            "");
}

TEST(ComponentTest, NumbersThatNobodySaidAreOfNothingElse) {
  const Outcome outcome = outcome_of(R"(
test "x" of Stand() {
  given object(Mine, [1 m, 0 m], id = 1);
  given object(Mine, [2 m, 0 m]);
  given claim(1, 7);
  expect IsValidObject(ClosestObject(UnclaimedObjects(sense_objects())));
}
)");
  EXPECT_TRUE(outcome.has_passed());
}

TEST(ComponentTest, TestWordsMayStillBeNames) {
  text::Diagnostics sink;
  load(std::make_shared<const text::Source>("names.cdl", R"(
assemblage test(given: gain = 1, expect: gain = 1, state: gain = 1, on: gain = 1) -> Vector {
  let no = Noise();
  let action = no;
  cooperate { given * expect * state * on: action; }
}
assemblage after() -> Vector { test() }
)"),
       {}, sink);
  EXPECT_TRUE(sink.items().empty()) << text::render(sink);
}

TEST(Documentation, NamesAllThatTestsMaySay) {
  const text::Result<text::SourcePtr> page =
      text::read_source(base::source_folder() + "/docs/component_tests.md");
  ASSERT_TRUE(page);
  const auto has = [&](std::string_view name) {
    return (*page)->text().find(fmt::format("`{}`", name)) != std::string_view::npos;
  };
  for (const cdl::TestPerceptInfo& one : cdl::kTestPercepts) {
    EXPECT_TRUE(has(one.name)) << one.name;
    for (const cdl::TestInput& input : one.inputs)
      EXPECT_TRUE(has(input.name)) << one.name << " " << input.name;
  }
  for (const cdl::TestAction& one : cdl::test_actions()) EXPECT_TRUE(has(one.name)) << one.name;
}

// Each test can fail: where the component is taken away, most of its tests don't hold any more.
TEST(Library, TestsNoticeABehaviorThatDoesNothing) {
  const text::Result<text::SourcePtr> source =
      text::read_source(base::source_folder() + "/library/assemblages/tests/seek.cdl");
  ASSERT_TRUE(source);
  const std::string text =
      "assemblage KeepOff(sphere: length = 1 m, safety_margin: length = 1 m) -> Vector { Stand() }\n" +
      std::string((*source)->text());
  text::Diagnostics sink;
  const Tests all = tests_in(text, sink);
  std::size_t failed = 0;
  for (const component_test::Test& test : all.tests) failed += run(test, {}).has_passed() ? 0 : 1;
  EXPECT_EQ(failed, 3U) << "those that go away from something";
}

// `mlab test-components library/assemblages/tests`
TEST(Library, DoesWhatTheTestsBesideItSay) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(base::source_folder()) /
                                                               "library/assemblages/tests")) {
    const text::Result<text::SourcePtr> source = text::read_source(entry.path().string());
    ASSERT_TRUE(source) << entry.path();
    text::Diagnostics sink;
    const Tests all = load(*source, {}, sink);
    EXPECT_TRUE(sink.items().empty()) << text::render(sink);
    for (const component_test::Test& test : all.tests) {
      const Outcome outcome = run(test, {});
      ++count;
      EXPECT_TRUE(outcome.has_passed())
          << text::render(told(*outcome.failure)) << testing::PrintToString(findings(*outcome.failure));
    }
  }
  EXPECT_GT(count, 60);
}

}  // namespace
}  // namespace mlab::component_test
