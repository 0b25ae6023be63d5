#include <gtest/gtest.h>

#include <algorithm>

#include "mlab/mission/executive.h"
#include "mlab/mission/testing/toy_fleet.h"

namespace mlab::mission {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the test's own vocabulary
UnitCommand for_robots(std::vector<base::RobotId> robots, UnitCommand c) {
  c.unit = kNoUnit;
  c.robots = std::move(robots);
  return c;
}

// Units a (robots 1 and 2) and b (robots 3 and 4), each 20 s away from its goal in step 1.
class Orders : public ::testing::Test {
 protected:
  Orders() {
    a_ = maker_.unit("a", 2);
    b_ = maker_.unit("b", 2);
    both_ = maker_.unit("both", {a_, b_});
    maker_.step("0", {start(both_)});
    maker_.step("1", {move_to(a_, "A", {100, 10}), move_to(b_, "B", {100, 50})});
    maker_.step("2", {move_to(a_, "C", {200, 10}), move_to(b_, "D", {200, 50})});
    make();
  }
  void make(const ExecutiveOptions& options = {}) {
    fleet_ = std::make_unique<ToyFleet>(maker_.make(), options);
  }
  void start_and_reach(std::uint32_t step) {
    fleet_->send(event::Execute{});
    ASSERT_TRUE(fleet_->run_until([&] { return fleet_->state().step == step; }));
  }
  void order(std::vector<Command> commands) { fleet_->send(event::Typed{std::move(commands)}); }
  const State& state() const { return fleet_->state(); }
  bool reaches(const std::function<bool()>& holds) { return fleet_->run_until(holds); }
  geom::Point goal(std::uint32_t robot) { return fleet_->robot(robot).order.order.goal; }
  Outcome outcome(std::string_view text) const {
    for (const CommandRecord& command : state().commands)
      if (command.text == text) return command.outcome;
    return Outcome::kPending;
  }

  MissionMaker maker_;
  std::uint32_t a_ = 0;
  std::uint32_t b_ = 0;
  std::uint32_t both_ = 0;
  std::unique_ptr<ToyFleet> fleet_;
};

TEST_F(Orders, AnOrderEndsOnlyTheCommandOfItsUnit) {
  start_and_reach(1);
  const std::uint32_t sequence = fleet_->robot(3).order.order.sequence;
  order({move_to(a_, "X", {50, 100})});
  EXPECT_EQ(outcome("unit a MOVETO A"), Outcome::kReplaced);
  EXPECT_EQ(outcome("unit b MOVETO B"), Outcome::kRunning);
  EXPECT_EQ(fleet_->robot(3).order.order.sequence, sequence) << "it is told nothing";
  EXPECT_EQ(state().steps[1].outcome, Outcome::kRunning);
  EXPECT_EQ(state().step, 1U);
  EXPECT_EQ(waits_for(state()),
            (std::vector<std::string>{"unit b MOVETO B: 2 of 2 robots", "unit a MOVETO X: 2 of 2 robots"}));
  EXPECT_TRUE(fleet_->has_told("step 1: unit a MOVETO A replaced: by `unit a MOVETO X`"));
}

TEST_F(Orders, WhatGotDoneInAPauseEndsWithExecuteAlsoWhereNoStepIsLeft) {
  fleet_->send(event::Execute{});
  ASSERT_TRUE(fleet_->run());
  maker_.mission().steps.clear();
  fleet_->send(event::Edited{maker_.make()});
  order({move_to(a_, "X", {50, 100})});
  fleet_->send(event::Pause{});
  event::Cycle cycle{.time = fleet_->time() + 1.0, .robots = {}};
  for (const std::uint32_t id : {1U, 2U}) {
    RobotReport report = fleet_->robot(id).report;
    report.sequence = fleet_->robot(id).order.order.sequence;
    report.done = true;
    cycle.robots.push_back(report);
  }
  fleet_->send(cycle);
  EXPECT_EQ(outcome("unit a MOVETO X"), Outcome::kRunning) << "nothing ends in a pause";
  fleet_->send(event::Execute{});
  EXPECT_EQ(outcome("unit a MOVETO X"), Outcome::kDone);
  EXPECT_EQ(state().mode, State::Mode::kIdle);
}

TEST_F(Orders, TheStepWaitsForWhatIsLeftOfItAndThePlanNeverTakesRobotsOutOfAnOrder) {
  start_and_reach(1);
  order({move_to(a_, "X", {50, 500})});
  ASSERT_TRUE(reaches([&] { return state().step == 2; }));
  EXPECT_EQ(outcome("unit b MOVETO B"), Outcome::kDone);
  EXPECT_TRUE(fleet_->has_told("step 1 done as far as orders left it"));
  EXPECT_EQ(goal(3), (geom::Point{200, 50})) << "unit b goes on with the plan";
  EXPECT_EQ(goal(1), (geom::Point{50, 500})) << "unit a with its order";
  EXPECT_EQ(waits_for(state()).at(1), "unit a MOVETO C: the order `unit a MOVETO X`");
  ASSERT_TRUE(reaches([&] { return outcome("unit a MOVETO X") == Outcome::kDone; }));
  EXPECT_EQ(goal(1), (geom::Point{200, 10})) << "then the plan's command begins";
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(state().outcome, Outcome::kDone);
}

TEST_F(Orders, TheStepGoesOnAtOnceWhenNothingIsLeftOfIt) {
  start_and_reach(1);
  order({move_to(both_, "X", {50, 500})});
  EXPECT_EQ(state().step, 2U);
  EXPECT_EQ(state().steps[1].outcome, Outcome::kDone);
  EXPECT_TRUE(fleet_->has_told("step 1 done: orders took all of it"));
  EXPECT_EQ(goal(1), (geom::Point{50, 500})) << "the next step waits for the order";
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(state().outcome, Outcome::kDone);
  EXPECT_TRUE(fleet_->has_told("typed: unit both MOVETO X done"));
}

TEST_F(Orders, SeveralOrdersLiveSideBySide) {
  start_and_reach(1);
  order({move_to(a_, "X", {50, 300})});
  order({move_to(b_, "Y", {300, 50})});
  EXPECT_EQ(outcome("unit a MOVETO X"), Outcome::kRunning);
  EXPECT_EQ(outcome("unit b MOVETO Y"), Outcome::kRunning);
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(outcome("unit a MOVETO X"), Outcome::kDone);
  EXPECT_EQ(outcome("unit b MOVETO Y"), Outcome::kDone);
}

TEST_F(Orders, AnOrderTakesTheUnitFromAnEarlierOne) {
  start_and_reach(1);
  order({move_to(a_, "X", {50, 300}), move_to(b_, "Y", {300, 50})});
  order({move_to(a_, "Z", {0, 100})});
  EXPECT_EQ(outcome("unit a MOVETO X"), Outcome::kReplaced);
  EXPECT_EQ(outcome("unit b MOVETO Y"), Outcome::kRunning);
  order({move_to(b_, "W", {0, 0})});
  EXPECT_EQ(outcome("unit b MOVETO Y"), Outcome::kReplaced);
  EXPECT_TRUE(fleet_->has_told("typed commands done") || fleet_->has_told("typed commands replaced"));
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(state().outcome, Outcome::kDone);
}

TEST_F(Orders, ARobotThatIsOrderedAwayLeavesItsUnitsCommandToTheOthers) {
  start_and_reach(1);
  order({for_robots({{2}}, move_to(0, "X", {50, 300}))});
  EXPECT_EQ(outcome("unit a MOVETO A"), Outcome::kRunning);
  EXPECT_TRUE(fleet_->has_told("step 1: unit a MOVETO A goes on without robot 2: `robot 2 MOVETO X`"));
  EXPECT_EQ(fleet_->robot(1).order.members, (std::vector<base::RobotId>{{1}}));
  EXPECT_EQ(goal(2), (geom::Point{50, 300}));
  ASSERT_TRUE(reaches([&] { return outcome("unit a MOVETO A") == Outcome::kDone; }));
  EXPECT_LE(geom::distance(fleet_->position(1), {100, 10}), 1.0) << "alone its place is the goal itself";
  ASSERT_TRUE(reaches([&] { return outcome("robot 2 MOVETO X") == Outcome::kDone; }));
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(fleet_->robot(2).order.members, (std::vector<base::RobotId>{{1}, {2}}))
      << "the plan's next command has the whole unit again";
}

TEST_F(Orders, RobotsOfSeveralUnitsAreAUnitForAsLongAsTheOrderLasts) {
  start_and_reach(1);
  UnitCommand in_line = for_robots({{4}, {2}, {1}}, move_to(0, "X", {50, 300}));
  in_line.formation = percept::Formation::kLine;
  order({in_line});
  EXPECT_EQ(fleet_->robot(1).order.members, (std::vector<base::RobotId>{{4}, {2}, {1}})) << "in rank order";
  EXPECT_EQ(outcome("unit a MOVETO A"), Outcome::kReplaced) << "nobody is left of it";
  EXPECT_EQ(outcome("unit b MOVETO B"), Outcome::kRunning);
  const auto record = std::ranges::find(state().commands, "robots 4, 2, 1", &CommandRecord::unit);
  ASSERT_NE(record, state().commands.end());
  EXPECT_EQ(record->text, "robots 4, 2, 1 MOVETO X (Line)");
}

TEST_F(Orders, InOneStepARobotMayBeSentElsewhereThanItsUnit) {
  maker_.mission().steps[1].commands = {move_to(both_, "A", {100, 10}),
                                        for_robots({{3}}, move_to(0, "Y", {0, 60}))};
  make();
  start_and_reach(1);
  EXPECT_EQ(goal(3), (geom::Point{0, 60}));
  EXPECT_EQ(fleet_->robot(1).order.members, (std::vector<base::RobotId>{{1}, {2}, {4}}));
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(state().outcome, Outcome::kDone);
  EXPECT_FALSE(fleet_->has_told("two commands"));
}

TEST_F(Orders, OfTwoCommandsOfAStepTheLastOneHasTheRobotAlsoWhereTheFirstHadToWait) {
  maker_.mission().steps[2].commands = {move_to(both_, "A", {100, 10}),
                                        for_robots({{3}}, move_to(0, "Y", {0, 60}))};
  make();
  start_and_reach(1);
  order({move_to(a_, "X", {50, 500})});
  ASSERT_TRUE(reaches([&] { return state().step == 2; }));
  EXPECT_EQ(goal(3), (geom::Point{0, 60}));
  ASSERT_TRUE(reaches([&] { return outcome("unit a MOVETO X") == Outcome::kDone; }));
  EXPECT_EQ(goal(3), (geom::Point{0, 60}));
  EXPECT_EQ(fleet_->robot(1).order.members, (std::vector<base::RobotId>{{1}, {2}, {4}}));
}

TEST_F(Orders, WhoHasReachedTheEndOfAnOrderStaysThereUntilACommandNamesIt) {
  maker_.mission().steps.pop_back();
  make();
  start_and_reach(1);
  order({for_robots({{2}}, move_to(0, "X", {0, 60}))});
  ASSERT_TRUE(fleet_->run());
  fleet_->run_cycles(100);
  EXPECT_LE(geom::distance(fleet_->position(2), {0, 60}), 1.0);
  EXPECT_EQ(standing_orders(state()).size(), 3U);
}

TEST_F(Orders, RobotsThatDoNotRunAreLeftOutAndNamed) {
  const auto c = maker_.unit("c", 1);
  make();
  start_and_reach(1);
  order({for_robots({{1}, {5}}, move_to(0, "X", {50, 30}))});
  EXPECT_TRUE(fleet_->has_told("typed: robot 5 does not run and is left out of `robots 1, 5 MOVETO X`"));
  ASSERT_TRUE(reaches([&] { return outcome("robots 1, 5 MOVETO X") == Outcome::kDone; }));
  order({move_to(c, "X", {50, 30})});
  EXPECT_EQ(outcome("unit c MOVETO X"), Outcome::kFailed);
  EXPECT_TRUE(fleet_->has_told("typed: unit c MOVETO X failed: robot 5 does not run"));
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(state().outcome, Outcome::kDone) << "the mission has nothing to do with it";
}

TEST_F(Orders, StartedAndOrderedInOneBreath) {
  const auto c = maker_.unit("c", 1);
  make();
  order({start(c), move_to(c, "X", {30, 0})});
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(outcome("unit c MOVETO X"), Outcome::kDone);
}

TEST_F(Orders, AStartOfRobotsThatRunTakesThemFromNothing) {
  start_and_reach(1);
  order({start(a_, {500, 500})});
  EXPECT_EQ(outcome("unit a MOVETO A"), Outcome::kRunning);
  EXPECT_EQ(goal(1), (geom::Point{100, 10}));
}

TEST_F(Orders, AQuestionOfACommandThatIsTakenAwayIsWithdrawn) {
  maker_.step("3", {occupy(a_, "P", {210, 10}), occupy(b_, "Q", {210, 50})});
  make();
  start_and_reach(3);
  ASSERT_TRUE(reaches([&] { return fleet_->questions().size() == 2; }));
  order({move_to(a_, "X", {200, 100})});
  ASSERT_EQ(fleet_->questions().size(), 1U);
  EXPECT_EQ(fleet_->questions().begin()->second.text, "Unit \"b\" is occupying Q. Proceed?");
  fleet_->answer(fleet_->questions().begin()->first);
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(state().outcome, Outcome::kDone) << "the mission is done when the order is";
  EXPECT_TRUE(fleet_->has_told("no step is left; the mission is done when the orders under way are"));
  EXPECT_EQ(outcome("unit a MOVETO X"), Outcome::kDone);
}

TEST_F(Orders, RobotsAreAskedForByTheirNumbers) {
  start_and_reach(1);
  order({for_robots({{1}, {2}, {3}}, occupy(0, "X", {50, 10}))});
  ASSERT_TRUE(reaches([&] { return !fleet_->questions().empty(); }));
  EXPECT_EQ(fleet_->questions().begin()->second.text, "Robots 1-3 are occupying X. Proceed?");
}

TEST_F(Orders, AnOrderThatFailsLeavesTheMissionAlone) {
  make({.patience = 30.0});
  start_and_reach(1);
  fleet_->robot(1).is_stuck = fleet_->robot(2).is_stuck = true;
  order({move_to(a_, "X", {50, 300})});
  ASSERT_TRUE(reaches([&] { return outcome("unit a MOVETO X") == Outcome::kFailed; }));
  EXPECT_EQ(state().mode, State::Mode::kRunning);
  EXPECT_EQ(outcome("unit a MOVETO C"), Outcome::kRunning) << "it waited for the order's end";
  EXPECT_EQ(goal(1), (geom::Point{200, 10}));
}

TEST_F(Orders, JumpAndSingleStepEndTheStepAndLeaveOrdersAlone) {
  start_and_reach(1);
  order({move_to(a_, "X", {50, 500})});
  fleet_->send(event::SingleStep{});
  EXPECT_EQ(state().step, 2U);
  EXPECT_EQ(outcome("unit b MOVETO B"), Outcome::kSkipped);
  EXPECT_EQ(outcome("unit a MOVETO X"), Outcome::kRunning);
  fleet_->send(event::Rewind{});
  EXPECT_EQ(state().mode, State::Mode::kRunning) << "the order is under way";
  EXPECT_EQ(outcome("unit a MOVETO C"), Outcome::kSkipped);
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(outcome("unit a MOVETO X"), Outcome::kDone);
  EXPECT_EQ(state().step, 0U);
}

TEST_F(Orders, AbortEndsThemAll) {
  start_and_reach(1);
  order({move_to(a_, "X", {50, 500})});
  fleet_->send(event::Abort{});
  EXPECT_EQ(outcome("unit a MOVETO X"), Outcome::kAborted);
  EXPECT_EQ(outcome("unit b MOVETO B"), Outcome::kAborted);
  EXPECT_EQ(state().mode, State::Mode::kIdle);
  EXPECT_EQ(fleet_->count<effect::Stop>(), 4);
}

TEST_F(Orders, OutsideOfARunTheyLeaveThePlanWhereItIs) {
  fleet_->send(event::SingleStep{});
  ASSERT_TRUE(fleet_->run());
  order({move_to(a_, "X", {50, 100})});
  order({move_to(b_, "Y", {50, 0})});
  ASSERT_TRUE(fleet_->run());
  EXPECT_EQ(state().step, 1U);
  EXPECT_EQ(state().outcome, Outcome::kRunning);
  EXPECT_LE(geom::distance(fleet_->position(1), {50, 100}), 11.0);
}

TEST_F(Orders, AStickForRobotsOfTwoUnitsIsPutDownByItself) {
  start_and_reach(1);
  order({for_robots({{1}}, command(0, Task::kTeleoperate, "P"))});
  order({for_robots({{3}}, command(0, Task::kTeleoperate, "P"))});
  EXPECT_EQ(fleet_->count<effect::OpenTeleoperation>(), 2);
  EXPECT_EQ(outcome("robot 1 TELEOPERATE P"), Outcome::kRunning);
  const auto second = std::ranges::find(state().commands, "robot 3", &CommandRecord::unit);
  fleet_->send(event::TeleoperationComplete{static_cast<std::uint32_t>(second - state().commands.begin())});
  EXPECT_EQ(outcome("robot 3 TELEOPERATE P"), Outcome::kDone);
  EXPECT_EQ(outcome("robot 1 TELEOPERATE P"), Outcome::kRunning);
}

TEST_F(Orders, UntilEndsACommandThatTakesTimeAndItsRobotsHoldWhereTheyAre) {
  UnitCommand until = move_to(a_, "F", {900, 10});
  until.until = MissionTime{MissionTime::Kind::kSinceReached, 10.0};
  maker_.mission().steps[1].commands = {until};
  make();
  start_and_reach(1);
  const double begin = fleet_->time();
  ASSERT_TRUE(reaches([&] { return state().step == 2; }));
  EXPECT_NEAR(fleet_->time() - begin, 10.0, 0.2);
  EXPECT_EQ(outcome("unit a MOVETO F"), Outcome::kDone);
  EXPECT_TRUE(fleet_->has_told("done by UNTIL"));
}

TEST_F(Orders, UntilEndsTeleoperationAndHaltsWhoIsUnderWay) {
  UnitCommand stick = command(a_, Task::kTeleoperate, "P");
  stick.until = MissionTime{MissionTime::Kind::kSinceReached, 5.0};
  UnitCommand far = move_to(b_, "F", {900, 10});
  far.until = stick.until;
  maker_.mission().steps.pop_back();
  maker_.mission().steps[1].commands = {stick, far};
  make();
  start_and_reach(1);
  ASSERT_TRUE(fleet_->run(10.0));
  EXPECT_EQ(state().outcome, Outcome::kDone);
  EXPECT_TRUE(fleet_->robot(3).order.order.halted);
  const geom::Point there = fleet_->position(3);
  fleet_->run_cycles(50);
  EXPECT_EQ(fleet_->position(3), there);
}

TEST_F(Orders, UntilIsLongerThanPatience) {
  make({.patience = 20.0});
  UnitCommand far = move_to(a_, "F", {900, 10});
  far.until = MissionTime{MissionTime::Kind::kSinceStart, 100.0};
  maker_.mission().steps[1].commands = {far};
  make({.patience = 20.0});
  start_and_reach(1);
  fleet_->robot(1).is_stuck = fleet_->robot(2).is_stuck = true;
  ASSERT_TRUE(reaches([&] { return state().step == 2; }));
  EXPECT_NEAR(fleet_->time(), 100.0, 0.3);
  EXPECT_FALSE(awaits_only_operator(state()));
}

}  // namespace
}  // namespace mlab::mission
