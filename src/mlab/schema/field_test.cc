#include "mlab/schema/field.h"

#include <limits>

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

using geom::Vector;

TEST(Repulsion, FallsInAStraightLineFromTheInnerToTheOuterDistance) {
  EXPECT_DOUBLE_EQ(repulsion_strength(4.5, 1.5, 4.5), 0.0);
  EXPECT_DOUBLE_EQ(repulsion_strength(3.0, 1.5, 4.5), 0.5);
  EXPECT_NEAR(repulsion_strength(1.501, 1.5, 4.5), 0.9997, 1e-4);
  EXPECT_DOUBLE_EQ(repulsion_strength(1.5, 1.5, 4.5), 1e12);
  EXPECT_DOUBLE_EQ(repulsion_strength(0.0, 1.5, 4.5), 1e12);
}

TEST(Repulsion, HasNoSlopeWithoutARing) {
  EXPECT_DOUBLE_EQ(repulsion_strength(2.0, 2.0, 2.0), kInfinity);
  EXPECT_DOUBLE_EQ(repulsion_strength(2.1, 2.0, 2.0), 0.0);
  EXPECT_DOUBLE_EQ(repulsion_strength(2.1, 2.0, 1.0), 0.0);
}

TEST(Repulsion, PointsStraightAwayAndStaysInThePlane) {
  EXPECT_EQ(repulsion({0.0, 3.0, 7.0}, 3.0, 1.5, 4.5), (Vector{0.0, -0.5, 0.0}));
}

TEST(Repulsion, OfSomethingExactlyHerePushesBackwards) {
  EXPECT_EQ(repulsion({}, 0.0, 1.0, 2.0), (Vector{-kInfinity, 0.0, 0.0}));
}

TEST(Repulsion, OfSomethingWithoutAPlaceIsNothing) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(repulsion({kNan, 0.0}, kNan, 1.0, 2.0), Vector{});
}

TEST(Ramp, RisesBetweenItsEnds) {
  EXPECT_DOUBLE_EQ(ramp(5.0, 5.0, 25.0), 0.0);
  EXPECT_DOUBLE_EQ(ramp(15.0, 5.0, 25.0), 0.5);
  EXPECT_DOUBLE_EQ(ramp(25.0, 5.0, 25.0), 1.0);
  EXPECT_DOUBLE_EQ(ramp(99.0, 5.0, 25.0), 1.0);
}

TEST(Ramp, IsAStepWhereItHasNoWidth) {
  EXPECT_DOUBLE_EQ(ramp(5.0, 5.0, 5.0), 0.0);
  EXPECT_DOUBLE_EQ(ramp(5.0001, 5.0, 5.0), 1.0);
}

TEST(Ramp, OfNoNumberIsNone) {
  EXPECT_TRUE(std::isnan(ramp(std::numeric_limits<double>::quiet_NaN(), 5.0, 5.0)));
  EXPECT_TRUE(std::isnan(ramp(std::numeric_limits<double>::quiet_NaN(), 1.0, 5.0)));
}

}  // namespace
}  // namespace mlab::schema
