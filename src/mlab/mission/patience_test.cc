#include <gtest/gtest.h>

#include "mlab/mission/executive.h"
#include "mlab/mission/testing/toy_fleet.h"

namespace mlab::mission {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the test's own vocabulary

class Patience : public ::testing::Test {
 protected:
  Patience() {
    a_ = maker_.unit("a", 2);
    b_ = maker_.unit("b", 1);
    maker_.step({start(a_, {0, 0}, {0, 10}), start(b_, {0, 50})});
  }
  // The unit a to (100, 5), together with whatever else is wanted.
  ToyFleet& run(double seconds, std::vector<Command> more = {}) {
    more.insert(more.begin(), move_to(a_, "A", {100, 5}));
    maker_.step(std::move(more)).step({stop(b_)});
    fleet_ = std::make_unique<ToyFleet>(maker_.make(), ExecutiveOptions{.patience = 60.0});
    fleet_->send(event::Execute{});
    fleet_->run_cycles(2);
    disturb_(*fleet_);
    fleet_->run(seconds);
    return *fleet_;
  }

  // After the start b goes somewhere, and robot 2 of a is lost; then a has the task, with (100, 5) as its
  // goal.
  std::unique_ptr<ToyFleet> with_one_lost_before(Task task) const {
    MissionMaker maker = maker_;
    UnitCommand whole = command(a_, task, "A", {100, 5});
    whole.radius = 10;
    maker.step({move_to(b_, "B", {10, 50})}).step({whole});
    auto fleet = std::make_unique<ToyFleet>(maker.make(), ExecutiveOptions{.patience = 60.0});
    fleet->send(event::Execute{});
    fleet->run_cycles(2);
    fleet->robot(2).report.is_running = false;
    return fleet;
  }

  MissionMaker maker_;
  std::uint32_t a_ = 0;
  std::uint32_t b_ = 0;
  std::function<void(ToyFleet&)> disturb_ = [](ToyFleet&) {};
  std::unique_ptr<ToyFleet> fleet_;
};

TEST_F(Patience, FailsACommandWithoutProgressAndSaysWhoIsWhereAndWhy) {
  disturb_ = [](ToyFleet& fleet) { fleet.robot(1).is_stuck = fleet.robot(2).is_stuck = true; };
  const ToyFleet& fleet = run(100.0, {move_to(b_, "B", {2000, 50})});
  EXPECT_NEAR(fleet.time(), 60.0, 1.0);
  EXPECT_EQ(fleet.state().outcome, Outcome::kFailed);
  EXPECT_EQ(fleet.state().mode, State::Mode::kIdle);
  EXPECT_EQ(fleet.state().step, 1U) << "Execute tries the step again";
  EXPECT_TRUE(fleet.has_told(
      "step 1: unit a MOVETO A failed: no progress for 60 s; robot 1 at (0.5, 0.0), 99.5 m to go: "
      "no progress; robot 2 at (0.5, 10.0), 99.5 m to go: no progress"))
      << fleet.transcript();
  EXPECT_TRUE(fleet.has_told("step 1: unit b MOVETO B aborted"));
  EXPECT_TRUE(fleet.has_told("step 1 failed\nmission failed at step 1"));
  EXPECT_EQ(fleet.state().steps[1].outcome, Outcome::kFailed);
  EXPECT_EQ(fleet.state().commands[2].outcome, Outcome::kFailed);
  EXPECT_NE(fleet.state().commands[2].message.find("no progress for 60 s"), std::string::npos);
}

TEST_F(Patience, IsNotTriedByTimeInWhichSomebodyElseHoldsAllRobots) {
  disturb_ = [](ToyFleet& fleet) {
    fleet.run_cycles(10);
    fleet.hold(700.0);
  };
  const ToyFleet& fleet = run(100.0);
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone) << fleet.transcript();
  EXPECT_GT(fleet.time(), 700.0);
}

TEST_F(Patience, LastsWhileAnyRobotComesNearer) {
  disturb_ = [](ToyFleet& fleet) {
    fleet.robot(1).is_stuck = true;  // the other one drags their centre to the goal, slowly
    for (const std::uint32_t id : {1U, 2U}) fleet.robot(id).order.order.speed = 0.5;
  };
  EXPECT_EQ(run(1000.0).state().outcome, Outcome::kDone);
}

TEST_F(Patience, CountsOnlyMoreThanACentimetreAsProgress) {
  disturb_ = [](ToyFleet& fleet) {
    for (const std::uint32_t id : {1U, 2U}) fleet.robot(id).order.order.speed = 0.0001;
  };
  EXPECT_EQ(run(1000.0).state().outcome, Outcome::kFailed);
}

TEST_F(Patience, NamesALostRobotAtOnceAndFailsLater) {
  disturb_ = [](ToyFleet& fleet) { fleet.robot(2).reports = false; };
  ToyFleet& fleet = run(5.0);
  EXPECT_TRUE(fleet.has_told("step 1: robot 2 is not running, but `unit a MOVETO A` waits for it"))
      << fleet.transcript();
  fleet.run(200.0);
  EXPECT_EQ(fleet.state().outcome, Outcome::kFailed);
  EXPECT_TRUE(fleet.has_told("lost, it no longer reports")) << fleet.transcript();
  EXPECT_FALSE(fleet.has_told("; robot 1")) << "it is done";
}

TEST_F(Patience, NamesAFault) {
  disturb_ = [](ToyFleet& fleet) { fleet.robot(2).report.is_running = false; };
  EXPECT_TRUE(run(200.0).has_told(
      "robot 2 at (0.5, 10.0), 100.0 m to go: not running, stopped by a fault or a failsafe"))
      << fleet_->transcript();
}

TEST_F(Patience, IsShortWithAUnitOfWhichNobodyIsLeft) {
  disturb_ = [](ToyFleet& fleet) {
    fleet.robot(1).report.is_running = false;
    fleet.robot(2).reports = false;
  };
  ToyFleet& fleet = run(25.0);
  EXPECT_TRUE(fleet.state().in_step) << fleet.transcript();
  fleet.run(10.0);
  EXPECT_NEAR(fleet.time(), 30.0, 1.0);
  EXPECT_TRUE(
      fleet.has_told("unit a MOVETO A failed: none of its robots runs, and nobody replaced one for "
                     "30 s; robot 1 at (0.5, 0.0), 100.0 m to go: not running"))
      << fleet.transcript();
  EXPECT_EQ(fleet.state().commands[2].failure, Failure::kNobodyLeft);
}

TEST_F(Patience, IsShortWithAUnitThatWasStopped) {
  maker_.step({stop(a_)});
  const ToyFleet& fleet = run(25.0);
  EXPECT_TRUE(fleet.state().in_step) << fleet.transcript();
  fleet_->run(10.0);
  EXPECT_NEAR(fleet.time(), 30.0, 1.0);
  EXPECT_TRUE(fleet.has_told("unit a MOVETO A failed: none of its robots runs")) << fleet.transcript();
}

TEST_F(Patience, IsNotGainedByWhoComesNearerWithinThePlaceOfARally) {
  UnitCommand rally = command(a_, Task::kRally, "A", {1000, 5});
  rally.radius = 995;
  maker_.step({rally});
  fleet_ = std::make_unique<ToyFleet>(maker_.make(), ExecutiveOptions{.patience = 60.0});
  fleet_->send(event::Execute{});
  fleet_->run_cycles(2);
  fleet_->robot(2).report.is_running = false;
  fleet_->run(100.0);
  EXPECT_NEAR(fleet_->time(), 60.0, 3.0) << fleet_->transcript();
  EXPECT_TRUE(fleet_->has_told("unit a RALLY A failed: no progress for 60 s")) << fleet_->transcript();
}

TEST_F(Patience, LastsWithOneThatIsReplacedInTime) {
  disturb_ = [](ToyFleet& fleet) {
    fleet.robot(1).report.is_running = fleet.robot(2).report.is_running = false;
  };
  ToyFleet& fleet = run(25.0);
  fleet.robot(1).report.is_running = true;
  fleet.run(25.0);
  EXPECT_TRUE(fleet.state().in_step) << fleet.transcript();
  fleet.robot(2).report.is_running = true;
  fleet.run(100.0);
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone) << fleet.transcript();
}

TEST_F(Patience, IsNotTriedByWhoWasLostBeforeTheCommandBegan) {
  for (const Task task : {Task::kMoveTo, Task::kRally}) {
    const auto made = with_one_lost_before(task);
    ToyFleet& fleet = *made;
    fleet.run(100.0);
    EXPECT_EQ(fleet.state().outcome, Outcome::kDone) << fleet.transcript();
    const std::string text = task == Task::kMoveTo ? "MOVETO" : "RALLY";
    EXPECT_TRUE(fleet.has_told("step 2: robot 2 does not run and is left out of `unit a " + text + " A`"))
        << fleet.transcript();
  }
}

TEST_F(Patience, IsHadAgainWithWhoWasLeftOutAndIsReplaced) {
  for (const Task task : {Task::kMoveTo, Task::kRally}) {
    const auto made = with_one_lost_before(task);
    ToyFleet& fleet = *made;
    ASSERT_TRUE(fleet.run_until([&] { return fleet.state().steps.size() == 3; }, 60.0)) << fleet.transcript();
    fleet.run(2.0);
    fleet.robot(2).report.is_running = true;
    fleet.run_cycles(2);
    EXPECT_TRUE(fleet.has_told("robot 2 runs again and takes part in `unit a")) << fleet.transcript();
    ASSERT_EQ(fleet.state().runs.size(), 1U);
    EXPECT_EQ(fleet.state().runs[0].needed, (std::vector{base::RobotId{1}, base::RobotId{2}}));
    EXPECT_EQ(fleet.state().runs[0].missing, 2U);
    fleet.run(100.0);
    EXPECT_EQ(fleet.state().outcome, Outcome::kDone) << fleet.transcript();
    EXPECT_NEAR(fleet.robot(2).report.pose.position.x, 100.0, 15.0) << "it came, too";
  }
}

TEST_F(Patience, WithoutAnEndLastsAlsoWhereNobodyIsLeft) {
  maker_.step({move_to(b_, "B", {100, 50})});
  fleet_ = std::make_unique<ToyFleet>(maker_.make(), ExecutiveOptions{.patience = 0.0});
  fleet_->send(event::Execute{});
  fleet_->run_cycles(2);
  fleet_->robot(3).report.is_running = false;
  fleet_->run(100.0);
  EXPECT_TRUE(fleet_->state().in_step) << fleet_->transcript();
}

TEST_F(Patience, NamesRobotsThatWereNeverStarted) {
  const auto c = maker_.unit("c", 3);
  const ToyFleet& fleet = run(200.0, {move_to(c, "C", {5, 5})});
  EXPECT_TRUE(
      fleet.has_told("step 1: robots 4, 5 and 6 are not running, but `unit c MOVETO C` waits for them"));
  EXPECT_TRUE(fleet.has_told("unit c MOVETO C failed: no progress for 60 s; robot 4: not started; robot 5"))
      << fleet.transcript();
}

TEST_F(Patience, NamesRobotsThatWereStopped) {
  maker_.step({stop(b_)}).step({move_to(b_, "B", {1, 1})});
  fleet_ = std::make_unique<ToyFleet>(maker_.make(), ExecutiveOptions{.patience = 60.0});
  fleet_->send(event::Execute{});
  fleet_->run(100.0);
  EXPECT_TRUE(fleet_->has_told("robot 3 at (0.0, 50.0): stopped")) << fleet_->transcript();
}

TEST_F(Patience, NamesRobotsThatDoNotStart) {
  fleet_ = std::make_unique<ToyFleet>(maker_.make(), ExecutiveOptions{.patience = 60.0});
  fleet_->robot(2).starts = false;
  fleet_->send(event::Execute{});
  fleet_->run(100.0);
  EXPECT_TRUE(fleet_->has_told(
      "step 0: unit a START StartPlace failed: no progress for 60 s; robot 2: does not start"))
      << fleet_->transcript();
}

TEST_F(Patience, IsNotTriedByRobotsThatFaultedAsTheyStarted) {
  fleet_ = std::make_unique<ToyFleet>(maker_.make(), ExecutiveOptions{.patience = 600.0});
  fleet_->robot(2).faults = true;
  fleet_->send(event::Execute{});
  fleet_->run(5.0);
  EXPECT_TRUE(
      fleet_->has_told("step 0: unit a START StartPlace failed: robot 2 at (0.0, 10.0): not running, "
                       "stopped by a fault or a failsafe"))
      << fleet_->transcript();
  EXPECT_EQ(fleet_->state().outcome, Outcome::kFailed);
}

TEST_F(Patience, IsHadWithRobotsThatAreStillToComeBesideAFaultedOne) {
  fleet_ = std::make_unique<ToyFleet>(maker_.make(), ExecutiveOptions{.patience = 60.0});
  fleet_->robot(1).faults = true;
  fleet_->robot(2).starts = false;
  fleet_->send(event::Execute{});
  fleet_->run(30.0);
  EXPECT_TRUE(fleet_->state().in_step) << fleet_->transcript();
  fleet_->run(60.0);
  EXPECT_TRUE(
      fleet_->has_told("no progress for 60 s; robot 1 at (0.0, 0.0): not running, stopped by "
                       "a fault or a failsafe; robot 2: does not start"))
      << fleet_->transcript();
}

TEST_F(Patience, StartsARobotAnewThatWasStopped) {
  maker_.step({stop(b_)}).step({start(b_)}).step({move_to(b_, "B", {1, 1})});
  fleet_ = std::make_unique<ToyFleet>(maker_.make(), ExecutiveOptions{.patience = 60.0});
  fleet_->send(event::Execute{});
  fleet_->run(100.0);
  EXPECT_EQ(fleet_->state().outcome, Outcome::kDone) << fleet_->transcript();
}

TEST_F(Patience, IsNotTriedByTwoCommandsOfOneStepForTheSameRobots) {
  const auto both = maker_.unit("both", {a_, b_});
  const ToyFleet& fleet = run(200.0, {move_to(both, "B", {10, 50})});
  EXPECT_TRUE(
      fleet.has_told("step 1: robots 1 and 2 are in two commands of this step; the last one, "
                     "`unit both MOVETO B`, has them"));
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone) << fleet.transcript();
}

TEST_F(Patience, NamesARobotThatDoesNotTakeUpItsOrder) {
  disturb_ = [](ToyFleet& fleet) {
    fleet.robot(2).order.order.sequence = 0;
    fleet.robot(2).report.sequence = 77;
  };
  EXPECT_TRUE(run(200.0).has_told("robot 2 at (0.5, 10.0), 100.0 m to go: it has not taken up the order"))
      << fleet_->transcript();
}

TEST_F(Patience, NamesARobotWhoseProgramTellsNothing) {
  disturb_ = [](ToyFleet& fleet) {
    fleet.robot(2).order.order.sequence = 0;
    fleet.robot(2).report.sequence = 0;
  };
  EXPECT_TRUE(run(200.0).has_told("its program does not report on orders")) << fleet_->transcript();
}

TEST_F(Patience, DoesNotRunDuringAPause) {
  disturb_ = [](ToyFleet& fleet) { fleet.send(event::Pause{}); };
  ToyFleet& fleet = run(500.0);
  EXPECT_EQ(fleet.state().outcome, Outcome::kRunning);
  fleet.send(event::Resume{});
  EXPECT_TRUE(fleet.run(100.0));
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
}

TEST_F(Patience, OfZeroNeverEnds) {
  maker_.step({move_to(a_, "A", {100, 5})});
  ToyFleet fleet(maker_.make(), {.patience = 0.0});
  fleet.robot(1).is_stuck = fleet.robot(2).is_stuck = true;
  fleet.send(event::Execute{});
  EXPECT_FALSE(fleet.run(2000.0));
}

TEST_F(Patience, CountsTheRobotsThatAreTooManyToName) {
  MissionMaker m;
  const auto all = m.unit("all", 1000);
  m.step({move_to(all, "A", {1, 1})});
  ToyFleet fleet(m.make(), {.patience = 1.0});
  fleet.send(event::Execute{});
  fleet.run(10.0);
  EXPECT_TRUE(fleet.has_told("robots 1, 2, 3, 4, 5, 6, 7, 8 and 992 more are not running"));
  EXPECT_TRUE(fleet.has_told("; robot 8: not started; and 992 more")) << fleet.transcript();
}

}  // namespace
}  // namespace mlab::mission
