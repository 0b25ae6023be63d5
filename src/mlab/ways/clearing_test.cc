#include "mlab/ways/clearing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/ways/testing/grounds.h"

namespace mlab::ways {
namespace {

using testing::any_ground;
using testing::room_at;

constexpr std::uint64_t kClearingSeed = 20261127;

TEST(Clearing, IsFreeWhereThereIsRoom) {
  std::mt19937_64 random(kClearingSeed);
  std::uniform_real_distribution<double> place(-5.0, 105.0);
  for (int round = 0; round < 40; ++round) {
    const Ground ground = any_ground(random, 100.0, round, round / 3);
    const double clearance = 0.1 * (round % 30);
    const Clearing clearing(ground, clearance);
    for (int i = 0; i < 300; ++i) {
      const geom::Point p{place(random), place(random)};
      EXPECT_EQ(clearing.is_free(p), ground.bounds.contains(p) && room_at(ground, p) >= clearance)
          << round << ": " << p.x << " " << p.y;
    }
  }
}

TEST(Clearing, VisitsEveryDiscNearAPlaceOnce) {
  std::mt19937_64 random(kClearingSeed + 7);
  std::uniform_real_distribution<double> place(-30.0, 130.0);
  std::uniform_real_distribution<double> reach(0.0, 40.0);
  for (int round = 0; round < 40; ++round) {
    const Ground ground = any_ground(random, 100.0, 3 * round, round / 4);
    const Clearing clearing(ground, 0.05 * (round % 7));
    for (int i = 0; i < 50; ++i) {
      const geom::Point p{place(random), place(random)};
      const double far = reach(random);
      std::vector<int> visits(ground.discs.size(), 0);
      clearing.visit_discs(p, far, [&](std::uint32_t disc) { ++visits.at(disc); });
      for (std::size_t disc = 0; disc < visits.size(); ++disc) {
        const bool is_near = distance(ground.discs[disc].center, p) - ground.discs[disc].radius <= far;
        EXPECT_TRUE(visits[disc] == 1 || (visits[disc] == 0 && !is_near)) << round << ": disc " << disc;
      }
    }
  }
}

TEST(Clearing, APieceIsFreeWhereAllOfItIs) {
  std::mt19937_64 random(kClearingSeed + 1);
  std::uniform_real_distribution<double> place(0.0, 100.0);
  int free_ones = 0;
  for (int round = 0; round < 60; ++round) {
    const Ground ground = any_ground(random, 100.0, round / 4, round / 6);
    const double clearance = 0.05 * round;
    const Clearing clearing(ground, clearance);
    for (int i = 0; i < 50; ++i) {
      const geom::Segment s{{place(random), place(random)}, {place(random), place(random)}};
      double room = 1e9;
      for (int k = 0; k <= 500; ++k) room = std::min(room, room_at(ground, s.a + (s.b - s.a) * (k / 500.0)));
      // Between two samples it may be a little less.
      if (std::abs(room - clearance) < 0.15) continue;
      EXPECT_EQ(clearing.is_free(s), room > clearance) << round;
      EXPECT_EQ(!clearing.first_hit(s), room > clearance) << round;
      free_ones += room > clearance ? 1 : 0;
    }
  }
  EXPECT_GT(free_ones, 100);
}

TEST(Clearing, WhatIsMetFirstIsNamed) {
  Ground ground;
  ground.discs = {{{50.0, 0.0}, 3.0}, {{20.0, 1.0}, 3.0}};
  ground.walls = {{{80.0, -5.0}, {80.0, 5.0}}};
  const Clearing clearing(ground, 1.0);
  EXPECT_EQ(clearing.first_hit({{0.0, 0.0}, {100.0, 0.0}}), 1U);
  EXPECT_EQ(clearing.first_hit({{30.0, 0.0}, {100.0, 0.0}}), 0U);
  EXPECT_EQ(clearing.first_hit({{60.0, 0.0}, {100.0, 0.0}}), 2U);
  EXPECT_EQ(clearing.first_hit({{100.0, 0.0}, {60.0, 0.0}}), 2U);
  EXPECT_EQ(clearing.first_hit({{82.0, 0.0}, {100.0, 0.0}}), std::nullopt);
}

TEST(Clearing, FreeArcsAreThoseWithRoom) {
  std::mt19937_64 random(kClearingSeed + 2);
  for (int round = 0; round < 60; ++round) {
    const Ground ground = any_ground(random, 100.0, 2 + round / 2, round / 4);
    const double clearance = 0.1 + 0.05 * round;
    const Clearing clearing(ground, clearance);
    for (std::uint32_t i = 0; i < clearing.rounds().size(); ++i) {
      const auto [center, radius] = clearing.rounds()[i];
      const auto arcs = clearing.free_arcs(i);
      for (int k = 0; k < 90; ++k) {
        const double angle = (k + 0.3) / 90.0 * 2.0 * std::numbers::pi;
        const geom::Point p = center + geom::Offset{radius * std::cos(angle), radius * std::sin(angle)};
        const bool is_named = std::ranges::any_of(arcs, [&](const Arc& arc) {
          return (angle >= arc.begin && angle <= arc.end) || angle + 2.0 * std::numbers::pi <= arc.end;
        });
        EXPECT_EQ(is_named, clearing.is_free(p)) << round << ", round " << i << " at " << angle;
      }
    }
  }
}

TEST(Clearing, TheNearestFreePlaceIsFreeAndNoneIsNearer) {
  std::mt19937_64 random(kClearingSeed + 3);
  std::uniform_real_distribution<double> place(-10.0, 110.0);
  int moved = 0;
  for (int round = 0; round < 60; ++round) {
    const Ground ground = any_ground(random, 100.0, round, round / 3);
    const Clearing clearing(ground, 0.05 * round);
    for (int i = 0; i < 20; ++i) {
      const geom::Point p{place(random), place(random)};
      const auto found = clearing.nearest_free(p);
      if (!found) {
        for (int k = 0; k < 5000; ++k)
          ASSERT_FALSE(clearing.is_free(geom::Point{place(random), place(random)})) << round;
        continue;
      }
      EXPECT_TRUE(clearing.is_free(*found));
      const double far = distance(p, *found);
      moved += far > 0.0 ? 1 : 0;
      for (int k = 0; k < 400; ++k) {
        const double angle = place(random);
        const double d = far * std::sqrt(0.5 + 0.499 * std::sin(place(random)));
        const geom::Point nearer = p + geom::Offset{d * std::cos(angle), d * std::sin(angle)};
        if (d >= far - 1e-5) continue;
        EXPECT_FALSE(clearing.is_free(nearer)) << round << " " << far << " " << d;
      }
    }
  }
  EXPECT_GT(moved, 300);
}

}  // namespace
}  // namespace mlab::ways
