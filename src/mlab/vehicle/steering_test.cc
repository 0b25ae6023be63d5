#include "mlab/vehicle/steering.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace mlab::vehicle {
namespace {

Limits rover() {
  Limits out;
  out.kinematics.drive = binding::Drive::kDifferential;
  out.kinematics.max_speed = 1.0;
  out.kinematics.max_turn_rate = 0.5;
  out.kinematics.max_acceleration = 2.0;
  out.min_speed = -0.25;
  return out;
}

percept::Action wants(double x, double y) {
  percept::Action out;
  out.drives = true;
  out.velocity = {x, y, 0.0};
  return out;
}

TEST(Steering, CutsToTheVehiclesLimits) {
  EXPECT_EQ(cut_to(rover(), {5.0, -3.0}), (Command{1.0, -0.5}));
  EXPECT_EQ(cut_to(rover(), {-5.0, 0.1}), (Command{-0.25, 0.1}));
  Limits forwards = rover();
  forwards.min_speed = 0.0;
  EXPECT_EQ(cut_to(forwards, {-5.0, 0.1}), (Command{0.0, 0.1}));
}

TEST(Steering, StandsWhereTheCommandIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(cut_to(rover(), {nan, 0.2}), Command{});
  EXPECT_EQ(cut_to(rover(), {0.2, std::numeric_limits<double>::infinity()}), Command{});
  EXPECT_EQ(command_for(rover(), wants(nan, nan), {}, 0.1), Command{});
}

TEST(Steering, StandsWhereNobodyDrives) {
  percept::Action nobody;
  nobody.velocity = {1.0, 0.0, 0.0};
  EXPECT_EQ(command_for(rover(), nobody, {}, 0.1), Command{});
}

TEST(Steering, GathersSpeedAsTheVehicleCan) {
  EXPECT_DOUBLE_EQ(command_for(rover(), wants(1.0, 0.0), {}, 0.1).speed, 0.2);
  EXPECT_DOUBLE_EQ(command_for(rover(), wants(1.0, 0.0), {0.5, 0.0}, 0.1).speed, 0.7);
}

TEST(Steering, TurnsTowardsWhereItIsToGo) {
  EXPECT_DOUBLE_EQ(command_for(rover(), wants(0.0, 1.0), {}, 0.1).turn_rate, 0.5);
  EXPECT_DOUBLE_EQ(command_for(rover(), wants(0.0, -1.0), {}, 0.1).turn_rate, -0.5);
}

TEST(Steering, TurnsNoFasterThanItCanTellHowItTurns) {
  EXPECT_NEAR(command_for(rover(), wants(1.0, 0.08), {}, 0.1).turn_rate, 0.1, 1e-3);
  EXPECT_NEAR(command_for(rover(), wants(1.0, -0.08), {}, 0.1).turn_rate, -0.1, 1e-3);
}

}  // namespace
}  // namespace mlab::vehicle
