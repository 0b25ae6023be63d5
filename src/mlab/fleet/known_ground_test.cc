#include "mlab/fleet/known_ground.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/random.h"

namespace mlab::fleet {
namespace {

overlay::Overlay with_one_disc() {
  overlay::Overlay map;
  map.obstacles.push_back({{50.0, 50.0}, 4.0, 0.0, {}});
  return map;
}

TEST(TeamGround, KnowsWhatTheMapHas) {
  const TeamGround ground(with_one_disc());
  EXPECT_TRUE(ground.knows({50.0, 50.0}));
  EXPECT_FALSE(ground.knows({60.0, 50.0}));
  EXPECT_NE(ground.view().revision, 0U);
  EXPECT_EQ(ground.view().revision, TeamGround(with_one_disc()).view().revision);
}

TEST(TeamGround, HasNothingOfTheMapThatMoves) {
  overlay::Overlay map = with_one_disc();
  map.obstacles.push_back({.center = {20.0, 20.0},
                           .radius = 3.0,
                           .height = 0.0,
                           .place = {},
                           .route = {{30.0, 20.0}},
                           .speed = 1.0});
  const TeamGround ground(map);
  EXPECT_FALSE(ground.knows({20.0, 20.0}));
  ASSERT_EQ(ground.view().discs.size(), 1U);
  EXPECT_EQ(ground.view().revision, TeamGround(with_one_disc()).view().revision);
  const std::vector<ways::Round> sensed = {{{70.0, 50.0}, 2.0}};
  ASSERT_NE(ground.with(sensed), nullptr);
  EXPECT_EQ(ground.with(sensed)->view().discs.size(), 2U);
}

TEST(TeamGround, TellsEdgesOfMinefieldsFromWalls) {
  overlay::Overlay map = with_one_disc();
  overlay::ControlMeasure mines;
  mines.kind = overlay::MeasureKind::kMinefield;
  mines.points = {{10.0, 10.0}, {20.0, 10.0}, {10.0, 20.0}};
  overlay::ControlMeasure wall;
  wall.kind = overlay::MeasureKind::kWall;
  wall.points = {{40.0, 0.0}, {40.0, 9.0}};
  map.measures = {mines, wall};
  const TeamGround ground(map);
  const std::vector<ways::Round> sensed = {{{70.0, 50.0}, 2.0}};
  for (const percept::KnownGround& view : {ground.view(), ground.with(sensed)->view()}) {
    ASSERT_EQ(view.walls.size(), 4U);
    EXPECT_EQ(view.edges, 3U);
    EXPECT_FALSE(view.is_edge(0));
    EXPECT_TRUE(view.is_edge(1));
    EXPECT_TRUE(view.is_edge(3));
  }
}

TEST(TeamGround, RemembersWhatWasSensedOnce) {
  const TeamGround before(with_one_disc());
  const std::vector<ways::Round> sensed = {
      {{70.0, 50.0}, 2.0}, {{70.1, 50.0}, 2.0}, {{50.0, 50.0}, 4.0}, {{90.0, 50.0}, 1.0}};
  const auto after = before.with(sensed);
  ASSERT_NE(after, nullptr);
  EXPECT_EQ(after->view().discs.size(), 3U);
  EXPECT_NE(after->view().revision, before.view().revision);
  EXPECT_TRUE(after->knows({70.0, 50.0}));
  EXPECT_EQ(after->with(sensed), nullptr);
  EXPECT_EQ(before.view().discs.size(), 1U);
}

TEST(TeamGround, ForgetsWhatIsSeenToBeGone) {
  const TeamGround map(with_one_disc());
  const std::vector<ways::Round> sensed = {{{70.0, 50.0}, 2.0}, {{72.0, 60.0}, 0.05}};
  const auto before = map.with(sensed);
  const geom::Pose here{{60.0, 50.0}, 0.5};
  const std::vector<percept::Obstacle> all = {{here.to_robot(geom::Point{50.0, 50.0}), 4.0, {}},
                                              {here.to_robot(geom::Point{70.0, 50.1}), 2.0, {}}};
  EXPECT_TRUE(before->missed(here, 30.0, all).empty());
  EXPECT_TRUE(before->missed(here, 5.0, {}).empty()) << "farther than it sees";
  EXPECT_EQ(before->missed(here, 30.0, std::span(all).first(1)), (std::vector<geom::Point>{{70.0, 50.0}}));
  const std::vector<geom::Point> both = before->missed(here, 30.0, {});
  ASSERT_EQ(both.size(), 2U) << "not what is as small as a place of a wall";
  const auto after = before->without(both);
  ASSERT_NE(after, nullptr);
  EXPECT_FALSE(after->knows({50.0, 50.0})) << "of the map, too";
  EXPECT_FALSE(after->knows({70.0, 50.0}));
  EXPECT_EQ(after->without(both), nullptr);
  EXPECT_EQ(before->without(std::span(both).last(1))->without(std::span(both).first(1))->view().revision,
            after->view().revision);
}

TEST(TeamGround, MissesAmongManyWhatOneByOneWouldBeMissed) {
  constexpr std::uint64_t kSeed = 20261129;
  base::Random random(kSeed);
  overlay::Overlay map;
  for (int i = 0; i < 600; ++i) {
    const double radius = i % 50 == 0 ? 40.0 : random.uniform(0.1, 6.0);
    map.obstacles.push_back({{random.uniform(0.0, 900.0), random.uniform(0.0, 900.0)}, radius, 0.0, {}});
  }
  const TeamGround ground(map);
  std::size_t missed = 0;
  for (int look = 0; look < 60; ++look) {
    const geom::Pose here{{random.uniform(-50.0, 950.0), random.uniform(-50.0, 950.0)},
                          random.uniform(-3.0, 3.0)};
    const double reach = random.uniform(0.5, 80.0);
    std::vector<percept::Obstacle> seen;
    std::vector<geom::Point> expected;
    for (const ways::Round& disc : ground.view().discs) {
      if (distance(disc.center, here.position) - disc.radius > reach - 1.0 || disc.radius < 0.25) continue;
      if (random.uniform(0.0, 1.0) < 0.5)
        seen.push_back({here.to_robot(disc.center), disc.radius, {}});
      else
        expected.push_back(disc.center);
    }
    std::erase_if(expected, [&](geom::Point center) {  // something else is seen in its place
      const geom::Vector there = here.to_robot(center);
      return std::ranges::any_of(seen, [&](const auto& one) { return length(one.center - there) <= 0.2; });
    });
    EXPECT_EQ(ground.missed(here, reach, seen), expected) << "seed " << kSeed << ", look " << look;
    missed += expected.size();
  }
  EXPECT_GT(missed, 100U);
}

TEST(TeamGround, MissesNothingWhereNobodyKnowsWhereTheRobotIs) {
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(TeamGround(with_one_disc()).missed({{kNowhere, 50.0}, 0.0}, 30.0, {}).empty());
}

TEST(TeamGround, HasRoomForSoManyAndNoMore) {
  std::vector<ways::Round> sensed;
  for (int i = 0; i < 5'000; ++i) sensed.push_back({{2.0 * i, -10.0}, 0.1});
  const auto after = TeamGround(with_one_disc()).with(sensed);
  ASSERT_NE(after, nullptr);
  EXPECT_EQ(after->view().discs.size(), 1U + TeamGround::kMostSensed);
  EXPECT_EQ(after->with(sensed), nullptr);
}

}  // namespace
}  // namespace mlab::fleet
