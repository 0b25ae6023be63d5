#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "mlab/lang/mdl/mdl.h"

namespace mlab::mdl {
namespace {

class MdlTyped : public ::testing::Test {
 protected:
  Immediate read(const std::string& line) {
    text::Diagnostics sink;
    auto typed = parse_immediate(line, *mission_, sink, LoadOptions{9, {}});
    EXPECT_TRUE(typed.has_value()) << text::render(sink);
    return typed.value_or(Immediate{});
  }

  std::shared_ptr<const mission::Mission> mission_ = [] {
    text::Diagnostics sink;
    const std::string text =
        "SP Home 10 10\nUNIT <a> ROBOT ROBOT\nOBSTACLE 50 50 5\nCOMMAND LIST:\n0. UNIT a START Home 0 5\n";
    return check_mission(std::make_shared<const text::Source>("test.mdl", text), "", sink);
  }();
};

TEST_F(MdlTyped, SendsUnitsOfTheMission) {
  const Immediate typed = read("UNIT a MOVETO Home Column SPEED 2");
  ASSERT_EQ(typed.commands.size(), 1U);
  EXPECT_EQ(std::get<mission::UnitCommand>(typed.commands[0]).unit, 0U);
  EXPECT_EQ(std::get<mission::UnitCommand>(typed.commands[0]).speed, 2.0);
  EXPECT_EQ(typed.edited, nullptr);
  EXPECT_FALSE(typed.changes_obstacles);
}

TEST_F(MdlTyped, TakesThePrefixAndSeveralCommands) {
  const Immediate typed =
      read("immediate command: UNIT a STOP AND PRINT ROBOT-INFO AND SET SHOW-TRAILS AND QUIT");
  ASSERT_EQ(typed.commands.size(), 4U);
  EXPECT_TRUE(std::holds_alternative<mission::Quit>(typed.commands[3]));
  EXPECT_EQ(typed.edited, nullptr);
}

TEST_F(MdlTyped, DefinesUnitsThatTheSameLineMayUse) {
  const Immediate typed = read("UNIT <b> (<c> ROBOT) (ROBOT) AND UNIT c START 1 2");
  ASSERT_NE(typed.edited, nullptr);
  ASSERT_EQ(typed.edited->units.size(), 4U);
  EXPECT_EQ(typed.edited->robots.size(), 4U);
  EXPECT_EQ(typed.edited->robots.back().id.value, 4U);
  EXPECT_EQ(std::get<mission::UnitCommand>(typed.commands.at(0)).unit, 2U);
  EXPECT_EQ(mission_->units.size(), 1U);
}

TEST_F(MdlTyped, PlacesObstacles) {
  const Immediate typed = read("OBSTACLE 5 6 1");
  ASSERT_NE(typed.edited, nullptr);
  EXPECT_TRUE(typed.changes_obstacles);
  EXPECT_EQ(typed.edited->overlay.obstacles.size(), 2U);
  EXPECT_TRUE(typed.commands.empty());
}

TEST_F(MdlTyped, CreatesObstaclesWithTheOptionsOfTheLine) {
  const Immediate typed = read("SET OBSTACLE-COVERAGE 0 AND CREATE-OBSTACLES");
  ASSERT_NE(typed.edited, nullptr);
  EXPECT_TRUE(typed.edited->overlay.obstacles.empty());
  EXPECT_EQ(typed.edited->options.obstacle_coverage, 0.0);
  EXPECT_FALSE(read("CREATE-OBSTACLES").edited->overlay.obstacles.empty());
}

}  // namespace
}  // namespace mlab::mdl
