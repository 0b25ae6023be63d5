#include "mlab/schema/vector_sum.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

using geom::Vector;

TEST(VectorSum, OfNothingIsZero) {
  EXPECT_EQ(VectorSum{}.total(), Vector{});
}

TEST(VectorSum, AddsOrdinaryVectors) {
  VectorSum sum;
  sum.add({1.0, 2.0, 3.0});
  sum.add({0.5, -2.0, 1.0});
  EXPECT_EQ(sum.total(), (Vector{1.5, 0.0, 4.0}));
}

TEST(VectorSum, LetsAnAbsoluteDemandOutweighEverything) {
  VectorSum sum;
  sum.add({0.8, 0.0});
  sum.add({0.0, kInfinity * 1.5});
  const Vector unit = geom::unit(sum.total());
  EXPECT_NEAR(unit.x, 0.0, 1e-9);
  EXPECT_NEAR(unit.y, 1.0, 1e-9);
}

TEST(VectorSum, LetsTheRestDecideWhereAbsoluteDemandsCancel) {
  VectorSum sum;
  const double angle = 0.3;  // its sine and cosine are rounded
  sum.add(geom::polar(kInfinity, angle));
  sum.add({0.25, 0.5});
  sum.add(geom::polar(kInfinity, angle + kPi));
  EXPECT_EQ(sum.total(), (Vector{0.25, 0.5, 0.0}));
}

TEST(VectorSum, EscapesSidewaysFromDemandsThatAreNotQuiteOpposite) {
  VectorSum sum;
  sum.add(geom::polar(kInfinity, 3.0));
  sum.add(geom::polar(kInfinity, -3.0));
  sum.add({5.0, 0.0});
  EXPECT_LT(sum.total().x, -1e12);
  EXPECT_DOUBLE_EQ(sum.total().y, 0.0);
}

TEST(VectorSum, WithAVectorThatIsNotFiniteIsNoNumber) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInf = std::numeric_limits<double>::infinity();
  for (const Vector bad : {Vector{kNaN, 0.0}, Vector{0.0, kNaN}, Vector{0.0, 0.0, kNaN}, Vector{kInf, 0.0},
                           Vector{0.0, -kInf}}) {
    VectorSum sum;
    sum.add({0.5, 0.5});
    sum.add(bad);
    sum.add({kInfinity, 0.0});
    EXPECT_TRUE(std::isnan(sum.total().x + sum.total().y + sum.total().z)) << bad.x << " " << bad.y;
  }
}

TEST(VectorSum, StaysFiniteWithManyAbsoluteDemands) {
  VectorSum sum;
  for (int i = 0; i < 1000; ++i) sum.add({kInfinity * 100.0, 0.0});
  EXPECT_TRUE(std::isfinite(sum.total().x));
}

}  // namespace
}  // namespace mlab::schema
