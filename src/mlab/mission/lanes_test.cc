#include "mlab/mission/lanes.h"

#include <gtest/gtest.h>

namespace mlab::mission {
namespace {

constexpr double kTiny = 1e-9;

TEST(Lanes, BesideAGoalIsAcrossTheDirectionOfArrival) {
  const Track lane = beside({{100, 50}}, {1, 0}, 25.0);
  ASSERT_EQ(lane.size(), 1U);
  EXPECT_NEAR(lane[0].x, 100.0, kTiny);
  EXPECT_NEAR(lane[0].y, 75.0, kTiny);
}

TEST(Lanes, KeepTheirDistanceFromARouteRoundACorner) {
  const Track lane = beside({{0, 0}, {100, 0}, {100, 100}}, {0, 1}, 10.0);
  ASSERT_EQ(lane.size(), 3U);
  EXPECT_NEAR(geom::distance(lane[0], {0, 10}), 0.0, kTiny);
  EXPECT_NEAR(geom::distance(lane[1], {90, 10}), 0.0, kTiny) << "the inside of a left turn";
  EXPECT_NEAR(geom::distance(lane[2], {90, 100}), 0.0, kTiny);
}

TEST(Lanes, DoNotRunFarOutAtASharpCorner) {
  const Track route = {{0, 0}, {100, 0}, {0, 1}};
  const Track lane = beside(route, {-1, 0}, 10.0);
  EXPECT_LE(geom::distance(lane[1], route[1]), 20.0 + kTiny);
}

TEST(Lanes, PassOverPointsThatStandTwice) {
  const Track lane = beside({{0, 0}, {0, 0}, {100, 0}, {100, 0}}, {1, 0}, 10.0);
  for (const geom::Point p : lane) EXPECT_NEAR(p.y, 10.0, kTiny);
}

TEST(Lanes, WithoutADirectionStayOnTheTrack) {
  EXPECT_EQ(beside({{5, 5}}, {}, 10.0)[0], (geom::Point{5, 5}));
  EXPECT_TRUE(beside({}, {}, 10.0).empty());
}

TEST(Lanes, AreClearWhereNothingIsInTheWay) {
  overlay::Overlay map;
  map.obstacles.push_back({.center = {500, 500}, .radius = 10.0, .height = 0.0, .place = {}});
  overlay::ControlMeasure wall;
  wall.kind = overlay::MeasureKind::kWall;
  wall.points = {{200, 110}, {300, 110}};
  map.measures.push_back(wall);
  const auto clear = [&](geom::Point track, geom::Point lane) { return is_clear(map, {track}, {lane}, 5.0); };
  EXPECT_TRUE(clear({100, 100}, {100, 150}));
  EXPECT_FALSE(clear({500, 450}, {500, 486})) << "in the obstacle's clearance";
  EXPECT_TRUE(clear({500, 450}, {500, 484}));
  EXPECT_FALSE(clear({250, 100}, {250, 120})) << "behind the wall";
  EXPECT_FALSE(clear({2, 500}, {2, 510})) << "at the edge of the area";
  EXPECT_FALSE(clear({990, 500}, {1001, 500}));
}

TEST(Lanes, FormationsTakeUpHalfTheirSizeOnEachSide) {
  using percept::Formation;
  EXPECT_NEAR(half_extent(Formation::kColumn, 2, 50.0, true), 25.0, kTiny);
  EXPECT_NEAR(half_extent(Formation::kColumn, 2, 50.0, false), 0.0, kTiny);
  EXPECT_NEAR(half_extent(Formation::kLine, 4, 50.0, false), 75.0, kTiny);
  EXPECT_EQ(half_extent(Formation::kNone, 4, 50.0, false), 0.0);
  EXPECT_EQ(half_extent(Formation::kLine, 1000, 50.0, false), 25000.0);
}

}  // namespace
}  // namespace mlab::mission
