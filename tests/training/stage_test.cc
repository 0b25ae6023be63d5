#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/cnl/elaborate.h"
#include "mlab/lang/cnl/load.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/sim/bench_run.h"
#include "mlab/simulated/run.h"
#include "mlab/training/mission_stage.h"
#include "mlab/training/scenario_stage.h"

namespace mlab::training {
namespace {

using Names = std::vector<std::string>;

std::shared_ptr<const flow::Program> bench_program(const std::string& name) {
  text::Diagnostics sink;
  const auto source = text::read_source(base::source_folder() + "/bench/" + name + ".cnl");
  const flow::Network network = cnl::elaborate(cnl::load(*source, sink), sink);
  auto program = flow::build_program(network, robot::component_library(), sink);
  EXPECT_TRUE(program) << text::render(sink);
  return program;
}

std::vector<double> seen_of(Stage& stage) {
  std::vector<double> out(stage.robots().size() * stage.seen().size());
  stage.observe(out);
  return out;
}

std::unique_ptr<Stage> scenario(int threads, const Names& seen, const Names& acted,
                                const std::string& control = "schemas") {
  auto stage = make_scenario_stage({.robots = 100, .threads = threads}, bench_program(control), seen, acted);
  EXPECT_TRUE(stage) << stage.error();
  return std::move(*stage);
}

TEST(ScenarioStage, IsTheRunOfTheBenchmarkBitForBit) {
  constexpr int kCycles = 40;
  const sim::BenchScenario places = sim::make_bench_scenario(100, 1);
  const auto program = bench_program("schemas");
  flow::Frame initial = program->make_frame();
  program->set(initial.data(), *program->find("half"), std::to_string(0.9 * places.side / 2.0));
  std::vector<flow::Frame> frames(places.robots.size());
  std::vector<geom::Pose> poses(places.robots.size());
  const sim::BenchResult bench = sim::run_bench(places, {.warm_up = 0, .cycles = kCycles},
                                                [&](std::uint32_t i, const auto& percepts, auto& out) {
                                                  if (percepts.time == 0.0) frames[i] = initial;
                                                  program->step(frames[i].data(), percepts, out, 1, i + 1);
                                                });
  const auto stage = scenario(1, {"body.x", "body.y", "body.contacts"}, {"half"});
  const std::vector<double> begin = seen_of(*stage);
  const std::vector<double> half(100, std::stod(std::to_string(0.9 * places.side / 2.0)));
  for (int i = 0; i < kCycles; ++i) ASSERT_EQ(stage->step(half, {}, {}), std::nullopt);
  const std::vector<double> end = seen_of(*stage);
  double displacement = 0.0;
  double contacts = 0.0;
  for (std::size_t i = 0; i < 100; ++i) {
    displacement += distance({begin[3 * i], begin[3 * i + 1]}, geom::Point{end[3 * i], end[3 * i + 1]}) / 100;
    contacts += end[3 * i + 2];
  }
  EXPECT_EQ(displacement, bench.mean_displacement);
  EXPECT_EQ(contacts, static_cast<double>(bench.contacts));
}

TEST(ScenarioStage, IsTheSameForAnyNumberOfThreads) {
  const Names seen = {"body.pose", "body.ranges", "*"};
  const auto one = scenario(1, seen, {});
  const auto two = scenario(2, seen, {});
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(one->step({}, {}, {}), std::nullopt);
    ASSERT_EQ(two->step({}, {}, {}), std::nullopt);
    ASSERT_EQ(seen_of(*one), seen_of(*two)) << "cycle " << i;
  }
}

TEST(ScenarioStage, BeginsAnew) {
  const auto stage = scenario(1, {"body.pose", "body.ranges"}, {});
  const std::vector<double> begin = seen_of(*stage);
  for (int i = 0; i < 5; ++i) stage->step({}, {}, {});
  const std::vector<double> fifth = seen_of(*stage);
  EXPECT_NE(begin, fifth);
  stage->reset(1);
  EXPECT_EQ(stage->cycle(), 0U);
  EXPECT_EQ(seen_of(*stage), begin);
  for (int i = 0; i < 5; ++i) stage->step({}, {}, {});
  EXPECT_EQ(seen_of(*stage), fifth);
}

// What is told goes into the cycle that begins with what was seen: there is no cycle of delay.
TEST(ScenarioStage, RobotsGoAsTheyAreTold) {
  const auto stage = scenario(1, {"body.pose", "body.driven"}, {"wish"}, "steered");
  std::vector<double> wish(300, 0.0);
  wish[0] = 0.2;
  const std::vector<double> begin = seen_of(*stage);
  ASSERT_EQ(stage->step(wish, {}, {}), std::nullopt);
  const std::vector<double> end = seen_of(*stage);
  EXPECT_NEAR(end[3], 0.02, 1e-12);
  EXPECT_NEAR(end[0] - begin[0], 0.02 * std::cos(begin[2]), 1e-12);
  EXPECT_EQ(end[7], 0.0) << "the second robot was told to stand";
}

TEST(ScenarioStage, RefusesWhatIsNoNumberAndStays) {
  const auto stage = scenario(1, {"body.pose"}, {"half"});
  std::vector<double> half(100, 10.0);
  half[42] = std::nan("");
  const std::vector<double> before = seen_of(*stage);
  EXPECT_EQ(stage->step(half, {}, {}), "row 42: nan: `half` takes numbers from 0 to 1000000 m");
  EXPECT_EQ(stage->cycle(), 0U);
  EXPECT_EQ(seen_of(*stage), before);
}

RunMaker maker(const std::string& mission) {
  const std::string file = base::source_folder() + "/missions/" + mission + "/" + mission + ".mdl";
  return [file](std::uint64_t seed) -> std::expected<std::unique_ptr<run::MissionRun>, std::string> {
    text::Diagnostics sink;
    auto read = mdl::load_mission(file, sink);
    run::RunSettings settings;
    settings.seed = seed;
    settings.executive.proceed_all = true;
    auto run = read ? simulated::make_run(read, {}, settings, sink) : nullptr;
    if (!run) return std::unexpected(text::render(sink));
    return run;
  };
}

TEST(MissionStage, IsTheMissionWhereNothingIsActed) {
  auto run = maker("patrol")(3);
  (*run)->post(mission::event::Execute{});
  auto stage = make_mission_stage(maker("patrol"), {}, {"body.pose"}, {});
  ASSERT_TRUE(stage) << stage.error();
  ASSERT_EQ((*stage)->reset(3), std::nullopt);
  ASSERT_EQ((*stage)->robots().size(), 2U);
  while ((*run)->step() == run::MissionRun::Progress::kStepped) {
    ASSERT_EQ((*stage)->step({}, {}, {}), std::nullopt);
    const std::vector<double> seen = seen_of(**stage);
    for (std::size_t i = 0; i < 2; ++i) {
      const geom::Pose& pose = (*run)->fleet().pose((*run)->fleet().robots()[i]);
      ASSERT_EQ((std::vector<double>(seen.begin() + 3 * i, seen.begin() + 3 * i + 3)),
                (std::vector<double>{pose.position.x, pose.position.y, pose.heading}));
    }
  }
  EXPECT_FALSE((*stage)->is_over());
  ASSERT_EQ((*stage)->step({}, {}, {}), std::nullopt);
  EXPECT_TRUE((*stage)->is_over());
  std::vector<std::uint8_t> ended(2);
  (*stage)->ended(ended);
  EXPECT_EQ(ended, (std::vector<std::uint8_t>{1, 1}));
}

TEST(MissionStage, SetsParametersAsAPersonDoes) {
  auto stage =
      make_mission_stage(maker("patrol"), {{2}}, {"body.driven", "base_velocity"}, {"base_velocity"});
  ASSERT_TRUE(stage) << stage.error();
  const std::vector<double> slow = {0.25};
  for (int i = 0; i < 30; ++i) ASSERT_EQ((*stage)->step(slow, {}, {}), std::nullopt);
  const std::vector<double> seen = seen_of(**stage);
  EXPECT_EQ(seen[1], 0.25);
  EXPECT_GT(seen[0], 0.0);
  const std::vector<double> wrong = {-1.0};
  const auto problem = (*stage)->step(wrong, {}, {});
  ASSERT_TRUE(problem);
  EXPECT_TRUE(problem->starts_with("row 0 (robot 2): -1: `base_velocity` takes numbers from 0")) << *problem;
}

TEST(MissionStage, SaysWhichRobotHasNoSuchPort) {
  const auto stage = make_mission_stage(maker("patrol"), {}, {"nothing_like_it"}, {});
  ASSERT_FALSE(stage);
  EXPECT_TRUE(stage.error().starts_with("robot 1: the program")) << stage.error();
  EXPECT_EQ(make_mission_stage(maker("patrol"), {{9}}, {}, {}).error(), "there is no robot 9");
}

}  // namespace
}  // namespace mlab::training
