
#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Vector;

TEST(Teleoperate, IsZeroForACentredStick) {
  flow::BehaviorProbe p = probe("Teleoperate");
  p.percepts.pose.heading = 1.0;
  p.step();
  EXPECT_EQ(geom::length(p.output<Vector>()), 0.0);
}

TEST(Teleoperate, ObeysTheConsole) {
  flow::BehaviorProbe p = probe("Teleoperate");
  p.percepts.pose.heading = kNorth;
  p.percepts.joystick = {.x = 0.0, .y = 0.4, .magnitude = 0.4, .is_robot_frame = true};
  p.step();
  EXPECT_EQ(p.output<Vector>(), (Vector{1.0, 0.0, 0.0}));
  p.percepts.joystick = {.x = 0.4, .y = 0.0, .magnitude = 0.4, .is_robot_frame = false};
  p.step();
  EXPECT_NEAR(p.output<Vector>().y, -1.0, 1e-12);
}

TEST(Teleoperate, ObeysItsInputsBeforeTheConsole) {
  flow::BehaviorProbe p = probe("TELOP");
  p.percepts.pose.heading = kNorth;
  p.percepts.joystick = {.x = 0.4, .y = 0.0, .magnitude = 0.4};
  p.set("x", -1.0).set("telop_mode", 1).step();
  EXPECT_EQ(p.output<Vector>(), (Vector{0.0, 1.0, 0.0}));
}

TEST(GetJoystickMagnitude, IsTheConsolesUnlessSet) {
  flow::BehaviorProbe p = probe("GetJoystickMagnitude");
  p.percepts.joystick.magnitude = 0.4;
  p.step();
  EXPECT_DOUBLE_EQ(p.output<double>(), 0.4);
  p.set("set", 1.0).step();
  EXPECT_DOUBLE_EQ(p.output<double>(), 1.0);
}

TEST(IsTeleoperationComplete, IsForTheConsoleOrAParameterToSay) {
  flow::BehaviorProbe p = probe("IsTeleoperationComplete");
  p.step();
  EXPECT_FALSE(p.output<bool>());
  p.percepts.joystick.complete = true;
  p.step();
  EXPECT_TRUE(p.output<bool>());
  p.percepts.joystick.complete = false;
  p.set("set", true).step();
  EXPECT_TRUE(p.output<bool>());
}

}  // namespace
}  // namespace mlab::library_test
