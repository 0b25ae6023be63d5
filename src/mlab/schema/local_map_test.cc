#include "mlab/schema/local_map.h"

#include <cmath>
#include <limits>
#include <type_traits>

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

using geom::Point;
static_assert(std::is_trivially_copyable_v<LocalMap>);
constexpr double kCell = 0.25;

TEST(LocalMap, RemembersWhatItSawWhileTheRobotMoves) {
  LocalMap map;
  map.center({0, 0}, kCell);
  map.block({2, 1}, 0.3, kCell);
  EXPECT_TRUE(map.is_blocked({2, 1}, kCell));
  EXPECT_FALSE(map.is_blocked({2.6, 1}, kCell));
  map.center({-3, 4}, kCell);
  EXPECT_TRUE(map.is_blocked({2, 1}, kCell));
  map.center({50, 0}, kCell);
  map.center({0, 0}, kCell);
  EXPECT_FALSE(map.is_blocked({2, 1}, kCell)) << "it was out of the square for a while";
}

TEST(LocalMap, GoesStraightWhereNothingIsInTheWay) {
  LocalMap map;
  map.center({0, 0}, kCell);
  EXPECT_EQ(map.first_stop({0, 0}, {3, 2}, kCell), (Point{3, 2}));
  const Point edge = map.first_stop({0, 0}, {100, 0}, kCell);
  EXPECT_NEAR(edge.x, 8.0, 0.3);
  EXPECT_NEAR(edge.y, 0.0, 0.3);
}

TEST(LocalMap, LeadsOutOfABoxCanyon) {
  LocalMap map;
  map.center({0, 0}, kCell);
  for (double y = -2.0; y <= 2.0; y += 0.1) map.block({2, y}, 0.3, kCell);
  for (double x = -2.0; x <= 2.0; x += 0.1) {
    map.block({x, 2}, 0.3, kCell);
    map.block({x, -2}, 0.3, kCell);
  }
  Point robot{0, 0};
  for (int i = 0; i < 400 && geom::distance(robot, {5, 0}) > 0.2; ++i) {
    const geom::Offset way = map.first_stop(robot, {5, 0}, kCell) - robot;
    ASSERT_GT(length(way), 0.0);
    robot = robot + way * (0.1 / length(way));
    ASSERT_FALSE(map.is_blocked(robot, kCell));
    map.center(robot, kCell);
  }
  EXPECT_LT(geom::distance(robot, {5, 0}), 0.2);
}

TEST(LocalMap, StaysWhereThereIsNoWay) {
  LocalMap map;
  map.center({0, 0}, kCell);
  for (double y = -9.0; y <= 9.0; y += 0.1) map.block({2, y}, 0.3, kCell);
  EXPECT_EQ(map.first_stop({0, 0}, {5, 0}, kCell), (Point{0, 0}));
}

TEST(LocalMap, TakesNumbersOfAnySize) {
  LocalMap map;
  map.center({1e12, -1e12}, 0.01);
  map.block({1e12, -1e12}, 1e13, 0.01);
  EXPECT_EQ(map.first_stop({1e12, -1e12}, {-1e12, 0}, 0.01), (Point{1e12, -1e12}));
}

TEST(LocalMap, WhatIsNotANumberIsNowhere) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  LocalMap map;
  map.center({0, 0}, kCell);
  map.block({kNaN, 0}, 1.0, kCell);
  map.block({1, 1}, kNaN, kCell);
  map.block({kInfinity, 0}, 1.0, kCell);
  for (double at = -7.0; at < 7.0; at += 0.5) EXPECT_FALSE(map.is_blocked({at, at}, kCell));
  EXPECT_FALSE(map.is_blocked({kNaN, 0}, kCell));
  EXPECT_TRUE(std::isnan(map.first_stop({0, 0}, {kNaN, 3}, kCell).x)) << "it comes out again";
}

}  // namespace
}  // namespace mlab::schema
