#include "mlab/binding/kinematics.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace mlab::binding {
namespace {

using geom::Offset;
using percept::Action;

constexpr double kPi = std::numbers::pi;

Action towards(double x, double y) {
  Action action;
  action.drives = true;
  action.velocity = {x, y, 0.0};
  return action;
}

Action unicycle(double speed, double turn_rate) {
  Action action = towards(speed, 0.0);
  action.spins = true;
  action.spin = turn_rate;
  return action;
}

WantedMotion drive_from(const Kinematics& k, const Action& action, double heading, double dt,
                        Momentum momentum = {}) {
  return drive(k, action, heading, {std::cos(heading), std::sin(heading)}, momentum, dt);
}

void expect_step(const WantedMotion& motion, double x, double y, double heading) {
  EXPECT_NEAR(motion.step.x, x, 1e-12);
  EXPECT_NEAR(motion.step.y, y, 1e-12);
  EXPECT_NEAR(motion.heading, heading, 1e-12);
}

TEST(Holonomic, GoesWhereTheVelocityPointsAndLooksThere) {
  expect_step(drive_from({}, towards(0, 2), 0.0, 0.5), 0, 1, kPi / 2);
  expect_step(drive_from({}, towards(2, 0), kPi / 2, 0.5), 0, 1, kPi / 2);
}

TEST(Holonomic, KeepsItsHeadingWhereItHardlyMoves) {
  expect_step(drive_from({}, towards(0, 9e-6), 0.3, 0.1), -9e-7 * std::sin(0.3), 9e-7 * std::cos(0.3), 0.3);
}

TEST(Holonomic, TurnsAsItIsToldWhereItSpins) {
  Action action = towards(0, 1);
  action.spins = true;
  action.spin = 2.0;
  expect_step(drive_from({}, action, 0.0, 0.1), 0, 0.1, 0.2);
}

TEST(Holonomic, StandsWhereNothingDrivesIt) {
  Action action = towards(5, 5);
  action.drives = false;
  expect_step(drive_from({}, action, 1.0, 0.1), 0, 0, 1.0);
}

TEST(Holonomic, KeepsItsLimits) {
  Kinematics k;
  k.max_speed = 1.0;
  expect_step(drive_from(k, towards(30, 40), 0.0, 1.0), 0.6, 0.8, std::atan2(4.0, 3.0));
  k.max_acceleration = 0.5;
  const WantedMotion first = drive_from(k, towards(5, 0), 0.0, 1.0);
  expect_step(first, 0.5, 0, 0);
  expect_step(drive_from(k, towards(5, 0), 0.0, 1.0, first.momentum), 1.0, 0, 0);
  k.max_turn_rate = 0.1;
  EXPECT_NEAR(drive_from(k, towards(-5, 1), 0.0, 1.0).heading, 0.1, 1e-12);
  k.max_turn_acceleration = 0.02;
  EXPECT_NEAR(drive_from(k, towards(-5, 1), 0.0, 1.0).heading, 0.02, 1e-12);
}

TEST(Differential, DrivesTheChordOfItsArc) {
  const Kinematics k{.drive = Drive::kDifferential};
  // A quarter of a circle of radius 1.
  expect_step(drive_from(k, unicycle(kPi / 2, kPi / 2), 0.0, 1.0), 1, 1, kPi / 2);
  expect_step(drive_from(k, unicycle(-2, 0), 0.0, 0.5), -1, 0, 0);
  expect_step(drive_from(k, unicycle(0, 1), 0.0, 0.5), 0, 0, 0.5);
}

TEST(Differential, TurnsTowardsAVelocityAndDrivesWhatOfItLiesAhead) {
  Kinematics k{.drive = Drive::kDifferential};
  k.max_turn_rate = 1.0;
  const WantedMotion aside = drive_from(k, towards(0, 3), 0.0, 0.1);
  expect_step(aside, 0, 0, 0.1);
  const WantedMotion behind = drive_from(k, towards(-3, 0), 0.0, 0.1);
  expect_step(behind, 0, 0, 0.1);
  const WantedMotion ahead = drive_from(k, towards(3, 0.003), 0.0, 0.1);
  EXPECT_NEAR(ahead.heading, 0.001, 1e-6);
  EXPECT_NEAR(length(ahead.step), 0.3, 1e-6);
}

TEST(Differential, KeepsTheShapeOfItsWayWhereAWheelIsTooFast) {
  Kinematics k{.drive = Drive::kDifferential};
  k.axle = 0.5;
  k.max_wheel_speed = 1.0;
  const WantedMotion motion = drive_from(k, unicycle(1.0, 4.0), 0.0, 0.1);
  EXPECT_NEAR(motion.momentum.speed, 0.5, 1e-12);
  EXPECT_NEAR(motion.momentum.turn_rate, 2.0, 1e-12);
}

TEST(Differential, GainsSpeedAndTurnsNoFasterThanItsLimits) {
  Kinematics k{.drive = Drive::kDifferential};
  k.max_speed = 1.0;
  k.max_acceleration = 2.0;
  k.max_turn_acceleration = 1.0;
  Momentum momentum;
  for (int i = 1; i <= 8; ++i) {
    const WantedMotion motion = drive_from(k, unicycle(9, 0.5), 0.0, 0.1, momentum);
    momentum = motion.momentum;
    EXPECT_NEAR(momentum.speed, std::min(1.0, 0.2 * i), 1e-12);
    EXPECT_NEAR(momentum.turn_rate, std::min(0.5, 0.1 * i), 1e-12);
  }
}

TEST(Synchro, SteersAndDrivesWithMotorsOfTheirOwn) {
  const Kinematics synchro{.drive = Drive::kSynchro, .max_wheel_speed = 1.0, .max_turn_rate = 2.0};
  const WantedMotion motion = drive_from(synchro, unicycle(3.0, 5.0), 0.0, 0.1);
  EXPECT_NEAR(motion.momentum.speed, 1.0, 1e-12) << "not slowed by turning";
  EXPECT_NEAR(motion.momentum.turn_rate, 2.0, 1e-12);
  expect_step(drive_from(synchro, towards(-1, 0), 0.0, 10.0), 0, 0, kPi);
}

TEST(Car, TurnsNoTighterThanItsSteeringAndNotInPlace) {
  Kinematics k{.drive = Drive::kCar};
  k.wheelbase = 2.0;
  k.max_steer = kPi / 4;  // a circle of radius 2
  const WantedMotion motion = drive_from(k, towards(0, 1), 0.0, 0.1);
  EXPECT_NEAR(motion.heading, 0.1 / 2.0, 1e-12);
  EXPECT_NEAR(length(motion.step), 2 * 2.0 * std::sin(0.025), 1e-12);
  expect_step(drive_from(k, unicycle(0, 5), 0.0, 0.1), 0, 0, 0);
  EXPECT_NEAR(drive_from(k, unicycle(1, 0.2), 0.0, 0.1).heading, 0.02, 1e-12);
}

TEST(Car, ComesRoundToADirectionBehindIt) {
  const Kinematics k{.drive = Drive::kCar};
  double heading = 0.0;
  Momentum momentum;
  for (int i = 0; i < 200; ++i) {
    const double bearing = kPi - heading;
    const WantedMotion motion =
        drive_from(k, towards(std::cos(bearing), std::sin(bearing)), heading, 0.1, momentum);
    heading = motion.heading;
    momentum = motion.momentum;
  }
  EXPECT_NEAR(std::abs(heading), kPi, 1e-6);
}

TEST(Kinematics, AHeadingStaysWithinHalfATurn) {
  const Kinematics k{.drive = Drive::kDifferential};
  EXPECT_NEAR(drive_from(k, unicycle(0, 1), kPi - 0.05, 0.1).heading, -kPi + 0.05, 1e-12);
  EXPECT_LE(std::abs(drive_from(k, unicycle(0, 1e6), 1.0, 0.1).heading), kPi);
}

}  // namespace
}  // namespace mlab::binding
