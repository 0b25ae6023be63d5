#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"
#include "mlab/schema/constants.h"

namespace mlab::library_test {
namespace {

using geom::Vector;

Vector avoid_robots(const std::vector<Vector>& centers, double sphere, double min_range) {
  std::vector<percept::RobotReading> robots;
  for (const Vector& center : centers) robots.push_back({.id = {2}, .center = center});
  flow::BehaviorProbe p = probe("AvoidRobots");
  p.percepts.robots = robots;
  p.set("readings", all<flow::Robots>(robots.size()))
      .set("sphere", sphere)
      .set("min_range", min_range)
      .step();
  return p.output<Vector>();
}

TEST(AvoidRobots, PushesHarderTheNearer) {
  const auto at = [](double d) { return -avoid_robots({{d, 0.0}}, 30.0, 15.0).x; };
  EXPECT_DOUBLE_EQ(at(31.0), 0.0);
  EXPECT_DOUBLE_EQ(at(30.0), 0.0);
  EXPECT_DOUBLE_EQ(at(22.5), 0.5);
  EXPECT_DOUBLE_EQ(at(15.0), schema::kInfinity);
  EXPECT_DOUBLE_EQ(at(1.0), schema::kInfinity);
}

TEST(AvoidRobots, SumsOverRobots) {
  const Vector push = avoid_robots({{22.5, 0.0}, {0.0, -22.5}}, 30.0, 15.0);
  EXPECT_DOUBLE_EQ(push.x, -0.5);
  EXPECT_DOUBLE_EQ(push.y, 0.5);
}

TEST(AvoidRobots, HasNoSlopeWhereTheSphereIsWithinTheMinimumRange) {
  EXPECT_EQ(avoid_robots({{16.0, 0.0}}, 10.0, 15.0), Vector{});
  EXPECT_DOUBLE_EQ(avoid_robots({{15.0, 0.0}}, 10.0, 15.0).x, -schema::kInfinity);
}

TEST(AvoidRobots, BacksAwayFromARobotOnTheSameSpot) {
  EXPECT_EQ(avoid_robots({{0.0, 0.0}}, 30.0, 15.0), (Vector{-schema::kInfinity, 0.0, 0.0}));
}

// Balch and Arkin 1998, table I: gain 2, S = 20, R = 5 against a goal gain of .8: break-even at d = 14 m.
TEST(AvoidRobots, BreaksEvenWithTheGoalAt14Metres) {
  EXPECT_NEAR(2.0 * avoid_robots({{14.0, 0.0}}, 20.0, 5.0).x, -0.8, 1e-12);
}

}  // namespace
}  // namespace mlab::library_test
