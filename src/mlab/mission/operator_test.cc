#include "mlab/mission/operator.h"

#include <gtest/gtest.h>

#include "mlab/mission/executive.h"
#include "mlab/mission/testing/toy_fleet.h"

namespace mlab::mission {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the test's own vocabulary

// Two robots and four steps: start, and three moves of about 20 s each.
class Operator : public ::testing::Test {
 protected:
  Operator() {
    a_ = maker_.unit("a", 1);
    b_ = maker_.unit("b", 1);
    both_ = maker_.unit("both", {a_, b_});
    maker_.step("0", {start(both_)});
    maker_.step("1", {move_to(both_, "A", {100, 10})});
    maker_.step("2", {move_to(both_, "B", {200, 10})});
    maker_.step("3", {move_to(both_, "C", {300, 10})});
    fleet_ = std::make_unique<ToyFleet>(maker_.make());
  }
  void start_and_reach(std::uint32_t step) {
    fleet_->send(event::Execute{});
    ASSERT_TRUE(fleet_->run_until([&] { return fleet_->state().step == step; }));
  }
  const State& state() const { return fleet_->state(); }

  MissionMaker maker_;
  std::uint32_t a_ = 0;
  std::uint32_t b_ = 0;
  std::uint32_t both_ = 0;
  std::unique_ptr<ToyFleet> fleet_;
};

TEST_F(Operator, PausesAndResumesTheRobots) {
  start_and_reach(1);
  fleet_->send(event::Pause{});
  EXPECT_TRUE(fleet_->is_paused());
  const geom::Point before = fleet_->position(1);
  fleet_->run_cycles(50);
  EXPECT_EQ(fleet_->position(1), before);
  fleet_->send(event::Resume{});
  EXPECT_FALSE(fleet_->is_paused());
  EXPECT_TRUE(fleet_->run());
  EXPECT_EQ(state().outcome, Outcome::kDone);
}

TEST_F(Operator, GoesOnWithExecuteAfterAPauseWithoutANewOrder) {
  start_and_reach(1);
  fleet_->send(event::Pause{});
  const auto sequence = state().last_sequence;
  fleet_->send(event::Execute{});
  EXPECT_FALSE(state().paused);
  EXPECT_EQ(state().last_sequence, sequence);
  EXPECT_EQ(state().step, 1U);
}

TEST_F(Operator, SingleStepOutsideARunDoesOneStep) {
  fleet_->send(event::SingleStep{});
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(state().step, 1U);
  EXPECT_EQ(state().mode, State::Mode::kIdle);
  fleet_->send(event::SingleStep{});
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(state().step, 2U);
  EXPECT_NEAR(fleet_->position(1).x, 100.0, 2.0);
}

TEST_F(Operator, SingleStepInARunAbandonsTheStepAndGoesOn) {
  start_and_reach(1);
  fleet_->send(event::SingleStep{});
  EXPECT_EQ(state().step, 2U);
  EXPECT_EQ(state().steps[1].outcome, Outcome::kSkipped);
  EXPECT_EQ(state().commands[1].outcome, Outcome::kSkipped);
  EXPECT_EQ(fleet_->robot(1).order.order.goal, (geom::Point{200, 10}));
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(state().outcome, Outcome::kDone);
}

TEST_F(Operator, SingleStepOverTheLastStepEndsTheMission) {
  start_and_reach(3);
  fleet_->send(event::SingleStep{});
  EXPECT_EQ(state().mode, State::Mode::kIdle);
  EXPECT_EQ(state().outcome, Outcome::kDone);
  EXPECT_TRUE(fleet_->has_told("step 3 skipped\nmission done"));
}

TEST_F(Operator, StopAfterStepFinishesTheStepThatRunsAndStops) {
  start_and_reach(1);
  fleet_->send(event::StopAfterStep{});
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(state().steps[1].outcome, Outcome::kDone);
  EXPECT_EQ(state().step, 2U);
  EXPECT_EQ(state().mode, State::Mode::kIdle);
  EXPECT_EQ(state().outcome, Outcome::kRunning);
}

TEST_F(Operator, StopAfterStepLetsAnOrderFinishAndGoesOnWithNothing) {
  start_and_reach(1);
  fleet_->send(event::Typed{{move_to(a_, "X", {50, 900})}});
  fleet_->send(event::StopAfterStep{});
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(state().steps[1].outcome, Outcome::kDone);
  EXPECT_TRUE(fleet_->has_told("typed: unit a MOVETO X done"));
  EXPECT_EQ(state().step, 2U);
  EXPECT_EQ(state().mode, State::Mode::kIdle);
}

TEST_F(Operator, StopAfterStepOutsideARunChangesNothing) {
  fleet_->send(event::StopAfterStep{});
  fleet_->send(event::Execute{});
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(state().outcome, Outcome::kDone);
}

TEST_F(Operator, ExecuteDuringASingleStepMakesItARun) {
  fleet_->send(event::SingleStep{});
  fleet_->send(event::Execute{});
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(state().outcome, Outcome::kDone);
}

TEST_F(Operator, JumpsToAStepAndStartsItInARun) {
  start_and_reach(1);
  fleet_->send(event::Jump{3});
  EXPECT_EQ(fleet_->robot(1).order.order.goal, (geom::Point{300, 10}));
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(state().outcome, Outcome::kDone);
}

TEST_F(Operator, JumpsOutsideARunWithoutStartingAnything) {
  fleet_->send(event::Jump{2});
  EXPECT_EQ(state().step, 2U);
  EXPECT_EQ(state().mode, State::Mode::kIdle);
  fleet_->send(event::Jump{99});
  EXPECT_EQ(state().step, 2U);
  EXPECT_TRUE(fleet_->has_told("there is no such step to go to"));
}

TEST_F(Operator, RewindsAndLeavesTheRobotsTheirCommand) {
  start_and_reach(2);
  fleet_->send(event::Rewind{});
  EXPECT_EQ(state().step, 0U);
  EXPECT_EQ(state().mode, State::Mode::kIdle);
  EXPECT_EQ(fleet_->count<effect::Stop>(), 0);
  EXPECT_EQ(standing_orders(state()).size(), 1U);
}

TEST_F(Operator, AbortsUnpausesStopsAllAndRewinds) {
  start_and_reach(2);
  fleet_->send(event::Pause{});
  fleet_->send(event::Abort{});
  EXPECT_FALSE(fleet_->is_paused());
  EXPECT_EQ(fleet_->count<effect::Stop>(), 2);
  EXPECT_EQ(state().outcome, Outcome::kAborted);
  EXPECT_EQ(state().step, 0U);
  EXPECT_TRUE(state().groups.empty());
  EXPECT_EQ(state().steps.back().outcome, Outcome::kAborted);
}

TEST_F(Operator, RunsTheMissionAgainRightAfterAnAbort) {
  start_and_reach(2);
  fleet_->send(event::Abort{});
  fleet_->send(event::Execute{});
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(state().outcome, Outcome::kDone);
}

TEST_F(Operator, ATypedOccupyAsksItsOwnQuestion) {
  fleet_->send(event::Typed{{start(both_)}});
  fleet_->cycle();
  fleet_->send(event::Typed{{occupy(a_, "X", {50, 100})}});
  ASSERT_TRUE(fleet_->run_until([&] { return !fleet_->questions().empty(); }));
  EXPECT_EQ(fleet_->questions().at(1).text, "Unit \"a\" is occupying X. Proceed?");
  fleet_->answer(1);
  EXPECT_EQ(state().mode, State::Mode::kIdle);
}

TEST_F(Operator, ARobotsOwnQuestionWaitsForItsAnswerBeyondTheStep) {
  start_and_reach(1);
  fleet_->send(event::RobotAsks{{1}});
  fleet_->send(event::RobotAsks{{1}});
  ASSERT_EQ(fleet_->questions().size(), 1U) << "once is enough";
  EXPECT_FALSE(awaits_only_operator(state())) << "the other robot still drives";
  EXPECT_EQ(fleet_->questions().at(1).text, "Robot 1 asks whether it may go on. Proceed?");
  ASSERT_TRUE(fleet_->run_until([&] { return state().step == 2; }));
  EXPECT_EQ(fleet_->questions().size(), 1U);
  fleet_->answer(1);
  EXPECT_EQ(fleet_->count<effect::LetProceed>(), 1);
  EXPECT_TRUE(state().questions.empty());
  EXPECT_TRUE(fleet_->run());
  EXPECT_EQ(state().outcome, Outcome::kDone);
}

TEST_F(Operator, NoToARobotsQuestionAbortsTheMission) {
  start_and_reach(1);
  fleet_->send(event::RobotAsks{{2}});
  fleet_->send(event::RobotAsks{{1}});
  EXPECT_TRUE(awaits_only_operator(state()));
  fleet_->answer(1, false);
  EXPECT_EQ(fleet_->count<effect::LetProceed>(), 0);
  EXPECT_EQ(state().outcome, Outcome::kAborted);
}

TEST_F(Operator, NobodyIsAskedForARobotThatHasStopped) {
  start_and_reach(1);
  fleet_->send(event::RobotAsks{{1}});
  fleet_->send(event::RobotAsks{{2}});
  fleet_->send(event::Typed{{stop(a_)}});
  ASSERT_EQ(fleet_->questions().size(), 1U);
  EXPECT_EQ(fleet_->questions().begin()->second.robot, base::RobotId{2});
}

TEST_F(Operator, ATypedSetActsBesideTheStepThatRuns) {
  start_and_reach(1);
  fleet_->send(event::Typed{{SetBoolean{}, Print{}}});
  EXPECT_EQ(fleet_->count<effect::Set>(), 1);
  EXPECT_EQ(fleet_->count<effect::Print>(), 1);
  EXPECT_EQ(state().step, 1U);
  EXPECT_EQ(state().steps.back().outcome, Outcome::kRunning);
}

TEST_F(Operator, ATypedQuitEndsTheRun) {
  start_and_reach(1);
  fleet_->send(event::Typed{{Quit{}}});
  EXPECT_EQ(fleet_->count<effect::Quit>(), 1);
  EXPECT_EQ(state().mode, State::Mode::kQuit);
  EXPECT_EQ(state().commands[1].outcome, Outcome::kAborted);
}

TEST_F(Operator, ATypedCommandForAnUnknownUnitIsRefused) {
  start_and_reach(1);
  fleet_->send(event::Typed{{move_to(77, "X", {})}});
  EXPECT_TRUE(fleet_->has_told("typed: no such unit"));
  EXPECT_EQ(state().step, 1U);
}

TEST_F(Operator, ATypedRouteOutlivesTheEvent) {
  start_and_reach(1);
  {
    UnitCommand follow = command(both_, Task::kFollow, "R");
    follow.route = {{0, 10}, {60, 60}};
    fleet_->send(event::Typed{{follow}});
  }
  ASSERT_EQ(fleet_->robot(1).order.order.route.size(), 2U);
  EXPECT_EQ(fleet_->robot(1).order.order.route[1], (geom::Point{60, 60}));
  ASSERT_TRUE(fleet_->run_until([&] { return fleet_->has_told("typed: unit both FOLLOW R done"); }));
}

TEST_F(Operator, AnEditedPlanGoesOnWithTheStepOfTheSameLabel) {
  start_and_reach(1);
  MissionMaker edited = maker_;
  auto& steps = edited.mission().steps;
  steps.insert(steps.begin() + 1,
               Step{.label = "0a", .commands = {move_to(both_, "Z", {1, 1})}, .place = {}});
  std::get<UnitCommand>(steps[3].commands[0]).goal = {200, 50};
  fleet_->send(event::Edited{edited.make()});
  EXPECT_EQ(state().step, 2U);
  EXPECT_EQ(state().mode, State::Mode::kRunning);
  ASSERT_TRUE(fleet_->run_until([&] { return state().step == 3; }));
  EXPECT_EQ(fleet_->robot(1).order.order.goal, (geom::Point{200, 50}));
}

TEST_F(Operator, AnEditThatRemovesTheStepThatRunsStopsTheExecution) {
  start_and_reach(1);
  MissionMaker edited = maker_;
  edited.mission().steps.erase(edited.mission().steps.begin() + 1);
  fleet_->send(event::Edited{edited.make()});
  EXPECT_EQ(state().mode, State::Mode::kIdle);
  EXPECT_TRUE(fleet_->has_told("step 1 is no longer in the plan; execution stops"));
  EXPECT_EQ(state().step, 1U);
  fleet_->send(event::Execute{});
  EXPECT_EQ(fleet_->robot(1).order.order.goal, (geom::Point{200, 10}));
}

TEST_F(Operator, AnEditMayAddRobotsAndReorderUnits) {
  start_and_reach(1);
  MissionMaker edited = maker_;
  const auto c = edited.unit("c", 1);
  std::swap(edited.mission().units[a_], edited.mission().units[c]);
  edited.mission().steps.push_back({.label = "9", .commands = {start(a_, {7, 7})}, .place = {}});
  fleet_->send(event::Edited{edited.make()});
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(state().outcome, Outcome::kDone) << fleet_->transcript();
  EXPECT_EQ(fleet_->position(3), (geom::Point{7, 7}));
}

}  // namespace
}  // namespace mlab::mission
