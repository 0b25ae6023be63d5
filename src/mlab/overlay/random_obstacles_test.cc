#include "mlab/overlay/random_obstacles.h"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "mlab/base/testing/processor_time.h"

namespace mlab::overlay {
namespace {

TEST(AdditiveFeedbackRandom, GivesThePublishedSequenceOfSeedOne) {
  AdditiveFeedbackRandom random(1);
  EXPECT_EQ(random.next(), 1804289383);
  EXPECT_EQ(random.next(), 846930886);
  EXPECT_EQ(random.next(), 1681692777);
  EXPECT_EQ(random.next(), 1714636915);
  EXPECT_EQ(random.next(), 1957747793);
}

struct Sequence {
  std::uint32_t seed;
  std::int32_t first;
  std::int32_t thousandth;
};

TEST(AdditiveFeedbackRandom, AgreesWithTheCLibraryForAnySeed) {
  for (const Sequence& s :
       {Sequence{1, 1804289383, 1143565421}, Sequence{2, 1505335290, 2057566690},
        Sequence{945816576U, 380669464, 620287295}, Sequence{4294967295U, 254925627, 1892540048},
        Sequence{2147483648U, 1336741213, 193932953}, Sequence{4294967293U, 853660264, 532443557},
        Sequence{2147483647U, 1065668062, 1698607095}}) {
    AdditiveFeedbackRandom random(s.seed);
    EXPECT_EQ(random.next(), s.first) << s.seed;
    for (int i = 0; i < 998; ++i) random.next();
    EXPECT_EQ(random.next(), s.thousandth) << s.seed;
  }
  EXPECT_EQ(AdditiveFeedbackRandom(0).next(), AdditiveFeedbackRandom(1).next());
}

TEST(ObstacleSeed, IsRoundedAsAThirtyTwoBitFloat) {
  EXPECT_EQ(obstacle_seed(945816565), 945816576U);
  EXPECT_EQ(obstacle_seed(5052), 5052U);
  EXPECT_EQ(obstacle_seed(2.5), 3U);
  EXPECT_EQ(obstacle_seed(-2.5), static_cast<std::uint32_t>(-3));
  EXPECT_EQ(obstacle_seed(obstacle_seed(945816565)), 945816576U);
}

// The fields of three historic missions.
TEST(CreateObstacles, RepeatsHistoricFields) {
  const CreatedObstacles example3 = create_obstacles(Area{}, {2.0, 6.0, 15.0}, obstacle_seed(945816565));
  ASSERT_EQ(example3.obstacles.size(), 65U);
  EXPECT_NEAR(example3.obstacles[0].center.x, 177.73, 0.005);
  EXPECT_NEAR(example3.obstacles[0].center.y, 224.25, 0.005);
  EXPECT_NEAR(example3.obstacles[0].radius, 7.55, 0.005);
  EXPECT_TRUE(example3.is_complete);
  EXPECT_EQ(create_obstacles(Area{1000, 675}, {2.0, 3.0, 15.0}, obstacle_seed(5052)).obstacles.size(), 52U);
  EXPECT_EQ(create_obstacles(Area{800, 800}, {1.0, 4.0, 10.0}, obstacle_seed(8)).obstacles.size(), 44U);
  EXPECT_EQ(create_obstacles(Area{}, {2.0, 6.0, 15.0}, 945816565).obstacles.size(),
            57U);  // the seed not rounded
}

TEST(CreateObstacles, CoversWhatWasAskedAndOverlapsNothing) {
  const std::vector<ObstacleDisc> robots = {{{50, 50}, 40.0, 0.0, {}}};
  const Region region{{0, 0}, {200, 100}};
  const CreatedObstacles created = create_obstacles(region, {20.0, 1.0, 4.0}, 7, 0.0, robots);
  EXPECT_TRUE(created.is_complete);
  double covered = 0.0;
  auto all = created.obstacles;
  all.insert(all.end(), robots.begin(), robots.end());
  for (std::size_t i = 0; i < created.obstacles.size(); ++i) {
    covered += std::numbers::pi * all[i].radius * all[i].radius;
    EXPECT_TRUE(region.contains(all[i].center));
    EXPECT_GE(all[i].height, 1.0);
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      EXPECT_GE(geom::distance(all[i].center, all[j].center), all[i].radius + all[j].radius);
    }
  }
  EXPECT_GE(covered, 0.2 * 200 * 100);
  EXPECT_LT(covered, 0.2 * 200 * 100 + std::numbers::pi * 16.0);
}

TEST(CreateObstacles, GivesUpWhereThereIsNoRoom) {
  const CreatedObstacles created = create_obstacles(Area{10, 10}, {30.0, 20.0, 20.0}, 1);
  EXPECT_EQ(created.obstacles.size(), 1U);  // it covers the area already
  const std::vector<ObstacleDisc> everywhere = {{{5, 5}, 100.0, 0.0, {}}};
  const CreatedObstacles none =
      create_obstacles(Region{{0, 0}, {10, 10}}, {30.0, 1.0, 1.0}, 1, 0.0, everywhere);
  EXPECT_TRUE(none.obstacles.empty());
  EXPECT_FALSE(none.is_complete);
}

TEST(CreateObstacles, CountsWhatIsCoveredAlready) {
  EXPECT_TRUE(create_obstacles(Region{{0, 0}, {10, 10}}, {10.0, 1.0, 1.0}, 1, 10.0).obstacles.empty());
}

TEST(CreateObstacles, EndsSoonHoweverBigTheArea) {
  const auto create = [](double size) {
    const CreatedObstacles created = create_obstacles(Area{size, size}, {30.0, 1.0, 2.0}, 1);
    EXPECT_EQ(created.obstacles.size(), kMaxCreatedObstacles);
    EXPECT_FALSE(created.is_complete);
  };
  EXPECT_LT(base::Yardstick([&] { create(1e5); }).times([&] { create(1e8); }, 4.0), 4.0);
  EXPECT_TRUE(create_obstacles(Area{1e-3, 1e-3}, {0.0, 1.0, 2.0}, 1).obstacles.empty());
}

}  // namespace
}  // namespace mlab::overlay
