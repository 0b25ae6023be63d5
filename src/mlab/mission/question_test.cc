#include "mlab/mission/question.h"

#include <gtest/gtest.h>

#include "mlab/mission/executive.h"
#include "mlab/mission/testing/toy_fleet.h"

namespace mlab::mission {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the test's own vocabulary

// Two units that occupy a place each, 10 s away, and then stop.
std::shared_ptr<const Mission> occupation(std::optional<MissionTime> until = {}) {
  MissionMaker m;
  const auto a = m.unit("a", 1);
  const auto b = m.unit("b", 1);
  UnitCommand occupy_a = occupy(a, "AA-A", {51, 0});
  UnitCommand occupy_b = occupy(b, "AA-B", {51, 20});
  occupy_a.until = occupy_b.until = until;
  m.step({start(a, {0, 0}), start(b, {0, 20})}).step({occupy_a, occupy_b}).step({stop(a), stop(b)});
  return m.make();
}

// 12:00:00 UTC on 1995-01-17, in a zone five hours west.
ExecutiveOptions at_noon() {
  return {.epoch_seconds = 790344000.0, .zone_offset = -5.0 * 3600.0};
}

TEST(Question, EachUnitInPlaceAsksAndTheStepWaitsForBothAnswers) {
  ToyFleet fleet(occupation());
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run_until([&] { return fleet.questions().size() == 2; }));
  EXPECT_EQ(fleet.questions().at(1).text, "Unit \"a\" is occupying AA-A. Proceed?");
  EXPECT_EQ(fleet.questions().at(2).text, "Unit \"b\" is occupying AA-B. Proceed?");
  EXPECT_EQ(fleet.state().commands[fleet.questions().at(2).command].unit, "b");
  EXPECT_FALSE(fleet.questions().at(1).expires);
  EXPECT_TRUE(awaits_only_operator(fleet.state()));
  fleet.run_cycles(20000);
  fleet.answer(2);
  fleet.run_cycles(10);
  EXPECT_EQ(fleet.state().step, 1U);
  fleet.answer(1);
  EXPECT_EQ(fleet.state().step, 2U) << "the next step starts at once";
  ASSERT_TRUE(fleet.run(1.0));
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
}

TEST(Question, IsNotAskedBeforeTheUnitIsInPlace) {
  ToyFleet fleet(occupation());
  fleet.send(event::Execute{});
  fleet.run_cycles(80);
  EXPECT_TRUE(fleet.questions().empty());
  EXPECT_FALSE(awaits_only_operator(fleet.state()));
  EXPECT_EQ(waits_for(fleet.state()).at(0), "unit a OCCUPY AA-A: 1 of 1 robot");
}

TEST(Question, AnsweredWithAbortStopsEverything) {
  ToyFleet fleet(occupation());
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run_until([&] { return fleet.questions().size() == 2; }));
  fleet.answer(1, false);
  EXPECT_EQ(fleet.state().outcome, Outcome::kAborted);
  EXPECT_EQ(fleet.state().mode, State::Mode::kIdle);
  EXPECT_EQ(fleet.state().step, 0U);
  EXPECT_TRUE(fleet.questions().empty()) << "the other one is withdrawn";
  EXPECT_FALSE(fleet.robot(1).report.is_running);
  EXPECT_FALSE(fleet.robot(2).report.is_running);
  EXPECT_TRUE(fleet.has_told("mission aborted"));
}

TEST(Question, IsAnsweredWithYesAtOnceWhereAllAre) {
  ToyFleet fleet(occupation(), {.proceed_all = true});
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run(20.0));
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
  EXPECT_EQ(fleet.count<effect::Ask>(), 0);
  EXPECT_TRUE(fleet.has_told("Unit \"a\" is occupying AA-A. Proceed? yes"));
}

TEST(Question, AnswersItselfWhenTheTimeoutIsOver) {
  ToyFleet fleet(occupation(MissionTime{MissionTime::Kind::kSinceReached, 10.0}));
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run_until([&] { return fleet.questions().size() == 2; }));
  const double in_place = fleet.time();
  EXPECT_NEAR(fleet.questions().at(1).expires.value_or(0.0), in_place + 10.0, 1e-9);
  EXPECT_FALSE(awaits_only_operator(fleet.state())) << "time moves it on, too";
  ASSERT_TRUE(fleet.run_until([&] { return fleet.questions().empty(); }));
  EXPECT_NEAR(fleet.time() - in_place, 10.0, 0.11);
  EXPECT_EQ(fleet.state().step, 2U);
  EXPECT_EQ(fleet.count<effect::Withdraw>(), 2);
}

TEST(Question, WithTimeoutZeroIsNotAsked) {
  ToyFleet fleet(occupation(MissionTime{MissionTime::Kind::kSinceReached, 0.0}));
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run(20.0));
  EXPECT_EQ(fleet.count<effect::Ask>(), 0);
}

TEST(Question, AnswersItselfAtATimeOfDayOfTheMissionClock) {
  // The clock shows 7:00:00 at the start.
  ToyFleet fleet(occupation(MissionTime{MissionTime::Kind::kOfDay, 7 * 3600 + 60.0}), at_noon());
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run(100.0));
  EXPECT_NEAR(fleet.time(), 60.0, 0.3);
  EXPECT_TRUE(fleet.has_told("unit a OCCUPY AA-A: it is 07:01:00, proceeds by itself"));
}

TEST(Question, IsNotAskedWhenTheTimeIsPast) {
  for (const MissionTime past :
       {MissionTime{MissionTime::Kind::kOfDay, 3600.0}, MissionTime{MissionTime::Kind::kAbsolute, 1000.0},
        MissionTime{MissionTime::Kind::kSinceStart, 5.0}}) {
    ToyFleet fleet(occupation(past), at_noon());
    fleet.send(event::Execute{});
    ASSERT_TRUE(fleet.run(20.0));
    EXPECT_EQ(fleet.count<effect::Ask>(), 0);
  }
}

TEST(Question, DoesNotAnswerItselfDuringAPause) {
  ToyFleet fleet(occupation(MissionTime{MissionTime::Kind::kSinceReached, 10.0}));
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run_until([&] { return fleet.questions().size() == 2; }));
  fleet.send(event::Pause{});
  fleet.run_cycles(200);
  EXPECT_EQ(fleet.questions().size(), 2U);
  fleet.send(event::Resume{});
  fleet.cycle();
  EXPECT_TRUE(fleet.questions().empty());
}

TEST(Question, ThatNobodyAskedIsIgnored) {
  ToyFleet fleet(occupation());
  fleet.send(event::Execute{});
  const State before = fleet.state();
  fleet.answer(77);
  fleet.answer(77, false);
  EXPECT_EQ(fleet.state(), before);
}

TEST(Teleoperation, LastsUntilTheOperatorEndsIt) {
  MissionMaker m;
  const auto a = m.unit("a", 1);
  m.step({start(a)}).step({command(a, Task::kTeleoperate, "X", {50, 0})}).step({stop(a)});
  ToyFleet fleet(m.make(), {.patience = 5.0});
  fleet.send(event::Execute{});
  fleet.run_cycles(200);
  EXPECT_EQ(fleet.count<effect::OpenTeleoperation>(), 1);
  EXPECT_EQ(fleet.state().step, 1U) << "teleoperation may take any time";
  fleet.send(event::TeleoperationComplete{0});
  EXPECT_EQ(fleet.state().step, 1U);
  fleet.send(event::TeleoperationComplete{1});
  EXPECT_EQ(fleet.state().step, 2U);
  ASSERT_TRUE(fleet.run(1.0));
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
}

TEST(Teleoperation, EndsWhenTheRobotsSaySo) {
  MissionMaker m;
  const auto a = m.unit("a", 1);
  m.step({start(a)}).step({command(a, Task::kTeleoperate, "X", {50, 0})});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  fleet.run_cycles(5);
  fleet.robot(1).report.done = true;
  ASSERT_TRUE(fleet.run(1.0));
}

TEST(Teleoperation, IsTakenAsCompleteWhereNobodyIsAsked) {
  MissionMaker m;
  const auto a = m.unit("a", 1);
  m.step({start(a)}).step({command(a, Task::kTeleoperate, "X", {50, 0})});
  ToyFleet fleet(m.make(), {.proceed_all = true});
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run(1.0));
  EXPECT_TRUE(fleet.has_told("nobody steers, taken as complete"));
  EXPECT_EQ(fleet.count<effect::OpenTeleoperation>(), 0) << "nobody is to be waited for";
}

}  // namespace
}  // namespace mlab::mission
