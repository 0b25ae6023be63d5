#include "mlab/sim/radio.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/angle.h"
#include "mlab/base/random.h"
#include "mlab/sim/simulator.h"

namespace mlab::sim {
namespace {

using geom::Point;

BodyIndex add(Simulator& simulator, Point place, const RadioSpec& radio, std::uint32_t unit = 0,
              double heading = 0.0) {
  BodySetup setup;
  setup.spec.radio = radio;
  setup.pose = {place, heading};
  setup.robot = {static_cast<std::uint32_t>(simulator.body_count() + 1)};
  setup.unit = unit;
  return simulator.add_body(setup)->body;
}

// What one body hears, with the memory that holds it.
struct Heard {
  Heard(const Simulator& simulator, BodyIndex body) {
    simulator.sense(body, {{percept::Sensor::kRadio}}, buffer, percepts);
  }
  SenseBuffer buffer;
  percept::Percepts percepts;
};

World walls(std::initializer_list<geom::Segment> segments, bool are_solid = true) {
  World world;
  std::uint32_t group = 0;
  for (const geom::Segment& one : segments) world.walls.push_back({one, group++, are_solid});
  return world;
}

TEST(SignalStrength, FallsEvenlyWithTheLogarithmOfTheDistance) {
  EXPECT_DOUBLE_EQ(binding::signal_strength(0.2, 100.0, 0), 100.0);
  EXPECT_DOUBLE_EQ(binding::signal_strength(1.0, 100.0, 0), 100.0);
  EXPECT_NEAR(binding::signal_strength(10.0, 100.0, 0), 50.0, 1e-9);
  EXPECT_NEAR(binding::signal_strength(std::sqrt(10.0), 100.0, 0), 75.0, 1e-9);
  EXPECT_EQ(binding::signal_strength(100.0, 100.0, 0), 0.0);
  EXPECT_NEAR(binding::signal_strength(10.0, 100.0, 3), 20.0, 1e-9);
  EXPECT_EQ(binding::signal_strength(10.0, 100.0, 5), 0.0) << "walls take more than there is";
  EXPECT_EQ(binding::signal_strength(1e9, 0.0, 40), 100.0) << "one without a range is heard everywhere";
}

TEST(SignalStrength, OfAShortRangeIsFullToItsEnd) {
  for (const double range : {0.5, 1.0}) {
    EXPECT_EQ(binding::signal_strength(0.9 * range, range, 0), 100.0);
    EXPECT_EQ(binding::signal_strength(1.1 * range, range, 0), 0.0);
  }
}

TEST(Radio, TellsWhoIsHeardWhereAndHowWell) {
  Simulator simulator(World{});
  const BodyIndex here = add(simulator, {0, 0}, {.range = 100.0}, 1, base::radians(90.0));
  add(simulator, {0, 10}, {.range = 100.0}, 1);
  add(simulator, {5, 0}, {.range = 20.0}, 2);
  add(simulator, {60, 0}, {.range = 50.0}, 1);  // the weaker of two radios counts
  add(simulator, {-99, 0}, {}, 1);              // one that is heard everywhere hears no further than others
  const Heard heard(simulator, here);
  ASSERT_EQ(heard.percepts.radio.size(), 3U);
  const auto& [first, second, third] =
      std::tie(heard.percepts.radio[0], heard.percepts.radio[1], heard.percepts.radio[2]);
  EXPECT_EQ(first.id.value, 2U);
  EXPECT_NEAR(first.strength, 50.0, 1e-9);
  EXPECT_NEAR(first.center.x, 10.0, 1e-9) << "ahead, for it looks north";
  EXPECT_TRUE(first.is_unit_mate);
  EXPECT_EQ(second.id.value, 3U);
  EXPECT_NEAR(second.strength, 100.0 * (1.0 - std::log(5.0) / std::log(20.0)), 1e-9);
  EXPECT_NEAR(second.center.y, -5.0, 1e-9);
  EXPECT_FALSE(second.is_unit_mate);
  EXPECT_EQ(third.id.value, 5U);
  EXPECT_NEAR(third.strength, 100.0 * (1.0 - std::log(99.0) / std::log(100.0)), 1e-9);
}

TEST(Radio, IsHeardEverywhereWithoutARange) {
  Simulator simulator(World{});
  const BodyIndex here = add(simulator, {0, 0}, {});
  add(simulator, {100'000, 100'000}, {});
  const Heard heard(simulator, here);
  ASSERT_EQ(heard.percepts.radio.size(), 1U);
  EXPECT_EQ(heard.percepts.radio[0].strength, 100.0);
  EXPECT_EQ(simulator.radio(), nullptr) << "all that is told arrives";
}

TEST(Radio, WallsTakeOfASignalAndAreasDoNot) {
  const auto strength = [](World world) {
    Simulator simulator(std::move(world));
    const BodyIndex here = add(simulator, {0, 0}, {.range = 100.0});
    add(simulator, {10, 0}, {.range = 100.0});
    const Heard heard(simulator, here);
    return heard.percepts.radio.empty() ? 0.0 : heard.percepts.radio[0].strength;
  };
  EXPECT_NEAR(strength(walls({{{3, -50}, {3, 50}}, {{7, -2}, {7, 2}}, {{8, 5}, {8, 9}}})), 30.0, 1e-9);
  World ridge = walls({{{3, -5}, {4, 0}}, {{4, 0}, {3, 5}}, {{5, 5}, {5, -5}}});
  for (Wall& wall : ridge.walls) wall.group = 7;
  EXPECT_NEAR(strength(std::move(ridge)), 40.0, 1e-9) << "one wall, though a corner of it lies on the line";
  EXPECT_NEAR(strength(walls({{{3, -5}, {3, 5}}}, false)), 50.0, 1e-9);
}

TEST(Radio, IsSilentInAZoneWithoutCommunication) {
  for (const double range : {0.0, 100.0}) {
    World world;
    world.silences.push_back({{5, -5}, {15, -5}, {15, 5}, {5, 5}});
    Simulator simulator(std::move(world));
    const BodyIndex here = add(simulator, {0, 0}, {.range = range});
    const BodyIndex inside = add(simulator, {10, 0}, {.range = range});
    const BodyIndex also_inside = add(simulator, {12, 0}, {.range = range});
    const BodyIndex beyond = add(simulator, {20, 0}, {.range = range});
    const Heard heard(simulator, here);
    ASSERT_EQ(heard.percepts.radio.size(), 1U);
    EXPECT_EQ(heard.percepts.radio[0].id.value, beyond.value + 1) << "what is behind the zone is heard";
    EXPECT_TRUE(Heard(simulator, inside).percepts.radio.empty());
    const binding::RadioLinks* links = simulator.radio();
    ASSERT_NE(links, nullptr);
    EXPECT_EQ(links->net_of(here), links->net_of(beyond));
    EXPECT_NE(links->net_of(here), links->net_of(inside));
    EXPECT_NE(links->net_of(inside), links->net_of(also_inside));
    simulator.set_silences({});
    EXPECT_FALSE(Heard(simulator, inside).percepts.radio.empty());
  }
}

TEST(Radio, LinksOverOthers) {
  Simulator simulator(World{});
  const RadioSpec radio{.range = 30.0};
  const BodyIndex a = add(simulator, {0, 0}, radio);
  const BodyIndex far = add(simulator, {100, 0}, radio);
  const BodyIndex c = add(simulator, {50, 0}, radio);
  const BodyIndex b = add(simulator, {25, 0}, radio);
  const binding::RadioLinks* links = simulator.radio();
  ASSERT_NE(links, nullptr);
  EXPECT_EQ(links->net_of(a), links->net_of(c));
  EXPECT_TRUE(links->arrives(a, c));
  EXPECT_NE(links->net_of(a), links->net_of(far));
  EXPECT_FALSE(links->arrives(a, far));
  simulator.remove_body(b);
  links = simulator.radio();
  EXPECT_NE(links->net_of(a), links->net_of(c)) << "who was between them is gone";
}

TEST(Radio, LinksOverThoseWhoAreHeardEverywhere) {
  Simulator simulator(World{});
  const BodyIndex a = add(simulator, {0, 0}, {.range = 30.0});
  const BodyIndex base = add(simulator, {20, 0}, {});
  const BodyIndex far = add(simulator, {1000, 0}, {.range = 30.0});
  const BodyIndex other_base = add(simulator, {1010, 0}, {});
  const binding::RadioLinks* links = simulator.radio();
  ASSERT_NE(links, nullptr);
  EXPECT_EQ(links->net_of(a), links->net_of(base));
  EXPECT_EQ(links->net_of(base), links->net_of(other_base));
  EXPECT_EQ(links->net_of(a), links->net_of(far)) << "each hears a base, and those hear each other";
}

// As an independent search finds it: who reaches whom, step by step, over every pair.
TEST(Radio, NetsAreWhatASearchOverAllPairsFinds) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    base::Random random(seed);
    World world = walls({{{-20, 0}, {20, 0}}, {{0, 5}, {0, 40}}});
    Simulator simulator(world);
    std::vector<RadioSpec> radios;
    std::vector<Point> places;
    for (int i = 0; i < 60; ++i) {
      radios.push_back({.range = random.below(10) == 0 ? 0.0 : random.uniform(3.0, 25.0)});
      add(simulator, {random.uniform(-60.0, 60.0), random.uniform(-60.0, 60.0)}, radios.back());
      places.push_back(simulator.pose(BodyIndex{static_cast<std::uint32_t>(i)}).position);
    }
    const auto crossed = [&](Point a, Point b) {
      return static_cast<std::uint32_t>(std::ranges::count_if(
          world.walls, [&](const Wall& w) { return geom::intersects({a, b}, w.segment); }));
    };
    std::vector<std::uint32_t> net(radios.size(), 1000);
    for (std::uint32_t first = 0; first < net.size(); ++first) {
      if (net[first] != 1000) continue;
      std::vector<std::uint32_t> open{first};
      net[first] = first;
      while (!open.empty()) {
        const std::uint32_t at = open.back();
        open.pop_back();
        for (std::uint32_t other = 0; other < net.size(); ++other) {
          const double range = binding::common_range(radios[at], radios[other]);
          const double strength = binding::signal_strength(geom::distance(places[at], places[other]), range,
                                                           crossed(places[at], places[other]));
          if (net[other] != 1000 || strength <= 0.0) continue;
          net[other] = first;
          open.push_back(other);
        }
      }
    }
    const binding::RadioLinks* links = simulator.radio();
    ASSERT_NE(links, nullptr);
    for (std::uint32_t i = 0; i < net.size(); ++i)
      EXPECT_EQ(links->net_of(BodyIndex{i}), net[i]) << "seed " << seed;
  }
}

TEST(Radio, ThatIsNoNumberIsOneWithoutARange) {
  Simulator simulator(World{});
  const BodyIndex here = add(simulator, {0, 0}, {.range = -5.0, .loss = -1.0});
  add(simulator, {1000, 0}, {.range = std::nan(""), .loss = std::nan("")});
  EXPECT_EQ(Heard(simulator, here).percepts.radio.size(), 1U);
  EXPECT_EQ(simulator.radio(), nullptr);
}

TEST(Radio, OfManyTheStrongestAreTold) {
  Simulator simulator(World{});
  const BodyIndex here = add(simulator, {0, 0}, {.range = 1000.0});
  for (int i = 500; i >= 1; --i) add(simulator, {2.0 * i, 0}, {.range = 1000.0});
  const Heard heard(simulator, here);
  ASSERT_EQ(heard.percepts.radio.size(), 64U);
  for (std::size_t i = 0; i < 64; ++i) EXPECT_NEAR(heard.percepts.radio[i].center.x, 2.0 * (i + 1), 1e-9);
}

TEST(Radio, LosesTheShareThatItIsToldToTheSameWhoeverAsks) {
  Simulator simulator(World{}, {.seed = 7});
  const BodyIndex a = add(simulator, {0, 0}, {.loss = 0.3});
  const BodyIndex b = add(simulator, {5, 0}, {});
  const std::vector<percept::Action> actions(2);
  int lost = 0;
  constexpr int kCycles = 10'000;
  for (int i = 0; i < kCycles; ++i) {
    const binding::RadioLinks* links = simulator.radio();
    ASSERT_NE(links, nullptr);
    EXPECT_EQ(links->arrives(a, b), links->arrives(a, b));
    EXPECT_TRUE(links->arrives(b, a)) << "the loss is the teller's";
    EXPECT_TRUE(links->loses(a) && !links->loses(b));
    lost += links->arrives(a, b) ? 0 : 1;
    simulator.step(actions, 0.1);
  }
  EXPECT_NEAR(lost, 0.3 * kCycles, 0.02 * kCycles);
}

}  // namespace
}  // namespace mlab::sim
