#include "mlab/sim/bench_scenario.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "mlab/sim/bench_run.h"

namespace mlab::sim {
namespace {

text::SourcePtr source(std::string text) {
  return std::make_shared<text::Source>("positions.csv", std::move(text));
}

TEST(BenchScenario, KeepsItsOwnRules) {
  const BenchScenario scenario = make_bench_scenario(500, 1);
  EXPECT_DOUBLE_EQ(scenario.side, std::sqrt(5000.0));
  EXPECT_EQ(scenario.robots.size(), 500U);
  double covered = 0.0;
  const double half = scenario.side / 2;
  for (const Disc& disc : scenario.discs) {
    covered += std::numbers::pi * disc.radius * disc.radius;
    EXPECT_LE(std::max(std::abs(disc.center.x), std::abs(disc.center.y)), half - 0.8);
    for (const Disc& other : scenario.discs) {
      EXPECT_TRUE(&other == &disc || distance(other.center, disc.center) >= 1.3);
    }
    for (const geom::Pose& robot : scenario.robots) {
      EXPECT_GE(distance(robot.position, disc.center), 0.5 + 0.085036758 + 0.05);
    }
  }
  EXPECT_NEAR(covered / (scenario.side * scenario.side), 0.05, 0.001);
}

TEST(BenchScenario, IsReadFromCsv) {
  const auto read =
      read_bench_scenario(source("# side_m,20.5\r\nobstacle,1,-2.5,0.5\nrobot,3,4,-1.5\n\nrobot,5,6,0"));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->side, 20.5);
  ASSERT_EQ(read->discs.size(), 1U);
  EXPECT_EQ(read->discs[0].center, (geom::Point{1, -2.5}));
  ASSERT_EQ(read->robots.size(), 2U);
  EXPECT_EQ(read->robots[0], (geom::Pose{{3, 4}, -1.5}));
}

TEST(BenchScenario, SaysWhichLineItDoesNotUnderstand) {
  for (const char* bad : {"robot,1,2", "robot,1,2,x", "robot,1,2,nan", "obstacle,1,2,-3", "banana,1,2,3"}) {
    const auto read = read_bench_scenario(source("# side_m,20\n" + std::string(bad) + "\n"));
    ASSERT_FALSE(read) << bad;
    EXPECT_EQ(read.error().kind, "bad-positions");
    EXPECT_EQ(read.error().place.source->line_column(read.error().place.span.begin).line, 2U);
  }
  EXPECT_FALSE(read_bench_scenario(source("robot,1,2,3\n")));
  EXPECT_FALSE(read_bench_scenario(source("# side_m,20\n")));
  EXPECT_FALSE(read_bench_scenario(source("")));
}

TEST(Bench, ComputesWhatOtherSimulatorsDo) {
  const BenchResult result = run_bench(make_bench_scenario(1000), {}, diffusion_control);
  EXPECT_EQ(result.cycles, 200);
  EXPECT_GE(result.hit_share, 0.056);
  EXPECT_LE(result.hit_share, 0.058);
  EXPECT_GE(result.mean_hit_distance, 0.70);
  EXPECT_LE(result.mean_hit_distance, 0.72);
  EXPECT_GE(result.mean_displacement, 2.95);
  EXPECT_LE(result.mean_displacement, 3.07);
}

TEST(Bench, TimesThatItTellsAddUp) {
  const BenchResult result =
      run_bench(make_bench_scenario(200, 1), {.threads = 2, .cycles = 100}, diffusion_control);
  EXPECT_NEAR(result.sense + result.behave + result.move + result.contact, result.seconds,
              0.2 * result.seconds);
  EXPECT_GT(result.robot_cycles_per_second, 0.0);
}

}  // namespace
}  // namespace mlab::sim
