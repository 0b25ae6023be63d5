#include "mlab/fleet/failsafes.h"

#include <gtest/gtest.h>

namespace mlab::fleet {
namespace {

using mission::Failsafe;
using mission::FailsafeAction;
using mission::FailsafeCondition;

constexpr double kCycle = 0.1;

Failsafe row(FailsafeCondition condition, FailsafeAction action, double seconds = 0.0) {
  Failsafe out;
  out.condition = condition;
  out.action = action;
  out.seconds = seconds;
  if (condition == FailsafeCondition::kOutside) {
    out.fence_name = "Field";
    out.fence = {{0, 0}, {100, 0}, {100, 60}, {0, 60}};
  }
  return out;
}

// A robot in the middle of nowhere, whose program wants to go east.
struct Robot {
  Failsafes failsafes;
  binding::Kinematics kinematics;
  FailsafeState state;
  Situation situation;
  percept::Action action;
  binding::Passage nothing;

  explicit Robot(const std::vector<Failsafe>& rows) : failsafes(rows) {
    situation.motion.pose.position = {50, 30};
    situation.radius = 0.2;
    situation.order = 1;
  }
  Failsafes::Outcome step(double speed = 1.0) {
    situation.kinematics = &kinematics;
    situation.passage = &nothing;
    action = {};
    action.drives = true;
    action.velocity = {speed, 0.0, 0.0};
    action.status.sequence = 1;
    return failsafes.guard(situation, kCycle, state, action);
  }
};

TEST(Failsafes, LetEverythingThroughWhereNothingIsWrong) {
  Robot robot({row(FailsafeCondition::kOutside, FailsafeAction::kHold),
               row(FailsafeCondition::kInContact, FailsafeAction::kStop),
               row(FailsafeCondition::kLinkLost, FailsafeAction::kReturn, 5.0)});
  const Failsafes::Outcome outcome = robot.step();
  EXPECT_FALSE(outcome.triggered || outcome.is_over);
  EXPECT_EQ(robot.action.velocity, (geom::Vector{1.0, 0.0, 0.0}));
}

TEST(Failsafes, HoldUntilTheConditionIsOver) {
  Robot robot({row(FailsafeCondition::kInContact, FailsafeAction::kHold, 0.25)});
  robot.situation.is_in_contact = true;
  EXPECT_FALSE(robot.step().triggered);
  EXPECT_FALSE(robot.step().triggered);
  EXPECT_TRUE(robot.action.drives) << "it has not held for long enough";
  EXPECT_EQ(robot.step().triggered, 0U);
  EXPECT_FALSE(robot.action.drives);
  EXPECT_EQ(robot.action.status.sequence, 1U) << "what it says of its order goes on";
  EXPECT_FALSE(robot.step().triggered) << "told once";
  robot.situation.is_in_contact = false;
  EXPECT_TRUE(robot.step().is_over);
  EXPECT_TRUE(robot.action.drives);
}

TEST(Failsafes, DoNotHoldWhoWasGivenAnotherOrderUntilTheConditionWasOver) {
  for (const bool is_steered : {false, true}) {
    Robot robot({row(FailsafeCondition::kInContact, FailsafeAction::kHold)});
    robot.situation.is_in_contact = true;
    EXPECT_TRUE(robot.step().triggered);
    robot.situation.order = is_steered ? 1 : 2;
    robot.situation.is_steered = is_steered;
    EXPECT_TRUE(robot.step().is_over);
    for (int i = 0; i < 100; ++i) EXPECT_FALSE(robot.step().triggered);
    EXPECT_TRUE(robot.action.drives) << "it drives out of it";
    robot.situation.is_in_contact = false;
    robot.step();
    robot.situation.is_in_contact = true;
    robot.situation.is_steered = false;
    EXPECT_TRUE(robot.step().triggered) << "it met something anew";
  }
}

TEST(Failsafes, OfSeveralTheHighestRankActs) {
  Robot robot({row(FailsafeCondition::kLinkLost, FailsafeAction::kReturn, 1.0),
               row(FailsafeCondition::kInContact, FailsafeAction::kHold)});
  robot.situation.home = {50, 0};
  robot.situation.is_in_contact = true;
  EXPECT_EQ(robot.step().triggered, 1U);
  EXPECT_FALSE(robot.action.drives);
  robot.situation.silence = 1.1;
  EXPECT_EQ(robot.step().triggered, 0U);
  EXPECT_TRUE(robot.action.drives);
  EXPECT_LT(robot.action.velocity.y, 0.0) << "home";
  robot.situation.silence = 0.0;
  EXPECT_FALSE(robot.step().is_over) << "it goes home all the same";
}

TEST(Failsafes, OfOtherRobotsAreNotTheirs) {
  Failsafe of_scouts = row(FailsafeCondition::kInContact, FailsafeAction::kStop);
  of_scouts.types = {"scout"};
  Robot robot({of_scouts, row(FailsafeCondition::kInContact, FailsafeAction::kHold)});
  robot.situation.is_in_contact = true;
  robot.situation.rows = robot.failsafes.rows_of("ROBOT");
  EXPECT_EQ(robot.step().triggered, 1U);
  robot.state = {};
  robot.situation.rows = robot.failsafes.rows_of("scout");
  EXPECT_EQ(robot.step().triggered, 0U);
}

TEST(Failsafes, AreStuckWhereTheyWantToDriveAndCantGetOn) {
  Robot robot({row(FailsafeCondition::kStuck, FailsafeAction::kHold, 2.0)});
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(robot.step(0.0).triggered) << "it does not want to";
  int cycles = 0;
  while (!robot.step().triggered && cycles < 100) ++cycles;
  EXPECT_NEAR(cycles * kCycle, 2.0, 0.2);
  Robot other({row(FailsafeCondition::kStuck, FailsafeAction::kHold, 2.0)});
  for (int i = 0; i < 100; ++i) {
    EXPECT_FALSE(other.step().triggered) << "it gets on";
    other.situation.motion.pose.position.x += 0.1;
  }
}

TEST(Failsafes, HoldBeforeAFenceUntilTheProgramTurnsBack) {
  Robot robot({row(FailsafeCondition::kOutside, FailsafeAction::kHold)});
  robot.situation.motion.pose.position.x = 99.75;
  EXPECT_EQ(robot.step().triggered, 0U);
  EXPECT_FALSE(robot.action.drives);
  for (int i = 0; i < 50; ++i) {
    const Failsafes::Outcome outcome = robot.step(0.1);
    EXPECT_FALSE(outcome.triggered || outcome.is_over) << "it does not tremble at the line";
  }
  EXPECT_TRUE(robot.step(-1.0).is_over);
  EXPECT_TRUE(robot.action.drives);
}

TEST(Failsafes, GoOnAtAFenceAndAreHeldBackAllTheSame) {
  Robot robot({row(FailsafeCondition::kOutside, FailsafeAction::kContinue)});
  robot.situation.motion.pose.position.x = 99.75;
  EXPECT_TRUE(robot.step().triggered);
  EXPECT_FALSE(robot.action.drives);
}

TEST(Failsafes, ReverseInsideBackwardsWhereTheyLookOut) {
  Robot robot({row(FailsafeCondition::kOutside, FailsafeAction::kReverseInside)});
  robot.kinematics.drive = binding::Drive::kCar;
  robot.situation.motion.pose.position.x = 99.75;
  robot.step();
  EXPECT_TRUE(robot.action.drives && robot.action.spins);
  EXPECT_LT(robot.action.velocity.x, 0.0);
  EXPECT_EQ(robot.action.spin, 0.0);
  robot.situation.motion.pose.position.x = 96.5;
  robot.step(-1.0);
  EXPECT_FALSE(robot.action.drives) << "far enough: it waits for an order";
}

TEST(Failsafes, ReturnPastWhatIsInTheWay) {
  Robot robot({row(FailsafeCondition::kInContact, FailsafeAction::kReturn)});
  robot.situation.home = {90, 30};
  robot.situation.is_in_contact = true;
  const std::vector<percept::Obstacle> ahead = {{{1.5, 0.1, 0.0}, 0.5}};
  robot.step();
  robot.situation.obstacles = ahead;
  robot.step();
  EXPECT_LT(robot.action.velocity.y, -0.1);
  EXPECT_LE(geom::length(robot.action.velocity), robot.situation.cruise_speed + 1e-9);
}

}  // namespace
}  // namespace mlab::fleet
