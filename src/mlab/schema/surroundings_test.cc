#include "mlab/schema/surroundings.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

using geom::Offset;

// A body at (100, 50) that looks north, in an area of 200 x 100 m, with cycles of 0.1 s.
class SurroundingsTest : public testing::Test {
 protected:
  static constexpr Spacing kSpacing{.radius = 0.5, .gap = 1.0, .fastest = 5.0};

  SurroundingsTest() {
    percepts_.pose = {{100, 50}, 1.5707963267948966};
    percepts_.cycle_duration = 0.1;
    percepts_.id = {1};
    percepts_.ground.bounds = {0, 0, 200, 100};
  }

  /// Where it goes in a cycle [m, world].
  Offset goes(Offset wanted) {
    flow::Obstacles near;
    for (std::size_t i = 0; i < obstacles_.size(); ++i) near.add(i);
    flow::Robots met;
    for (std::size_t i = 0; i < robots_.size(); ++i) met.add(i);
    const flow::ListView<percept::Obstacle> obstacles(near, obstacles_);
    const flow::ListView<percept::RobotReading> robots(met, robots_);
    SeenRobots seen;
    const geom::Point before = percepts_.pose.position + came_from_;
    const Surroundings around(percepts_, spacing_, obstacles, robots, before, seen);
    return around.clear_velocity(around.give_way(wanted), 5.0) * percepts_.cycle_duration;
  }

  percept::Percepts percepts_;
  Spacing spacing_ = kSpacing;
  Offset came_from_;  // in the cycle before
  std::vector<percept::Obstacle> obstacles_;
  std::vector<percept::RobotReading> robots_;
};

TEST_F(SurroundingsTest, WhoIsAloneGoesWhereItWants) {
  const Offset went = goes({3, -2});
  EXPECT_DOUBLE_EQ(went.x, 0.3);
  EXPECT_DOUBLE_EQ(went.y, -0.2);
}

TEST_F(SurroundingsTest, DirectionsTurnWithTheBody) {
  const flow::Obstacles near;
  const flow::Robots met;
  const flow::ListView<percept::Obstacle> obstacles(near, {});
  const flow::ListView<percept::RobotReading> robots(met, {});
  SeenRobots seen;
  const Surroundings around(percepts_, kSpacing, obstacles, robots, percepts_.pose.position, seen);
  const Offset north = around.to_world({1, 0, 0});
  EXPECT_NEAR(north.x, 0.0, 1e-15);
  EXPECT_NEAR(north.y, 1.0, 1e-15);
  EXPECT_NEAR(around.to_robot({0, 1}).x, 1.0, 1e-15);
}

TEST_F(SurroundingsTest, NothingSolidIsDrivenInto) {
  obstacles_.push_back({.center = {2.6, 0, 0}, .radius = 2.0});  // 0.1 m ahead, in the north
  const Offset towards = goes({0, 5});
  EXPECT_LE(towards.y, 0.1);
  const Offset away = goes({0, -5});
  EXPECT_NEAR(away.y, -0.5, 1e-9);
}

TEST_F(SurroundingsTest, OfWhatIsBetweenTwoRobotsEachTakesHalf) {
  robots_.push_back({.id = {2}, .center = {1.2, 0, 0}, .radius = 0.5});  // 0.2 m between them
  EXPECT_LE(goes({0, 5}).y, 0.1);
}

// A corridor whose walls are known, and seen by rays besides, which take them for a little thicker.
TEST_F(SurroundingsTest, WhereItIsTightOnlyTheWallsCountThatAreKnown) {
  percepts_.ground.revision = 1;
  const std::vector<geom::Segment> walls{{{99.28, 0}, {99.28, 100}}, {{100.72, 0}, {100.72, 100}}};
  for (const double ahead : {0.0, 0.72, -0.72}) {
    for (const double left : {0.72, -0.72}) obstacles_.push_back({.center = {ahead, left, 0}, .radius = 0.1});
  }
  EXPECT_LT(goes({0, 5}).y, 0.499) << "things that nobody knows of are kept clear of";
  percepts_.ground.walls = walls;
  EXPECT_NEAR(goes({0, 5}).y, 0.5, 1e-9);
}

// Somebody may come round it, and each drives half of what is between them.
TEST_F(SurroundingsTest, AmongOthersTheEndOfAWallIsPassedSlowly) {
  percepts_.ground.revision = 1;
  spacing_.obstacle_gap = 0.0;
  came_from_ = {0, -0.5};
  const Offset end{-0.71, 0.3};
  const geom::Point there = percepts_.pose.position + end;
  const std::vector<geom::Segment> wall{{there, {there.x, 90}}};
  const std::vector<geom::Segment> longer{{there, {there.x, 90}}, {there, {there.x, 20}}};
  percepts_.ground.walls = wall;
  const double half = 0.5 * (length(end) - kSpacing.radius);
  EXPECT_GT(dot(goes({0, 5}), unit(end)), half) << "alone";
  robots_.push_back({.id = {2}, .center = {-2.5, 0, 0}, .radius = 0.5});
  EXPECT_LE(dot(goes({0, 5}), unit(end)), half + 1e-9);
  EXPECT_GT(goes({0, 5}).y, 0.2);
  percepts_.ground.walls = longer;
  EXPECT_GT(goes({0, 5}).y, 0.45);
}

TEST_F(SurroundingsTest, TheAreaIsNotLeft) {
  percepts_.pose.position = {100, 99.9};
  EXPECT_LE(goes({0, 5}).y, 0.1 + 1e-9);
  percepts_.pose.position = {0.2, 50};
  EXPECT_GE(goes({-5, 0}).x, -0.2 - 1e-9);
}

}  // namespace
}  // namespace mlab::schema
