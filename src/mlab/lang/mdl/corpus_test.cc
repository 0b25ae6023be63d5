#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/tree.h"
#include "mlab/text/testing/golden.h"

namespace mlab::mdl {
namespace {

namespace fs = std::filesystem;

// Real missions of the historic system, where they are at hand.
fs::path corpus() {
  const char* named = std::getenv("MLAB_CORPUS");
  return (named != nullptr ? fs::path(named) : fs::path(base::source_folder()) / "../shared/corpus") /
         "missions";
}

class MdlCorpus : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::is_directory(corpus())) GTEST_SKIP() << "no corpus at " << corpus();
  }
};

// What the language's reference says of a file.
struct Figures {
  std::string name;
  std::size_t steps = 0;
  std::size_t commands = 0;
  std::size_t robots = 0;
  std::size_t measures = 0;
  std::size_t obstacles = 0;  // placed and created
};

struct Goal {
  std::string name;
  std::size_t step = 0;
  std::size_t command = 0;
  geom::Point goal;
};

std::shared_ptr<const mission::Mission> load(const std::string& name) {
  text::Diagnostics sink;
  auto mission = load_mission((corpus() / name).string(), sink);
  EXPECT_NE(mission, nullptr) << text::render(sink);
  return mission;
}

std::size_t command_count(const mission::Mission& mission) {
  std::size_t out = 0;
  for (const mission::Step& step : mission.steps) out += step.commands.size();
  return out;
}

TEST_F(MdlCorpus, HasTheStepsRobotsAndFeaturesOfTheReference) {
  for (const Figures& f : std::vector<Figures>{{"democ", 11, 15, 2, 10, 0},
                                               {"example3", 11, 13, 4, 13, 65},
                                               {"example_formation", 13, 13, 4, 4, 52},
                                               {"example_turn", 7, 7, 4, 3, 44},
                                               {"robot-lab1", 7, 7, 1, 9, 0},
                                               {"squeeze", 6, 6, 4, 3, 24},
                                               {"tech-demo2", 13, 13, 2, 12, 34}}) {
    const auto mission = load(f.name);
    ASSERT_NE(mission, nullptr);
    EXPECT_EQ(mission->steps.size(), f.steps) << f.name;
    EXPECT_EQ(command_count(*mission), f.commands) << f.name;
    EXPECT_EQ(mission->robots.size(), f.robots) << f.name;
    EXPECT_EQ(mission->overlay.measures.size(), f.measures) << f.name;
    EXPECT_EQ(mission->overlay.obstacles.size(), f.obstacles) << f.name;
  }
}

TEST_F(MdlCorpus, HasTheGoalsOfTheReference) {
  for (const Goal& g : std::vector<Goal>{{"democ", 0, 0, {610, 120}},
                                         {"democ", 2, 0, {550, 220}},
                                         {"democ", 6, 1, {400, 630}},
                                         {"example3", 0, 0, {130, 130}},
                                         {"example3", 2, 0, {80, 300}},
                                         {"example3", 4, 0, {550, 300}},
                                         {"robot-lab1", 0, 0, {3.65, 2.34}},
                                         {"robot-lab1", 1, 0, {9.25, 4.8}},
                                         {"robot-lab1", 2, 0, {6.25, 2.6}},
                                         {"squeeze", 0, 0, {85, 220}},
                                         {"squeeze", 2, 0, {660, 340}}}) {
    const auto mission = load(g.name);
    ASSERT_NE(mission, nullptr);
    const auto& command = std::get<mission::UnitCommand>(mission->steps.at(g.step).commands.at(g.command));
    EXPECT_NEAR(command.goal.x, g.goal.x, 0.005) << g.name << " step " << g.step;
    EXPECT_NEAR(command.goal.y, g.goal.y, 0.005) << g.name << " step " << g.step;
  }
}

TEST_F(MdlCorpus, CreatesTheHistoricObstacles) {
  const auto mission = load("example3");
  ASSERT_NE(mission, nullptr);
  EXPECT_EQ(*mission->options.seed, 945816576.0);
  const overlay::ObstacleDisc& first = mission->overlay.obstacles.front();
  EXPECT_NEAR(first.center.x, 177.73, 0.01);
  EXPECT_NEAR(first.center.y, 224.25, 0.01);
  EXPECT_NEAR(first.radius, 7.55, 0.01);
}

TEST_F(MdlCorpus, StaysTheSameWhenItIsFormattedTwice) {
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(corpus())) {
    if (entry.path().has_extension()) continue;
    const std::string text = text::testing::read_all(entry.path());
    EXPECT_TRUE(looks_like_mdl(text)) << entry.path();
    text::Diagnostics sink;
    const std::string once = print(parse(std::make_shared<const text::Source>("once", text), sink));
    const std::string twice = print(parse(std::make_shared<const text::Source>("twice", once), sink));
    EXPECT_EQ(once, twice);
    EXPECT_EQ(text::render(sink), "");
    ++files;
  }
  EXPECT_GE(files, 7U);
}

TEST_F(MdlCorpus, OverlaysAreNotTakenForMissions) {
  for (const auto& path : text::testing::golden_files(corpus(), ".ovl")) {
    EXPECT_FALSE(looks_like_mdl(text::testing::read_all(path))) << path;
  }
}

}  // namespace
}  // namespace mlab::mdl
