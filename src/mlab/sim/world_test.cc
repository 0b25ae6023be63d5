#include "mlab/sim/world.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mlab::sim {
namespace {

using overlay::ControlMeasure;
using overlay::MeasureKind;

ControlMeasure measure(MeasureKind kind, std::string name, std::vector<geom::Point> points) {
  ControlMeasure m;
  m.kind = kind;
  m.name = std::move(name);
  m.points = std::move(points);
  return m;
}

TEST(World, TakesObstaclesAndTheAreaFromTheOverlay) {
  overlay::Overlay overlay;
  overlay.area = overlay::Area{300, 200};
  overlay.obstacles.push_back({.center = {10, 20}, .radius = 3, .height = 0, .place = {}});
  const World world = world_of(overlay);
  ASSERT_EQ(world.discs.size(), 1U);
  EXPECT_EQ(world.discs[0].center, (geom::Point{10, 20}));
  EXPECT_EQ(world.discs[0].radius, 3);
  EXPECT_EQ(world.area_high, (geom::Point{300, 200}));
}

TEST(World, WallsAreSolidAndBoundariesGapsAndRoomsAreNot) {
  overlay::Overlay overlay;
  const std::vector<geom::Point> line = {{0, 0}, {5, 0}, {5, 5}};
  for (const MeasureKind kind :
       {MeasureKind::kWall, MeasureKind::kBoundary, MeasureKind::kGap, MeasureKind::kRoom, MeasureKind::kDoor,
        MeasureKind::kHallway, MeasureKind::kRoad, MeasureKind::kAxis}) {
    overlay.measures.push_back(measure(kind, "", line));
  }
  overlay.measures.push_back(measure(MeasureKind::kWall, "", {{9, 9}, {8, 8}}));
  const World world = world_of(overlay);
  ASSERT_EQ(world.walls.size(), 3U);
  EXPECT_EQ(world.walls[0].group, world.walls[1].group);
  EXPECT_NE(world.walls[1].group, world.walls[2].group);
  EXPECT_EQ(world.walls[2].segment.a, (geom::Point{9, 9}));
}

TEST(World, AMinefieldIsAClosedEdgeThatIsNotSolidBehindAllWalls) {
  overlay::Overlay overlay;
  overlay.measures.push_back(measure(MeasureKind::kMinefield, "", {{0, 0}, {5, 0}, {5, 5}}));
  overlay.measures.push_back(measure(MeasureKind::kWall, "", {{9, 9}, {8, 8}}));
  overlay.measures.push_back(measure(MeasureKind::kMinefield, "", {{50, 50}}));
  overlay.measures.back().size = 20.0;
  const World world = world_of(overlay);
  ASSERT_EQ(world.walls.size(), 1U + 3U + 24U);
  EXPECT_TRUE(world.walls[0].is_solid);
  EXPECT_FALSE(world.walls[1].is_solid);
  EXPECT_EQ(world.walls[3].segment.b, (geom::Point{0, 0})) << "it comes back to where it began";
  EXPECT_NE(world.walls[3].group, world.walls[4].group);
  for (std::size_t i = 4; i < world.walls.size(); ++i)
    EXPECT_NEAR(distance(nearest_point(world.walls[i].segment, {50, 50}), {50, 50}), 10.0, 1e-9);
}

TEST(World, AWeatherZoneIsAClosedWallAndANoFlyZoneConcernsNobodyOnTheGround) {
  overlay::Overlay overlay;
  const std::vector<geom::Point> line = {{0, 0}, {5, 0}, {5, 5}};
  overlay.measures.push_back(measure(MeasureKind::kBoundary, "Storm-WeatherZone", line));
  overlay.measures.push_back(measure(MeasureKind::kBoundary, "NoFlyZone1", line));
  overlay.measures.push_back(measure(MeasureKind::kBoundary, "NoCommZone", line));
  const World world = world_of(overlay);
  EXPECT_EQ(world.walls.size(), 3U);
  EXPECT_EQ(world.silences, (std::vector<Outline>{line}));
}

TEST(World, ObjectsHaveAClassByTheirColour) {
  overlay::Overlay overlay;
  overlay.objects.push_back({.center = {1, 2},
                             .diameter = 0.4,
                             .style = overlay::ObjectStyle::kContainer,
                             .color = "Green",
                             .place = {}});
  overlay.objects.push_back({.center = {3, 4},
                             .diameter = 5,
                             .style = overlay::ObjectStyle::kFixed,
                             .color = "dark sea green",
                             .place = {}});
  overlay.objects.push_back({.center = {3, 4},
                             .diameter = 5,
                             .style = overlay::ObjectStyle::kMovable,
                             .color = "mauve",
                             .place = {}});
  const World world = world_of(overlay);
  ASSERT_EQ(world.objects.size(), 3U);
  EXPECT_EQ(world.objects[0].id.value, 1U);
  EXPECT_EQ(world.objects[0].object_class, percept::ObjectClass::kBasket);
  EXPECT_EQ(world.objects[0].style, percept::ObjectStyle::kContainer);
  EXPECT_EQ(world.objects[0].radius, 0.2);
  EXPECT_EQ(world.objects[1].object_class, percept::ObjectClass::kTree);
  EXPECT_EQ(world.objects[2].object_class, percept::ObjectClass::kUnknown);
}

TEST(World, ObjectsWithARouteTravel) {
  overlay::Overlay overlay;
  overlay.objects.push_back({.center = {1, 2}, .diameter = 1, .style = {}, .color = "red", .place = {}});
  overlay.objects.push_back({.center = {3, 4},
                             .diameter = 1,
                             .style = {},
                             .color = "red",
                             .place = {},
                             .route = {{3, 9}},
                             .speed = 2});
  const World world = world_of(overlay);
  ASSERT_EQ(world.travels.size(), 1U);
  EXPECT_EQ(world.travels[0].object.value, 2U);
  EXPECT_EQ(world.travels[0].course->at(1.0).place, (geom::Point{3, 6}));
}

TEST(World, WhatIsNotANumberOrTooFarAwayIsLeftOut) {
  World world;
  world.discs = {{{0, 0}, 1}, {{NAN, 0}, 1}, {{0, 0}, -1}, {{0, 2e8}, 1}, {{0, 0}, INFINITY}};
  world.walls = {{{{0, 0}, {1, 1}}, 0}, {{{0, 0}, {INFINITY, 1}}, 0}};
  world.area_high = {NAN, INFINITY};
  keep_usable(world);
  EXPECT_EQ(world.discs.size(), 1U);
  EXPECT_EQ(world.walls.size(), 1U);
  EXPECT_EQ(world.area_high, (geom::Point{World::kFarthest, World::kFarthest}));
}

}  // namespace
}  // namespace mlab::sim
