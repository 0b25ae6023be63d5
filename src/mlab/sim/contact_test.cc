#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/random.h"
#include "mlab/binding/passage.h"
#include "mlab/sim/simulator.h"

namespace mlab::sim {
namespace {

using geom::Point;
using percept::Action;

Action driving(double x, double y) {
  Action action;
  action.drives = true;
  action.spins = true;  // keeps the heading, so that x stays east
  action.velocity = {x, y, 0.0};
  return action;
}

BodySpec disc_body(double radius) {
  BodySpec spec;
  spec.radius = radius;
  return spec;
}

BodyIndex add(Simulator& simulator, Point place, double radius = 0.2) {
  const auto robot = static_cast<std::uint32_t>(simulator.body_count() + 1);
  const BodySetup setup{.spec = disc_body(radius), .pose = {place, 0.0}, .robot = {robot}, .unit = 0};
  const auto placed = simulator.add_body(setup);
  EXPECT_TRUE(placed && !placed->moved);
  return placed.value_or(Placement{}).body;
}

/// How deep the bodies are inside anything, at most; negative: how near they come to it [m].
double deepest(const Simulator& simulator) {
  double depth = -HUGE_VAL;
  const auto count = static_cast<std::uint32_t>(simulator.body_count());
  for (std::uint32_t i = 0; i < count; ++i) {
    const Point p = simulator.pose({i}).position;
    const double r = simulator.spec({i}).radius;
    for (const Disc& disc : simulator.discs())
      depth = std::max(depth, r + disc.radius - distance(disc.center, p));
    for (const Wall& wall : simulator.walls()) {
      depth = std::max(depth, r - distance(nearest_point(wall.segment, p), p));
    }
    for (std::uint32_t j = 0; j < i; ++j) {
      depth = std::max(depth, r + simulator.spec({j}).radius - distance(simulator.pose({j}).position, p));
    }
  }
  return depth;
}

void run(Simulator& simulator, const std::vector<Action>& actions, int cycles, double dt = 0.1) {
  for (int i = 0; i < cycles; ++i) simulator.step(actions, dt);
}

TEST(Contact, ARobotStopsAtAWallItDrivesInto) {
  World world;
  world.walls.push_back({{{5, -10}, {5, 10}}, 0});
  Simulator simulator(world);
  const BodyIndex body = add(simulator, {0, 0});
  run(simulator, {driving(1, 0)}, 100);
  EXPECT_NEAR(simulator.pose(body).position.x, 4.8, 1e-5);
  EXPECT_EQ(simulator.contacts(body), 1U);
  EXPECT_NEAR(simulator.distance_driven(body), 4.8, 1e-5);
}

TEST(Contact, NothingIsJumpedOverAtAnySpeed) {
  for (const double speed : {1.0, 1e2, 1e4, 1e6, 1e300}) {
    for (const double radius : {0.0, 0.2, 3.0}) {
      World world;
      world.walls.push_back({{{5, -10}, {5, 10}}, 0});
      world.discs.push_back({{-5, 0}, 0.01});
      Simulator simulator(world);
      const BodyIndex body = add(simulator, {0, 0}, radius);
      run(simulator, {driving(speed, 0)}, 50);
      EXPECT_NEAR(simulator.pose(body).position.x, 5 - radius, 1e-5) << speed;
      run(simulator, {driving(-speed, 0)}, 100);
      EXPECT_NEAR(simulator.pose(body).position.x, -4.99 + radius, 1e-5) << speed;
    }
  }
}

TEST(Contact, ARobotSlidesAlongAWallWithTheRestOfItsSpeed) {
  World world;
  world.walls.push_back({{{-100, 0.2}, {100, 0.2}}, 0});
  Simulator simulator(world);
  const BodyIndex body = add(simulator, {0, -0.1});
  run(simulator, {driving(1, 1)}, 100);
  EXPECT_NEAR(simulator.pose(body).position.x, 10.0, 1e-3);
  EXPECT_NEAR(simulator.pose(body).position.y, 0.0, 1e-4);
  EXPECT_EQ(simulator.contacts(body), 1U);
}

TEST(Contact, ARobotSlidesRoundADiscWithoutLosingTouch) {
  World world;
  world.discs.push_back({{5, 0.05}, 1.0});
  Simulator simulator(world);
  const BodyIndex body = add(simulator, {0, 0});
  run(simulator, {driving(1, 0)}, 150);
  EXPECT_GT(simulator.pose(body).position.x, 7.0);
  EXPECT_EQ(simulator.contacts(body), 1U);
}

TEST(Contact, ARobotPushedIntoACornerStaysThere) {
  World world;
  world.walls.push_back({{{5, -10}, {5, 5}}, 0});
  world.walls.push_back({{{5, 5}, {-10, 5}}, 1});
  Simulator simulator(world);
  const BodyIndex body = add(simulator, {0, 0});
  run(simulator, {driving(30, 17)}, 50);
  EXPECT_NEAR(simulator.pose(body).position.x, 4.8, 1e-5);
  EXPECT_NEAR(simulator.pose(body).position.y, 4.8, 1e-5);
  EXPECT_EQ(simulator.contacts(body), 2U);
  run(simulator, {driving(-1, 0)}, 10);
  EXPECT_NEAR(simulator.pose(body).position.x, 3.8, 1e-4);
}

TEST(Contact, TwoRobotsHeadOnStopBetweenTheirStarts) {
  Simulator simulator({});
  const BodyIndex a = add(simulator, {0, 0});
  const BodyIndex b = add(simulator, {2, 0});
  run(simulator, {driving(1, 0), driving(-3, 0)}, 50);
  EXPECT_NEAR(distance(simulator.pose(a).position, simulator.pose(b).position), 0.4, 1e-4);
  EXPECT_NEAR(simulator.pose(a).position.x, 0.4, 1e-4);
  EXPECT_EQ(simulator.contacts(a), 1U);
  EXPECT_EQ(simulator.contacts(b), 1U);
}

TEST(Contact, TouchingRobotsCanSeparateAndSlidePastEachOther) {
  Simulator simulator({});
  const BodyIndex a = add(simulator, {0, 0});
  const BodyIndex b = add(simulator, {0.4, 0});
  run(simulator, {driving(0, 1), driving(0, 0)}, 10);
  EXPECT_NEAR(simulator.pose(a).position.y, 1.0, 1e-3);
  run(simulator, {driving(0, -1), driving(1, 0)}, 10);
  EXPECT_NEAR(simulator.pose(b).position.x, 1.4, 1e-3);
}

TEST(Contact, ARobotThatIsRunIntoFromBehindGoesOn) {
  Simulator simulator({});
  const BodyIndex front = add(simulator, {1, 0});
  add(simulator, {0, 0});
  run(simulator, {driving(1, 0), driving(5, 0)}, 20);
  EXPECT_NEAR(simulator.pose(front).position.x, 3.0, 1e-9);
}

TEST(Contact, AConvoyThatTouchesDrivesAtFullSpeed) {
  Simulator simulator({});
  std::vector<Action> actions;
  for (int i = 0; i < 30; ++i) {
    add(simulator, {0.4 * i, 0});
    actions.push_back(driving(1, 0));
  }
  run(simulator, actions, 10);
  for (std::uint32_t i = 0; i < 30; ++i) EXPECT_NEAR(simulator.pose({i}).position.x, 0.4 * i + 1.0, 1e-3);
}

TEST(Contact, AConvoyBeforeAWallClosesUpWithoutOverlap) {
  World world;
  world.walls.push_back({{{20, -10}, {20, 10}}, 0});
  Simulator simulator(world);
  std::vector<Action> actions;
  for (int i = 0; i < 30; ++i) {
    add(simulator, {0.5 * i, 0});
    actions.push_back(driving(2, 0));
  }
  run(simulator, actions, 100);
  EXPECT_LE(deepest(simulator), 0.0);
  EXPECT_NEAR(simulator.pose({29}).position.x, 19.8, 1e-3);
  EXPECT_NEAR(simulator.pose({0}).position.x, 19.8 - 29 * 0.4, 0.01);
}

TEST(Contact, RestingAgainstAThingIsOneContactAndComingBackIsAnother) {
  World world;
  world.walls.push_back({{{1, -10}, {1, 10}}, 0});
  Simulator simulator(world);
  const BodyIndex body = add(simulator, {0, 0});
  run(simulator, {driving(1, 0)}, 50);
  EXPECT_EQ(simulator.contacts(body), 1U);
  run(simulator, {driving(0, 1)}, 20);  // along it, without pushing
  EXPECT_EQ(simulator.contacts(body), 1U);
  run(simulator, {driving(-1, 0)}, 5);
  run(simulator, {driving(1, 0)}, 10);
  EXPECT_EQ(simulator.contacts(body), 2U);
}

TEST(Contact, SlidingFromOnePieceOfAWallToTheNextIsOneContact) {
  World world;
  for (int i = 0; i < 20; ++i) world.walls.push_back({{{i * 1.0, 0.5}, {i + 1.0, 0.5}}, 7});
  Simulator simulator(world);
  const BodyIndex body = add(simulator, {0.5, 0});
  run(simulator, {driving(1, 1)}, 150);
  EXPECT_GT(simulator.pose(body).position.x, 15.0);
  EXPECT_EQ(simulator.contacts(body), 1U);
}

TEST(Contact, TheEdgeOfTheMissionAreaHoldsRobotsWithoutAContact) {
  World world;
  world.area_low = {0, 0};
  world.area_high = {100, 50};
  Simulator simulator(world);
  const BodyIndex inside = add(simulator, {50, 25});
  const BodyIndex outside = add(simulator, {150, 25});
  run(simulator, {driving(20, 3), driving(1, 0)}, 100);
  EXPECT_NEAR(simulator.pose(inside).position.x, 99.5, 1e-9);
  EXPECT_NEAR(simulator.pose(inside).position.y, 49.5, 1e-9);
  EXPECT_EQ(simulator.contacts(inside), 0U);
  EXPECT_NEAR(simulator.pose(outside).position.x, 160.0, 1e-9);
}

TEST(Contact, ARobotGetsThroughAGapThatIsAHairWiderThanItself) {
  World world;
  world.walls.push_back({{{5, 0.20001}, {6, 0.20001}}, 0});
  world.walls.push_back({{{5, -0.20001}, {6, -0.20001}}, 1});
  Simulator simulator(world);
  const BodyIndex body = add(simulator, {0, 0});
  run(simulator, {driving(1, 0)}, 100);
  EXPECT_NEAR(simulator.pose(body).position.x, 10.0, 1e-3);
}

TEST(Contact, ARobotDoesNotFitThroughAGapNarrowerThanItself) {
  World world;
  world.walls.push_back({{{5, 0.1999}, {5, 10}}, 0});
  world.walls.push_back({{{5, -0.1999}, {5, -10}}, 1});
  for (const double speed : {0.3, 7.0, 1e5}) {
    Simulator simulator(world);
    const BodyIndex body = add(simulator, {0, 0});
    run(simulator, {driving(speed, 0)}, 400);
    EXPECT_LT(simulator.pose(body).position.x, 5.0);
  }
}

/// A world of everything, and robots that want everything.
struct Chaos {
  explicit Chaos(std::uint64_t seed) : random(seed) {
    World world;
    far = random.below(4) == 0 ? Point{4e6, -3e6} : Point{};
    const double half = 3.0 + 10.0 * random.uniform();
    low = far - geom::Offset{half, half};
    high = far + geom::Offset{half, half};
    const Point corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
    for (std::uint32_t i = 0; i < 4; ++i) world.walls.push_back({{corners[i], corners[(i + 1) % 4]}, 0});
    for (std::uint64_t i = random.below(12); i > 0; --i) world.walls.push_back({{place(), place()}, 1});
    for (std::uint64_t i = random.below(5); i > 0; --i) {
      const Point p = place();
      world.walls.push_back({{p, p}, 2});  // a post without width
    }
    for (std::uint64_t i = random.below(12); i > 0; --i) world.discs.push_back({place(), size()});
    simulator = std::make_unique<Simulator>(world, SimulatorSettings{.seed = seed, .threads = 1});
    for (std::uint64_t i = 1 + random.below(40); i > 0; --i) {
      const auto id = static_cast<std::uint32_t>(i);
      Point where = place();
      // Now and then exactly beside the last one.
      if (random.below(3) == 0 && simulator->body_count() > 0) {
        const BodyIndex last{static_cast<std::uint32_t>(simulator->body_count() - 1)};
        where = simulator->pose(last).position + geom::Offset{2 * simulator->spec(last).radius, 0};
      }
      BodySpec spec = disc_body(size());
      if (where.x >= high.x || !simulator->is_free(where, spec.radius)) continue;
      spec.kinematics.drive = static_cast<Drive>(random.below(3));
      if (random.below(2) == 0) spec.kinematics.max_acceleration = random.uniform(0.1, 10.0);
      simulator->add_body({.spec = spec, .pose = {where, random.angle()}, .robot = {id}, .unit = 0});
    }
  }

  Point place() { return {random.uniform(low.x, high.x), random.uniform(low.y, high.y)}; }
  double size() { return random.below(4) == 0 ? 0.0 : random.uniform(0.0, random.below(3) == 0 ? 2.0 : 0.5); }
  Action action() {
    Action a;
    a.drives = random.below(8) != 0;
    a.spins = random.below(2) == 0;
    const double speed = std::pow(10.0, random.uniform(-3.0, random.below(3) == 0 ? 7.0 : 1.0));
    a.velocity = geom::polar(speed, random.angle());
    a.spin = random.uniform(-5.0, 5.0);
    return a;
  }

  base::Random random;
  Point far, low, high;
  std::unique_ptr<Simulator> simulator;
};

TEST(Contact, NothingEverOverlapsOrLeavesARoomWhateverRobotsDo) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    Chaos chaos(seed);
    Simulator& simulator = *chaos.simulator;
    // Placed robots may touch; from then on they keep their distance.
    ASSERT_LE(deepest(simulator), 2e-9) << "seed " << seed;
    std::vector<Action> actions(simulator.body_count());
    for (int cycle = 0; cycle < 60; ++cycle) {
      if (cycle % 5 == 0) {
        for (Action& action : actions) action = chaos.action();
      }
      simulator.step(actions, 0.1);
      ASSERT_LE(deepest(simulator), 2e-9) << "seed " << seed << " cycle " << cycle;
      for (std::uint32_t i = 0; i < simulator.body_count(); ++i) {
        const Point p = simulator.pose({i}).position;
        ASSERT_TRUE(p.x > chaos.low.x && p.x < chaos.high.x && p.y > chaos.low.y && p.y < chaos.high.y)
            << "seed " << seed << " cycle " << cycle << " robot " << i;
      }
    }
  }
}

TEST(Contact, RobotsInACorridorTooNarrowToPassKeepTheirOrder) {
  World world;
  world.walls.push_back({{{0, 0}, {100, 0}}, 0});
  world.walls.push_back({{{0, 0.7}, {100, 0.7}}, 1});
  world.walls.push_back({{{0, 0}, {0, 0.7}}, 2});
  world.walls.push_back({{{100, 0}, {100, 0.7}}, 3});
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    base::Random random(seed);
    Simulator simulator(world);
    std::vector<Action> actions(20);
    for (int i = 0; i < 20; ++i) add(simulator, {2.0 + 4.0 * i, random.uniform(0.25, 0.45)});
    for (int cycle = 0; cycle < 200; ++cycle) {
      for (Action& action : actions) {
        const double speed = std::pow(10.0, random.uniform(-1.0, 5.0));
        if (random.below(4) == 0)
          action = driving(random.uniform(-speed, speed), random.uniform(-speed, speed));
      }
      simulator.step(actions, 0.1);
      for (std::uint32_t i = 1; i < 20; ++i) {
        ASSERT_LT(simulator.pose({i - 1}).position.x, simulator.pose({i}).position.x) << "seed " << seed;
      }
      ASSERT_LE(deepest(simulator), 0.0);
    }
  }
}

TEST(Contact, ACrowdPackedTightlyGetsLooseAgain) {
  Simulator simulator({});
  std::vector<Action> inwards;
  std::vector<Action> outwards;
  for (int i = 0; i < 200; ++i) {
    const double angle = 2.4 * i;  // golden angle: evenly over a disc
    const double away = 0.6 * std::sqrt(i + 1.0);
    add(simulator, {away * std::cos(angle), away * std::sin(angle)});
    inwards.push_back(driving(-std::cos(angle), -std::sin(angle)));
    outwards.push_back(driving(std::cos(angle), std::sin(angle)));
  }
  run(simulator, inwards, 150);
  ASSERT_LE(deepest(simulator), 0.0);
  double spread = 0.0;
  for (std::uint32_t i = 0; i < 200; ++i)
    spread = std::max(spread, length(simulator.pose({i}).position - Point{}));
  EXPECT_LT(spread, 5.0);  // 200 discs of 0.2 m take at least 2.9 m
  run(simulator, outwards, 300);
  ASSERT_LE(deepest(simulator), 0.0);
  for (std::uint32_t i = 0; i < 200; ++i)
    EXPECT_GT(length(simulator.pose({i}).position - Point{}), 15.0) << i;
}

TEST(Contact, WhatIsNotANumberCountsAsStandingStill) {
  Simulator simulator({});
  const BodyIndex body = add(simulator, {0, 0});
  run(simulator, {driving(NAN, INFINITY)}, 3);
  EXPECT_EQ(simulator.pose(body).position, (Point{0, 0}));
}

// Fences foresee by it where bodies are led to.
TEST(Contact, IsForeseenByWhoFollowsAPassage) {
  base::Random random(5);
  const auto place = [&] { return Point{random.uniform(0, 30), random.uniform(0, 30)}; };
  std::size_t met = 0;
  for (int round = 0; round < 60; ++round) {
    World world;
    world.area_low = {0, 0};
    world.area_high = {30, 30};
    for (int k = 0; k < 12; ++k) world.discs.push_back({place(), random.uniform(0.3, 2.0)});
    for (std::uint32_t k = 0; k < 5; ++k) world.walls.push_back({{place(), place()}, k});
    Simulator simulator(world);
    const double radius = random.uniform(0.1, 0.8);
    const auto placed =
        simulator.add_body({.spec = disc_body(radius), .pose = {{15, 15}, 0.0}, .robot = {1}, .unit = 0});
    if (!placed) continue;
    binding::Passage passage;
    for (const Disc& disc : simulator.discs()) passage.add(disc);
    for (const Wall& wall : simulator.walls()) passage.add(wall.segment);
    passage.keep_within({kAreaMargin, kAreaMargin}, {30 - kAreaMargin, 30 - kAreaMargin});
    for (int cycle = 0; cycle < 100; ++cycle) {
      const Action action = driving(random.uniform(-8, 8), random.uniform(-8, 8));
      const Point from = simulator.pose(placed->body).position;
      const geom::Offset step{action.velocity.x * 0.3, action.velocity.y * 0.3};
      const binding::Passage::Way way = passage.follow(from, step, radius);
      simulator.step(std::span(&action, 1), 0.3);
      ASSERT_NEAR(geom::distance(way.end(), simulator.pose(placed->body).position), 0.0, 1e-9)
          << "round " << round << ", cycle " << cycle;
      met += way.end() == from + step ? 0 : 1;
    }
  }
  EXPECT_GT(met, 500U) << "it is about those that meet something";
}

/// All see all others near them.
void look_round(const Simulator& simulator, double range) {
  SenseBuffer buffer;
  percept::Percepts seen;
  const auto count = static_cast<std::uint32_t>(simulator.body_count());
  for (std::uint32_t i = 0; i < count; ++i)
    simulator.sense(BodyIndex{i}, {{percept::Sensor::kRobots, range}}, buffer, seen);
}

TEST(Contact, BodiesMoveAsTheyWouldHadNobodyLookedRound) {
  constexpr int kBodies = 60;
  for (const double range : {0.5, 3.0, 30.0}) {
    Simulator seeing{World{}};
    Simulator blind{World{}};
    base::Random random(11);
    std::vector<Action> actions;
    for (int i = 0; i < kBodies; ++i) {
      const Point place{2.0 * (i % 8), 2.0 * (i / 8.0)};
      add(seeing, place, 0.3);
      add(blind, place, 0.3);
      actions.push_back(driving(random.uniform(-3, 3), random.uniform(-3, 3)));
    }
    std::uint32_t contacts = 0;
    for (int cycle = 0; cycle < 100; ++cycle) {
      look_round(seeing, range);
      seeing.step(actions, 0.1);
      blind.step(actions, 0.1);
      if (cycle % 20 == 0) {
        for (Action& action : actions) action = driving(random.uniform(-3, 3), random.uniform(-3, 3));
      }
    }
    for (std::uint32_t i = 0; i < kBodies; ++i) {
      ASSERT_EQ(seeing.pose({i}), blind.pose({i})) << i << " with a range of " << range;
      ASSERT_EQ(seeing.contacts({i}), blind.contacts({i}));
      contacts += seeing.contacts({i});
    }
    EXPECT_GT(contacts, 20U);
  }
}

TEST(Contact, WhoComesInTheWayAfterwardsIsMet) {
  const std::vector<Action> actions = {driving(1, 0), Action{}};
  // Put there, started there, or there all the time while one looked from elsewhere.
  for (const int how : {0, 1, 2}) {
    Simulator simulator{World{}};
    const BodyIndex body = add(simulator, {0, 0});
    if (how == 0) add(simulator, {50, 0});
    if (how == 2) add(simulator, {0.45, 0});
    look_round(simulator, 10.0);
    if (how == 0) simulator.put_body({1}, {{0.45, 0}, 0.0}, {}, 0.0);
    if (how == 1) add(simulator, {0.45, 0});
    if (how == 2) {
      SenseBuffer buffer;
      percept::Percepts seen;
      simulator.sense_at(body, {{-50, 0}, 0.0}, {{percept::Sensor::kRobots, 10.0}}, buffer, seen);
      EXPECT_TRUE(seen.robots.empty());
    }
    simulator.step(actions, 0.1);
    EXPECT_NEAR(simulator.pose(body).position.x, 0.05, 1e-4) << how;
    EXPECT_LE(deepest(simulator), 1e-9) << how;
  }
}

}  // namespace
}  // namespace mlab::sim
