#include "mlab/fleet/known_ground.h"

#include <vector>

#include <gtest/gtest.h>

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
