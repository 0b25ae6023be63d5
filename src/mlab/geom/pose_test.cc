#include "mlab/geom/pose.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace mlab::geom {
namespace {

TEST(Pose, SeesAPointToItsLeftAsPositiveY) {
  const Pose facing_north{{10.0, 20.0}, std::numbers::pi / 2.0};
  const Vector seen = facing_north.to_robot(Point{7.0, 20.0});  // three metres to the west
  EXPECT_NEAR(seen.x, 0.0, 1e-12);
  EXPECT_NEAR(seen.y, 3.0, 1e-12);
}

TEST(Pose, PointAtIsTheInverseOfToRobot) {
  const Pose pose{{-3.0, 8.0}, 0.7};
  const Point p{12.0, -4.0};
  const Point back = pose.point_at(pose.to_robot(p));
  EXPECT_NEAR(back.x, p.x, 1e-12);
  EXPECT_NEAR(back.y, p.y, 1e-12);
}

TEST(Pose, LooksWhereItsHeadingSaysWhicheverWasAskedForBefore) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double one : {0.7, 0.7, -0.7, 0.0, -0.0, nan, 0.0, 3.0, nan, -0.0, 1e9, 0.7}) {
    const volatile double heading = one;  // compilers know cosines to another last digit
    const Offset ahead = ahead_of(heading);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(ahead.x), std::bit_cast<std::uint64_t>(std::cos(heading)));
    EXPECT_EQ(std::bit_cast<std::uint64_t>(ahead.y), std::bit_cast<std::uint64_t>(std::sin(heading)));
  }
}

TEST(Segment, NearestPointStaysBetweenTheEnds) {
  const Segment s{{0.0, 0.0}, {10.0, 0.0}};
  EXPECT_EQ(nearest_point(s, {5.0, 3.0}), (Point{5.0, 0.0}));
  EXPECT_EQ(nearest_point(s, {-5.0, 3.0}), (Point{0.0, 0.0}));
  EXPECT_EQ(nearest_point(s, {15.0, 3.0}), (Point{10.0, 0.0}));
}

TEST(Segment, IntersectsAlsoWhereAnEndTouches) {
  const Segment s{{0.0, 0.0}, {10.0, 0.0}};
  EXPECT_TRUE(intersects(s, {{5.0, -1.0}, {5.0, 1.0}}));
  EXPECT_TRUE(intersects(s, {{5.0, 0.0}, {5.0, 1.0}}));
  EXPECT_FALSE(intersects(s, {{5.0, 0.1}, {5.0, 1.0}}));
  EXPECT_FALSE(intersects(s, {{11.0, -1.0}, {11.0, 1.0}}));
}

TEST(Segment, MeetsAnotherWhereOneEndOfEitherTouchesIt) {
  const Segment wall{{0, 0}, {4, 0}};
  for (const Segment one : {Segment{{2, 0}, {2, 3}}, Segment{{2, 3}, {2, 0}}}) {
    EXPECT_TRUE(intersects(wall, one));
    EXPECT_TRUE(intersects(one, wall));
  }
  EXPECT_FALSE(intersects(wall, {{2, 3}, {2, 0.5}}));
}

}  // namespace
}  // namespace mlab::geom
