
#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Vector;

TEST(MoveAhead, PointsToADirectionOfTheWorld) {
  flow::BehaviorProbe p = probe("MoveAhead");
  p.percepts.pose.heading = kNorth;
  p.set("heading", 0.0).step();
  EXPECT_NEAR(p.output<Vector>().x, 0.0, 1e-12);
  EXPECT_NEAR(p.output<Vector>().y, -1.0, 1e-12);
  p.set("heading", kNorth).step();
  EXPECT_NEAR(p.output<Vector>().x, 1.0, 1e-12);
}

TEST(MoveForward, PointsToWhereTheRobotLooks) {
  flow::BehaviorProbe p = probe("MoveForward");
  p.step();
  EXPECT_EQ(p.output<Vector>(), (Vector{1.0, 0.0, 0.0}));
  p.set("amount", -0.5).step();
  EXPECT_EQ(p.output<Vector>(), (Vector{-0.5, 0.0, 0.0}));
}

TEST(Stand, WantsNothing) {
  flow::BehaviorProbe p = probe("NOOP");
  p.step();
  EXPECT_EQ(p.output<Vector>(), Vector{});
}

}  // namespace
}  // namespace mlab::library_test
