#include "mlab/overlay/environment_change.h"

#include <gtest/gtest.h>

namespace mlab::overlay {
namespace {

EnvironmentEvent event(const EnvironmentChange& change) {
  return {0.0, 0.0, {change}, {}};
}
std::vector<ObstacleDisc> discs(std::initializer_list<geom::Point> centers) {
  std::vector<ObstacleDisc> out;
  for (const geom::Point p : centers) out.push_back({p, 1.0, 0.0, {}});
  return out;
}

TEST(Executions, CountsFromTheStartInPeriods) {
  const EnvironmentEvent e{10.0, 5.0, {}, {}};
  EXPECT_EQ(executions(e, 9.9), 0U);
  EXPECT_EQ(executions(e, 10.0), 1U);
  EXPECT_EQ(executions(e, 14.9), 1U);
  EXPECT_EQ(executions(e, 15.0), 2U);
  EXPECT_EQ(executions(e, 1010.0), 201U);
}

TEST(Executions, IsNeverMoreThanOneWithoutAPeriod) {
  const EnvironmentEvent e{10.0, 0.0, {}, {}};
  EXPECT_EQ(executions(e, 1e9), 1U);
}

TEST(Executions, DoesNotMissACycleThatIsAHairShort) {
  const EnvironmentEvent e{1.0, 0.0, {}, {}};
  double time = 0.0;
  for (int i = 0; i < 10; ++i) time += 0.1;
  ASSERT_LT(time, 1.0);
  EXPECT_EQ(executions(e, time), 1U);
}

TEST(EnvironmentChange, AddsAndRemovesSingleObstacles) {
  auto obstacles = discs({{1, 1}, {5, 5}});
  EXPECT_TRUE(apply(event(AddObstacle{{3, 4}, 2.0}), 0, 1, {}, obstacles));
  ASSERT_EQ(obstacles.size(), 3U);
  EXPECT_EQ(obstacles[2].radius, 2.0);
  apply(event(RemoveObstacle{{5.000005, 5}}), 0, 1, {}, obstacles);
  EXPECT_EQ(obstacles.size(), 2U);
  apply(event(RemoveObstacle{{1.0001, 1}}), 0, 1, {}, obstacles);
  EXPECT_EQ(obstacles.size(), 2U);
}

TEST(EnvironmentChange, ClearsARegionWithItsEdges) {
  auto obstacles = discs({{0, 0}, {10, 10}, {5, 5}, {10.1, 5}});
  apply(event(ClearRegion{{{0, 0}, {10, 10}}}), 0, 1, {}, obstacles);
  ASSERT_EQ(obstacles.size(), 1U);
  EXPECT_EQ(obstacles[0].center.x, 10.1);
}

TEST(EnvironmentChange, FillsARegionUpToItsCoverageClearOfRobots) {
  const std::vector<ObstacleDisc> robots = {{{100, 100}, 30.0, 0.0, {}}};
  const FillRegion fill{{{0, 0}, {200, 200}}, {3.0, 1.0, 5.0}, 1.0, 0.0};
  std::vector<ObstacleDisc> obstacles;
  EXPECT_TRUE(apply(event(fill), 0, 1, robots, obstacles));
  EXPECT_GT(obstacles.size(), 15U);
  for (const ObstacleDisc& d : obstacles) EXPECT_GE(geom::distance(d.center, {100, 100}), 30.0 + d.radius);
  // Now it is full: nothing comes on top.
  const std::size_t full = obstacles.size();
  apply(event(fill), 1, 1, robots, obstacles);
  EXPECT_EQ(obstacles.size(), full);
}

TEST(EnvironmentChange, RepeatsForTheSameSeedAndMovesOnByTheIncrement) {
  const auto field = [](std::optional<double> seed, double increment, std::uint64_t execution,
                        std::uint64_t run_seed) {
    std::vector<ObstacleDisc> obstacles;
    apply(event(FillRegion{{{0, 0}, {200, 200}}, {3.0, 1.0, 5.0}, seed, increment}), execution, run_seed, {},
          obstacles);
    return obstacles.at(0).center;
  };
  EXPECT_EQ(field(1.0, 0.0, 0, 7), field(1.0, 0.0, 5, 8));
  EXPECT_EQ(field(1.0, 2.0, 3, 7), field(7.0, 0.0, 0, 7));
  EXPECT_EQ(field({}, 0.0, 0, 7), field({}, 0.0, 0, 7));
  EXPECT_NE(field({}, 0.0, 0, 7), field({}, 0.0, 0, 8));
  EXPECT_NE(field({}, 0.0, 0, 7), field({}, 0.0, 1, 7));
}

}  // namespace
}  // namespace mlab::overlay
