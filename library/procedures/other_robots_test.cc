#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Vector;
using percept::ObjectClass;

const std::vector<percept::RobotReading> kInSight = {
    {.id = {2}, .center = {30.0, 0.0}, .is_unit_mate = true},
    {.id = {3}, .center = {0.0, 20.0}, .object_class = ObjectClass::kEnemyRobot},
    {.id = {4}, .center = {0.0, -50.0}, .is_unit_mate = true, .object_class = ObjectClass::kEnemyRobot}};

flow::BehaviorProbe looking(const char* name, std::size_t count = kInSight.size()) {
  flow::BehaviorProbe p = probe(name);
  p.percepts.robots = kInSight;
  p.set("robots", all<flow::Robots>(count));
  return p;
}

std::vector<int> kept(flow::BehaviorProbe& p) {
  p.step();
  const auto& out = p.output<flow::Robots>();
  return {out.indices.begin(), out.indices.begin() + out.count};
}

TEST(FilterRobotsByClass, KeepsTheClassesOrAllOthers) {
  flow::BehaviorProbe p = looking("FilterRobotsByClass");
  p.set_text("classes", "EnemyRobot");
  EXPECT_EQ(kept(p), (std::vector<int>{1, 2}));
  p.set("remove", true);
  EXPECT_EQ(kept(p), (std::vector<int>{0}));
  p.set_text("classes", "Tree").set("remove", false);
  EXPECT_EQ(kept(p), std::vector<int>{});
}

TEST(FilterUnitMates, KeepsThemOrAllOthers) {
  flow::BehaviorProbe p = looking("FilterUnitMates");
  EXPECT_EQ(kept(p), (std::vector<int>{0, 2}));
  p.set("remove", true);
  EXPECT_EQ(kept(p), (std::vector<int>{1}));
}

TEST(ClosestRobot, GoesByTheCentreAndIsZeroWithoutAny) {
  flow::BehaviorProbe p = looking("ClosestRobot");
  p.step();
  EXPECT_EQ(p.output<Vector>(), (Vector{0.0, 20.0, 0.0}));
  p.set("robots", flow::Robots{}).step();
  EXPECT_EQ(p.output<Vector>(), Vector{});
}

TEST(CountRobots, CountsThoseWithinTheRange) {
  flow::BehaviorProbe p = looking("CountRobots");
  p.set("range", 30.0).step();
  EXPECT_EQ(p.output<int>(), 2) << "one is just within";
  p.set("range", 10.0).step();
  EXPECT_EQ(p.output<int>(), 0);
}

TEST(AreRobotsNear, AsksForAtLeastSoMany) {
  flow::BehaviorProbe p = looking("AreRobotsNear");
  p.set("range", 30.0).set("count", 2).step();
  EXPECT_TRUE(p.output<bool>());
  p.set("count", 3).step();
  EXPECT_FALSE(p.output<bool>());
  p.set("range", 60.0).step();
  EXPECT_TRUE(p.output<bool>());
}

}  // namespace
}  // namespace mlab::library_test
