#include "mlab/geom/vector.h"

#include <numbers>

#include <gtest/gtest.h>

namespace mlab::geom {
namespace {

TEST(Vector, UnitKeepsTheDirectionAndDropsTheLength) {
  const Vector u = unit({3.0, 4.0, 7.0});
  EXPECT_DOUBLE_EQ(u.x, 0.6);
  EXPECT_DOUBLE_EQ(u.y, 0.8);
  EXPECT_DOUBLE_EQ(u.z, 0.0);
}

TEST(Vector, UnitOfAlmostNothingIsZero) {
  EXPECT_EQ(unit({1e-6, 0.0, 0.0}), Vector{});
}

TEST(Vector, RotatesCounterClockwise) {
  const Vector v = rotated({1.0, 0.0, 2.0}, std::numbers::pi / 2.0);
  EXPECT_NEAR(v.x, 0.0, 1e-15);
  EXPECT_NEAR(v.y, 1.0, 1e-15);
  EXPECT_DOUBLE_EQ(v.z, 2.0);
}

TEST(Vector, CrossIsPositiveToTheLeft) {
  EXPECT_GT(cross({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}), 0.0);
}

}  // namespace
}  // namespace mlab::geom
