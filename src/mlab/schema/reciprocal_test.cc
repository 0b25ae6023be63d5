#include "mlab/schema/reciprocal.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/random.h"

namespace mlab::schema {
namespace {

using geom::Offset;
using geom::Point;

TEST(ReciprocalVelocity, IsTheWantedOneWhereNobodyIs) {
  EXPECT_EQ(reciprocal_velocity({3.0, 1.0}, {}, {}, 0.1, 5.0), (Offset{3.0, 1.0}));
  EXPECT_NEAR(length(reciprocal_velocity({30.0, 10.0}, {}, {}, 0.1, 5.0)), 5.0, 1e-12);
}

TEST(ReciprocalVelocity, StopsBeforeAWallOfThings) {
  std::vector<Traffic> wall;
  for (int i = -6; i <= 6; ++i) wall.push_back({{4.0, static_cast<double>(i)}, {}, 1.0, 2.0, false});
  const Offset v = reciprocal_velocity({5.0, 0.0}, {5.0, 0.0}, wall, 0.1, 5.0);
  EXPECT_LE(v.x, 1.5 + 1e-9) << "in two seconds three metres";
}

TEST(ReciprocalVelocity, DoesAllOfItForWhatPasses) {
  // It would be met in a second, and does nothing itself.
  const Traffic passing{{3.0, 3.0}, {0.0, -3.0}, 1.0, 3.0, false, true};
  const Offset v = reciprocal_velocity({3.0, 0.0}, {3.0, 0.0}, std::span(&passing, 1), 0.1, 4.0);
  EXPECT_GT(length(v - Offset{3.0, 0.0}), 0.1);
  double nearest = 1e9;
  for (int i = 0; i <= 30; ++i) {
    const double t = 0.1 * i;
    nearest = std::min(nearest, length(passing.place + (passing.velocity - v) * t));
  }
  EXPECT_GT(nearest, 1.0 - 1e-6);
}

TEST(ReciprocalVelocity, KeepsOffWhatStandsThoughSomethingPassesOverIt) {
  // Between a wall and something that comes: there is no way out, and the wall is not driven into.
  std::vector<Traffic> traffic;
  for (int i = -6; i <= 6; ++i) traffic.push_back({{-0.5, 0.3 * i}, {}, 0.5, 0.5, false});
  traffic.push_back({{4.0, 0.0}, {-8.0, 0.0}, 3.9, 3.0, false, true});
  const Offset v = reciprocal_velocity({1.0, 0.0}, {}, traffic, 0.1, 2.0);
  EXPECT_GE(v.x, -1e-6);
  EXPECT_LE(v.x, 0.1) << "nor towards what comes";
}

TEST(ReciprocalVelocity, IsTheWantedOneWhereAllAreClearlyOutOfItsWay) {
  base::Random random(14);
  const auto offset = [&](double most) {
    return Offset{random.uniform(-most, most), random.uniform(-most, most)};
  };
  int clear = 0;
  constexpr int kExamples = 100'000;
  for (int i = 0; i < kExamples; ++i) {
    const Offset wanted = offset(3.0);
    const Offset now = offset(3.0);
    std::vector<Traffic> traffic;
    for (int k = 0; k < 1 + i % 4; ++k) {
      const bool shares = random.uniform(0.0, 1.0) < 0.5;
      traffic.push_back({offset(40.0), offset(5.0), random.uniform(0.1, 8.0), random.uniform(0.1, 4.0),
                         shares, !shares && i % 3 == 0});
    }
    if (!std::ranges::all_of(traffic, [&](const Traffic& one) { return is_clear_of(one, wanted, now); }))
      continue;
    ++clear;
    ASSERT_EQ(reciprocal_velocity(wanted, now, traffic, 0.1, 5.0), wanted) << i;
  }
  EXPECT_GT(clear, kExamples / 20) << "else nothing was looked at";
  EXPECT_LT(clear, kExamples - kExamples / 20);
}

TEST(ReciprocalVelocity, IsNotClearOfWhomItWouldMeet) {
  // Nine metres are between them, and they come nearer by 2.9 and by 3.1 in each of three seconds.
  const Traffic ahead{{10.0, 0.0}, {-2.0, 0.0}, 1.0, 3.0, true};
  EXPECT_TRUE(is_clear_of(ahead, {0.9, 0.0}, {0.9, 0.0}));
  EXPECT_FALSE(is_clear_of(ahead, {1.1, 0.0}, {1.1, 0.0}));
  EXPECT_FALSE(is_clear_of({{0.5, 0.0}, {}, 1.0, 3.0, true}, {}, {})) << "who is too near already";
}

/// Bodies that all keep clear by the rule, each on its way to a place.
struct Crowd {
  struct Body {
    Point place;
    Point goal;
    Offset velocity;
  };
  std::vector<Body> bodies;
  double radius = 0.5;
  double nearest = 1e9;

  void step(double dt) {
    std::vector<Offset> chosen;
    for (const Body& body : bodies) {
      std::vector<Traffic> traffic;
      for (const Body& other : bodies) {
        if (&other != &body)
          traffic.push_back({other.place - body.place, other.velocity, 2.0 * radius, 3.0, true});
      }
      std::ranges::sort(traffic, {}, [](const Traffic& one) { return length(one.place); });
      const Offset to = body.goal - body.place;
      const Offset straight = unit(to) * std::min(2.0, length(to) / dt);
      const Offset wanted = straight + Offset{straight.y, -straight.x} * 0.1;  // all pass on the right
      chosen.push_back(reciprocal_velocity(wanted, body.velocity, traffic, dt, 2.5));
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      bodies[i].velocity = chosen[i];
      bodies[i].place = bodies[i].place + chosen[i] * dt;
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j)
        nearest = std::min(nearest, distance(bodies[i].place, bodies[j].place));
    }
  }
  bool is_there() const {
    return std::ranges::all_of(bodies, [](const Body& one) { return distance(one.place, one.goal) < 0.3; });
  }
};

TEST(ReciprocalVelocity, LetsACrowdCrossWithoutAContact) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    auto random = base::Random::of(seed, 0, 0, 0);
    Crowd crowd;
    constexpr int kCount = 12;
    for (int i = 0; i < kCount; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + 0.3 * random.uniform()) / kCount;
      const Offset from{15.0 * std::cos(angle), 15.0 * std::sin(angle)};
      crowd.bodies.push_back({Point{} + from, Point{} - from, {}});
    }
    for (int i = 0; i < 1200 && !crowd.is_there(); ++i) crowd.step(0.1);
    EXPECT_TRUE(crowd.is_there()) << "seed " << seed;
    EXPECT_GT(crowd.nearest, 2.0 * crowd.radius - 0.02) << "seed " << seed;
  }
}

TEST(ReciprocalVelocity, TwoHeadOnPass) {
  Crowd crowd;
  crowd.bodies = {{{-10.0, 0.0}, {10.0, 0.0}, {}}, {{10.0, 0.001}, {-10.0, 0.001}, {}}};
  for (int i = 0; i < 300 && !crowd.is_there(); ++i) crowd.step(0.1);
  EXPECT_TRUE(crowd.is_there());
  EXPECT_GT(crowd.nearest, 0.99);
}

}  // namespace
}  // namespace mlab::schema
