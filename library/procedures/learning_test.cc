#include <array>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Point;

struct Learner {
  flow::BehaviorProbe p = probe("LearnToGo");
  // Moves at `speed` for so many cycles.
  void run(int cycles, double speed, Point goal) {
    for (int i = 0; i < cycles; ++i) {
      p.set("goal", p.percepts.pose.to_robot(goal)).step();
      p.percepts.pose.position = p.percepts.pose.point_at(geom::unit(p.output<geom::Vector>()) *
                                                          (speed * p.percepts.cycle_duration));
    }
  }
  double strength() const { return geom::length(p.output<geom::Vector>()); }
};

TEST(LearnToGo, PullsHarderWhileItMakesProgress) {
  Learner learner;
  learner.run(1, 1.0, {1000, 0});
  EXPECT_NEAR(learner.strength(), 1.0, 1e-9);
  learner.run(100, 1.0, {1000, 0});
  EXPECT_GT(learner.strength(), 1.8);
  EXPECT_LT(learner.strength(), 2.1);
}

TEST(LearnToGo, GetsNoisyWhereItIsStuck) {
  Learner learner;
  learner.run(100, 0.0, {1000, 0});
  const geom::Vector first = learner.p.output<geom::Vector>();
  learner.run(300, 0.0, {1000, 0});
  EXPECT_GT(geom::length(learner.p.output<geom::Vector>() - first), 0.5) << "another random direction";
}

TEST(LearnToGo, ReachesAGoalBehindAnObstacle) {
  Learner learner;
  for (int i = 0; i < 2000; ++i) {
    const std::array<percept::Obstacle, 1> seen = {{{learner.p.percepts.pose.to_robot(Point{5, 0}), 1.0}}};
    learner.p.percepts.obstacles = seen;
    learner.p.set("readings", all<flow::Obstacles>(1));
    learner.run(1, 1.0, {10, 0});
    if (geom::distance(learner.p.percepts.pose.position, {10, 0}) < 0.5) return;
  }
  FAIL() << "never came";
}

}  // namespace
}  // namespace mlab::library_test
