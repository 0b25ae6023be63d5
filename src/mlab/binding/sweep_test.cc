#include "mlab/binding/sweep.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "mlab/base/random.h"

namespace mlab::binding {
namespace {

using geom::Offset;
using geom::Point;

TEST(Sweep, MeetsADiscWhereTheDistanceIsTheRadius) {
  EXPECT_DOUBLE_EQ(meets_disc({-10, 0}, {20, 0}, 2.0), 0.4);
  EXPECT_EQ(meets_disc({-10, 0}, {-20, 0}, 2.0), kNever);
  EXPECT_EQ(meets_disc({-10, 0}, {7.9, 0}, 2.0), kNever);
  EXPECT_EQ(meets_disc({-10, 2.1}, {20, 0}, 2.0), kNever);
}

TEST(Sweep, ATouchingPointMayLeaveOrSlideButNotEnter) {
  EXPECT_EQ(meets_disc({-2, 0}, {-1, 0}, 2.0), kNever);
  EXPECT_EQ(meets_disc({-2, 0}, {0, 5}, 2.0), kNever);
  EXPECT_EQ(meets_disc({-2, 0}, {1, 0}, 2.0), 0.0);
}

TEST(Sweep, APointWithinTheSkinMayStayAsNearAsItIs) {
  const double inside = 2.0 - 1.5 * kSkin;
  EXPECT_EQ(meets_disc({-inside, 0}, {0, 5}, 2.0), kNever);
  EXPECT_EQ(meets_disc({-inside, 0}, {1e-3, 0}, 2.0), 0.0);
}

TEST(Sweep, IsExactAfterTheLongestMotions) {
  const double time = meets_disc({-5e5, 0.1}, {1e6, 0}, 0.2);
  ASSERT_LE(time, 1.0);
  EXPECT_NEAR(length(Offset{-5e5, 0.1} + Offset{1e6, 0} * time), 0.2, 1e-9);
}

TEST(Sweep, MeetsAWallOnItsFaceAndAtItsEnds) {
  const geom::Segment wall{{0, -1}, {0, 1}};
  EXPECT_DOUBLE_EQ(meets_wall(wall, {-3, 0}, {10, 0}, 0.5), 0.25);
  EXPECT_DOUBLE_EQ(meets_wall(wall, {3, 0}, {-10, 0}, 0.5), 0.25);
  EXPECT_NEAR(meets_wall(wall, {-3, 1.3}, {10, 0}, 0.5), 0.26, 1e-12);  // 0.4 beside the end, 0.3 above it
  EXPECT_EQ(meets_wall(wall, {-3, 1.6}, {10, 0}, 0.5), kNever);
  EXPECT_DOUBLE_EQ(meets_wall(wall, {0, 4}, {0, -10}, 0.5), 0.25);
  EXPECT_EQ(meets_wall(wall, {-0.5, -3}, {0, 10}, 0.5), kNever);
}

TEST(Sweep, AWallWithoutLengthIsAPost) {
  const geom::Segment post{{0, 0}, {0, 0}};
  EXPECT_DOUBLE_EQ(meets_wall(post, {-3, 0}, {10, 0}, 0.5), 0.25);
}

TEST(Sweep, TwoMoversMeetWhereTheyAreARadiusApart) {
  const Mover a{{0, 0}, {10, 0}, 1.0};
  const Mover b{{11, 0}, {-10, 0}, 1.0};
  EXPECT_DOUBLE_EQ(meet(a, b, 1.0), 0.5);
  // One that stops earlier is met later.
  EXPECT_DOUBLE_EQ(meet(a, {{11, 0}, {-10, 0}, 0.2}, 1.0), 0.8);
  EXPECT_EQ(meet({{0, 0}, {10, 0}, 0.3}, {{11, 0}, {-10, 0}, 0.2}, 1.0), kNever);
}

/// Follows motions in small steps.
double least_distance(const geom::Segment& wall, Point from, Offset motion, double until) {
  double least = HUGE_VAL;
  for (int i = 0; i <= 2000; ++i) {
    const Point p = from + motion * (until * i / 2000.0);
    least = std::min(least, distance(nearest_point(wall, p), p));
  }
  return least;
}

TEST(Sweep, NoWallIsComeNearerToThanTheRadiusBeforeItIsMet) {
  base::Random random(7);
  int met = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto place = [&] { return Point{random.uniform(-2, 2), random.uniform(-2, 2)}; };
    const geom::Segment wall{place(), place()};
    const Point from = place();
    const Offset motion = (place() - Point{}) * 2.0;  // up to 4 m along each axis
    const double radius = random.uniform(0.0, 0.5) + kSkin;
    if (distance(nearest_point(wall, from), from) < radius) continue;
    const double time = meets_wall(wall, from, motion, radius);
    met += time <= 1.0 ? 1 : 0;
    ASSERT_GE(least_distance(wall, from, motion, std::min(1.0, time)), radius - 1.01 * kSlack);
    if (time <= 1.0) {
      const Point end = from + motion * time;
      ASSERT_NEAR(distance(nearest_point(wall, end), end), radius, 1e-9);
    }
  }
  EXPECT_GT(met, 300);
}

}  // namespace
}  // namespace mlab::binding
