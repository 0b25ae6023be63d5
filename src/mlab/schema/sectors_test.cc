#include "mlab/schema/sectors.h"

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

using geom::polar;
using geom::Vector;

constexpr double kDegree = kPi / 180.0;

void expect_same(Vector a, Vector b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
}

TEST(Sectors, CountToTheLeftFromStraightAhead) {
  EXPECT_EQ(Sectors::index(polar(1.0, 0.0)), 0U);
  EXPECT_EQ(Sectors::index(polar(1.0, 14.0 * kDegree)), 0U);
  EXPECT_EQ(Sectors::index(polar(1.0, 16.0 * kDegree)), 1U);
  EXPECT_EQ(Sectors::index(polar(1.0, 180.0 * kDegree)), 6U);
  EXPECT_EQ(Sectors::index(polar(1.0, -90.0 * kDegree)), 9U);
}

TEST(Sectors, WrapJustRightOfStraightAhead) {
  EXPECT_EQ(Sectors::index(polar(1.0, 345.5 * kDegree)), 0U);
  EXPECT_EQ(Sectors::index(polar(1.0, 359.0 * kDegree)), 0U);
  EXPECT_EQ(Sectors::index(polar(1.0, 344.0 * kDegree)), 11U);
}

TEST(Sectors, PreferStraightAhead) {
  expect_same(Sectors{}.freest(), {1.0, 0.0});
}

TEST(Sectors, PreferLeftToRight) {
  Sectors sectors;
  sectors.block({1.0, 0.0});
  expect_same(sectors.freest(), polar(5.0 / 6.0, 30.0 * kDegree));
  sectors.block(polar(1.0, 30.0 * kDegree));
  expect_same(sectors.freest(), polar(5.0 / 6.0, -30.0 * kDegree));
  sectors.block(polar(1.0, -30.0 * kDegree));
  expect_same(sectors.freest(), polar(4.0 / 6.0, 60.0 * kDegree));
}

TEST(Sectors, GiveNothingWhereOnlyBehindOrNoneIsClear) {
  Sectors sectors;
  for (int i = 0; i < 12; ++i) {
    if (i != 6) sectors.block(polar(1.0, i * 30.0 * kDegree));
  }
  expect_same(sectors.freest(), {});
  sectors.block({-1.0, 0.0});
  expect_same(sectors.freest(), {});
}

}  // namespace
}  // namespace mlab::schema
