#include "mlab/percept/formation.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace mlab::percept {
namespace {

using geom::Vector;

constexpr double kSpacing = 50.0;

void expect_near(Vector a, Vector b) {
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
}

TEST(Station, FourRobotsStandAsTheHistoricTablesSay) {
  expect_near(station(Formation::kLine, 0, 4, kSpacing), {0, -25, 0});
  expect_near(station(Formation::kLine, 1, 4, kSpacing), {0, -75, 0});
  expect_near(station(Formation::kLine, 3, 4, kSpacing), {0, 75, 0});
  expect_near(station(Formation::kColumn, 0, 4, kSpacing), {75, 0, 0});
  expect_near(station(Formation::kColumn, 1, 4, kSpacing), {-25, 0, 0});
  expect_near(station(Formation::kColumn, 2, 4, kSpacing), {25, 0, 0});
  expect_near(station(Formation::kDiamond, 3, 4, kSpacing), {-50, 0, 0});
  expect_near(station(Formation::kWedge, 1, 4, kSpacing), {-25, -75, 0});
}

TEST(Station, TwoRobotsInAWedgeRightAreMirrored) {
  expect_near(station(Formation::kWedge, 0, 2, kSpacing), {25, -25, 0});
  expect_near(station(Formation::kWedgeRight, 0, 2, kSpacing), {25, 25, 0});
}

TEST(Station, NeighboursInLineAndColumnAreOneSpacingApartForEveryNumberOfRobots) {
  for (const Formation formation : {Formation::kLine, Formation::kColumn}) {
    for (int count = 2; count <= 12; ++count) {
      for (int rank = 0; rank < count; ++rank) {
        double nearest = 1e9;
        for (int other = 0; other < count; ++other) {
          if (other == rank) continue;
          nearest = std::min(nearest, length(station(formation, rank, count, kSpacing) -
                                             station(formation, other, count, kSpacing)));
        }
        EXPECT_NEAR(nearest, kSpacing, 1e-9) << name(formation) << " " << count << " " << rank;
      }
    }
  }
}

TEST(Station, EveryFormationIsCentredOnTheUnit) {
  for (int f = 0; f < kFormationCount; ++f) {
    for (int count = 1; count <= 12; ++count) {
      Vector sum;
      for (int rank = 0; rank < count; ++rank)
        sum += station(static_cast<Formation>(f), rank, count, kSpacing);
      expect_near(sum, {});
    }
  }
}

TEST(Station, NoTwoRobotsShareOne) {
  for (const Formation f : {Formation::kLine, Formation::kLineRight, Formation::kWedge,
                            Formation::kWedgeRight, Formation::kDiamond, Formation::kColumn}) {
    for (int count = 2; count <= 16; ++count) {
      for (int a = 0; a < count; ++a) {
        for (int b = a + 1; b < count; ++b) {
          EXPECT_GT(length(station(f, a, count, kSpacing) - station(f, b, count, kSpacing)), kSpacing * 0.6)
              << name(f) << " " << count << ": " << a << ", " << b;
        }
      }
    }
  }
}

TEST(Formation, IsFoundByItsNameInAnyLetterCase) {
  EXPECT_EQ(formation_named("wedge-LEFT"), Formation::kWedgeLeft);
  EXPECT_EQ(formation_named("vee"), std::nullopt);
}

}  // namespace
}  // namespace mlab::percept
