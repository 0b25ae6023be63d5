#include "mlab/schema/route.h"

#include <vector>

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

using geom::Point;

const std::vector<Point> kCorner = {{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}};
// A hairpin whose legs are 1 m apart.
const std::vector<Point> kHairpin = {{0.0, 0.0}, {10.0, 0.0}, {10.0, 1.0}, {0.0, 1.0}};

TEST(Route, IsAsLongAsItsLegs) {
  EXPECT_DOUBLE_EQ(route_length(kCorner), 20.0);
  EXPECT_DOUBLE_EQ(route_length({}), 0.0);
}

TEST(Route, TellsPlacesByTheWayToThem) {
  EXPECT_EQ(route_point(kCorner, 4.0), (Point{4.0, 0.0}));
  EXPECT_EQ(route_point(kCorner, 10.0), (Point{10.0, 0.0}));
  EXPECT_EQ(route_point(kCorner, 13.0), (Point{10.0, 3.0}));
}

TEST(Route, HoldsAtItsEnds) {
  EXPECT_EQ(route_point(kCorner, -1.0), (Point{0.0, 0.0}));
  EXPECT_EQ(route_point(kCorner, 99.0), (Point{10.0, 10.0}));
}

TEST(Route, TellsThreePlacesAsOneByOne) {
  for (const auto& route : {kCorner, kHairpin, {}, {{2.0, 3.0}}, {{2.0, 3.0}, {2.0, 3.0}}}) {
    for (double at = -15.0; at < 35.0; at += 0.7) {
      const auto three = route_points(route, {at - 10.0, at, at + 5.3});
      EXPECT_EQ(three[0], route_point(route, at - 10.0)) << at;
      EXPECT_EQ(three[1], route_point(route, at)) << at;
      EXPECT_EQ(three[2], route_point(route, at + 5.3)) << at;
    }
  }
}

TEST(Route, FindsTheNearestPlace) {
  EXPECT_DOUBLE_EQ(nearest_way(kCorner, {4.0, -3.0}, 0.0, 20.0), 4.0);
  EXPECT_DOUBLE_EQ(nearest_way(kCorner, {12.0, 6.0}, 0.0, 20.0), 16.0);
  EXPECT_DOUBLE_EQ(nearest_way(kCorner, {99.0, 99.0}, 0.0, 20.0), 20.0);
}

TEST(Route, LooksOnlyWhereItIsTold) {
  EXPECT_DOUBLE_EQ(nearest_way(kHairpin, {3.0, 0.9}, 0.0, 5.0), 3.0);
  EXPECT_DOUBLE_EQ(nearest_way(kHairpin, {3.0, 0.9}, 0.0, 21.0), 18.0);
  EXPECT_DOUBLE_EQ(nearest_way(kHairpin, {3.0, 0.0}, 6.0, 9.0), 6.0);
}

TEST(Route, OfOnePointOrNoneStaysWhereItWas) {
  const std::vector<Point> one = {{2.0, 3.0}};
  EXPECT_EQ(route_point(one, 5.0), (Point{2.0, 3.0}));
  EXPECT_DOUBLE_EQ(nearest_way(one, {9.0, 9.0}, 0.0, 5.0), 0.0);
  EXPECT_DOUBLE_EQ(nearest_way({}, {9.0, 9.0}, 0.0, 5.0), 0.0);
  const std::vector<Point> same = {{2.0, 3.0}, {2.0, 3.0}};
  EXPECT_DOUBLE_EQ(nearest_way(same, {9.0, 9.0}, 0.0, 5.0), 0.0);
}

}  // namespace
}  // namespace mlab::schema
