#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

template <class T>
T value_of(const char* name) {
  flow::BehaviorProbe p = probe(name);
  p.step();
  return p.output<T>();
}

TEST(Nothing, HoldsNothing) {
  EXPECT_EQ(value_of<flow::Objects>("NoObjects").count, 0);
  EXPECT_EQ(value_of<flow::Obstacles>("NoObstacles").count, 0);
  EXPECT_EQ(value_of<flow::Robots>("NoRobots").count, 0);
  EXPECT_EQ(value_of<flow::Ranges>("NoRanges").count, 0);
  EXPECT_EQ(value_of<percept::ObjectReading>("NoObject").id.value, 0U);
  EXPECT_EQ(value_of<double>("ZeroNumber"), 0.0);
  EXPECT_EQ(value_of<int>("ZeroCount"), 0);
  EXPECT_EQ(value_of<geom::Point>("ZeroPoint"), geom::Point());
  EXPECT_EQ(value_of<geom::Pose>("ZeroPose"), geom::Pose());
  EXPECT_EQ(value_of<ways::PlannedWay>("NoWay").count, 0);
  EXPECT_EQ(value_of<percept::Task>("NoTask"), percept::Task());
  EXPECT_EQ(value_of<percept::Formation>("NoFormation"), percept::Formation());
  EXPECT_EQ(value_of<percept::FormationReference>("NoFormationReference"), percept::FormationReference());
}

}  // namespace
}  // namespace mlab::library_test
