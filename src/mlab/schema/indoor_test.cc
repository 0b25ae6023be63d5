#include "mlab/schema/indoor.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

using geom::Offset;
using geom::Point;
constexpr double kHalfTurn = std::numbers::pi;

const std::array<Point, 6> kLShape = {{{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 10}, {0, 10}}};
const std::array<percept::Room, 1> kRooms = {{{kLShape}}};
const std::array<percept::Hallway, 1> kHallways = {{{{0, -2}, {20, -2}, 3.0}}};
const std::array<percept::Door, 2> kDoors = {{{{4, 0}, {6, 0}, false}, {{12, 0}, {13, 0}, true}}};
const percept::SiteMap kMap{kDoors, kRooms, kHallways};

TEST(Indoor, KnowsItsRoomByTheOutline) {
  EXPECT_TRUE(is_in_room(kMap, {2, 8}));
  EXPECT_TRUE(is_in_room(kMap, {8, 2}));
  EXPECT_FALSE(is_in_room(kMap, {8, 8}));
  EXPECT_FALSE(is_in_room(kMap, {5, -1}));
}

TEST(Indoor, KnowsItsHallwayByAxisAndWidth) {
  EXPECT_EQ(hallway_at(kMap, {5, -3.4}), kHallways.data());
  EXPECT_EQ(hallway_at(kMap, {5, -3.6}), nullptr);
  EXPECT_EQ(hallway_at(kMap, {-0.1, -2}), nullptr);
  EXPECT_FALSE(is_in(percept::Hallway{{1, 1}, {1, 1}, 2.0}, {1, 1}));
}

TEST(Indoor, FindsTheNearestDoorAndLeavesMarkedOnesOut) {
  EXPECT_EQ(nearest_door(kMap, {12, -1}, false), 2U);
  EXPECT_EQ(nearest_door(kMap, {12, -1}, true), 1U);
  EXPECT_EQ(nearest_door({}, {12, -1}, false), 0U);
  EXPECT_FALSE(door(kMap, 0).has_value());
  EXPECT_FALSE(door(kMap, 3).has_value());
}

TEST(Indoor, LaysAPassageToTheOtherSide) {
  const Passage in = passage(kDoors[0], {5, -3}, 1.5);
  EXPECT_DOUBLE_EQ(in.target.x, 5.0);
  EXPECT_DOUBLE_EQ(in.target.y, 1.5);
  EXPECT_DOUBLE_EQ(in.half_width, 1.0);
  EXPECT_DOUBLE_EQ(passage(kDoors[0], {5, 3}, 1.5).target.y, -1.5);
}

TEST(DockDirection, IsStraightFromAfarAndZeroAtTheDock) {
  const DockField field{.controlled_radius = 2.0, .ballistic_gain = 0.5};
  const Offset far = dock_direction({10, 0}, {0, 0}, kHalfTurn, field);
  EXPECT_DOUBLE_EQ(far.x, -0.5);
  EXPECT_DOUBLE_EQ(far.y, 0.0);
  EXPECT_EQ(dock_direction({0.04, 0}, {0, 0}, 0.0, field), (Offset{}));
}

TEST(DockDirection, GoesStraightOnTheAxis) {
  const Offset on = dock_direction({1, 0}, {0, 0}, 0.0, {});
  EXPECT_DOUBLE_EQ(on.x, -1.0);
  EXPECT_DOUBLE_EQ(on.y, 0.0);
}

TEST(DockDirection, BringsARobotRoundToTheAxisFromAnySide) {
  for (const double start : {0.3, 1.5, 2.9, -2.9, -1.0}) {
    Point robot{1.5 * std::cos(start), 1.5 * std::sin(start)};
    double last_angle = start;
    for (int i = 0; i < 20000 && length(robot - Point{}) > 0.06; ++i) {
      robot = robot + dock_direction(robot, {0, 0}, 0.0, {.controlled_radius = 3.0}) * 0.001;
      if (length(robot - Point{}) > 0.3) last_angle = std::atan2(robot.y, robot.x);
    }
    EXPECT_LT(length(robot - Point{}), 0.06) << start;
    EXPECT_LT(std::abs(last_angle), 0.6) << start;
  }
}

TEST(LooksAt, SeesADoorInItsConeUpToItsRange) {
  const double left = kHalfTurn / 2;
  EXPECT_TRUE(looks_at(kDoors[0], {5, -2}, left, 2.5));
  EXPECT_FALSE(looks_at(kDoors[0], {5, -2}, left, 1.5));
  EXPECT_FALSE(looks_at(kDoors[0], {5, -2}, -left, 2.5));
  EXPECT_TRUE(looks_at(kDoors[0], {3.85, -2}, left, 2.5)) << "the edge of the cone";
  EXPECT_FALSE(looks_at(kDoors[0], {3.5, -2}, left, 2.5));
}

}  // namespace
}  // namespace mlab::schema
