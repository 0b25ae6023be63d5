#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/lang/mdl/mdl.h"

// What is set in place of what a mission says.
namespace mlab::mdl {
namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;

class MdlSettings : public ::testing::Test {
 protected:
  std::shared_ptr<const mission::Mission> read(const std::string& text, const Pairs& settings) {
    LoadOptions options;
    options.seed = 5;
    options.files.is_file = [this](const std::string& path) { return files.contains(path); };
    options.files.read = [this](const std::string& path) -> text::Result<text::SourcePtr> {
      return std::make_shared<const text::Source>(path, files.at(path));
    };
    for (const auto& [name, value] : settings) {
      const auto source = std::make_shared<const text::Source>("--set", name + "=" + value);
      const auto size = static_cast<std::uint32_t>(name.size());
      options.settings.push_back({name,
                                  value,
                                  {source, {0, size}},
                                  {source, {size + 1, size + 1 + static_cast<std::uint32_t>(value.size())}}});
    }
    sink = text::Diagnostics();
    return check_mission(std::make_shared<const text::Source>("test.mdl", text), "", sink, options);
  }
  // The errors alone.
  std::string errors(const std::string& text, const Pairs& settings) {
    EXPECT_EQ(read(text, settings), nullptr);
    return text::render(sink);
  }

  std::map<std::string, std::string> files;
  text::Diagnostics sink;
};

constexpr const char* kQuit = "COMMAND LIST:\n0. QUIT\n";
constexpr const char* kField =
    "MISSION-AREA 400 400\nSET OBSTACLE-COVERAGE 5\nCREATE-OBSTACLES\nCOMMAND LIST:\n0. QUIT\n";

TEST_F(MdlSettings, AddAParameterToAllTypesOrToOne) {
  const std::string types = "NEW-ROBOT scout robot red (base_velocity = 1)\nNEW-ROBOT mule robot blue\n";
  const auto all = read(types + kQuit, {{"base_velocity", "2.5"}});
  ASSERT_NE(all, nullptr) << text::render(sink);
  for (const mission::RobotType& type : all->types) {
    EXPECT_EQ(type.parameters.back().key, "base_velocity");
    EXPECT_EQ(type.parameters.back().value, "2.5");
    const text::Place& at = type.parameters.back().value_place;
    EXPECT_EQ(at.source->text(at.span), "2.5");
    EXPECT_TRUE(type.parameters.back().is_from_outside);
  }
  const auto one = read(types + kQuit, {{"SCOUT:base_velocity", "2.5"}});
  ASSERT_NE(one, nullptr) << text::render(sink);
  EXPECT_EQ(one->types[1].parameters.size(), 2U);
  EXPECT_TRUE(one->types[2].parameters.empty());
}

TEST_F(MdlSettings, SayThatThereIsNoSuchType) {
  const std::string told =
      errors(std::string("NEW-ROBOT scout robot red\n") + kQuit, {{"mule:base_velocity", "2"}});
  EXPECT_NE(told.find("--set:1:1: error: unknown robot type `mule`"), std::string::npos) << told;
  EXPECT_NE(told.find("the mission has ROBOT and scout"), std::string::npos) << told;
}

TEST_F(MdlSettings, TakeTheNumbersThatSetGivesInAllOfTheMission) {
  const auto plain = read(kField, {});
  ASSERT_NE(plain, nullptr);
  const auto dense = read(kField, {{"obstacle-coverage", "10"}});
  ASSERT_NE(dense, nullptr) << text::render(sink);
  EXPECT_EQ(dense->options.obstacle_coverage, 10.0);
  EXPECT_GT(dense->overlay.obstacles.size(), plain->overlay.obstacles.size());

  const std::string slow = "SET CYCLE-DURATION 0.2\nCOMMAND LIST:\n0. SET CYCLE-DURATION 0.5\n1. QUIT\n";
  const auto set = read(slow, {{"CYCLE-DURATION", "0.05"}});
  ASSERT_NE(set, nullptr) << text::render(sink);
  EXPECT_EQ(set->options.cycle_duration, 0.05);
  EXPECT_EQ(std::get<mission::SetNumber>(set->steps[0].commands[0]).value, 0.05);
}

TEST_F(MdlSettings, RefuseNumbersThatAreNoneOrOutOfRangeOnce) {
  std::string told = errors(kField, {{"OBSTACLE-COVERAGE", "40"}});
  EXPECT_EQ(sink.error_count(), 1U) << told;
  EXPECT_NE(told.find("--set:1:19: error: OBSTACLE-COVERAGE goes from 0 to 30"), std::string::npos) << told;
  told = errors(kField, {{"OBSTACLE-COVERAGE", "much"}});
  EXPECT_EQ(sink.error_count(), 1U) << told;
  EXPECT_NE(told.find("takes a number, found `much`"), std::string::npos) << told;
}

TEST_F(MdlSettings, SayHowRobotsMoveInPlaceOfTheMission) {
  const std::string text = std::string("SET NAVIGATION PLANNED\nSET STATIONS ASSIGNED\n") + kQuit;
  const auto set = read(text, {{"navigation", "Reactive"}, {"STATIONS", "RANK"}, {"COHESION", "7"}});
  ASSERT_NE(set, nullptr) << text::render(sink);
  EXPECT_EQ(set->options.plans_ways, false);
  EXPECT_EQ(set->options.assigns_stations, false);
  EXPECT_EQ(set->options.cohesion, 7.0);
  const auto other = read(std::string("SET NAVIGATION REACTIVE\n") + kQuit, {{"NAVIGATION", "PLANNED"}});
  ASSERT_NE(other, nullptr) << text::render(sink);
  EXPECT_EQ(other->options.plans_ways, true);
  EXPECT_FALSE(other->options.assigns_stations);
  const std::string told = errors(text, {{"NAVIGATION", "1"}});
  EXPECT_EQ(sink.error_count(), 1U) << told;
  EXPECT_NE(told.find("--set:1:12: error: NAVIGATION takes PLANNED or REACTIVE, found `1`"),
            std::string::npos)
      << told;
}

TEST_F(MdlSettings, SetTheSeedOfObstacles) {
  const auto by_run = read(kField, {});
  EXPECT_TRUE(by_run->has_obstacles_by_seed);
  const auto fixed = read(kField, {{"SEED", "7"}});
  ASSERT_NE(fixed, nullptr) << text::render(sink);
  EXPECT_FALSE(fixed->has_obstacles_by_seed);
  const auto written = read(std::string("SET SEED 7\n") + kField, {});
  ASSERT_EQ(fixed->overlay.obstacles.size(), written->overlay.obstacles.size());
  EXPECT_EQ(fixed->overlay.obstacles[0].center, written->overlay.obstacles[0].center);
}

TEST_F(MdlSettings, PutAnotherOverlayInPlaceOfOne) {
  files = {{"a.odl", "MISSION-AREA 100 100\nCONTROL MEASURES:\n"},
           {"b.odl", "MISSION-AREA 200 200\nCONTROL MEASURES:\n"},
           {"c.odl", "CONTROL MEASURES:\n"}};
  const std::string one = std::string("OVERLAY a.odl\n") + kQuit;
  const auto other = read(one, {{"OVERLAY", "b.odl"}});
  ASSERT_NE(other, nullptr) << text::render(sink);
  EXPECT_EQ(other->overlay.mission_area().width, 200.0);

  const std::string two = std::string("OVERLAY a.odl\nOVERLAY c.odl\n") + kQuit;
  const auto named = read(two, {{"OVERLAY:a.odl", "b.odl"}});
  ASSERT_NE(named, nullptr) << text::render(sink);
  EXPECT_EQ(named->overlay.mission_area().width, 200.0);

  EXPECT_NE(errors(two, {{"OVERLAY", "b.odl"}}).find("the mission names 2 overlays"), std::string::npos);
  EXPECT_NE(errors(kQuit, {{"OVERLAY", "b.odl"}}).find("names no overlay"), std::string::npos);
  EXPECT_NE(errors(one, {{"OVERLAY:x.odl", "b.odl"}}).find("no overlay `x.odl`"), std::string::npos);
  const std::string missing = errors(one, {{"OVERLAY", "d.odl"}});
  EXPECT_NE(missing.find("--set:1:9: error: there is no overlay `d.odl`"), std::string::npos) << missing;
}

TEST_F(MdlSettings, PutAFormationInPlaceOfThoseOfTheCommands) {
  const std::string text =
      "UNIT <u> ROBOT ROBOT\nCOMMAND LIST:\n0. UNIT u START 5 5\n1. UNIT u MOVETO 60 60 FORMATION Column\n"
      "2. UNIT u MOVETO 90 90 No-Formation\n3. UNIT u SWEEPTO 5 90\n";
  const auto mission = read(text, {{"FORMATION", "Wedge"}});
  ASSERT_NE(mission, nullptr) << text::render(sink);
  const auto formation_of = [&](std::size_t step) {
    return std::get<mission::UnitCommand>(mission->steps[step].commands[0]).formation;
  };
  EXPECT_EQ(formation_of(1), percept::Formation::kWedge);
  EXPECT_EQ(formation_of(2), percept::Formation::kNone);
  EXPECT_EQ(formation_of(3), percept::Formation::kNone) << "it names none";
  EXPECT_NE(errors(text, {{"FORMATION", "Circle"}}).find("expected a formation (No-Formation, Line,"),
            std::string::npos);
  EXPECT_NE(errors(kField, {{"FORMATION", "Wedge"}}).find("no command of the mission names a formation"),
            std::string::npos);
}

TEST_F(MdlSettings, LetAWholeNumberOfRobotsFail) {
  const auto mission = read(kField, {{"FAILING-ROBOTS", "2"}, {"FAILURES-WITHIN", "30.5"}});
  ASSERT_NE(mission, nullptr) << text::render(sink);
  EXPECT_EQ(mission->options.failing_robots, 2.0);
  EXPECT_EQ(mission->options.failures_within, 30.5);
  EXPECT_NE(errors(kField, {{"FAILING-ROBOTS", "1.5"}}).find("takes a whole number, found `1.5`"),
            std::string::npos);
  EXPECT_NE(errors(kField, {{"FAILING-ROBOTS", "-1"}}).find("goes from 0 to 65535"), std::string::npos);
}

TEST_F(MdlSettings, CountOnceAndTheLastTime) {
  const auto mission = read(kField, {{"OBSTACLE-COVERAGE", "10"}, {"OBSTACLE-COVERAGE", "2"}});
  ASSERT_NE(mission, nullptr) << text::render(sink);
  EXPECT_EQ(mission->options.obstacle_coverage, 2.0);
}

}  // namespace
}  // namespace mlab::mdl
