#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"
#include "mlab/schema/constants.h"

namespace mlab::library_test {
namespace {

using geom::Vector;
using percept::Obstacle;

Vector avoid(const std::vector<Obstacle>& obstacles, double sphere, double margin) {
  flow::BehaviorProbe p = probe("AvoidStaticObstacles");
  p.percepts.obstacles = obstacles;
  p.set("readings", all<flow::Obstacles>(obstacles.size()))
      .set("sphere", sphere)
      .set("safety_margin", margin)
      .step();
  return p.output<Vector>();
}

TEST(AvoidStaticObstacles, PushesStraightAwayFromTheObstacle) {
  const Vector push = avoid({{{0.0, 3.0}, 1.0}}, 3.0, 0.5);
  EXPECT_DOUBLE_EQ(push.x, 0.0);
  EXPECT_DOUBLE_EQ(push.y, -0.5);
}

TEST(AvoidStaticObstacles, PushesHarderTheNearer) {
  const auto at = [](double d) { return -avoid({{{d, 0.0}, 1.0}}, 3.0, 0.5).x; };
  EXPECT_DOUBLE_EQ(at(99.0), 0.0);
  EXPECT_DOUBLE_EQ(at(4.5), 0.0);
  EXPECT_DOUBLE_EQ(at(3.0), 0.5);
  EXPECT_NEAR(at(1.501), 0.9997, 1e-4);
  EXPECT_DOUBLE_EQ(at(1.5), 1e12);
  EXPECT_DOUBLE_EQ(at(0.5), 1e12);
}

TEST(AvoidStaticObstacles, SumsOverObstacles) {
  const Vector push = avoid({{{3.0, 0.0}, 1.0}, {{0.0, 3.0}, 1.0}, {{3.0, 0.0}, 1.0}}, 3.0, 0.5);
  EXPECT_DOUBLE_EQ(push.x, -1.0);
  EXPECT_DOUBLE_EQ(push.y, -0.5);
}

TEST(AvoidStaticObstacles, BacksAwayFromAnObstacleThatItStandsOn) {
  EXPECT_EQ(avoid({{{0.0, 0.0}, 1.0}}, 3.0, 0.5), (Vector{-schema::kInfinity, 0.0, 0.0}));
}

TEST(AvoidStaticObstacles, LeavesItToTheOthersWhereTwoMarginsPressFromOppositeSides) {
  const Vector push = avoid({{{0.0, 1.2}, 1.0}, {{0.0, -1.2}, 1.0}, {{3.0, 0.0}, 1.0}}, 3.0, 0.5);
  EXPECT_DOUBLE_EQ(push.x, -0.5);
  EXPECT_DOUBLE_EQ(push.y, 0.0);
}

TEST(AvoidStaticObstacles, WantsNothingWithoutObstaclesOrFromOneThatIsNowhere) {
  EXPECT_EQ(avoid({}, 3.0, 0.5), Vector{});
  EXPECT_EQ(avoid({{{std::numeric_limits<double>::quiet_NaN(), 0.0}, 1.0}}, 3.0, 0.5), Vector{});
}

// Published analytic case: goal pull 1, obstacle radius .5, S = 2 from the centre, gain 1.5: they balance at
// d = 1.
TEST(AvoidStaticObstacles, BalancesTheGoalOneMetreFromTheObstacle) {
  EXPECT_DOUBLE_EQ(1.5 * avoid({{{1.0, 0.0}, 0.5}}, 1.5, 0.0).x, -1.0);
  EXPECT_DOUBLE_EQ(0.5 * avoid({{{0.5 + 1e-9, 0.0}, 0.5}}, 1.5, 0.0).x, -0.5 * (1.0 - 1e-9 / 1.5));
}

// Balch and Arkin 1998, table I: gain 1.5, S = 50, R = 5 against a goal gain of .8: break-even at d = 26 m.
TEST(AvoidStaticObstacles, BreaksEvenWithTheGoalAt26Metres) {
  EXPECT_NEAR(1.5 * avoid({{{26.0, 0.0}, 0.0}}, 45.0, 5.0).x, -0.8, 1e-12);
}

}  // namespace
}  // namespace mlab::library_test
