#include "mlab/schema/swept.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

using geom::Point;

constexpr double kReach = 5.0;   // [m]
constexpr double kMargin = 2.5;  // [m]

percept::KnownGround ground_with(const std::vector<ways::Round>& discs,
                                 const std::vector<geom::Segment>& walls = {}) {
  return {.revision = 1, .discs = discs, .walls = walls, .bounds = {}};
}

// Small ones on a lane along the axis.
std::vector<ways::Round> rocks_along(double length) {
  std::vector<ways::Round> out;
  for (double x = 0.0; x < length; x += 10.0) out.push_back({{x, 0.5}, 0.2});
  return out;
}

// Goes straight from place to place in steps of 0.4 m, and looks at what it has passed of the way.
void go(Swept& swept, const percept::KnownGround& ground, const std::vector<Point>& along,
        const std::vector<Point>& way) {
  for (std::size_t i = 1; i < along.size(); ++i) {
    const int steps = static_cast<int>(distance(along[i - 1], along[i]) / 0.4) + 1;
    for (int k = 0; k <= steps; ++k) {
      const Point here = along[i - 1] + (along[i] - along[i - 1]) * (1.0 * k / steps);
      swept.look(ground, here, kReach);
      swept.pass(ground, way, 1, distance(way[0], nearest_point({way[0], way[1]}, here)), kMargin, kReach);
    }
  }
}

TEST(Trail, IsNowhereFartherFromWhereOneWasThanItMayBe) {
  constexpr double kTolerance = 0.1;  // [m]
  Trail trail;
  std::vector<Point> places;
  for (int i = 0; i < 400; ++i) {
    const double t = 0.4 * i;
    places.push_back({t, 4.0 * std::sin(0.05 * t) + (i % 2 == 0 ? 0.02 : -0.02)});
    trail.go_to(places.back(), kTolerance);
  }
  EXPECT_LT(trail.pieces(), 40U);
  for (const Point p : places) {
    double least = 1e9;
    for (std::size_t back = 0; back < trail.pieces(); ++back)
      least = std::min(least, distance(nearest_point(trail.piece(back), p), p));
    EXPECT_LE(least, 1.5 * kTolerance);
  }
}

TEST(Trail, ForgetsTheOldest) {
  Trail trail;
  for (int i = 0; i < 1'000; ++i) trail.go_to({1.0 * i, i % 2 == 0 ? 0.0 : 5.0}, 0.1);
  EXPECT_EQ(trail.pieces(), Trail::kMostCorners);
  EXPECT_EQ(trail.piece(0).b, (Point{999.0, 5.0}));
}

TEST(Swept, MissesNothingOfALaneThatItKeeps) {
  const auto ground = ground_with({});
  const std::vector<Point> way{{0, 0}, {100, 0}};
  Swept swept;
  swept.begin();
  go(swept, ground, {{-10, 3}, {0, 0.1}, {100, -0.1}}, way);
  EXPECT_TRUE(swept.pass(ground, way, 2, 0.0, kMargin, kReach));
  EXPECT_TRUE(swept.missed().empty());
}

TEST(Swept, MissesWhatIsBeyondARockUntilItSeesThat) {
  const std::vector<ways::Round> rock{{{50, 0}, 3.0}};
  const auto ground = ground_with(rock);
  const std::vector<Point> way{{0, 0}, {100, 0}};
  Swept swept;
  swept.begin();
  go(swept, ground, {{0, 0}, {42, 0}, {46, 6}, {54, 6}, {58, 0}, {100, 0}}, way);
  ASSERT_FALSE(swept.missed().empty());
  for (const Point place : swept.missed()) {
    EXPECT_LT(place.y, 0.0);
    EXPECT_GT(distance(place, rock[0].center), 3.0);
    EXPECT_NEAR(place.x, 50.0, 12.0);
  }
  go(swept, ground, {{58, -4}, {42, -4}}, way);
  EXPECT_TRUE(swept.missed().empty());
}

TEST(Swept, MissesNothingWhereNothingStandsOnTheLane) {
  const std::vector<ways::Round> beside{{{50, 8}, 3.0}};
  const auto ground = ground_with(beside);
  const std::vector<Point> way{{0, 0}, {100, 0}};
  Swept swept;
  swept.begin();
  go(swept, ground, {{0, 0}, {50, 2}, {100, 0}}, way);
  EXPECT_TRUE(swept.missed().empty()) << "the way was planned beside it, and another robot was met";
}

TEST(Swept, DoesNotMissWhatTheLaneWouldNotHaveSeenNorWhatIsNoGround) {
  const std::vector<geom::Segment> wall{{{-10, -2}, {110, -2}}};
  const std::vector<ways::Round> rocks = rocks_along(100.0);
  auto ground = ground_with(rocks, wall);
  ground.bounds = {-20, -20, 120, 3};
  const std::vector<Point> way{{0, 0}, {100, 0}};
  Swept swept;
  swept.begin();
  swept.look(ground, {0, 200}, kReach);
  int looks = 0;
  while (!swept.pass(ground, way, 2, 0.0, kMargin, kReach) && ++looks < 1'000) {
    for (const Point place : swept.missed()) {
      EXPECT_GT(place.y, -2.0);
      EXPECT_LE(place.y, 3.0);
    }
    ASSERT_FALSE(swept.missed().empty());
    swept.give_up(swept.missed().front(), 2.0);
  }
  EXPECT_LT(looks, 1'000) << "what there is no room for is looked at later";
}

TEST(Swept, LooksAtSoMuchInACycle) {
  const std::vector<ways::Round> rocks = rocks_along(1000.0);
  const auto ground = ground_with(rocks);
  const std::vector<Point> way{{0, 0}, {1000, 0}};
  Swept swept;
  swept.begin();
  swept.look(ground, {500, 0}, kReach);
  EXPECT_FALSE(swept.pass(ground, way, 1, 1000.0, kMargin, kReach));
  EXPECT_LE(swept.missed().size(), Swept::kMostMissed);
}

TEST(Swept, GivesUpWhatIsNearToAPlace) {
  const std::vector<ways::Round> rocks = rocks_along(20.0);
  const auto ground = ground_with(rocks);
  const std::vector<Point> way{{0, 0}, {20, 0}};
  Swept swept;
  swept.begin();
  swept.look(ground, {0, 50}, kReach);
  swept.pass(ground, way, 1, 5.0, kMargin, kReach);
  ASSERT_FALSE(swept.missed().empty());
  const Point first = swept.missed().front();
  EXPECT_TRUE(swept.misses(first));
  swept.give_up(first, 0.0);
  EXPECT_FALSE(swept.misses(first));
  swept.give_up(first, 100.0);
  EXPECT_TRUE(swept.missed().empty());
}

}  // namespace
}  // namespace mlab::schema
