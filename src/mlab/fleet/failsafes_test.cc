#include "mlab/fleet/failsafes.h"

#include <cmath>

#include <gtest/gtest.h>

#include "mlab/fleet/testing/failsafe_row.h"

namespace mlab::fleet {
namespace {

using mission::Failsafe;
using mission::FailsafeAction;
using mission::FailsafeCondition;
using testing::row;

constexpr double kCycle = 0.1;

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

TEST(Failsafes, HoldWhoActsOnPerceptsThatAreTooOldUntilTheyAreNot) {
  Robot robot({row(FailsafeCondition::kPerceptsStale, FailsafeAction::kHold, 0.5)});
  robot.situation.percept_age = 0.4;
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(robot.step().triggered) << "late, and always as much";
  robot.situation.percept_age = 0.6;
  EXPECT_EQ(robot.step().triggered, 0U) << "they are as old as they are, however long one looks";
  EXPECT_FALSE(robot.action.drives);
  robot.situation.percept_age = 0.0;
  EXPECT_TRUE(robot.step().is_over);
}

TEST(Failsafes, HoldTheRobotOfAVehicleThatHasNotSaidForTooLongWhereItIs) {
  Robot robot({row(FailsafeCondition::kPerceptsStale, FailsafeAction::kHold, 1.0)});
  robot.situation.vehicle = binding::Upkeep{.motion_age = 0.4};
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(robot.step().triggered) << "in time, and always as late";
  robot.situation.vehicle->motion_age = 0.9;
  EXPECT_FALSE(robot.step().triggered);
  robot.situation.vehicle->motion_age = 1.0;
  EXPECT_EQ(robot.step().triggered, 0U);
  robot.situation.vehicle->motion_age = 0.1;
  EXPECT_TRUE(robot.step().is_over);
}

Failsafe below(double share, double seconds) {
  Failsafe out = row(FailsafeCondition::kBattery, FailsafeAction::kHold, seconds);
  out.share = share;
  return out;
}

TEST(Failsafes, HoldWhoseBatteryIsBelowTheShareUntilItWasCharged) {
  Robot robot({below(0.3, 0.25)});
  robot.situation.vehicle = binding::Upkeep{.battery = 0.3};
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(robot.step().triggered) << "not below";
  robot.situation.vehicle->battery = 0.29;
  EXPECT_FALSE(robot.step().triggered);
  EXPECT_FALSE(robot.step().triggered);
  EXPECT_EQ(robot.step().triggered, 0U);
  EXPECT_FALSE(robot.action.drives);
  robot.situation.vehicle->battery = 0.34;
  EXPECT_FALSE(robot.step().is_over) << "without its load it reads more, and is as empty as before";
  robot.situation.vehicle->battery = 0.35;
  EXPECT_TRUE(robot.step().is_over);
}

TEST(Failsafes, TakeABatteryThatIsNotToldOfForOneWithTooLittle) {
  for (const std::optional<double> told : {std::optional<double>(), std::optional<double>(0.9)}) {
    Robot robot({below(0.3, 0.0)});
    robot.situation.vehicle = binding::Upkeep{.battery = told, .battery_age = Situation::kBatteryPatience};
    EXPECT_FALSE(robot.step().triggered) << "it may still tell";
    robot.situation.vehicle->battery_age += 0.1;
    EXPECT_EQ(robot.step().triggered, 0U);
    EXPECT_LT(robot.failsafes.standing(0, robot.situation, robot.action, kCycle, robot.state).measure, 0.0);
    robot.situation.vehicle = binding::Upkeep{.battery = 0.9, .battery_age = 0.0};
    EXPECT_TRUE(robot.step().is_over);
  }
}

TEST(Failsafes, LookAtNoBatteryOfABodyThatIsMadeUp) {
  Robot robot({below(1.0, 0.0)});
  for (int i = 0; i < 200; ++i) EXPECT_FALSE(robot.step().triggered);
}

TEST(Failsafes, OfABatteryTellHowNearItIsToTheShare) {
  Robot robot({below(0.3, 0.0)});
  const auto standing = [&](double battery) {
    robot.situation.vehicle = binding::Upkeep{.battery = battery};
    robot.step();
    return robot.failsafes.standing(0, robot.situation, robot.action, kCycle, robot.state);
  };
  EXPECT_EQ(standing(0.9).used, 0.0);
  EXPECT_NEAR(standing(0.45).used, 0.25, 1e-9);
  EXPECT_EQ(standing(0.45).measure, 0.45);
  EXPECT_EQ(standing(0.45).state, RowStanding::State::kArmed);
  EXPECT_EQ(standing(0.35).state, RowStanding::State::kNear);
  EXPECT_EQ(standing(0.25).state, RowStanding::State::kActive);
}

TEST(Failsafes, HoldWhomNobodySteersUntilSomebodyTakesTheStick) {
  Robot robot({row(FailsafeCondition::kOperatorAbsent, FailsafeAction::kReturn, 0.25)});
  robot.situation.home = {50, 0};
  robot.situation.lacks_operator = true;
  EXPECT_FALSE(robot.step().triggered);
  EXPECT_FALSE(robot.step().triggered);
  EXPECT_EQ(robot.step().triggered, 0U);
  EXPECT_LT(robot.action.velocity.y, 0.0) << "home";
  robot.situation.lacks_operator = false;
  EXPECT_FALSE(robot.step().is_over) << "the stick is held in its middle";
  robot.situation.is_steered = true;
  EXPECT_TRUE(robot.step().is_over);
  EXPECT_EQ(robot.action.velocity, (geom::Vector{1.0, 0.0, 0.0}));
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

TEST(Failsafes, OfWhichTwoLookForStuckRobotsLetOneDriveThatGetsOn) {
  Robot robot({row(FailsafeCondition::kStuck, FailsafeAction::kContinue, 6.0),
               row(FailsafeCondition::kStuck, FailsafeAction::kStop, 2.0)});
  for (int i = 0; i < 200; ++i) {
    ASSERT_FALSE(robot.step().triggered) << i;
    robot.situation.motion.pose.position.x += 0.1;
  }
  int cycles = 0;
  while (!robot.step().triggered && cycles < 100) ++cycles;
  EXPECT_NEAR(cycles * kCycle, 2.0, 0.5) << "it gets on no more";
}

TEST(Failsafes, OfLowerRankActWhenTheHigherOneIsOver) {
  Robot robot({row(FailsafeCondition::kInContact, FailsafeAction::kContinue),
               row(FailsafeCondition::kOutside, FailsafeAction::kHold)});
  robot.situation.is_in_contact = true;
  EXPECT_EQ(robot.step().triggered, 0U);
  robot.situation.motion.pose.position.x = 99.75;
  EXPECT_FALSE(robot.step().triggered) << "the first one acts";
  robot.situation.is_in_contact = false;
  const Failsafes::Outcome outcome = robot.step();
  EXPECT_TRUE(outcome.is_over);
  EXPECT_EQ(outcome.triggered, 1U) << "it came to the line meanwhile";
  EXPECT_FALSE(robot.action.drives);
}

TEST(Failsafes, GiveWayToOneOfHigherRankAndActAgain) {
  Robot robot({row(FailsafeCondition::kInContact, FailsafeAction::kHold),
               row(FailsafeCondition::kOutside, FailsafeAction::kReverseInside)});
  robot.situation.motion.pose.position.x = 99.75;
  EXPECT_EQ(robot.step().triggered, 1U);
  robot.situation.is_in_contact = true;
  const Failsafes::Outcome outcome = robot.step();
  EXPECT_EQ(outcome.triggered, 0U);
  EXPECT_EQ(outcome.gave_way, 1U);
  EXPECT_FALSE(robot.action.drives);
  robot.situation.is_in_contact = false;
  EXPECT_EQ(robot.step().triggered, 1U);
  EXPECT_TRUE(robot.action.drives);
}

TEST(Failsafes, AreForgottenWithTheOrderUnderWhichTheyWaited) {
  Robot robot({row(FailsafeCondition::kInContact, FailsafeAction::kHold),
               row(FailsafeCondition::kStuck, FailsafeAction::kHold, 0.5)});
  for (int i = 0; i < 10; ++i) robot.step();
  EXPECT_EQ(robot.state.active, 1U);
  robot.situation.is_in_contact = true;
  EXPECT_EQ(robot.step().gave_way, 1U);
  robot.situation.order = 2;
  EXPECT_TRUE(robot.step().is_over);
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(robot.step().triggered) << "it drives out of it";
}

TEST(Failsafes, LetInWhoBeginsOutside) {
  Robot robot({row(FailsafeCondition::kOutside, FailsafeAction::kHold)});
  robot.situation.motion.pose.position.x = 110;
  const Failsafes::Outcome first = robot.step(-1.0);
  EXPECT_EQ(first.outside, 0U);
  EXPECT_FALSE(first.triggered);
  EXPECT_TRUE(robot.action.drives) << "nearer";
  EXPECT_FALSE(robot.step(1.0).outside) << "told once";
  EXPECT_FALSE(robot.action.drives) << "not away";
  robot.situation.motion.pose.position.x = 50;
  EXPECT_FALSE(robot.step(1.0).triggered);
  robot.situation.motion.pose.position.x = 99.75;
  EXPECT_EQ(robot.step(1.0).triggered, 0U) << "it was inside";
}

TEST(Failsafes, ReverseInsideFromBesideTheLine) {
  for (const binding::Drive drive : {binding::Drive::kDifferential, binding::Drive::kCar}) {
    Robot robot({row(FailsafeCondition::kOutside, FailsafeAction::kReverseInside)});
    robot.kinematics.drive = drive;
    // It looks along the upper line, and its program wants over it.
    Motion& motion = robot.situation.motion;
    motion.pose = {{50, 59.75}, 0.0};
    for (int i = 0; i < 400; ++i) {
      robot.situation.kinematics = &robot.kinematics;
      robot.situation.passage = &robot.nothing;
      robot.action = {};
      robot.action.drives = robot.action.spins = true;
      robot.action.velocity = {1.0, 0.0, 0.0};
      robot.action.spin = 3.0;
      robot.failsafes.guard(robot.situation, kCycle, robot.state, robot.action);
      const double heading = motion.pose.heading;
      const binding::WantedMotion moved =
          binding::drive(robot.kinematics, robot.action, heading, {std::cos(heading), std::sin(heading)},
                         motion.momentum, kCycle);
      motion = {{motion.pose.position + moved.step, moved.heading}, moved.momentum};
      ASSERT_LE(motion.pose.position.y, 59.8 + 1e-6);
    }
    EXPECT_NEAR(motion.pose.position.y, 56.8, 0.1);
  }
}

TEST(Failsafes, KnowWhatIsInTheWayOfARobotThatTheyDrive) {
  Robot robot({row(FailsafeCondition::kOutside, FailsafeAction::kReturn)});
  robot.kinematics.max_acceleration = 2.0;
  robot.situation.kinematics = &robot.kinematics;
  robot.situation.cruise_speed = 10.0;
  robot.situation.motion.pose.position.x = 80;
  EXPECT_GT(robot.failsafes.passage_reach(robot.situation, percept::Action{}, kCycle), 25.0)
      << "its program stands, and it would go home at ten metres a second";
  robot.situation.cruise_speed = 1.0;
  EXPECT_EQ(robot.failsafes.passage_reach(robot.situation, percept::Action{}, kCycle), 0.0);
}

// ---- how rows stand

using State = RowStanding::State;

State state_of(const Robot& robot, std::size_t row) {
  return robot.failsafes.standing(row, robot.situation, robot.action, kCycle, robot.state).state;
}

TEST(RowsOfFailsafes, GoFromArmedOverNearToActive) {
  Robot robot({row(FailsafeCondition::kInContact, FailsafeAction::kHold, 1.0)});
  robot.step();
  EXPECT_EQ(state_of(robot, 0), State::kArmed);
  robot.situation.is_in_contact = true;
  for (int i = 0; i < 4; ++i) robot.step();
  EXPECT_EQ(state_of(robot, 0), State::kArmed);
  robot.step();
  const RowStanding half = robot.failsafes.standing(0, robot.situation, robot.action, kCycle, robot.state);
  EXPECT_EQ(half.state, State::kNear);
  EXPECT_NEAR(half.used, 0.5, 1e-9);
  EXPECT_NEAR(half.measure, 0.5, 1e-9);
  for (int i = 0; i < 6; ++i) robot.step();
  EXPECT_EQ(state_of(robot, 0), State::kActive);
  robot.situation.is_in_contact = false;
  robot.step();
  EXPECT_EQ(state_of(robot, 0), State::kArmed);
}

TEST(RowsOfFailsafes, AreNearToAFenceByTheWayThatTheBodyNeedsToStop) {
  Robot robot({row(FailsafeCondition::kOutside, FailsafeAction::kHold)});
  robot.kinematics.max_acceleration = 1.0;
  const auto at = [&](double x, double speed) {
    robot.situation.motion = {{{x, 30}, 0.0}, {{speed, 0.0}, speed, 0.0}};
    robot.step(speed);
    return robot.failsafes.standing(0, robot.situation, robot.action, kCycle, robot.state);
  };
  EXPECT_EQ(at(90, 0.1).state, State::kArmed);
  EXPECT_EQ(at(90, 4.0).state, State::kNear) << "8 m to brake";
  EXPECT_NEAR(at(80, 4.0).used, (8.0 + 0.8 + 0.5) / 19.8, 1e-9);
  EXPECT_NEAR(at(80, 4.0).measure, 19.8, 1e-9) << "between its body and the line";
  EXPECT_EQ(at(99.75, 0.1).state, State::kNear);
  EXPECT_EQ(at(99.79, 0.5).state, State::kActive);
}

TEST(RowsOfFailsafes, WaitWhileAHigherOneActsAndAreOverruledByAnOrder) {
  Robot robot({row(FailsafeCondition::kInContact, FailsafeAction::kHold),
               row(FailsafeCondition::kLinkLost, FailsafeAction::kHold, 1.0)});
  robot.situation.is_in_contact = true;
  robot.situation.silence = 2.0;
  robot.step();
  EXPECT_EQ(state_of(robot, 0), State::kActive);
  EXPECT_EQ(state_of(robot, 1), State::kWaiting);
  robot.situation.order = 2;
  robot.step();
  EXPECT_EQ(state_of(robot, 0), State::kOverruled);
  EXPECT_EQ(state_of(robot, 1), State::kOverruled);
  robot.situation.rows = 0b01;
  EXPECT_EQ(state_of(robot, 1), State::kOthers);
}

}  // namespace
}  // namespace mlab::fleet
