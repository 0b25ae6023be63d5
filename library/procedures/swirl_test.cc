#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"
#include "mlab/schema/constants.h"

namespace mlab::library_test {
namespace {

using geom::Vector;

Vector swirl(const std::vector<percept::Obstacle>& obstacles) {
  flow::BehaviorProbe p = probe("SwirlObstacles");
  p.percepts.obstacles = obstacles;
  p.set("readings", all<flow::Obstacles>(obstacles.size()))
      .set("sphere", 3.0)
      .set("safety_margin", 0.5)
      .step();
  return p.output<Vector>();
}

TEST(SwirlObstacles, PassesAnObstacleDeadAheadOnItsRight) {
  EXPECT_EQ(swirl({{{3.0, 0.0}, 1.0}}), (Vector{0.0, -0.5, 0.0}));
}

TEST(SwirlObstacles, GoesOnAlongsideAnObstacle) {
  EXPECT_EQ(swirl({{{0.0, 3.0}, 1.0}}), (Vector{0.5, 0.0, 0.0}));
  EXPECT_EQ(swirl({{{0.0, -3.0}, 1.0}}), (Vector{0.5, 0.0, 0.0}));
}

TEST(SwirlObstacles, PassesOneOnTheRightOnItsLeft) {
  const Vector push = swirl({{{3.0, -0.01}, 1.0}});
  EXPECT_GT(push.y, 0.49);
}

TEST(SwirlObstacles, GoesStraightAwayInsideTheMargin) {
  EXPECT_EQ(swirl({{{0.0, 1.5}, 1.0}}), (Vector{-0.0, -schema::kInfinity, 0.0}));
  EXPECT_EQ(swirl({{{0.0, 0.0}, 1.0}}), (Vector{-schema::kInfinity, 0.0, 0.0}));
}

TEST(SwirlObstacles, WantsNothingFarAway) {
  EXPECT_EQ(swirl({{{0.0, 4.5}, 1.0}}), Vector{});
}

}  // namespace
}  // namespace mlab::library_test
