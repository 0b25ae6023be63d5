#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Vector;
using percept::ObjectReading;

const std::vector<ObjectReading> kObjects = {{.id = {1}, .center = {3.0, 0.0}, .radius = 0.1},
                                             {.id = {2}, .center = {0.0, 4.0}, .radius = 2.0}};

TEST(ClosestObstacle, GoesByTheCentre) {
  const std::vector<percept::Obstacle> obstacles = {{{5.0, 0.0}, 4.0}, {{0.0, 3.0}, 0.1}};
  flow::BehaviorProbe p = probe("ClosestObstacle");
  p.percepts.obstacles = obstacles;
  p.set("obstacles", all<flow::Obstacles>(2)).step();
  EXPECT_EQ(p.output<Vector>(), (Vector{0.0, 3.0, 0.0}));
  p.set("obstacles", flow::Obstacles{}).step();
  EXPECT_EQ(p.output<Vector>(), Vector{});
}

TEST(ClosestObject, GoesByTheEdge) {
  flow::BehaviorProbe p = probe("ClosestObject");
  p.percepts.objects = kObjects;
  p.set("objects", all<flow::Objects>(2)).step();
  EXPECT_EQ(p.output<ObjectReading>().id.value, 2U);
}

TEST(ClosestObject, OfNoneIsNoObject) {
  flow::BehaviorProbe p = probe("ClosestObject");
  p.step();
  EXPECT_EQ(p.output<ObjectReading>().id.value, 0U);
}

TEST(ObjectLocation, IsTheNearestPointOfTheObject) {
  flow::BehaviorProbe p = probe("ObjectLocation");
  p.set("object", kObjects[1]).step();
  EXPECT_EQ(p.output<Vector>(), (Vector{0.0, 2.0, 0.0}));
  p.set("object", ObjectReading{.id = {3}, .center = {1.0, 0.0}, .radius = 2.0}).step();
  EXPECT_EQ(p.output<Vector>(), Vector{});
  p.set("object", ObjectReading{}).step();
  EXPECT_EQ(p.output<Vector>(), Vector{});
}

TEST(IsValidObject, TellsAnObjectFromNone) {
  flow::BehaviorProbe p = probe("IsValidObject");
  p.set("object", kObjects[0]).step();
  EXPECT_TRUE(p.output<bool>());
  p.set("object", ObjectReading{}).step();
  EXPECT_FALSE(p.output<bool>());
}

TEST(IsAnyObject, TellsAListFromAnEmptyOne) {
  flow::BehaviorProbe p = probe("IsAnyObject");
  p.percepts.objects = kObjects;
  p.step();
  EXPECT_FALSE(p.output<bool>());
  p.set("objects", all<flow::Objects>(1)).step();
  EXPECT_TRUE(p.output<bool>());
}

}  // namespace
}  // namespace mlab::library_test
