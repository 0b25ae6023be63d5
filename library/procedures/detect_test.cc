#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Vector;

TEST(DetectObstacles, SeesEdgesWithinItsRange) {
  const std::vector<percept::Obstacle> obstacles = {
      {{5.0, 0.0}, 1.0}, {{0.0, 12.0}, 2.0}, {{0.0, 12.1}, 2.0}};
  flow::BehaviorProbe p = probe("DetectObstacles");
  p.percepts.obstacles = obstacles;
  p.set("range", 10.0).step();
  EXPECT_EQ(p.output<flow::Obstacles>().count, 2);
  EXPECT_EQ(p.output<flow::Obstacles>().indices[1], 1);
}

TEST(DetectObstacles, SeesNothingInTheOpen) {
  flow::BehaviorProbe p = probe("DetectObstacles");
  p.step();
  EXPECT_EQ(p.output<flow::Obstacles>().count, 0);
}

TEST(DetectObstacles, DropsTheFarthestOfTooMany) {
  std::vector<percept::Obstacle> obstacles(100, {{1.0, 0.0}, 0.1});
  flow::BehaviorProbe p = probe("DetectObstacles");
  p.percepts.obstacles = obstacles;
  p.step();
  EXPECT_EQ(p.output<flow::Obstacles>().count, flow::Obstacles::kCapacity);
}

TEST(DetectObstacles, TellsHowFarItLooks) {
  const flow::Behavior& b = behavior("DETECT_OBSTACLES");
  ASSERT_EQ(b.needs.size(), 1U);
  EXPECT_EQ(b.needs[0].sensor, percept::Sensor::kObstacles);
  EXPECT_EQ(b.needs[0].range_input, 0);
}

TEST(DetectRobots, SeesCentresWithinItsRange) {
  const std::vector<percept::RobotReading> robots = {{.id = {2}, .center = {3.0, 4.0}},
                                                     {.id = {3}, .center = {3.0, 4.1}}};
  flow::BehaviorProbe p = probe("DetectRobots");
  p.percepts.robots = robots;
  p.set("range", 5.0).step();
  EXPECT_EQ(p.output<flow::Robots>().count, 1);
}

TEST(DetectObjects, SeesEdgesWithinItsRange) {
  const std::vector<percept::ObjectReading> objects = {{.id = {1}, .center = {6.0, 0.0}, .radius = 1.0},
                                                       {.id = {2}, .center = {6.1, 0.0}, .radius = 1.0}};
  flow::BehaviorProbe p = probe("DetectObjects");
  p.percepts.objects = objects;
  p.set("range", 5.0).step();
  EXPECT_EQ(p.output<flow::Objects>().count, 1);
}

}  // namespace
}  // namespace mlab::library_test
