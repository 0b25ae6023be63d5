#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Vector;

Vector move_to_goal(Vector goal, double success_radius) {
  flow::BehaviorProbe p = probe("MoveToGoal");
  p.set("goal", goal).set("success_radius", success_radius).step();
  return p.output<Vector>();
}

TEST(MoveToGoal, PullsStraightToTheGoalWithFullStrength) {
  EXPECT_EQ(move_to_goal({3.0, 4.0}, 1.0), (Vector{0.6, 0.8, 0.0}));
  EXPECT_EQ(move_to_goal({-3000.0, 0.0, 9.0}, 1.0), (Vector{-1.0, 0.0, 0.0}));
}

TEST(MoveToGoal, WantsNothingOnTheSuccessRadiusOrWithinIt) {
  EXPECT_EQ(move_to_goal({5.0, 0.0}, 5.0), Vector{});
  EXPECT_EQ(move_to_goal({4.9, 0.0}, 5.0), Vector{});
  EXPECT_EQ(move_to_goal({5.001, 0.0}, 5.0), (Vector{1.0, 0.0, 0.0}));
}

TEST(MoveToGoal, WantsNothingAtTheGoalItself) {
  EXPECT_EQ(move_to_goal({}, 0.0), Vector{});
}

TEST(MoveToGoal, IsNoNumberForAGoalThatIsNone) {
  EXPECT_TRUE(std::isnan(move_to_goal({std::numeric_limits<double>::quiet_NaN(), 0.0}, 1.0).x));
}

TEST(MoveToGoal, HasASuccessRadiusOfFiveMetresUnlessTold) {
  flow::BehaviorProbe p = probe("MoveToGoal");
  p.set("goal", Vector{5.0, 0.0}).step();
  EXPECT_EQ(p.output<Vector>(), Vector{});
}

TEST(MoveTo, PullsRightToTheSpotWhereThereIsAGoal) {
  flow::BehaviorProbe p = probe("MoveTo");
  p.set("goal", Vector{0.0, 0.01}).step();
  EXPECT_EQ(p.output<Vector>(), (Vector{0.0, 1.0, 0.0}));
  p.set("goal", Vector{0.0, 0.0}).step();
  EXPECT_EQ(p.output<Vector>(), Vector{});
  p.set("goal", Vector{7.0, 0.0}).set("have_a_goal", false).step();
  EXPECT_EQ(p.output<Vector>(), Vector{});
}

TEST(MoveToGuarded, RisesFromTheDeadZoneToTheDropOff) {
  flow::BehaviorProbe p = probe("MoveToGuarded");
  p.set("dropoff_radius", 10.0).set("dead_zone_radius", 2.0).set("strength", 0.5);
  const auto at = [&](double x) {
    p.set("goal", Vector{x, 0.0}).step();
    return p.output<Vector>().x;
  };
  EXPECT_DOUBLE_EQ(at(100.0), 0.5);
  EXPECT_DOUBLE_EQ(at(10.0), 0.5);
  EXPECT_DOUBLE_EQ(at(6.0), 0.25);
  EXPECT_DOUBLE_EQ(at(2.0), 0.0);
  EXPECT_DOUBLE_EQ(at(0.0), 0.0);
}

}  // namespace
}  // namespace mlab::library_test
