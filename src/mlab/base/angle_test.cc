#include "mlab/base/angle.h"

#include <numbers>

#include <gtest/gtest.h>

namespace mlab::base {
namespace {

TEST(Angle, WrapsIntoTheHalfOpenCircle) {
  using std::numbers::pi;
  EXPECT_DOUBLE_EQ(wrap_angle(0.0), 0.0);
  EXPECT_DOUBLE_EQ(wrap_angle(pi), pi);
  EXPECT_DOUBLE_EQ(wrap_angle(-pi), pi);
  EXPECT_NEAR(wrap_angle(2.5 * pi), 0.5 * pi, 1e-12);
  EXPECT_NEAR(wrap_angle(-2.5 * pi), -0.5 * pi, 1e-12);
}

TEST(Angle, DegreesAndRadiansAreInverse) {
  EXPECT_DOUBLE_EQ(radians(180.0), std::numbers::pi);
  EXPECT_DOUBLE_EQ(degrees(radians(33.0)), 33.0);
}

}  // namespace
}  // namespace mlab::base
