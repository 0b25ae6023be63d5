
#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Point;
using geom::Vector;

TEST(GlobalToEgocentric, ShiftsAndTurns) {
  flow::BehaviorProbe p = probe("GlobalToEgocentric");
  p.set("global", Point{10.0, 25.0})
      .set("robot_location", Point{10.0, 20.0})
      .set("robot_heading", kNorth)
      .step();
  expect_near(p.output<Vector>(), {5.0, 0.0});
  p.set("robot_heading", 0.0).step();
  expect_near(p.output<Vector>(), {0.0, 5.0});
}

TEST(DetectGoal, TurnsWithTheRobot) {
  flow::BehaviorProbe p = probe("DETECT_GOAL_WITH_SHAFT_ENCODERS");
  p.percepts.pose = {{1.0, 1.0}, kNorth};
  p.set("goal", Point{1.0, 8.0}).step();
  expect_near(p.output<Vector>(), {7.0, 0.0});
}

TEST(ProjectGoal, KeepsThePlaceThatItProjectedWhenItStarted) {
  flow::BehaviorProbe p = probe("ProjectGoal");
  p.percepts.pose = {{1.0, 1.0}, kNorth};
  p.set("angle", kNorth).set("distance", 10.0).step();
  const Point place = p.output<Point>();
  EXPECT_NEAR(place.x, -9.0, 1e-9);
  EXPECT_NEAR(place.y, 1.0, 1e-9);
  p.percepts.pose = {{50.0, 50.0}, 0.0};
  p.step();
  EXPECT_EQ(p.output<Point>(), place);
  p.skip();
  p.step();
  EXPECT_NEAR(p.output<Point>().y, 60.0, 1e-9);
}

}  // namespace
}  // namespace mlab::library_test
