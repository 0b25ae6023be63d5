#include "mlab/schema/clearance.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/random.h"

namespace mlab::schema {
namespace {

using geom::Offset;
using geom::Point;

double room(Offset at, const Bar& bar) {
  return distance(nearest_point(bar.line, Point{} + at), Point{} + at) - bar.reach;
}

TEST(ClearMotion, IsTheMotionItselfWhereNothingIsMet) {
  const std::vector<Bar> bars = {{{{0, 1}, {5, 1}}, 0.2}, {{{-1, 0}, {-1, 0}}, 0.5}};
  for (const Offset motion : {Offset{0.4, 0}, Offset{0.4, 0.5}, Offset{}, Offset{0, -1}})
    EXPECT_EQ(clear_motion(motion, bars), motion);
  EXPECT_EQ(clear_motion({1, 2}, {}), (Offset{1, 2}));
}

TEST(ClearMotion, EndsAtAWallAndGoesAlongIt) {
  const std::vector<Bar> bars = {{{{-5, 1}, {5, 1}}, 0.2}};
  const Offset ahead = clear_motion({0, 3}, bars);
  EXPECT_NEAR(ahead.y, 0.8, 2e-3);
  EXPECT_EQ(ahead.x, 0.0);
  const Offset along = clear_motion({2, 3}, bars);
  EXPECT_NEAR(along.y, 0.8, 2e-3);
  EXPECT_NEAR(along.x, 2.0, 1e-9);
}

TEST(ClearMotion, PassesTheEndOfAWallThatItWouldGraze) {
  const std::vector<Bar> bars = {{{{1, -5}, {1, -0.1}}, 0.2}};
  const Offset past = clear_motion({2, 0}, bars);
  EXPECT_GT(past.x, 1.0) << "it is no wall to stop at";
  EXPECT_GT(past.y, 0.0);
}

TEST(ClearMotion, LeavesWhatItIsIn) {
  const std::vector<Bar> bars = {{{{0.1, 0}, {0.1, 0}}, 0.5}};
  EXPECT_EQ(clear_motion({-1, 0.5}, bars), (Offset{-1, 0.5}));
  EXPECT_NEAR(clear_motion({1, 0.5}, bars).x, 0.0, 1e-9);
}

TEST(ClearMotion, ComesNoNearerToWhatMovesThanThatAllows) {
  const std::vector<Bar> bars = {{{{1, 0}, {1, 0}}, 0.4, 0.3}};
  EXPECT_EQ(clear_motion({0.2, 0.5}, bars), (Offset{0.2, 0.5}));
  const Offset less = clear_motion({0.8, 0.5}, bars);
  EXPECT_NEAR(less.x, 0.3, 1e-9);
  EXPECT_NEAR(less.y, 0.5, 1e-9);
  EXPECT_NEAR(clear_motion({0.8, 0}, std::vector<Bar>{{{{1, 0}, {1, 0}}, 0.4, 0.0}}).x, 0.0, 1e-9);
}

// Whatever is around: nothing is touched on the way that was clear of it before, and it is never farther than
// wanted.
TEST(ClearMotionLaw, TouchesNothing) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    auto random = base::Random::of(seed, 0, 0, 0);
    std::vector<Bar> bars;
    for (std::size_t i = random.below(9); i-- > 0;) {
      const Point a{random.uniform(-2, 2), random.uniform(-2, 2)};
      const Point b{random.uniform(-2, 2), random.uniform(-2, 2)};
      const bool is_round = random.uniform() < 0.4;
      const Bar bar{{a, is_round ? a : b}, random.uniform(0.05, 0.6)};
      if (room({}, bar) > 0.01) bars.push_back(bar);
    }
    const Offset wanted{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)};
    const Offset motion = clear_motion(wanted, bars);
    EXPECT_LE(length(motion), length(wanted) + 1e-9);
    for (int step = 0; step <= 200; ++step) {
      for (const Bar& bar : bars) ASSERT_GT(room(motion * (step / 200.0), bar), -1e-6);
    }
  }
}

// Two that allow each other half of what is between them.
TEST(ClearMotionLaw, TwoThatShareNeverTouch) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    auto random = base::Random::of(seed, 0, 0, 0);
    const Offset between{random.uniform(-2, 2), random.uniform(-2, 2)};
    const double reach = random.uniform(0.1, 0.9) * length(between);
    const double half = 0.5 * (length(between) - reach);
    const auto motion_of = [&](double sign) {
      const Point other = Point{} + between * sign;
      return clear_motion({random.uniform(-3, 3), random.uniform(-3, 3)},
                          std::vector<Bar>{{{other, other}, reach, half}});
    };
    const Offset one = motion_of(1.0);
    const Offset other = motion_of(-1.0);
    for (int step = 0; step <= 100; ++step)
      ASSERT_GE(length(between + (other - one) * (step / 100.0)), reach - 1e-9);
  }
}

}  // namespace
}  // namespace mlab::schema
