// Obstacles that move by themselves: where they are, what meets them, what is sensed of them.

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/sim/simulated_binding.h"
#include "mlab/sim/simulator.h"

namespace mlab::sim {
namespace {

using geom::Offset;
using geom::Point;
using percept::Sensor;

constexpr double kCycle = 0.1;

overlay::ObstacleDisc roaming(Point from, std::vector<Point> route, double speed, double radius) {
  return {
      .center = from, .radius = radius, .height = 0, .place = {}, .route = std::move(route), .speed = speed};
}

World world_with(std::vector<overlay::ObstacleDisc> obstacles) {
  overlay::Overlay map;
  map.area = overlay::Area{200.0, 200.0};
  map.obstacles = std::move(obstacles);
  return world_of(map);
}

BodyIndex add(Simulator& simulator, Point place, double heading = 0.0, std::uint32_t robot = 1) {
  BodySetup setup;
  setup.robot = {robot};
  setup.pose = {place, heading};
  setup.spec.kinematics.max_speed = 50.0;
  return simulator.add_body(setup)->body;
}

percept::Action drive_by(geom::Vector velocity) {
  percept::Action out;
  out.drives = out.spins = true;  // it looks ahead all the time
  out.velocity = velocity;
  return out;
}

void drive(Simulator& simulator, const std::vector<geom::Vector>& velocities, int cycles) {
  std::vector<percept::Action> actions;
  for (const geom::Vector& v : velocities) actions.push_back(drive_by(v));
  for (int i = 0; i < cycles; ++i) simulator.step(actions, kCycle);
}

TEST(Roaming, DiscsAreWhereTheirCourseIsAtTheTime) {
  Simulator simulator(world_with({roaming({50, 50}, {{60, 50}}, 2.0, 1.0)}));
  ASSERT_TRUE(simulator.discs().empty());
  ASSERT_EQ(simulator.moving_discs().size(), 1U);
  EXPECT_EQ(simulator.moving_discs()[0].center, (Point{50, 50}));
  drive(simulator, {}, 20);
  EXPECT_NEAR(simulator.moving_discs()[0].center.x, 54.0, 1e-9);
  EXPECT_NEAR(simulator.moving_discs()[0].velocity.x, 2.0, 1e-12);
  drive(simulator, {}, 50);
  EXPECT_NEAR(simulator.moving_discs()[0].center.x, 56.0, 1e-9);
  EXPECT_NEAR(simulator.moving_discs()[0].velocity.x, -2.0, 1e-12);
}

TEST(Roaming, DiscsAreWhereTheyWereInARestoredState) {
  Simulator simulator(world_with({roaming({50, 50}, {{60, 50}}, 2.0, 1.0)}));
  drive(simulator, {}, 10);
  const auto kept = simulator.snapshot();
  const Point then = simulator.moving_discs()[0].center;
  drive(simulator, {}, 33);
  const Point later = simulator.moving_discs()[0].center;
  simulator.restore(*kept);
  EXPECT_EQ(simulator.moving_discs()[0].center, then);
  drive(simulator, {}, 33);
  EXPECT_EQ(simulator.moving_discs()[0].center, later);
}

TEST(Roaming, ARobotStopsWhereItWouldDriveIntoOne) {
  Simulator simulator(world_with({roaming({50, 50}, {{150, 50}}, 1.0, 2.0)}));
  const BodyIndex body = add(simulator, {40, 50});
  for (int i = 0; i < 100; ++i) {
    drive(simulator, {{5.0, 0.0, 0.0}}, 1);
    const MovingDisc& disc = simulator.moving_discs()[0];
    ASSERT_GE(distance(simulator.pose(body).position, disc.center), 2.2 - 1e-6) << i;
  }
  // It is as fast as what is in front of it, and in one contact with it all the time.
  EXPECT_NEAR(simulator.pose(body).position.x, simulator.moving_discs()[0].center.x - 2.2, 0.01);
  EXPECT_EQ(simulator.contacts(body), 1U);
  EXPECT_EQ(simulator.run_over(body), 0U);
  EXPECT_TRUE(simulator.in_contact(body));
}

TEST(Roaming, ARobotThatStandsIsRunOverWhichIsNoContact) {
  Simulator simulator(world_with({roaming({40, 50}, {{60, 50}}, 2.0, 1.0)}));
  const BodyIndex body = add(simulator, {50, 50.5});
  drive(simulator, {{}}, 90);
  EXPECT_EQ(simulator.pose(body).position, (Point{50, 50.5}));
  EXPECT_EQ(simulator.contacts(body), 0U);
  EXPECT_EQ(simulator.run_over(body), 1U);
  drive(simulator, {{}}, 100);
  EXPECT_EQ(simulator.run_over(body), 2U) << "on the way back";
}

TEST(Roaming, WhoIsOvertakenDidNotDriveIntoIt) {
  Simulator simulator(world_with({roaming({40, 50}, {{90, 50}}, 4.0, 1.0)}));
  const BodyIndex body = add(simulator, {45, 50});
  drive(simulator, {{1.0, 0.0, 0.0}}, 60);
  EXPECT_NEAR(simulator.pose(body).position.x, 51.0, 1e-9);
  EXPECT_EQ(simulator.contacts(body), 0U);
  EXPECT_EQ(simulator.run_over(body), 1U);
}

TEST(Roaming, WhoMeetsItHeadOnHasOneContactThoughItGoesOnOverTheRobot) {
  Simulator simulator(world_with({roaming({60, 50}, {{20, 50}}, 2.0, 1.0)}));
  const BodyIndex body = add(simulator, {40, 50});
  drive(simulator, {{1.0, 0.0, 0.0}}, 70);
  EXPECT_EQ(simulator.contacts(body), 1U);
  EXPECT_EQ(simulator.run_over(body), 0U);
}

TEST(Roaming, NothingIsJumpedOver) {
  // It is past the robot within one cycle, and the robot past it.
  Simulator simulator(
      world_with({roaming({50, 50}, {{50, 60}}, 90.0, 0.1), roaming({80, 56}, {{90, 56}}, 0.001, 0.1)}));
  const BodyIndex stands = add(simulator, {50, 54.5}, 0.0, 1);
  const BodyIndex fast = add(simulator, {78, 56}, 0.0, 2);
  drive(simulator, {{}, {45.0, 0.0, 0.0}}, 1);
  EXPECT_EQ(simulator.run_over(stands), 1U);
  EXPECT_EQ(simulator.contacts(fast), 1U);
  EXPECT_NEAR(simulator.pose(fast).position.x, 79.7, 0.001);
}

TEST(Roaming, WhoIsRunOverMayLeave) {
  Simulator simulator(world_with({roaming({48, 50}, {{150, 50}}, 1.0, 3.0)}));
  const BodyIndex body = add(simulator, {52, 50.5});
  drive(simulator, {{}}, 20);
  ASSERT_LT(distance(simulator.pose(body).position, simulator.moving_discs()[0].center), 3.0);
  drive(simulator, {{0.0, 2.0, 0.0}}, 20);
  EXPECT_GT(distance(simulator.pose(body).position, simulator.moving_discs()[0].center), 3.2);
  EXPECT_NEAR(simulator.pose(body).position.y, 54.5, 1e-6);
  EXPECT_EQ(simulator.contacts(body), 0U);
}

TEST(Roaming, ARobotThatDrivesBesideOneTouchesIt) {
  Simulator simulator(world_with({roaming({50, 50}, {{90, 50}}, 1.0, 1.0)}));
  const BodyIndex body = add(simulator, {50, 51.5});
  drive(simulator, {{1.0, 0.0, 0.0}}, 30);
  EXPECT_EQ(simulator.contacts(body), 0U);
  EXPECT_EQ(simulator.run_over(body), 0U);
  EXPECT_FALSE(simulator.in_contact(body));
}

TEST(Roaming, NobodyStartsInOne) {
  Simulator simulator(world_with({roaming({50, 50}, {{90, 50}}, 1.0, 3.0)}));
  const BodyIndex body = add(simulator, {51, 50});
  EXPECT_GE(distance(simulator.pose(body).position, {50, 50}), 3.2 - 1e-6);
  EXPECT_FALSE(simulator.is_free({50, 53}, 0.2));
  drive(simulator, {{}}, 100);
  EXPECT_TRUE(simulator.is_free({50, 46}, 0.2));
}

TEST(Roaming, ObstaclesAreToldWithTheirVelocityInTheRobotsFrame) {
  Simulator simulator(world_with({roaming({50, 60}, {{60, 60}}, 2.0, 1.0),
                                  roaming({50, 55}, {{50, 56}}, 0.5, 0.5),
                                  {.center = {50, 45}, .radius = 1.0, .height = 0.0, .place = {}}}));
  const BodyIndex body = add(simulator, {50, 50}, std::numbers::pi / 2);
  drive(simulator, {{}}, 10);
  SenseBuffer buffer;
  percept::Percepts out;
  simulator.sense(body, {{Sensor::kObstacles, 20.0}}, buffer, out);
  ASSERT_EQ(out.obstacles.size(), 3U);
  const percept::Obstacle& stands = out.obstacles[0];
  EXPECT_NEAR(stands.center.x, -5.0, 1e-9);
  EXPECT_FALSE(stands.is_moving());
  const percept::Obstacle& ahead = out.obstacles[1];
  EXPECT_NEAR(ahead.center.x, 5.5, 1e-9);
  EXPECT_NEAR(ahead.velocity.x, 0.5, 1e-9);
  EXPECT_NEAR(ahead.velocity.y, 0.0, 1e-9);
  const percept::Obstacle& aside = out.obstacles[2];
  EXPECT_NEAR(aside.center.x, 10.0, 1e-9);
  EXPECT_NEAR(aside.center.y, -2.0, 1e-9);
  EXPECT_NEAR(aside.velocity.x, 0.0, 1e-9);
  EXPECT_NEAR(aside.velocity.y, -2.0, 1e-9);
  EXPECT_EQ(aside.radius, 1.0);
}

TEST(Roaming, AllSensorsNoticeIt) {
  Simulator simulator(world_with({roaming({60, 50}, {{51.2, 50}}, 1.0, 1.0)}));
  BodySetup setup;
  setup.robot = {1};
  setup.pose = {{50, 50}, 0.0};
  setup.spec.ring = {.count = 4, .range = 20.0};
  const BodyIndex body = simulator.add_body(setup)->body;
  drive(simulator, {{}}, 30);
  SenseBuffer buffer;
  percept::Percepts out;
  simulator.sense(body, {{Sensor::kRanges, 1.0}, {Sensor::kObjects, 20.0}, {Sensor::kTouch, 1.0}}, buffer,
                  out);
  ASSERT_EQ(out.ranges.size(), 4U);
  EXPECT_TRUE(out.ranges[0].hit);
  EXPECT_NEAR(out.ranges[0].distance, 7.0 - 1.0 - 0.2, 1e-5);
  ASSERT_EQ(out.objects.size(), 1U);
  EXPECT_EQ(out.objects[0].object_class, percept::ObjectClass::kRock);
  EXPECT_EQ(out.objects[0].id.value, kRoamerObjectBase);
  EXPECT_NEAR(out.objects[0].center.x, 7.0, 1e-9);
  EXPECT_EQ(geom::length(out.touch), 0.0);
  drive(simulator, {{}}, 58);
  simulator.sense(body, {{Sensor::kTouch, 1.0}}, buffer, out);
  EXPECT_NEAR(out.touch.x, 1.0, 1e-9);
}

TEST(Roaming, ARingTellsHowFastIsWhatItHits) {
  Simulator simulator(world_with({roaming({60, 50}, {{52, 50}}, 1.0, 1.0),
                                  {.center = {50, 60}, .radius = 1.0, .height = 0.0, .place = {}}}));
  BodySetup setup;
  setup.robot = {1};
  setup.pose = {{50, 50}, 0.0};
  setup.spec.ring = {.count = 4, .range = 20.0};
  setup.spec.has_ring_obstacles = true;
  const BodyIndex body = simulator.add_body(setup)->body;
  drive(simulator, {{}}, 30);
  SenseBuffer buffer;
  percept::Percepts out;
  simulator.sense(body, {{Sensor::kObstacles, 20.0}}, buffer, out);
  ASSERT_EQ(out.obstacles.size(), 2U);
  EXPECT_NEAR(out.obstacles[0].velocity.x, -1.0, 1e-9);
  EXPECT_FALSE(out.obstacles[1].is_moving());
}

TEST(Roaming, AnyNumberOfThreadsGivesTheSame) {
  const auto all_of = [](int threads) {
    std::vector<overlay::ObstacleDisc> obstacles;
    for (int i = 0; i < 8; ++i)
      obstacles.push_back(roaming({10.0 + 20 * i, 20}, {{20.0 + 15 * i, 180}}, 1.0 + i, 1.0 + 0.3 * i));
    Simulator simulator(world_with(obstacles), {.seed = 1, .threads = threads});
    std::vector<geom::Vector> velocities;
    for (std::uint32_t i = 0; i < 600; ++i) {
      const std::uint32_t row = i / 27;
      add(simulator, {5.0 + 7 * (i % 27), 30.0 + 6.0 * row}, i, i + 1);
      velocities.push_back({1.0 + i % 5, 0.3 * (i % 3), 0.0});
    }
    drive(simulator, velocities, 150);
    std::vector<double> out;
    for (std::uint32_t i = 0; i < 600; ++i) {
      const Point at = simulator.pose(BodyIndex{i}).position;
      out.insert(out.end(), {at.x, at.y, 1.0 * simulator.contacts(BodyIndex{i}),
                             1.0 * simulator.run_over(BodyIndex{i})});
    }
    return out;
  };
  const std::vector<double> one = all_of(1);
  EXPECT_EQ(one, all_of(4));
  double run_over = 0.0;
  for (std::size_t i = 3; i < one.size(); i += 4) run_over += one[i];
  EXPECT_GT(run_over, 0.0);
}

TEST(Roaming, AChangedMapHasItsRoamersWhereTheyAreByNow) {
  overlay::Overlay before;
  before.area = overlay::Area{200.0, 200.0};
  before.obstacles = {roaming({50, 50}, {{60, 50}}, 1.0, 1.0), {{100, 100}, 2.0, 0.0, {}}};
  overlay::Overlay after = before;
  after.obstacles[0] = roaming({50, 50}, {{60, 50}}, 0.5, 1.0);
  SimulatedBinding binding(world_of(before), {});
  for (int i = 0; i < 40; ++i) binding.carry_out({}, kCycle);
  const binding::MapChange change = binding.change_map(before, after);
  EXPECT_TRUE(change.moved_by_obstacles.empty());
  const binding::WorldView& view = static_cast<binding::Binding&>(binding).view();
  ASSERT_EQ(view.moving_discs().size(), 1U);
  EXPECT_NEAR(view.moving_discs()[0].center.x, 52.0, 1e-9);
  EXPECT_EQ(view.discs().size(), 1U);
}

TEST(Roaming, WhatNoWorldHasIsLeftOut) {
  World world;
  world.roamers = {{overlay::Course({{0, 0}, {1e9, 0}}, 1.0), 1.0},
                   {overlay::Course({{0, 0}, {1, 0}}, 1.0), -1.0},
                   {overlay::Course({{3, 3}, {3, 3}}, 1.0), 1.0},
                   {overlay::Course({{0, 0}, {1, 0}}, std::nan("")), 1.0},
                   {overlay::Course({{0, 0}, {1, 0}}, 1.0), 1.0}};
  keep_usable(world);
  EXPECT_EQ(world.roamers.size(), 1U);
}

}  // namespace
}  // namespace mlab::sim
