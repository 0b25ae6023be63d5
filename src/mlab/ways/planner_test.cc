#include "mlab/ways/planner.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "mlab/ways/testing/grounds.h"

namespace mlab::ways {
namespace {

using testing::any_ground;
using testing::GridWays;
using testing::room_at;

constexpr std::uint64_t kPlannerSeed = 20261127;

double length_of(const std::vector<geom::Point>& corners) {
  double out = 0.0;
  for (std::size_t i = 1; i < corners.size(); ++i) out += distance(corners[i - 1], corners[i]);
  return out;
}

double room_along(const Ground& ground, const std::vector<geom::Point>& corners) {
  double out = 1e9;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    for (int k = 0; k <= 50; ++k)
      out = std::min(out, room_at(ground, corners[i - 1] + (corners[i] - corners[i - 1]) * (k / 50.0)));
  }
  return out;
}

TEST(Planner, GoesStraightWhereNothingIs) {
  const Ground ground;
  Planner planner(ground, 5.0);
  const auto way = planner.find({0.0, 0.0}, {30.0, 40.0});
  ASSERT_TRUE(way);
  EXPECT_EQ(way->length, 50.0);
  EXPECT_EQ(way->corners.size(), 2U);
}

// Two tangents of length sqrt(50^2 - 10^2) and the arc between them.
TEST(Planner, GoesRoundADisc) {
  Ground ground;
  ground.discs = {{{50.0, 0.0}, 8.0}};
  Planner planner(ground, 2.0);
  const auto way = planner.find({0.0, 0.0}, {100.0, 0.0});
  ASSERT_TRUE(way);
  const double tangent = std::sqrt(2500.0 - 100.0);
  const double arc = 10.0 * 2.0 * std::asin(10.0 / 50.0);
  EXPECT_NEAR(way->length, 2.0 * tangent + arc, 1e-9);
  EXPECT_GE(room_along(ground, way->corners), 2.0 - 1e-9);
  EXPECT_LT(length_of(way->corners), way->length * 1.001);
}

TEST(Planner, GoesRoundTheEndsOfWalls) {
  Ground ground;
  ground.walls = {{{50.0, -20.0}, {50.0, 30.0}}};
  Planner planner(ground, 0.5);
  const auto way = planner.find({0.0, 0.0}, {100.0, 0.0});
  ASSERT_TRUE(way);
  EXPECT_NEAR(way->length, 2.0 * std::sqrt(2900.0), 0.5);
  EXPECT_GE(room_along(ground, way->corners), 0.5 - 1e-9);
}

TEST(Planner, LeavesACorridorByItsDoor) {
  Ground ground;  // a closed room of 20 m, with a door of 1 m in its far side
  const geom::Point a{0.0, 0.0};
  const geom::Point b{20.0, 0.0};
  const geom::Point c{20.0, 20.0};
  const geom::Point d{0.0, 20.0};
  ground.walls = {{a, b}, {c, d}, {d, a}, {b, {20.0, 9.5}}, {{20.0, 10.5}, c}};
  Planner narrow(ground, 0.45);
  const auto way = narrow.find({5.0, 10.0}, {-10.0, 10.0});
  ASSERT_TRUE(way);
  EXPECT_GT(way->length, 40.0);
  EXPECT_GE(room_along(ground, way->corners), 0.45 - 1e-9);
  Planner wide(ground, 0.55);
  const auto none = wide.find({5.0, 10.0}, {-10.0, 10.0});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().nearest, (geom::Point{5.0, 10.0}));  // in an empty room no way turns
}

TEST(Planner, StaysWithinBounds) {
  Ground ground;
  ground.bounds = {0.0, -9.0, 100.0, 50.0};
  ground.discs = {{{50.0, 0.0}, 8.0}};
  Planner planner(ground, 2.0);
  const auto way = planner.find({0.0, -1.0}, {100.0, -1.0});
  ASSERT_TRUE(way);
  for (const geom::Point corner : way->corners) EXPECT_GE(corner.y, -1.0);
  ground.bounds.y1 = 9.0;
  Planner closed(ground, 2.0);
  EXPECT_FALSE(closed.find({0.0, -1.0}, {100.0, -1.0}).has_value());
}

// Whatever stands there, it is as long as the shortest one over a grid, but for what a grid's way has more:
// up to 8.3 % (of eight directions), and corners that it cuts within a step.
TEST(Planner, FindsTheShortestWayWhereverThereIsOne) {
  std::mt19937_64 random(kPlannerSeed);
  std::uniform_real_distribution<double> place(2.0, 98.0);
  int found = 0;
  int closed = 0;
  for (int round = 0; round < 120; ++round) {
    const Ground ground = any_ground(random, 100.0, 3 + round / 3, round % 3 == 0 ? round / 2 : 0);
    const double clearance = 0.3 + 0.02 * round;
    constexpr double kStep = 1.0;
    const GridWays grid(ground, clearance, 100.0, kStep);
    const GridWays tight(ground, clearance + kStep, 100.0, kStep);
    const GridWays wide(ground, clearance - kStep, 100.0, kStep);
    Planner planner(ground, clearance);
    const geom::Point from = grid.snapped({place(random), place(random)});
    const geom::Point to = grid.snapped({place(random), place(random)});
    if (!tight.is_free(from) || !tight.is_free(to)) continue;
    const auto way = planner.find(from, to);
    const double most = tight.length(from, to);
    const double least = wide.length(from, to);
    if (!way) {
      EXPECT_TRUE(std::isinf(most)) << round << ": the grid has a way of " << most;
      ++closed;
      continue;
    }
    ++found;
    EXPECT_LE(way->length, most + 1e-6) << round;
    EXPECT_GE(way->length, least / 1.0824 - 1e-6) << round;
    EXPECT_GE(room_along(ground, way->corners), clearance - 0.01 * (clearance + 8.0)) << round;
    EXPECT_NEAR(length_of(way->corners), way->length, 0.01 * way->length + 1e-6) << round;
    EXPECT_EQ(way->corners.front(), from);
    EXPECT_EQ(way->corners.back(), to);
    const auto back = planner.find(to, from);
    ASSERT_TRUE(back) << round;
    EXPECT_NEAR(back->length, way->length, 1e-6 * way->length) << round;
  }
  EXPECT_GT(found, 30);
  EXPECT_GT(closed, 1);
}

// Where things are many, those far away are looked at only when a way may lead by them.
TEST(Planner, GoesAsFarAroundAsItHasToWhereThingsAreMany) {
  // A wall of discs across the way that ends far off, within a field of others beyond.
  Ground few;
  for (int i = -60; i <= 200; ++i) few.discs.push_back({{50.0, 10.0 * i}, 6.0});
  Ground many = few;
  for (int row = 0; row < 20; ++row) {
    for (int i = 0; i < 20; ++i) many.discs.push_back({{5000.0 + 40.0 * i, 40.0 * row}, 6.0});
  }
  Planner all_at_once(few, 1.0);
  Planner by_rings(many, 1.0);
  const auto expected = all_at_once.find({0.0, 0.0}, {100.0, 0.0});
  const auto way = by_rings.find({0.0, 0.0}, {100.0, 0.0});
  ASSERT_TRUE(expected && way);
  EXPECT_GT(way->length, 1200.0);
  EXPECT_EQ(way->length, expected->length);
  EXPECT_EQ(way->corners, expected->corners);
  EXPECT_LT(by_rings.effort(), many.discs.size() * many.discs.size());
  // What was found before makes no difference, and no way is certain once all rings were looked at.
  EXPECT_EQ(by_rings.find({0.0, 0.0}, {100.0, 0.0})->corners, way->corners);
  many.bounds = {-100.0, -600.0, 200.0, 2000.0};
  const auto none = Planner(many, 1.0).find({0.0, 0.0}, {100.0, 0.0});
  ASSERT_FALSE(none);
  EXPECT_TRUE(none.error().is_certain);
}

TEST(Planner, AnswersTheSameWhateverWasAskedBefore) {
  std::mt19937_64 random(kPlannerSeed + 7);
  std::uniform_real_distribution<double> place(0.0, 100.0);
  const Ground ground = any_ground(random, 100.0, 30, 5);
  Planner used(ground, 1.0);
  for (int i = 0; i < 40; ++i) {
    const geom::Point from{place(random), place(random)};
    const geom::Point to{place(random), place(random)};
    if (!used.clearing().is_free(from) || !used.clearing().is_free(to)) continue;
    Planner fresh(ground, 1.0);
    const auto a = used.find(from, to);
    const auto b = fresh.find(from, to);
    ASSERT_EQ(a.has_value(), b.has_value());
    EXPECT_TRUE(!a || a->corners == b->corners) << i;
  }
}

}  // namespace
}  // namespace mlab::ways
