#include "mlab/schema/route_way.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/schema/route.h"
#include "mlab/schema/way.h"

namespace mlab::schema {
namespace {

using geom::Point;
using ways::PlannedWay;
using ways::WayEnd;

constexpr double kRadius = 0.2;
constexpr double kMargin = 5.0;

/// Round and round, farther and farther out: more corners than a way can tell.
std::vector<Point> spiral(int count) {
  std::vector<Point> out;
  for (int i = 0; i < count; ++i) {
    const double angle = 0.4 * i;
    out.push_back({500.0 + (20.0 + 3.0 * i) * std::cos(angle), 300.0 + (20.0 + 3.0 * i) * std::sin(angle)});
  }
  return out;
}

RouteWay along(const std::vector<Point>& route) {
  return plan_route({}, route.front(), route, kRadius, kMargin);
}

TEST(RouteWay, GoesByCornersThatItPassesAnyway) {
  std::vector<Point> route;
  for (int i = 0; i <= 50; ++i) route.push_back({2.0 * i, i % 2 == 0 ? 0.0 : 0.15});
  for (int i = 1; i <= 50; ++i) route.push_back({100.0, 2.0 * i});
  const RouteWay found = along(route);
  EXPECT_EQ(found.way.end, WayEnd::kGoal);
  EXPECT_EQ(found.way.count, 3U) << "a side each";
  EXPECT_EQ(found.way.points().back(), route.back());
  const double length = way_length(found.way);
  for (const Point corner : route) {
    const Point nearest = point_on(found.way, nearest_on(found.way, corner, 0.0, length));
    EXPECT_LE(distance(nearest, corner), 0.2);
  }
}

TEST(RouteWay, LeadsBackWhereTheRouteDoes) {
  const std::vector<Point> route = {{0.0, 0.0},  {50.0, 0.0}, {100.0, 0.0},
                                    {60.0, 0.0}, {20.0, 0.0}, {80.0, 0.0}};
  const RouteWay found = along(route);
  EXPECT_EQ(found.way.end, WayEnd::kGoal);
  EXPECT_DOUBLE_EQ(way_length(found.way), 100.0 + 80.0 + 60.0);
}

TEST(RouteWay, SaysHowMuchOfTheRouteIsBeyondItsEnd) {
  const std::vector<Point> route = spiral(80);
  const RouteWay found = along(route);
  ASSERT_EQ(found.way.end, WayEnd::kFull);
  EXPECT_NEAR(way_length(found.way) + found.way.beyond, route_length(route), 0.1);
}

// A gap that lies far beyond what the way can tell; the corners before it, zigzag, take all of its room.
TEST(RouteWay, KeepsItsDistanceWhateverIsBeyondItsEnd) {
  std::vector<Point> route;
  for (int i = 0; i < 60; ++i) route.push_back({20.0 * i, i % 2 == 0 ? 0.0 : 40.0});
  route.push_back({1400.0, 20.0});
  const std::vector<geom::Segment> walls = {{{1300.0, -500.0}, {1300.0, 19.0}},
                                            {{1300.0, 21.0}, {1300.0, 500.0}}};
  percept::KnownGround ground;
  ground.revision = 1'000'011;
  ground.walls = walls;
  ground.bounds = {-100.0, -500.0, 1500.0, 500.0};
  const RouteWay found = plan_route(ground, route.front(), route, kRadius, kMargin);
  ASSERT_EQ(found.way.end, WayEnd::kFull);
  EXPECT_EQ(found.way.whole_end(), WayEnd::kGoal);
  EXPECT_EQ(found.way.whole_last(), route.back());
  EXPECT_NEAR(way_length(found.way) + found.way.length_beyond(), route_length(route), 5.0);
  EXPECT_DOUBLE_EQ(found.way.clearance, kRadius + kMargin);
}

TEST(RouteWay, GoesOnAlongItsLineToTheEnd) {
  const std::vector<Point> route = spiral(200);
  RouteWay now = along(route);
  double at = 0.0;
  std::size_t passed = 0;
  double gone = 0.0;
  int rounds = 0;
  while (now.way.end == WayEnd::kFull) {
    ASSERT_LT(++rounds, 20);
    const double before = at;
    at += 0.5 * (way_length(now.way) - at);
    gone += at - before;
    passed += corners_passed(now.way, at, std::span(route).subspan(passed));
    const auto next = go_on_along_route({}, now.way, at, std::span(route).subspan(passed), kRadius, kMargin);
    ASSERT_TRUE(next);
    ASSERT_GE(next->way.cut_off, 0.0F);
    EXPECT_GT(next->behind, 100.0) << "the last of a formation go on along it";
    // The same line, from where it begins to where the one before ends.
    for (double there = at - next->behind; there <= way_length(now.way); there += 5.0) {
      const Point same = point_on(next->way, there - next->way.cut_off);
      ASSERT_LT(distance(point_on(now.way, there), same), 1e-3) << rounds << ", at " << there << " of " << at;
    }
    now = *next;
    at = now.behind;
    EXPECT_NEAR(gone + way_length(now.way) - at + now.way.beyond, route_length(route), 1.0);
  }
  EXPECT_EQ(now.way.end, WayEnd::kGoal);
  EXPECT_EQ(now.way.points().back(), route.back());
}

TEST(RouteWay, DoesNotBeginBehindWhatStandsThereByNow) {
  const std::vector<Point> route = spiral(120);
  const RouteWay before = along(route);
  const double at = 0.5 * way_length(before.way);
  const std::size_t passed = corners_passed(before.way, at, route);
  const auto rest = std::span(route).subspan(passed);
  const std::vector<ways::Round> rocks = {{point_on(before.way, at - 60.0), 3.0}};
  percept::KnownGround ground;
  ground.revision = 1'000'001;  // of no other test
  ground.discs = rocks;
  const auto next = go_on_along_route(ground, before.way, at, rest, kRadius, kMargin);
  ASSERT_TRUE(next);
  EXPECT_GT(next->behind, 10.0);
  EXPECT_LT(next->behind, 60.0);
  EXPECT_TRUE(is_open(ground, next->way));
}

TEST(RouteWay, DoesNotGoOnWhereNothingLeadsOn) {
  percept::KnownGround ground;  // a ring of walls round who is on it
  std::vector<geom::Segment> walls;
  const std::vector<Point> route = {{0.0, 0.0}, {100.0, 0.0}, {200.0, 0.0}, {300.0, 0.0}};
  const RouteWay before = along(route);
  for (int i = 0; i < 12; ++i) {
    const auto corner = [](int k) {
      const double angle = std::numbers::pi / 6.0 * k;
      return Point{150.0 + 8.0 * std::cos(angle), 8.0 * std::sin(angle)};
    };
    walls.push_back({corner(i), corner(i + 1)});
  }
  ground.revision = 1'000'002;
  ground.walls = walls;
  const std::vector<Point> rest = {{200.0, 50.0}, {300.0, 0.0}};
  EXPECT_FALSE(go_on_along_route(ground, before.way, 150.0, rest, kRadius, kMargin));
}

TEST(RouteWay, CountsCornersOfALineThatComesByAgain) {
  std::vector<Point> route;  // two rounds, dense
  for (int i = 0; i <= 200; ++i)
    route.push_back(
        {50.0 * std::cos(i * std::numbers::pi / 50.0), 50.0 * std::sin(i * std::numbers::pi / 50.0)});
  const RouteWay found = along(route);
  for (double at = 1.0; at < way_length(found.way); at += 3.0) {
    const std::size_t passed = corners_passed(found.way, at, route);
    EXPECT_NEAR(static_cast<double>(passed), 1.0 + at / route_length(route) * 200.0, 2.0) << at;
  }
}

TEST(RouteWay, PassesCornersBesideWhatTheyAreNearTo) {
  std::vector<Point> route;
  for (int i = 0; i <= 300; ++i) route.push_back({1.0 * i, 0.0});
  const std::vector<geom::Segment> walls = {{{-50.0, 3.0}, {350.0, 3.0}}};
  percept::KnownGround ground;
  ground.revision = 1'000'003;
  ground.walls = walls;
  ground.bounds = {-100.0, -100.0, 400.0, 100.0};
  const RouteWay found = plan_route(ground, route.front(), route, kRadius, kMargin);
  EXPECT_EQ(found.way.end, WayEnd::kGoal);
  EXPECT_LT(found.way.count, 10U) << "beside the wall, not to it and back for each of them";
  EXPECT_LT(way_length(found.way), 310.0);
  EXPECT_EQ(found.way.points().back(), route.back());
}

TEST(StationProgress, IsWhereTheStationIsNotWhereTheWayIsNearest) {
  std::vector<Point> route;
  for (int i = 0; i <= 40; ++i)
    route.push_back(
        {90.0 * std::sin(i * std::numbers::pi / 40.0), 90.0 - 90.0 * std::cos(i * std::numbers::pi / 40.0)});
  const PlannedWay way = along(route).way;
  for (const double at : {60.0, 120.0, 200.0}) {
    for (const double left : {75.0, -75.0, 0.0})
      EXPECT_NEAR(station_progress(way, left, beside_way(way, at, left), at - 20.0, at + 30.0), at, 1.0);
  }
}

}  // namespace
}  // namespace mlab::schema
