#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Vector;

TEST(DetectUnitCenter, IsWhatTheUnitSaysWhateverRobotsAreInSight) {
  const std::vector<percept::RobotReading> strangers = {{.id = {7}, .center = {100.0, 0.0}}};
  flow::BehaviorProbe p = probe("DETECT_UNIT_CENTER");
  p.percepts.robots = strangers;
  p.percepts.pose = {{10.0, 10.0}, 0.0};
  p.percepts.unit.center = {13.0, 14.0};
  p.step();
  EXPECT_EQ(p.output<Vector>(), (Vector{3.0, 4.0, 0.0}));
}

TEST(CenterOfRobots, CountsThisRobotAsOne) {
  const std::vector<percept::RobotReading> robots = {{.id = {2}, .center = {6.0, 0.0}},
                                                     {.id = {3}, .center = {0.0, 9.0}}};
  flow::BehaviorProbe p = probe("CenterOfRobots");
  p.percepts.robots = robots;
  p.set("robots", all<flow::Robots>(2)).step();
  EXPECT_EQ(p.output<Vector>(), (Vector{2.0, 3.0, 0.0}));
}

TEST(CenterOfRobots, IsTheRobotItselfWhenAlone) {
  flow::BehaviorProbe p = probe("CenterOfRobots");
  p.step();
  EXPECT_EQ(p.output<Vector>(), Vector{});
}

TEST(CenterOfObjects, CountsThisRobotAsOne) {
  const std::vector<percept::ObjectReading> objects = {{.id = {2}, .center = {6.0, 2.0}}};
  flow::BehaviorProbe p = probe("COMPUTE_UNIT_CENTER");
  p.percepts.objects = objects;
  p.set("objects", all<flow::Objects>(1)).step();
  EXPECT_EQ(p.output<Vector>(), (Vector{3.0, 1.0, 0.0}));
}

}  // namespace
}  // namespace mlab::library_test
