#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using percept::ObjectClass;

const std::vector<percept::ObjectReading> kInSight = {
    {.id = {1}, .object_class = ObjectClass::kFlag, .center = {1.0, 0.0}},
    {.id = {2}, .object_class = ObjectClass::kBasket, .center = {2.0, 0.0}},
    {.id = {3}, .object_class = ObjectClass::kFlag, .center = {3.0, 0.0}}};

std::vector<int> filtered(flow::BehaviorProbe p) {
  p.percepts.objects = kInSight;
  p.set("objects", all<flow::Objects>(kInSight.size())).step();
  const auto& out = p.output<flow::Objects>();
  return {out.indices.begin(), out.indices.begin() + out.count};
}

TEST(FilterObjectsByClass, KeepsTheClassesOrAllOthers) {
  flow::BehaviorProbe p = probe("FilterObjectsByClass");
  p.set_text("classes", "Flag");
  EXPECT_EQ(filtered(p), (std::vector<int>{0, 2}));
  p.set("remove", true);
  EXPECT_EQ(filtered(p), (std::vector<int>{1}));
  p.set_text("classes", "Tree").set("remove", false);
  EXPECT_EQ(filtered(p), std::vector<int>{});
}

TEST(FilterObjectsByColor, KeepsOneColourLetterCaseAside) {
  flow::BehaviorProbe p = probe("FilterObjectsByColor");
  p.set_text("color", "Purple");
  EXPECT_EQ(filtered(p), (std::vector<int>{0, 2}));
  p.set_text("color", "pink");
  EXPECT_EQ(filtered(p), std::vector<int>{});
}

TEST(CountObjects, CountsThem) {
  flow::BehaviorProbe p = probe("CountObjects");
  p.percepts.objects = kInSight;
  p.set("objects", all<flow::Objects>(3)).step();
  EXPECT_EQ(p.output<int>(), 3);
}

TEST(RemoveRobots, LeavesOutObstaclesThatAreRobots) {
  const std::vector<percept::Obstacle> obstacles = {{{5.0, 0.0}, 0.2}, {{8.0, 0.0}, 0.2}};
  const std::vector<percept::RobotReading> robots = {{.id = {2}, .center = {5.9, 0.0}},
                                                     {.id = {3}, .center = {9.0, 0.0}}};
  flow::BehaviorProbe p = probe("RemoveRobots");
  p.percepts.obstacles = obstacles;
  p.percepts.robots = robots;
  p.set("obstacles", all<flow::Obstacles>(2)).set("robots", all<flow::Robots>(2)).step();
  EXPECT_EQ(p.output<flow::Obstacles>().count, 1);
  EXPECT_EQ(p.output<flow::Obstacles>().indices[0], 1);
}

}  // namespace
}  // namespace mlab::library_test
