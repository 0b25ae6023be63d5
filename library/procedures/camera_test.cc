#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"
#include "mlab/base/angle.h"

namespace mlab::library_test {
namespace {

using base::radians;
using geom::Vector;
using percept::ObjectReading;
using std::numbers::pi;

TEST(LookTo, TurnsTheCameraAndGivesTheDirection) {
  for (const double pan : {0.0, 1.0, -2.5}) {
    flow::BehaviorProbe p = probe("LookTo");
    p.set("pan", pan).set("tilt", 0.5).step();
    EXPECT_TRUE(p.action.looks);
    EXPECT_NEAR(p.action.pan, pan, 1e-12);
    EXPECT_NEAR(std::atan2(p.output<Vector>().y, p.output<Vector>().x), pan, 1e-12);
    EXPECT_NEAR(p.output<Vector>().z, std::tan(0.5), 1e-12);
  }
}

TEST(LookAt, FollowsTheObject) {
  flow::BehaviorProbe p = probe("LookAt");
  p.set("object", ObjectReading{.id = {3}, .center = {-2, 2}}).step();
  EXPECT_TRUE(p.action.looks);
  EXPECT_NEAR(p.action.pan, 0.75 * pi, 1e-12);
}

TEST(LookAt, LeavesTheCameraWhereThereIsNoObject) {
  flow::BehaviorProbe p = probe("LookAt");
  p.set("object", ObjectReading{}).step();
  EXPECT_FALSE(p.action.looks);
  EXPECT_EQ(p.output<Vector>(), Vector{});
}

TEST(LookAt, LeavesTheCameraWhereTheObjectIsTheRobotsOwnPlace) {
  flow::BehaviorProbe p = probe("LookAt");
  p.set("object", ObjectReading{.id = {3}, .center = {}}).step();
  EXPECT_FALSE(p.action.looks);
}

// How far to both sides a camera that stops at `stop` gets in a minute.
std::pair<double, double> swept(double half_angle, double stop) {
  flow::BehaviorProbe p = probe("LookAround");
  p.set("speed", 1.0).set("half_angle", half_angle);
  double least = 0.0;
  double most = 0.0;
  for (int cycle = 0; cycle < 600; ++cycle) {
    p.step();
    EXPECT_LE(std::abs(p.action.pan - p.percepts.camera.pan), 0.1 + 1e-9);
    p.percepts.camera.pan = std::clamp(p.action.pan, -stop, stop);
    least = std::min(least, p.percepts.camera.pan);
    most = std::max(most, p.percepts.camera.pan);
  }
  return {least, most};
}

TEST(LookAround, SweepsFromSideToSide) {
  const auto [least, most] = swept(radians(60), pi);
  EXPECT_NEAR(least, radians(-60), 1e-6);
  EXPECT_NEAR(most, radians(60), 1e-6);
}

TEST(LookAround, TurnsBackWhereTheCameraStops) {
  const auto [least, most] = swept(radians(90), radians(45));
  EXPECT_NEAR(least, radians(-45), 1e-6);
  EXPECT_NEAR(most, radians(45), 1e-6);
}

TEST(GetPan, TellsWhereTheCameraLooks) {
  flow::BehaviorProbe p = probe("GetPan");
  p.percepts.camera.pan = 0.3;
  p.step();
  EXPECT_EQ(p.output<double>(), 0.3);
}

TEST(PanTilt, TurnsTheCameraUnlessThereIsNoDirection) {
  for (const char* name : {"PanTilt", "PANTILT", "PANTILTZOOM"}) {
    flow::BehaviorProbe p = probe(name);
    p.set("look", Vector{}).step();
    EXPECT_FALSE(p.action.looks);
    p.set("look", Vector{0, -3, 0}).step();
    EXPECT_TRUE(p.action.looks);
    EXPECT_NEAR(p.action.pan, -pi / 2, 1e-12);
  }
}

}  // namespace
}  // namespace mlab::library_test
