#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/angle.h"
#include "mlab/base/random.h"
#include "mlab/base/testing/processor_time.h"
#include "mlab/sim/simulator.h"

namespace mlab::sim {
namespace {

using geom::Point;
using percept::Percepts;
using percept::Sensor;

BodyIndex add(Simulator& simulator, geom::Pose pose, const BodySpec& spec = {}, std::uint32_t unit = 0) {
  const auto robot = static_cast<std::uint32_t>(simulator.body_count() + 1);
  const BodySetup setup{.spec = spec, .pose = pose, .robot = {robot}, .unit = unit};
  const auto placed = simulator.add_body(setup);
  EXPECT_TRUE(placed && !placed->moved);
  return placed.value_or(Placement{}).body;
}

BodySpec with_ring(std::uint16_t count, double range, double beam_width = 0.0) {
  BodySpec spec;
  spec.ring.count = count;
  spec.ring.range = range;
  spec.ring.beam_width = beam_width;
  return spec;
}

/// What one body senses, with the memory that holds it.
struct Sensed {
  Sensed(const Simulator& simulator, BodyIndex body, const percept::Needs& needs) {
    simulator.sense(body, needs, buffer, percepts);
  }
  SenseBuffer buffer;
  Percepts percepts;
};

TEST(Obstacles, AreSensedWhereTheirEdgeIsInRange) {
  World world;
  world.discs = {{{10, 0}, 2.0}, {{0, 13.1}, 3.0}, {{-12.9, 0}, 3.0}};
  Simulator simulator(world);
  const BodyIndex body = add(simulator, {{0, 0}, std::numbers::pi / 2});
  const Sensed sensed(simulator, body, {{Sensor::kObstacles, 10.0}});
  ASSERT_EQ(sensed.percepts.obstacles.size(), 2U);
  EXPECT_NEAR(sensed.percepts.obstacles[0].center.x, 0.0, 1e-12);  // nearest edge first
  EXPECT_NEAR(sensed.percepts.obstacles[0].center.y, -10.0, 1e-12);
  EXPECT_EQ(sensed.percepts.obstacles[0].radius, 2.0);
  EXPECT_EQ(sensed.percepts.obstacles[1].radius, 3.0);
}

TEST(Obstacles, WallsAreSensedAsSmallDiscsWhereSixteenRaysHitThem) {
  World world;
  world.walls.push_back({{{5, -100}, {5, 100}}, 0});
  Simulator simulator(world);
  const BodyIndex body = add(simulator, {{0, 0}, 0.0});
  const Sensed sensed(simulator, body, {{Sensor::kObstacles, 6.0}});
  // Rays at 0 and +-22.5 degrees: 5 / cos(22.5) = 5.41; at 45 degrees it is 7.07.
  ASSERT_EQ(sensed.percepts.obstacles.size(), 3U);
  EXPECT_NEAR(sensed.percepts.obstacles[0].center.x, 5.0, 1e-12);
  EXPECT_NEAR(sensed.percepts.obstacles[0].center.y, 0.0, 1e-12);
  EXPECT_NEAR(std::abs(sensed.percepts.obstacles[1].center.y), 5 * std::tan(base::radians(22.5)), 1e-9);
  EXPECT_EQ(sensed.percepts.obstacles[2].radius, 0.1);
}

// The edge of the square from (10, -5) to (20, 5).
World with_avoided_square() {
  World world;
  const std::vector<Point> corners = {{10, -5}, {20, -5}, {20, 5}, {10, 5}};
  for (std::size_t i = 0; i < corners.size(); ++i)
    world.walls.push_back({{corners[i], corners[(i + 1) % corners.size()]}, 0, false});
  return world;
}

TEST(Obstacles, AnAvoidedAreaIsSensedAtItsNearestPointWhereThatIsInRange) {
  Simulator simulator(with_avoided_square());
  const BodyIndex body = add(simulator, {{4, 2}, 0.0});
  EXPECT_TRUE(Sensed(simulator, body, {{Sensor::kObstacles, 5.9}}).percepts.obstacles.empty());
  const Sensed sensed(simulator, body, {{Sensor::kObstacles, 6.1}});
  ASSERT_EQ(sensed.percepts.obstacles.size(), 1U);
  EXPECT_NEAR(sensed.percepts.obstacles[0].center.x, 6.0, 1e-12);
  EXPECT_NEAR(sensed.percepts.obstacles[0].center.y, 0.0, 1e-12);
  EXPECT_EQ(sensed.percepts.obstacles[0].radius, 0.0);
}

TEST(Obstacles, AnAvoidedAreaPushesWhoIsInsideToTheNearestWayOut) {
  Simulator simulator(with_avoided_square());
  const BodyIndex body = add(simulator, {{15, 3}, 0.0});
  const Sensed sensed(simulator, body, {{Sensor::kObstacles, 10.0}});
  ASSERT_EQ(sensed.percepts.obstacles.size(), 1U);
  const auto& [center, radius, velocity] = sensed.percepts.obstacles[0];
  EXPECT_EQ(velocity, geom::Vector{});
  EXPECT_NEAR(center.x, 0.0, 1e-12);
  EXPECT_NEAR(center.y, -2.0, 1e-12) << "the way out lies to the left";
  EXPECT_NEAR(radius, 2.0, 1e-12) << "it touches the robot";
}

TEST(Obstacles, AnAvoidedAreaHidesAndStopsNothing) {
  Simulator simulator(with_avoided_square());
  const BodyIndex body = add(simulator, {{5, 0}, 0.0}, with_ring(8, 20.0));
  add(simulator, {{15, 0}, 0.0});
  const Sensed sensed(simulator, body, {{Sensor::kRobots, 20.0}, {Sensor::kRanges}});
  ASSERT_EQ(sensed.percepts.robots.size(), 1U) << "one stands inside";
  EXPECT_NEAR(static_cast<double>(sensed.percepts.ranges[0].distance), 9.6, 1e-6) << "between the two bodies";
}

TEST(Obstacles, OnlyTheNearestWallOnARayIsSensed) {
  World world;
  for (int i = 0; i < 20; ++i) world.walls.push_back({{{5.0 + i, -0.5}, {5.0 + i, 0.5}}, 0});
  Simulator simulator(world);
  const Sensed sensed(simulator, add(simulator, {{0, 0}, 0.0}), {{Sensor::kObstacles, 50.0}});
  ASSERT_EQ(sensed.percepts.obstacles.size(), 1U);
  EXPECT_NEAR(sensed.percepts.obstacles[0].center.x, 5.0, 1e-12);
}

TEST(Robots, AreSensedNearestFirstButNotThroughWalls) {
  World world;
  world.walls.push_back({{{-5, -1}, {-5, 1}}, 0});
  Simulator simulator(world);
  const BodyIndex self = add(simulator, {{0, 0}, 1.0}, {}, 3);
  add(simulator, {{8, 0}, 2.0}, {}, 3);
  add(simulator, {{0, 4}, 0.0});
  add(simulator, {{-10, 0}, 0.0});
  add(simulator, {{30, 0}, 0.0});
  const Sensed sensed(simulator, self, {{Sensor::kRobots, 20.0}});
  ASSERT_EQ(sensed.percepts.robots.size(), 2U);
  EXPECT_EQ(sensed.percepts.robots[0].id.value, 3U);
  EXPECT_FALSE(sensed.percepts.robots[0].is_unit_mate);
  EXPECT_EQ(sensed.percepts.robots[1].id.value, 2U);
  EXPECT_TRUE(sensed.percepts.robots[1].is_unit_mate);
  EXPECT_NEAR(sensed.percepts.robots[1].heading, 1.0, 1e-12);
  EXPECT_NEAR(length(sensed.percepts.robots[1].center), 8.0, 1e-12);
}

TEST(Robots, HaveTheClassOfTheirColour) {
  Simulator simulator(World{});
  const BodyIndex body = add(simulator, {{0, 0}, 0.0});
  const BodySetup enemy{
      .spec = {}, .pose = {{5, 0}, 0.0}, .robot = {2}, .seen_as = percept::ObjectClass::kEnemyRobot};
  ASSERT_TRUE(simulator.add_body(enemy));
  add(simulator, {{9, 0}, 0.0});
  const Sensed sensed(simulator, body, {{Sensor::kRobots, 20.0}});
  ASSERT_EQ(sensed.percepts.robots.size(), 2U);
  EXPECT_EQ(sensed.percepts.robots[0].object_class, percept::ObjectClass::kEnemyRobot);
  EXPECT_EQ(sensed.percepts.robots[1].object_class, percept::ObjectClass::kFriendlyRobot);
}

TEST(Robots, ThatWereRemovedAreNotSensed) {
  Simulator simulator({});
  const BodyIndex self = add(simulator, {{0, 0}, 0.0});
  const BodyIndex other = add(simulator, {{2, 0}, 0.0});
  EXPECT_EQ(Sensed(simulator, self, {{Sensor::kRobots, 5}}).percepts.robots.size(), 1U);
  simulator.remove_body(other);
  EXPECT_EQ(Sensed(simulator, self, {{Sensor::kRobots, 5}}).percepts.robots.size(), 0U);
}

TEST(Objects, AreSensedWithRobotsAndObstaclesButNotThroughWalls) {
  World world;
  world.walls.push_back({{{-5, -1}, {-5, 1}}, 0});
  world.discs.push_back({{0, 9}, 1.0});
  using percept::ObjectClass;
  using percept::ObjectStyle;
  world.objects.push_back({.id = {1},
                           .object_class = ObjectClass::kMine,
                           .style = ObjectStyle::kMovable,
                           .center = {4, 0},
                           .radius = 0.1,
                           .carrier = {},
                           .basket = {}});
  world.objects.push_back({.id = {2},
                           .object_class = ObjectClass::kFlag,
                           .style = ObjectStyle::kMovable,
                           .center = {-7, 0},
                           .radius = 0.1,
                           .carrier = {},
                           .basket = {}});
  Simulator simulator(world);
  const BodyIndex self = add(simulator, {{0, 0}, 0.0});
  add(simulator, {{0, -6}, 0.0});
  const Sensed sensed(simulator, self, {{Sensor::kObjects, 20.0}});
  ASSERT_EQ(sensed.percepts.objects.size(), 3U);
  EXPECT_EQ(sensed.percepts.objects[0].id.value, 1U);
  EXPECT_EQ(sensed.percepts.objects[0].style, ObjectStyle::kMovable);
  EXPECT_EQ(sensed.percepts.objects[1].id.value, kRobotObjectBase + 2);
  EXPECT_EQ(sensed.percepts.objects[1].object_class, ObjectClass::kFriendlyRobot);
  EXPECT_EQ(sensed.percepts.objects[2].id.value, kDiscObjectBase);
  EXPECT_EQ(sensed.percepts.objects[2].object_class, ObjectClass::kRock);
}

TEST(Objects, AreListedByTheWayToTheirEdgeRobotsTheSame) {
  World world;
  world.discs.push_back({{0, 5}, 1.0});
  Simulator simulator(world);
  const BodyIndex self = add(simulator, {{0, 0}, 0.0});
  BodySpec large;
  large.radius = 3.0;
  add(simulator, {{6, 0}, 0.0}, large);
  const Sensed sensed(simulator, self, {{Sensor::kObjects, 20.0}});
  ASSERT_EQ(sensed.percepts.objects.size(), 2U);
  EXPECT_EQ(sensed.percepts.objects[0].id.value, kRobotObjectBase + 2) << "3 m, of the rock 4 m";
}

TEST(Ring, MeasuresFromTheSurfaceOfTheBody) {
  World world;
  world.discs.push_back({{3, 0}, 1.0});
  world.walls.push_back({{{-10, 1.5}, {10, 1.5}}, 0});
  Simulator simulator(world);
  const BodyIndex body = add(simulator, {{0, 0}, 0.0}, with_ring(4, 5.0));
  add(simulator, {{-2, 0}, 0.0});
  const Sensed sensed(simulator, body, {{Sensor::kRanges}});
  const auto ranges = sensed.percepts.ranges;
  ASSERT_EQ(ranges.size(), 4U);
  EXPECT_EQ(sensed.percepts.range_limit, 5.0);
  EXPECT_FLOAT_EQ(ranges[0].distance, 1.8F);
  EXPECT_FLOAT_EQ(ranges[1].distance, 1.3F);
  EXPECT_FLOAT_EQ(ranges[1].angle, std::numbers::pi_v<float> / 2);
  EXPECT_FLOAT_EQ(ranges[2].distance, 1.6F);
  EXPECT_FALSE(ranges[3].hit);
  EXPECT_FLOAT_EQ(ranges[3].distance, 5.0F);
}

TEST(Ring, IsEmptyWhereTheBodyHasNone) {
  World world;
  world.discs.push_back({{1, 0}, 0.2});
  world.walls.push_back({{{-10, 0.5}, {10, 0.5}}, 0});
  Simulator simulator(world);
  const BodyIndex body = add(simulator, {{0, 0}, 0.0});
  add(simulator, {{-2, 0}, 0.0});
  const Sensed sensed(simulator, body, {{Sensor::kRanges}});
  EXPECT_TRUE(sensed.percepts.ranges.empty());
}

TEST(Ring, AConeSeesWhatARayMisses) {
  World world;
  world.discs.push_back({{3, 1.5}, 1.0});
  Simulator simulator(world);
  const BodyIndex ray = add(simulator, {{0, 0}, 0.0}, with_ring(1, 5.0));
  EXPECT_FALSE(Sensed(simulator, ray, {{Sensor::kRanges}}).percepts.ranges[0].hit);
  Simulator other(world);
  const BodyIndex cone = add(other, {{0, 0}, 0.0}, with_ring(1, 5.0, base::radians(60.0)));
  const Sensed seen(other, cone, {{Sensor::kRanges}});
  EXPECT_FLOAT_EQ(seen.percepts.ranges[0].distance, static_cast<float>(std::hypot(3, 1.5) - 1.0 - 0.2));
}

TEST(Ring, NoiseAndDropoutHaveTheirMeasureAndRepeat) {
  World world;
  world.walls.push_back({{{-50, 2.2}, {50, 2.2}}, 0});
  BodySpec spec = with_ring(1, 5.0);
  spec.ring.first_angle = std::numbers::pi / 2;
  spec.ring.noise = 0.1;
  spec.ring.dropout = 0.25;
  Simulator simulator(world);
  const BodyIndex body = add(simulator, {{0, 0}, 0.0}, spec);
  int hits = 0;
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kCycles = 4000;
  for (int i = 0; i < kCycles; ++i) {
    const Sensed first(simulator, body, {{Sensor::kRanges}});
    const Sensed again(simulator, body, {{Sensor::kRanges}});
    ASSERT_EQ(first.percepts.ranges[0].distance, again.percepts.ranges[0].distance);
    if (first.percepts.ranges[0].hit) {
      ++hits;
      sum += first.percepts.ranges[0].distance;
      squares += std::pow(first.percepts.ranges[0].distance - 2.0, 2);
    }
    simulator.step({}, 0.1);
  }
  EXPECT_NEAR(hits, 0.75 * kCycles, 100);
  EXPECT_NEAR(sum / hits, 2.0, 0.01);
  EXPECT_NEAR(std::sqrt(squares / hits), 0.1, 0.005);
}

/// Where a ray from `from` in the direction `angle` first hits anything, told without any of the simulator's
/// code.
double ray_cast(const Simulator& simulator, BodyIndex self, double angle, double reach) {
  const Point from = simulator.pose(self).position;
  const double ux = std::cos(angle);
  const double uy = std::sin(angle);
  double nearest = reach;
  const auto see_disc = [&](Point center, double radius) {
    const double along = ux * (center.x - from.x) + uy * (center.y - from.y);
    const double aside = ux * (center.y - from.y) - uy * (center.x - from.x);
    if (along > 0 && std::abs(aside) < radius) {
      nearest = std::min(nearest, along - std::sqrt(radius * radius - aside * aside));
    }
  };
  for (const Disc& disc : simulator.discs()) see_disc(disc.center, disc.radius);
  for (std::uint32_t i = 0; i < simulator.body_count(); ++i) {
    if (i != self.value) see_disc(simulator.pose({i}).position, simulator.spec({i}).radius);
  }
  for (const Wall& wall : simulator.walls()) {
    // Solve from + t u = a + s (b - a).
    const Point a = wall.segment.a;
    const double ex = wall.segment.b.x - a.x;
    const double ey = wall.segment.b.y - a.y;
    const double det = ex * uy - ey * ux;
    const double t = (ex * (a.y - from.y) - ey * (a.x - from.x)) / det;
    const double s = (ux * (a.y - from.y) - uy * (a.x - from.x)) / det;
    if (t >= 0 && s >= 0 && s <= 1) nearest = std::min(nearest, t);
  }
  return nearest;
}

TEST(Ring, AgreesWithRayCastingInRandomWorlds) {
  for (int seed = 1; seed <= base::examples(60); ++seed) {
    base::Random random(static_cast<std::uint64_t>(seed));
    const Point far = seed % 3 == 0 ? Point{4e6, 4e6} : Point{};
    const auto place = [&] { return far + geom::Offset{random.uniform(-10, 10), random.uniform(-10, 10)}; };
    World world;
    for (int i = 0; i < 12; ++i) world.walls.push_back({{place(), place()}, 0});
    for (int i = 0; i < 12; ++i) world.discs.push_back({place(), random.uniform(0.0, 1.5)});
    Simulator simulator(world);
    BodySpec spec = with_ring(static_cast<std::uint16_t>(1 + random.below(40)), random.uniform(0.1, 15.0));
    spec.ring.first_angle = random.angle();
    if (seed % 2 == 0) spec.ring.arc = random.uniform(0.05, 6.25);
    const double spacing = spec.ring.arc > 0.0 && spec.ring.count > 1
                               ? spec.ring.arc / (spec.ring.count - 1)
                               : 2.0 * std::numbers::pi / spec.ring.count;
    for (std::uint32_t i = 0; i < 20; ++i) {
      simulator.add_body({.spec = spec, .pose = {place(), random.angle()}, .robot = {i + 1}, .unit = 0});
    }
    for (std::uint32_t i = 0; i < 20; ++i) {
      const Sensed sensed(simulator, {i}, {{Sensor::kRanges}});
      for (int beam = 0; beam < spec.ring.count; ++beam) {
        const double angle = simulator.pose({i}).heading + spec.ring.first_angle + spacing * beam;
        const double expected = ray_cast(simulator, {i}, angle, spec.ring.range + spec.radius) - spec.radius;
        const percept::RangeReading& reading = sensed.percepts.ranges[static_cast<std::size_t>(beam)];
        // Rays that graze an edge may go either way.
        const double beside =
            ray_cast(simulator, {i}, angle + 1e-7, spec.ring.range + spec.radius) - spec.radius;
        if (std::abs(beside - expected) > 1e-3) continue;
        ASSERT_NEAR(reading.distance, expected, 1e-5) << "seed " << seed << " beam " << beam;
      }
    }
  }
}

TEST(Ring, AScannerLooksOnlyOverItsArc) {
  Simulator simulator({});
  BodySpec spec = with_ring(3, 5.0);
  spec.ring.arc = std::numbers::pi;
  spec.ring.first_angle = -spec.ring.arc / 2;
  const BodyIndex self = simulator.add_body({.spec = spec, .pose = {}, .robot = {1}, .unit = 0})->body;
  add(simulator, {{-2, 0}, 0.0});
  add(simulator, {{0, 3}, 0.0});
  const Sensed sensed(simulator, self, {{Sensor::kRanges}});
  ASSERT_EQ(sensed.percepts.ranges.size(), 3U);
  EXPECT_FALSE(sensed.percepts.ranges[0].hit) << "right";
  EXPECT_FALSE(sensed.percepts.ranges[1].hit) << "ahead; what is behind is not seen";
  EXPECT_TRUE(sensed.percepts.ranges[2].hit) << "left";
}

TEST(Obstacles, AreWhatTheRingHitsWhereTheBodySeesByIt) {
  World world;
  world.discs.push_back({{3.0, 0.0}, 1.0});
  Simulator simulator(world);
  BodySpec spec = with_ring(4, 5.0);
  spec.has_ring_obstacles = true;
  const BodyIndex self = simulator.add_body({.spec = spec, .pose = {}, .robot = {1}, .unit = 0})->body;
  const Sensed sensed(simulator, self, {{Sensor::kObstacles, 5.0}});
  ASSERT_EQ(sensed.percepts.obstacles.size(), 1U);
  EXPECT_NEAR(sensed.percepts.obstacles[0].center.x, 2.0, 1e-6);
  EXPECT_EQ(sensed.percepts.obstacles[0].radius, 0.0);
  EXPECT_TRUE(sensed.percepts.ranges.empty()) << "not asked for";
  EXPECT_TRUE(Sensed(simulator, self, {{Sensor::kObstacles, 1.5}}).percepts.obstacles.empty());
}

TEST(Ring, AConeTellsTheNearestOfAllRaysInIt) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    base::Random random(seed);
    const auto place = [&] { return Point{random.uniform(-6, 6), random.uniform(-6, 6)}; };
    World world;
    for (int i = 0; i < 6; ++i) world.walls.push_back({{place(), place()}, 0});
    for (int i = 0; i < 6; ++i) world.discs.push_back({place(), random.uniform(0.0, 1.0)});
    Simulator simulator(world);
    const BodySpec spec = with_ring(8, 5.0, random.uniform(0.02, 3.0));
    simulator.add_body({.spec = spec, .pose = {place(), random.angle()}, .robot = {1}, .unit = 0});
    const Sensed sensed(simulator, {0}, {{Sensor::kRanges}});
    for (int beam = 0; beam < 8; ++beam) {
      const double axis = simulator.pose({0}).heading + std::numbers::pi / 4 * beam;
      double nearest = HUGE_VAL;
      for (int i = -2000; i <= 2000; ++i) {
        const double angle = axis + spec.ring.beam_width / 2 * i / 2000.0;
        nearest =
            std::min(nearest, ray_cast(simulator, {0}, angle, spec.ring.range + spec.radius) - spec.radius);
      }
      const double distance = sensed.percepts.ranges[static_cast<std::size_t>(beam)].distance;
      // Posts without width are seen by a cone, but by no ray.
      ASSERT_LE(distance, nearest + 1e-5) << "seed " << seed << " beam " << beam;
      ASSERT_GE(distance, nearest - 0.05) << "seed " << seed << " beam " << beam;
    }
  }
}

TEST(Obstacles, AndRobotsAgreeWithLookingAtEverythingInRandomWorlds) {
  for (int seed = 1; seed <= base::examples(40); ++seed) {
    base::Random random(static_cast<std::uint64_t>(seed));
    const double size = std::pow(10.0, random.uniform(0.5, 4.0));
    const auto place = [&] { return Point{random.uniform(-size, size), random.uniform(-size, size)}; };
    World world;
    for (int i = 0; i < 40; ++i)
      world.discs.push_back({place(), size * std::pow(10.0, random.uniform(-3.0, -1.0))});
    for (int i = 0; i < 10; ++i) world.walls.push_back({{place(), place()}, 0});
    Simulator simulator(world);
    for (std::uint32_t i = 0; i < 60; ++i) {
      simulator.add_body({.spec = {}, .pose = {place(), random.angle()}, .robot = {i + 1}, .unit = 0});
    }
    const double range = size * random.uniform(0.01, 1.0);
    for (std::uint32_t i = 0; i < simulator.body_count(); ++i) {
      const Point here = simulator.pose({i}).position;
      const auto discs = std::ranges::count_if(
          world.discs, [&](const Disc& d) { return distance(d.center, here) <= range + d.radius; });
      int robots = 0;
      for (std::uint32_t j = 0; j < simulator.body_count(); ++j) {
        const Point there = simulator.pose({j}).position;
        const bool is_hidden = std::ranges::any_of(
            world.walls, [&](const Wall& w) { return intersects(w.segment, geom::Segment{here, there}); });
        robots += j != i && distance(here, there) <= range && !is_hidden ? 1 : 0;
      }
      const Sensed sensed(simulator, {i}, {{Sensor::kObstacles, range}, {Sensor::kRobots, range}});
      const auto sensed_discs = std::ranges::count_if(
          sensed.percepts.obstacles, [](const percept::Obstacle& o) { return o.radius != 0.1; });
      ASSERT_EQ(sensed_discs, discs) << "seed " << seed;
      ASSERT_EQ(static_cast<int>(sensed.percepts.robots.size()), robots) << "seed " << seed;
      ASSERT_TRUE(std::ranges::is_sorted(sensed.percepts.obstacles, {}, [](const percept::Obstacle& o) {
        return std::round((length(o.center) - o.radius) * 1e6);
      }));
    }
  }
}

TEST(Sensing, RangesThatAreNoNumbersSenseNothing) {
  Simulator simulator({});
  const BodyIndex self = add(simulator, {{0, 0}, 0.0});
  add(simulator, {{1, 0}, 0.0});
  EXPECT_TRUE(Sensed(simulator, self, {{Sensor::kRobots, NAN}}).percepts.robots.empty());
  EXPECT_TRUE(Sensed(simulator, self, {{Sensor::kRobots, -3}}).percepts.robots.empty());
  EXPECT_EQ(Sensed(simulator, self, {{Sensor::kRobots, INFINITY}}).percepts.robots.size(), 1U);
}

TEST(Touch, TellsWhereTheNearestThingThatTouchesTheBodyIs) {
  World world;
  world.discs = {{{0, 1.205}, 1.0}};
  world.walls.push_back({{{-0.209, -1}, {-0.209, 1}}, 0});
  Simulator simulator(world);
  const BodyIndex body = add(simulator, {{0, 0}, std::numbers::pi / 2});
  const Sensed sensed(simulator, body, {{Sensor::kTouch}});
  EXPECT_NEAR(sensed.percepts.touch.x, 1.0, 1e-12) << "the disc is nearer than the wall, and ahead";
  EXPECT_NEAR(sensed.percepts.touch.y, 0.0, 1e-12);
}

TEST(Touch, FeelsWalls) {
  World world;
  world.walls.push_back({{{-1, -0.205}, {1, -0.205}}, 0});
  Simulator simulator(world);
  const Sensed sensed(simulator, add(simulator, {{0, 0}, 0.0}), {{Sensor::kTouch}});
  EXPECT_NEAR(sensed.percepts.touch.x, 0.0, 1e-12);
  EXPECT_NEAR(sensed.percepts.touch.y, -1.0, 1e-12);
}

TEST(Touch, FeelsRobotsOfAnySize) {
  Simulator simulator({});
  const BodyIndex body = add(simulator, {{0, 0}, 0.0});
  BodySpec large;
  large.radius = 2.0;
  const BodyIndex other = add(simulator, {{-2.205, 0}, 0.0}, large);
  EXPECT_NEAR(Sensed(simulator, body, {{Sensor::kTouch}}).percepts.touch.x, -1.0, 1e-12);
  EXPECT_NEAR(Sensed(simulator, other, {{Sensor::kTouch}}).percepts.touch.x, 1.0, 1e-12);
}

TEST(Touch, IsNothingWhereNothingIsNearerThanACentimetre) {
  World world;
  world.discs = {{{0, 1.211}, 1.0}};
  Simulator simulator(world);
  const BodyIndex body = add(simulator, {{0, 0}, 0.0});
  EXPECT_EQ(Sensed(simulator, body, {{Sensor::kTouch}}).percepts.touch, geom::Vector{});
  world.discs = {{{0, 1.209}, 1.0}};
  Simulator nearer(world);
  const BodyIndex touches = add(nearer, {{0, 0}, 0.0});
  EXPECT_EQ(Sensed(nearer, touches, {{Sensor::kTouch}}).percepts.touch, (geom::Vector{0, 1, 0}));
  EXPECT_EQ(Sensed(nearer, touches, {{Sensor::kRobots, 5.0}}).percepts.touch, geom::Vector{})
      << "not asked for";
}

TEST(Touch, IsFeltByABodyThatDrivesAgainstAWall) {
  World world;
  world.walls.push_back({{{1, -5}, {1, 5}}, 0});
  Simulator simulator(world);
  const BodyIndex body = add(simulator, {{0, 0}, 0.0});
  percept::Action ahead;
  ahead.velocity = {1.0, 0.0, 0.0};
  ahead.drives = true;
  for (int i = 0; i < 20; ++i) simulator.step(std::span(&ahead, 1), 0.1);
  const Sensed sensed(simulator, body, {{Sensor::kTouch}});
  EXPECT_NEAR(sensed.percepts.touch.x, 1.0, 1e-9);
}

}  // namespace
}  // namespace mlab::sim
