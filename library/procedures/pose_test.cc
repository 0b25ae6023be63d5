#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Point;
using geom::Pose;

TEST(GetPose, IsWhereTheRobotIs) {
  flow::BehaviorProbe p = probe("GetPose");
  p.percepts.pose = {{3.0, 4.0}, 1.5};
  p.step();
  EXPECT_EQ(p.output<Pose>(), (Pose{{3.0, 4.0}, 1.5}));
}

TEST(GetPosition, IsThePartOfAPose) {
  flow::BehaviorProbe p = probe("GetPosition");
  p.set("pose", Pose{{3.0, 4.0}, 1.5}).step();
  EXPECT_EQ(p.output<Point>(), (Point{3.0, 4.0}));
}

TEST(GetHeading, IsThePartOfAPoseInRadians) {
  flow::BehaviorProbe p = probe("GetHeading");
  p.set("pose", Pose{{3.0, 4.0}, 1.5}).step();
  EXPECT_DOUBLE_EQ(p.output<double>(), 1.5);
}

TEST(GetHeading, IsInDegreesUnderItsHistoricName) {
  const auto found = library().find("GET_HEADING");
  ASSERT_NE(found.alias, nullptr);
  EXPECT_EQ(found.behavior->name, "GetHeading");
  EXPECT_EQ(found.behavior->output_unit, "rad");
  EXPECT_EQ(found.alias->output_unit, "deg");
}

}  // namespace
}  // namespace mlab::library_test
