#include "mlab/ways/sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace mlab::ways {
namespace {

constexpr std::uint64_t kSightSeed = 20261129;

// Lanes along the x axis over a square of 100 m.
const Lanes kSquare{{0.0, 0.0}, {1.0, 0.0}, 100.0, 10.0, 10};

TEST(Sight, AWallHidesWhatIsBehindIt) {
  const std::vector<geom::Segment> walls = {{{50.0, 20.0}, {50.0, 80.0}}};
  const Sight sight(kSquare, walls, 5.0);
  EXPECT_TRUE(sight.hides({48.0, 50.0}, {52.0, 50.0}));
  EXPECT_TRUE(sight.hides({52.0, 50.0}, {48.0, 52.0}));
  EXPECT_FALSE(sight.hides({48.0, 50.0}, {46.0, 52.0})) << "both on one side";
  EXPECT_FALSE(sight.hides({48.0, 82.0}, {52.0, 82.0})) << "past its end";
  EXPECT_FALSE(sight.hides({50.0, 50.0}, {52.0, 50.0})) << "on the wall";
  EXPECT_FALSE(sight.hides({50.0, 50.0}, {48.0, 50.0})) << "on the wall, from the other side";
}

TEST(Sight, NothingPassesWhereTwoWallsMeet) {
  const std::vector<geom::Segment> walls = {{{50.0, 20.0}, {50.0, 50.0}}, {{50.0, 50.0}, {50.0, 80.0}}};
  const Sight sight(kSquare, walls, 5.0);
  EXPECT_TRUE(sight.hides({48.0, 50.0}, {52.0, 50.0}));
}

TEST(Sight, WhatANearestPointDoesNotSeeAnEndMay) {
  const std::vector<geom::Segment> walls = {{{40.0, 50.0}, {49.0, 50.0}}};
  const Sight sight(kSquare, walls, 5.0);
  const LanePlace behind{48.8, 51.0};  // of the wall's end
  EXPECT_FALSE(sight.sees(behind, {40.0, 49.0}, {48.8, 49.0}, 5.0));
  EXPECT_TRUE(sight.sees(behind, {40.0, 49.0}, {51.0, 49.8}, 5.0));
  EXPECT_FALSE(sight.sees(behind, {40.0, 49.0}, {51.0, 49.8}, 2.0)) << "the end is too far away";
}

TEST(Sight, WithoutWallsNothingIsHidden) {
  const Sight sight(kSquare, {}, 5.0);
  EXPECT_TRUE(sight.is_open());
  EXPECT_FALSE(sight.hides({48.0, 50.0}, {52.0, 50.0}));
  EXPECT_TRUE(sight.sees({48.0, 50.0}, {52.0, 50.0}, {53.0, 50.0}, 5.0));
}

// Against a look at all walls, in steps.
TEST(Sight, IsWhatALookAtAllWallsSays) {
  std::mt19937_64 random(kSightSeed);
  std::uniform_real_distribution<double> place(-9.0, 109.0);
  std::uniform_real_distribution<double> off(-3.5, 3.5);
  int hidden = 0;
  for (int round = 0; round < 20; ++round) {
    const Lanes lanes{{3.0 * round, -20.0}, {std::cos(0.3 * round), std::sin(0.3 * round)}, 100.0, 10.0, 10};
    std::vector<geom::Segment> in_lanes;
    std::vector<geom::Segment> walls;
    for (int i = 0; i < 6 * round; ++i) {
      const LanePlace a{place(random), place(random)};
      const LanePlace b{a.along + 6.0 * off(random), a.across + 6.0 * off(random)};
      in_lanes.push_back({{a.along, a.across}, {b.along, b.across}});
      walls.push_back({lanes.to_world(a), lanes.to_world(b)});
    }
    const Sight sight(lanes, walls, 5.0);
    for (int i = 0; i < 200; ++i) {
      const LanePlace p{place(random), place(random)};
      const LanePlace from{p.along + off(random), p.across + off(random)};
      const geom::Segment look{{p.along, p.across}, {from.along, from.across}};
      const bool is_hidden =
          std::ranges::any_of(in_lanes, [&](const geom::Segment& wall) { return intersects(look, wall); });
      EXPECT_EQ(sight.hides(p, from), is_hidden) << "seed " << kSightSeed << ", round " << round;
      hidden += is_hidden ? 1 : 0;
    }
  }
  EXPECT_GT(hidden, 200);
}

}  // namespace
}  // namespace mlab::ways
