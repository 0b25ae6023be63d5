#include <array>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Point;

TEST(PlanPath, HeadsStraightForAGoalThatIsFree) {
  flow::BehaviorProbe p = probe("MOVE_TO_GOAL_DSTAR");
  p.percepts.pose = {{3, 4}, 1.0};
  p.set("goal", geom::Vector{2.0, 1.0}).step();
  EXPECT_NEAR(p.output<geom::Vector>().x, 2.0, 1e-9);
  EXPECT_NEAR(p.output<geom::Vector>().y, 1.0, 1e-9);
}

// A U of discs that is open to the west; the goal lies behind it.
TEST(PlanPath, LeavesATrapThatFieldsStayIn) {
  flow::BehaviorProbe p = probe("PlanPath");
  std::array<percept::Obstacle, 30> trap;
  const auto place = [](std::size_t i) {
    const double along = static_cast<double>(i % 10) * 0.4;
    return i < 10 ? Point{3.6, along - 1.8} : i < 20 ? Point{along, 2.0} : Point{along, -2.0};
  };
  for (int step = 0; step < 600; ++step) {
    for (std::size_t i = 0; i < trap.size(); ++i) trap[i] = {p.percepts.pose.to_robot(place(i)), 0.2};
    p.percepts.obstacles = trap;
    p.set("goal", p.percepts.pose.to_robot(Point{7, 0}));
    p.set("readings", all<flow::Obstacles>(trap.size())).step();
    p.percepts.pose.position = p.percepts.pose.point_at(geom::unit(p.output<geom::Vector>()) * 0.05);
    for (std::size_t i = 0; i < trap.size(); ++i)
      ASSERT_GT(geom::distance(p.percepts.pose.position, place(i)), 0.25) << "step " << step;
    if (geom::distance(p.percepts.pose.position, {7, 0}) < 0.3) return;
  }
  FAIL() << "is at " << p.percepts.pose.position.x << ", " << p.percepts.pose.position.y;
}

}  // namespace
}  // namespace mlab::library_test
