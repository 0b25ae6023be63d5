#include "mlab/sim/simulator.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/random.h"
#include "mlab/base/testing/count_allocations.h"
#include "mlab/base/testing/processor_time.h"
#include "mlab/sim/bench_scenario.h"

namespace mlab::sim {
namespace {

using geom::Point;
using percept::Action;
using percept::ObjectStyle;
using percept::Request;

Placement put(Simulator& simulator, geom::Pose pose, std::uint32_t robot, const BodySpec& spec = {}) {
  const auto placed = simulator.add_body({.spec = spec, .pose = pose, .robot = {robot}, .unit = 0});
  EXPECT_TRUE(placed.has_value());
  return placed.value_or(Placement{});
}

BodyIndex add(Simulator& simulator, geom::Pose pose, std::uint32_t robot, const BodySpec& spec = {}) {
  return put(simulator, pose, robot, spec).body;
}

Object object(std::uint32_t id, Point center, ObjectStyle style) {
  Object o;
  o.id = {id};
  o.center = center;
  o.radius = 0.1;
  o.style = style;
  return o;
}

/// A crowd in a room with walls, discs and things to carry, whose robots go by what they sense.
struct Crowd {
  explicit Crowd(int threads, std::uint32_t robots = 800)
      : simulator(world(), {.seed = 5, .threads = threads}) {
    BodySpec spec = bench_body(1.0);
    spec.ring.noise = 0.05;
    spec.ring.dropout = 0.05;
    base::Random random(3);
    for (std::uint32_t i = 0; i < robots; ++i) {
      spec.kinematics.drive = static_cast<Drive>(i % 3);
      simulator.add_body({.spec = spec,
                          .pose = {{random.uniform(-14, 14), random.uniform(-14, 14)}, random.angle()},
                          .robot = {robots - i},
                          .unit = i % 7});
    }
    buffers.resize(static_cast<std::size_t>(threads));
    for (SenseBuffer& buffer : buffers) buffer.reserve(256, 256, 256, 24);
    actions.resize(robots);
  }

  static World world() {
    World world;
    const Point corners[] = {{-15, -15}, {15, -15}, {15, 15}, {-15, 15}};
    for (std::uint32_t i = 0; i < 4; ++i) world.walls.push_back({{corners[i], corners[(i + 1) % 4]}, i});
    world.walls.push_back({{{-5, -5}, {5, 4}}, 9});
    base::Random random(4);
    for (int i = 0; i < 20; ++i) {
      world.discs.push_back({{random.uniform(-14, 14), random.uniform(-14, 14)}, random.uniform(0.1, 1.0)});
    }
    for (std::uint32_t i = 1; i <= 50; ++i) {
      const Point place{random.uniform(-14, 14), random.uniform(-14, 14)};
      world.objects.push_back(
          object(i, place, i % 10 == 0 ? ObjectStyle::kContainer : ObjectStyle::kMovable));
    }
    return world;
  }

  void cycle() {
    simulator.workers().run(actions.size(), 16, [&](std::size_t begin, std::size_t end, int worker) {
      for (std::size_t i = begin; i < end; ++i) {
        percept::Percepts percepts;
        const BodyIndex body{static_cast<std::uint32_t>(i)};
        simulator.sense(body,
                        {{percept::Sensor::kObstacles, 3},
                         {percept::Sensor::kRobots, 3},
                         {percept::Sensor::kObjects, 2},
                         {percept::Sensor::kRanges}},
                        buffers[static_cast<std::size_t>(worker)], percepts);
        actions[i] = decide(percepts);
      }
    });
    simulator.step(actions, 0.1);
  }
  static Action decide(const percept::Percepts& percepts) {
    Action action;
    action.drives = true;
    action.velocity = {1.5, 0.0, 0.0};
    for (const auto& reading : percepts.ranges) {
      if (reading.hit) action.velocity += geom::polar(reading.distance - 1.0, reading.angle);
    }
    for (const auto& robot : percepts.robots) action.velocity += geom::unit(robot.center) * 0.05;
    for (const auto& seen : percepts.objects) {
      if (seen.id.value < kRobotObjectBase) action.ask({.object = seen.id, .reach = 1.0});
    }
    if (percepts.carried.value != 0)
      action.ask({.kind = Request::Kind::kDropInBasket, .object = {}, .reach = 0.5});
    return action;
  }
  /// Everything that can be asked for, as numbers.
  std::vector<double> all() const {
    std::vector<double> values;
    for (std::uint32_t i = 0; i < simulator.body_count(); ++i) {
      const geom::Pose pose = simulator.pose({i});
      const geom::Offset velocity = simulator.velocity({i});
      for (const double v : {pose.position.x, pose.position.y, pose.heading, velocity.x, velocity.y,
                             simulator.distance_driven({i}), static_cast<double>(simulator.contacts({i})),
                             static_cast<double>(simulator.carried({i}).value)}) {
        values.push_back(v);
      }
    }
    for (const Object& o : simulator.objects()) {
      for (const double v : {o.center.x, o.center.y, 1.0 * o.carrier.value, 1.0 * o.basket.value})
        values.push_back(v);
    }
    return values;
  }

  Simulator simulator;
  std::vector<SenseBuffer> buffers;
  std::vector<Action> actions;
};

TEST(Simulator, GivesTheSameBitForBitForAnyNumberOfThreads) {
  Crowd one(1);
  Crowd two(2);
  Crowd seven(7);
  for (int i = 0; i < 40; ++i) {
    one.cycle();
    two.cycle();
    seven.cycle();
  }
  const std::vector<double> expected = one.all();
  EXPECT_EQ(two.all(), expected);
  EXPECT_EQ(seven.all(), expected);
  // The crowd did something worth comparing.
  std::uint32_t contacts = 0;
  for (std::uint32_t i = 0; i < one.simulator.body_count(); ++i) contacts += one.simulator.contacts({i});
  EXPECT_GT(contacts, 20U);
  EXPECT_TRUE(
      std::ranges::any_of(one.simulator.objects(), [](const Object& o) { return o.carrier.value != 0; }));
}

TEST(Simulator, GoesOnFromASnapshotAsItDidTheFirstTime) {
  Crowd crowd(2, 200);
  for (int i = 0; i < 10; ++i) crowd.cycle();
  const auto snapshot = crowd.simulator.snapshot();
  for (int i = 0; i < 20; ++i) crowd.cycle();
  const std::vector<double> expected = crowd.all();
  crowd.simulator.set_obstacles({});
  add(crowd.simulator, {{0, 0}, 0.0}, 999);
  crowd.simulator.restore(*snapshot);
  EXPECT_EQ(crowd.simulator.body_count(), 200U);
  EXPECT_EQ(crowd.simulator.cycle(), 10U);
  for (int i = 0; i < 20; ++i) crowd.cycle();
  EXPECT_EQ(crowd.all(), expected);
}

TEST(Simulator, TakesNothingFromTheHeapOnceItRuns) {
  Crowd crowd(1, 300);
  for (int i = 0; i < 50; ++i) crowd.cycle();
  const std::size_t before = base::allocation_count();
  EXPECT_GT(before, 0U);
  for (int i = 0; i < (base::kIsSlowBuild ? 40 : 200); ++i) crowd.cycle();
  EXPECT_EQ(base::allocation_count() - before, 0U);
}

TEST(Simulator, MovesARobotThatStartsWhereSomethingIsToTheNearestFreePlace) {
  World world;
  world.discs.push_back({{0, 0}, 1.0});
  Simulator simulator(world);
  const Placement placed = put(simulator, {{0.9, 0}, 0.0}, 1);
  EXPECT_TRUE(placed.moved);
  EXPECT_GE(length(placed.pose.position - Point{}), 1.2);
  EXPECT_LE(distance(placed.pose.position, {0.9, 0}), 0.45);
  Simulator again(world);
  EXPECT_EQ(put(again, {{0.9, 0}, 0.0}, 1).pose, placed.pose);
}

TEST(Simulator, PutsManyRobotsAtOnePlaceSideBySide) {
  Simulator simulator({});
  for (std::uint32_t i = 0; i < 300; ++i) {
    const Placement placed = put(simulator, {{5, 5}, 0.0}, i + 1);
    ASSERT_EQ(placed.moved, i > 0);
    for (std::uint32_t j = 0; j < i; ++j) {
      ASSERT_GE(distance(simulator.pose({j}).position, placed.pose.position), 1.2 - 1e-8);
    }
    ASSERT_LT(distance(placed.pose.position, {5, 5}), 16.0);  // packed well: 300 discs of 0.6 m take 10.4 m
  }
}

TEST(Simulator, RobotsThatExactlyTouchAreNotMoved) {
  Simulator simulator({});
  for (std::uint32_t i = 0; i < 50; ++i) {
    EXPECT_FALSE(put(simulator, {{0.4 * i, 0.0}, 0.0}, i + 1).moved);
  }
}

TEST(Simulator, SaysWhereNoPlaceIsFree) {
  World world;
  world.discs.push_back({{0, 0}, 3e4});
  Simulator simulator(world);
  EXPECT_FALSE(simulator.add_body({.spec = {}, .pose = {}, .robot = {1}, .unit = 0}));
  EXPECT_FALSE(simulator.add_body({.spec = {}, .pose = {{NAN, 0}, 0.0}, .robot = {1}, .unit = 0}));
  EXPECT_EQ(simulator.body_count(), 0U);
}

TEST(Simulator, AnObstacleThatComesMovesTheRobotThatStandsThere) {
  Simulator simulator({});
  const BodyIndex body = add(simulator, {{0, 0}, 0.0}, 1);
  add(simulator, {{50, 0}, 0.0}, 2);
  const Disc disc{{0.3, 0}, 1.0};
  const auto moved = simulator.add_obstacles({&disc, 1});
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_EQ(moved[0].body, body);
  EXPECT_GE(distance(simulator.pose(body).position, disc.center), 1.2 - 1e-8);
  EXPECT_EQ(simulator.remove_obstacles([](const Disc& d) { return d.radius == 1.0; }), 1U);
  EXPECT_TRUE(simulator.discs().empty());
}

TEST(Simulator, AWallThatComesMovesTheRobotThatStandsThereAndStopsTheOthers) {
  Simulator simulator({});
  const BodyIndex on_it = add(simulator, {{5, 0.05}, 0.0}, 1);
  const BodyIndex before_it = add(simulator, {{0, 3}, 0.0}, 2);
  const std::vector<Wall> walls = {{{{5, -10}, {5, 10}}, 0}};
  const auto moved = simulator.set_walls(walls);
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_EQ(moved[0].body, on_it);
  EXPECT_TRUE(moved[0].moved);
  EXPECT_GE(std::abs(simulator.pose(on_it).position.x - 5), 0.2 - 1e-8);
  EXPECT_FALSE(simulator.in_sight({0, 0}, {10, 0}));
  std::vector<Action> actions(2);
  actions[1].drives = true;
  actions[1].velocity = {2, 0, 0};
  for (int i = 0; i < 50; ++i) simulator.step(actions, 0.1);
  EXPECT_NEAR(simulator.pose(before_it).position.x, 4.8, 1e-3);
  EXPECT_EQ(simulator.contacts(before_it), 1U);
  const std::vector<Wall> another = {{{{5, -10}, {5, 10}}, 0}, {{{50, 0}, {60, 0}}, 1}};
  EXPECT_TRUE(simulator.set_walls(another).empty());
  for (int i = 0; i < 5; ++i) simulator.step(actions, 0.1);
  EXPECT_EQ(simulator.contacts(before_it), 1U) << "the same wall is the same contact";
  simulator.set_walls({});
  for (int i = 0; i < 50; ++i) simulator.step(actions, 0.1);
  EXPECT_GT(simulator.pose(before_it).position.x, 10.0);
  EXPECT_EQ(simulator.discs().size(), 0U);
}

TEST(Simulator, RestoresWallsAndObjectsAsTheyWere) {
  Crowd crowd(2, 200);
  for (int i = 0; i < 10; ++i) crowd.cycle();
  const auto snapshot = crowd.simulator.snapshot();
  const std::size_t walls = crowd.simulator.walls().size();
  for (int i = 0; i < 20; ++i) crowd.cycle();
  const std::vector<double> expected = crowd.all();
  const std::vector<Wall> other = {{{{1, 1}, {90, 90}}, 7}};
  crowd.simulator.set_walls(other);
  crowd.simulator.set_objects({}, {});
  for (int i = 0; i < 5; ++i) crowd.cycle();
  crowd.simulator.restore(*snapshot);
  EXPECT_EQ(crowd.simulator.walls().size(), walls);
  for (int i = 0; i < 20; ++i) crowd.cycle();
  EXPECT_EQ(crowd.all(), expected);
}

TEST(Simulator, ARemovedRobotIsInNobodysWay) {
  Simulator simulator({});
  const BodyIndex a = add(simulator, {{0, 0}, 0.0}, 1);
  const BodyIndex b = add(simulator, {{1, 0}, 0.0}, 2);
  simulator.remove_body(b);
  std::vector<Action> actions(2);
  actions[0].drives = true;
  actions[0].velocity = {1, 0, 0};
  for (int i = 0; i < 30; ++i) simulator.step(actions, 0.1);
  EXPECT_NEAR(simulator.pose(a).position.x, 3.0, 1e-9);
  EXPECT_EQ(simulator.contacts(a), 0U);
  EXPECT_FALSE(simulator.is_present(b));
  EXPECT_TRUE(simulator.is_free({1, 0}, 0.2));
}

TEST(Simulator, WorksFarFromTheOriginAsNearIt) {
  std::vector<double> ends;
  for (const Point origin : {Point{0, 0}, Point{4194304, -4194304}}) {
    World world;
    world.area_low = origin;
    world.area_high = origin + geom::Offset{1000, 1000};
    world.discs.push_back({origin + geom::Offset{20, 10.25}, 1.0});
    Simulator simulator(world);
    const BodyIndex body = add(simulator, {origin + geom::Offset{10, 10}, 0.0}, 1);
    std::vector<Action> actions(1);
    actions[0].drives = true;
    actions[0].spins = true;
    actions[0].velocity = {1, 0, 0};
    for (int i = 0; i < 200; ++i) simulator.step(actions, 0.1);
    EXPECT_EQ(simulator.contacts(body), 1U);
    ends.push_back(simulator.pose(body).position.x - origin.x);
  }
  EXPECT_NEAR(ends[0], ends[1], 1e-3);
}

// Two hundred robots in the middle of walls that stand as densely over a square of any size.
std::unique_ptr<Simulator> among_walls(double size) {
  base::Random random(1);
  World world;
  for (std::uint32_t i = 0; i < size * size / 100; ++i) {
    const Point p{random.uniform(0, size), random.uniform(0, size)};
    world.walls.push_back({{p, p + geom::Offset{random.uniform(-5, 5), random.uniform(-5, 5)}}, i});
  }
  world.walls.push_back({{{-1e7, -1e7}, {1e7, -1e7}}, 0});
  auto out = std::make_unique<Simulator>(world);
  const double low = size / 2 - 50;
  for (std::uint32_t i = 0; i < 200; ++i)
    add(*out, {{random.uniform(low, low + 100), random.uniform(low, low + 100)}, 0.0}, i + 1,
        bench_body(5.0));
  return out;
}

TEST(Simulator, ManyWallsCostNoMoreThanThoseNearby) {
  SenseBuffer buffer;
  percept::Percepts percepts;
  const auto sense = [&](const Simulator& simulator) {
    for (std::uint32_t i = 0; i < 200; ++i)
      simulator.sense(
          {i},
          {{percept::Sensor::kObstacles, 50}, {percept::Sensor::kRobots, 100}, {percept::Sensor::kRanges}},
          buffer, percepts);
  };
  const auto few = among_walls(250);
  const auto many = among_walls(2000);  // 64 times as many
  EXPECT_LT(base::Yardstick([&] { sense(*few); }).times([&] { sense(*many); }, 4.0), 4.0);
}

TEST(Objects, ArePickedUpWithinReachCarriedAndDropped) {
  World world;
  world.objects = {object(1, {1.0, 0}, ObjectStyle::kMovable), object(2, {0, 1}, ObjectStyle::kFixed)};
  Simulator simulator(world);
  const BodyIndex body = add(simulator, {{0, 0}, 0.0}, 1);
  std::vector<Action> actions(1);
  const auto step = [&](std::initializer_list<Request> requests, double speed = 0.0) {
    actions[0] = {};
    actions[0].drives = true;
    actions[0].velocity = {speed, 0, 0};
    for (const Request& request : requests) actions[0].ask(request);
    simulator.step(actions, 0.1);
  };
  step({{.kind = Request::Kind::kPickUp, .object = {1}, .reach = 0.69}});
  EXPECT_EQ(simulator.carried(body).value, 0U);
  step({{.kind = Request::Kind::kPickUp, .object = {2}, .reach = 5.0}});
  EXPECT_EQ(simulator.carried(body).value, 0U);
  step({{.kind = Request::Kind::kPickUp, .object = {1}, .reach = 0.71}});
  EXPECT_EQ(simulator.carried(body).value, 1U);
  SenseBuffer buffer;
  percept::Percepts percepts;
  simulator.sense(body, {{percept::Sensor::kObjects, 10}}, buffer, percepts);
  EXPECT_EQ(percepts.carried.value, 1U);
  ASSERT_EQ(percepts.objects.size(), 1U);
  EXPECT_EQ(percepts.objects[0].id.value, 2U);
  step({}, 20.0);
  EXPECT_EQ(simulator.objects()[0].center, (Point{2, 0}));
  step({{.kind = Request::Kind::kDrop, .object = {}}}, 10.0);
  EXPECT_EQ(simulator.carried(body).value, 0U);
  EXPECT_EQ(simulator.objects()[0].center, (Point{3, 0}));
}

TEST(Objects, GoToTheRobotWithTheLowestIdWhereTwoAsk) {
  World world;
  world.objects = {object(1, {0, 0}, ObjectStyle::kMovable)};
  Simulator simulator(world);
  const BodyIndex late = add(simulator, {{1, 0}, 0.0}, 7);
  const BodyIndex early = add(simulator, {{-1, 0}, 0.0}, 3);
  std::vector<Action> actions(2);
  for (Action& action : actions) action.ask({.kind = Request::Kind::kPickUp, .object = {1}, .reach = 2.0});
  simulator.step(actions, 0.1);
  EXPECT_EQ(simulator.carried(early).value, 1U);
  EXPECT_EQ(simulator.carried(late).value, 0U);
}

TEST(Objects, InABasketAreCountedAndOutOfSight) {
  World world;
  world.objects = {object(1, {0.3, 0}, ObjectStyle::kMovable), object(2, {1, 0}, ObjectStyle::kContainer),
                   object(3, {-1.5, 0}, ObjectStyle::kContainer)};
  Simulator simulator(world);
  const BodyIndex body = add(simulator, {{0, 0}, 0.0}, 1);
  std::vector<Action> actions(1);
  actions[0].ask({.kind = Request::Kind::kPickUp, .object = {1}, .reach = 1.0});
  actions[0].ask({.kind = Request::Kind::kDropInBasket, .object = {}, .reach = 0.5});  // too far
  simulator.step(actions, 0.1);
  EXPECT_EQ(simulator.carried(body).value, 1U);
  actions[0] = {};
  actions[0].ask({.kind = Request::Kind::kDropInBasket, .object = {}, .reach = 2.0});  // the nearest
  simulator.step(actions, 0.1);
  EXPECT_EQ(simulator.carried(body).value, 0U);
  EXPECT_EQ(simulator.basket_count({2}), 1U);
  EXPECT_EQ(simulator.basket_count({3}), 0U);
  actions[0] = {};
  actions[0].ask({.kind = Request::Kind::kPickUp, .object = {1}, .reach = 5.0});
  simulator.step(actions, 0.1);
  EXPECT_EQ(simulator.carried(body).value, 0U);
}

Travel travel(std::uint32_t id, std::vector<Point> points, double speed) {
  return {{id}, std::make_shared<const overlay::Course>(std::move(points), speed)};
}

TEST(Objects, TravelUntilSomebodyTakesThem) {
  World world;
  world.objects = {object(1, {0, 0.3}, ObjectStyle::kMovable), object(2, {5, 0}, ObjectStyle::kContainer),
                   object(3, {9, 9}, ObjectStyle::kFixed)};
  world.travels = {travel(1, {{0, 0.3}, {10, 0.3}}, 1.0), travel(2, {{5, 0}, {5, 8}}, 2.0),
                   travel(3, {{9, 9}, {9, NAN}}, 2.0), travel(7, {{9, 9}, {9, 0}}, 2.0)};
  Simulator simulator(world);
  const BodyIndex body = add(simulator, {{1, 0}, 0.0}, 1);
  std::vector<Action> actions(1);
  for (int i = 0; i < 10; ++i) simulator.step(actions, 0.1);
  EXPECT_NEAR(simulator.objects()[0].center.x, 1.0, 1e-9);
  EXPECT_NEAR(simulator.objects()[1].center.y, 2.0, 1e-9);
  EXPECT_EQ(simulator.objects()[2].center, (Point{9, 9})) << "its course is none";
  const auto snapshot = simulator.snapshot();

  actions[0].ask({.kind = Request::Kind::kPickUp, .object = {1}, .reach = 1.0});
  simulator.step(actions, 0.1);
  ASSERT_EQ(simulator.carried(body).value, 1U);
  actions[0] = {};
  actions[0].ask({.kind = Request::Kind::kDrop, .object = {}, .reach = 0.0});
  simulator.step(actions, 0.1);
  ASSERT_EQ(simulator.carried(body).value, 0U);
  actions[0] = {};
  for (int i = 0; i < 10; ++i) simulator.step(actions, 0.1);
  EXPECT_EQ(simulator.objects()[0].center, simulator.pose(body).position) << "it stays where it was put";

  // Another map with the same things: what was taken stays, the rest goes on, from its new course on at once.
  const std::vector<Object> same(simulator.objects().begin(), simulator.objects().end());
  const std::vector<base::ObjectId> were = {{1}, {2}, {3}};
  world.travels[1] = travel(2, {{5, 0}, {5, 80}}, 10.0);
  simulator.set_objects(same, were, world.travels);
  EXPECT_EQ(simulator.objects()[0].center, simulator.pose(body).position);
  EXPECT_NEAR(simulator.objects()[1].center.y, 22.0, 1e-9);

  simulator.restore(*snapshot);
  simulator.step(actions, 0.1);
  EXPECT_NEAR(simulator.objects()[0].center.x, 1.1, 1e-9) << "nobody has taken it yet";
  EXPECT_NEAR(simulator.objects()[1].center.y, 2.2, 1e-9);
}

TEST(Objects, AreTakenAlongByWhatTheyLieIn) {
  World world;
  world.objects = {object(1, {0.3, 0}, ObjectStyle::kMovable), object(2, {1, 0}, ObjectStyle::kContainer)};
  world.travels = {travel(2, {{1, 0}, {1, 8}}, 1.0)};
  Simulator simulator(world);
  add(simulator, {{0, 0}, 0.0}, 1);
  std::vector<Action> actions(1);
  actions[0].ask({.kind = Request::Kind::kPickUp, .object = {1}, .reach = 1.0});
  actions[0].ask({.kind = Request::Kind::kDropInBasket, .object = {}, .reach = 2.0});
  simulator.step(actions, 0.1);
  ASSERT_EQ(simulator.basket_count({2}), 1U);
  actions[0] = {};
  for (int i = 0; i < 19; ++i) simulator.step(actions, 0.1);
  EXPECT_NEAR(simulator.objects()[1].center.y, 2.0, 1e-9);
  EXPECT_EQ(simulator.objects()[0].center, simulator.objects()[1].center);
}

// Three things: one is carried, one lies in the basket, one stands.
World toys() {
  World world;
  for (const double x : {0.3, 0.4, 30.0}) {
    Object& toy = world.objects.emplace_back();
    toy.id = {static_cast<std::uint32_t>(world.objects.size())};
    toy.style = percept::ObjectStyle::kMovable;
    toy.center = {x, 0};
    toy.radius = 0.1;
  }
  Object& basket = world.objects.emplace_back();
  basket.id = {4};
  basket.style = percept::ObjectStyle::kContainer;
  basket.center = {0, 0.4};
  basket.radius = 0.2;
  return world;
}

TEST(Objects, KeepWhatHappenedToThemWhenOthersComeAndGo) {
  Simulator simulator(toys());
  const BodyIndex body = add(simulator, {{0, 0}, 0.0}, 1);
  std::vector<Action> actions(1);
  actions[0].ask({.kind = Request::Kind::kPickUp, .object = {2}, .reach = 1.0});
  actions[0].ask({.kind = Request::Kind::kDropInBasket, .object = {}, .reach = 1.0});
  actions[0].ask({.kind = Request::Kind::kPickUp, .object = {1}, .reach = 1.0});
  simulator.step(actions, 0.1);
  ASSERT_EQ(simulator.carried(body).value, 1U);
  ASSERT_EQ(simulator.basket_count({4}), 1U);

  // A new one comes first, so that all get other ids; the third goes.
  const World before = toys();
  World after;
  after.objects = {before.objects[2], before.objects[0], before.objects[1], before.objects[3]};
  after.objects[0].center = {40, 0};
  for (std::uint32_t i = 0; i < 4; ++i) after.objects[i].id = {i + 1};
  const auto were = same_objects(before.objects, after.objects);
  EXPECT_EQ(were, (std::vector<base::ObjectId>{{0}, {1}, {2}, {4}}));
  simulator.set_objects(after.objects, were);
  EXPECT_EQ(simulator.objects().size(), 4U);
  EXPECT_EQ(simulator.carried(body).value, 2U);
  EXPECT_EQ(simulator.objects()[1].carrier.value, 1U);
  EXPECT_EQ(simulator.basket_count({4}), 1U);
  EXPECT_EQ(simulator.objects()[0].center, (Point{40, 0}));

  // Without the basket what lay in it lies there; without what it carries the robot carries nothing.
  after.objects = {after.objects[2]};
  after.objects[0].id = {1};
  const std::vector<base::ObjectId> only = {{3}};
  simulator.set_objects(after.objects, only);
  EXPECT_EQ(simulator.carried(body).value, 0U);
  EXPECT_EQ(simulator.objects()[0].basket.value, 0U);
  EXPECT_EQ(simulator.objects()[0].center, (Point{0, 0.4}));
  simulator.step(std::vector<Action>(1), 0.1);
}

TEST(Objects, OfARemovedRobotStayWhereItStood) {
  World world;
  world.objects = {object(1, {0.3, 0}, ObjectStyle::kMovable)};
  Simulator simulator(world);
  const BodyIndex body = add(simulator, {{0, 0}, 0.0}, 1);
  std::vector<Action> actions(1);
  actions[0].ask({.kind = Request::Kind::kPickUp, .object = {1}, .reach = 1.0});
  simulator.step(actions, 0.1);
  simulator.remove_body(body);
  EXPECT_EQ(simulator.objects()[0].carrier.value, 0U);
  EXPECT_EQ(simulator.objects()[0].center, (Point{0, 0}));
}

}  // namespace
}  // namespace mlab::sim
