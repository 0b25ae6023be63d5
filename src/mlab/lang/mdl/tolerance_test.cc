#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/mdl/mdl.h"

namespace mlab::mdl {
namespace {

std::shared_ptr<const mission::Mission> check(const std::string& text, const std::string& folder = "") {
  text::Diagnostics sink;
  auto mission = check_mission(std::make_shared<const text::Source>("test.mdl", text), folder, sink);
  EXPECT_EQ(sink.error_count() + sink.warning_count(), 0U) << text::render(sink);
  return mission;
}

const std::string kTestdata = base::source_folder() + "/src/mlab/lang/mdl/testdata";

TEST(MdlTolerance, StartPointsMayStandInMissions) {
  const auto mission = check(
      "OVERLAY origin.odl\nSP StartPlace* 3.4 4.26\nUNIT <u> ROBOT\nCOMMAND LIST:\n0. UNIT u START "
      "SP-StartPlace\n",
      kTestdata);
  ASSERT_NE(mission, nullptr);
  const auto& start = std::get<mission::UnitCommand>(mission->steps[0].commands[0]);
  EXPECT_DOUBLE_EQ(start.goal.x, 13.4);  // ORIGIN is added
  EXPECT_DOUBLE_EQ(start.goal.y, 24.26);
  EXPECT_FALSE(mission->overlay.measures.back().shows_label);
}

TEST(MdlTolerance, ReservedWordsMayBeNames) {
  const auto mission = check(
      "MISSION NAME Overlay\nSCENARIO Line\nSP Wedge 1 1\nSP Red 2 2\nUNIT <and> ROBOT\nCOMMAND LIST:\n"
      "0. UNIT and START Wedge\n1. UNIT and MOVETO Red Column\n");
  ASSERT_NE(mission, nullptr);
  EXPECT_EQ(mission->name, "Overlay");
  EXPECT_EQ(std::get<mission::UnitCommand>(mission->steps[1].commands[0]).formation,
            percept::Formation::kColumn);
}

TEST(MdlTolerance, RedAndYellowAreStillColoursAndHosts) {
  const auto mission =
      check("NEW-ROBOT a \"robot\" red yellow\nUNIT <u> a\nCOMMAND LIST:\n0. UNIT u START 1 1\n");
  ASSERT_NE(mission, nullptr);
  EXPECT_EQ(mission->types[1].color, "red");
  EXPECT_EQ(mission->types[1].host, "yellow");
}

TEST(MdlTolerance, OtherReservedWordsAfterAProgramBeginTheNextStatement) {
  const auto mission = check(
      "NEW-ROBOT a robot SCENARIO x UNIT <u> a ROBOT SET SHOW-TRAILS COMMAND LIST: 0. UNIT u START 1 1 0 "
      "5\n");
  ASSERT_NE(mission, nullptr);
  EXPECT_EQ(mission->scenario, "x");
  EXPECT_EQ(mission->types[1].color, "blue");
  EXPECT_EQ(mission->robots.size(), 2U);
}

TEST(MdlTolerance, ParametersMayHaveTheNamesOfReservedWords) {
  const auto mission = check(
      "NEW-ROBOT a \"x\" (\"timeout\" = 10, TIMEOUT = 5, seed = 3, \"speed\" = on)\nCOMMAND LIST:\n0. "
      "QUIT\n");
  ASSERT_NE(mission, nullptr);
  const auto& parameters = mission->types[1].parameters;
  EXPECT_EQ(parameters[0].key, "timeout");
  EXPECT_EQ(parameters[1].key, "timeout");
  EXPECT_EQ(parameters[2].key, "seed");
  EXPECT_EQ(parameters[3].value, "1");
}

// The report of 1995, Figures 19 and 20: the note is a comment, and a `)` closes the parameters.
TEST(MdlTolerance, TheReportsRobotLaboratoryIsUnderstood) {
  const auto mission = check(R"(MISSION NAME "Single Denning MRV2 Robot Simulation"
OVERLAY "robot_lab.odl"
SP StartPlace 3.4 4.26
                            -- Note: x means EAST, y means NORTH
NEW-ROBOT stimpy-the-robot "robot"
                                       (robot_type= "SIMULATION",
tty_num= 0,
"timeout"= 10,
echo_tty = 0,
move_to_goal_success_radius = 0.3,
navigation_success_radius = 0.3,
avoid_obstacle_sphere = 1.25,
navigation_move_to_goal_gain = 1.0,
navigation_avoid_obstacle_gain = 0.7,
lurch_mode = 1,
base_velocity = 0.1,
max_velocity = 0.1
)
UNIT <unit-stimpy> stimpy-the-robot
COMMAND LIST:
 0. UNIT unit-stimpy START StartPlace 0 20
 1. UNIT unit-stimpy MOVETO DoorWay
 2. UNIT unit-stimpy MOVETO Middle
 3. UNIT unit-stimpy MOVETO StartPlace
 4. UNIT unit-stimpy OCCUPY StartPlace
 5. UNIT unit-stimpy STOP
)",
                             kTestdata);
  ASSERT_NE(mission, nullptr);
  EXPECT_EQ(mission->types[1].parameters.size(), 12U);
  EXPECT_EQ(mission->types[1].parameters[4].value, "0.3");
  EXPECT_EQ(mission->overlay.mission_area().width, 1000.0);
  EXPECT_EQ(std::get<mission::UnitCommand>(mission->steps[1].commands[0]).goal, (geom::Point{9.0, 2.4}));
}

// Figure 12, word for word.
TEST(MdlTolerance, TheReportsDemoCIsUnderstood) {
  const auto mission = check(R"(MISSION NAME "Demo C simulation"
SCENARIO "Demo-C"
OVERLAY democ.odl
UNIT <scouts> (<scouts-1> ROBOT ROBOT) (<scouts-2> ROBOT ROBOT)
COMMAND LIST:
  0. UNIT scouts START AA-AA1 0 20
  1. UNIT scouts OCCUPY AA-AA1 FORMATION Column
  2. UNIT scouts MOVETO ATK-AP1 FORMATION Column
  3. UNIT scouts OCCUPY ATK-AP1 FORMATION Diamond
  4. UNIT scouts MOVETO PP-Charlie FORMATION Column
  5. UNIT scouts MOVETO PP-Delta1 FORMATION Column
  6. UNIT scouts MOVETO AXIS-Gamma1 FORMATION Diamond
  7. UNIT scouts-1 MOVETO ATK-BP1 AND
     UNIT scouts-2 MOVETO ATK-BP2
  8. UNIT scouts-1 OCCUPY ATK-BP1 AND
     UNIT scouts-2 OCCUPY ATK-BP2
  9. UNIT scouts MOVETO OBJ-Tango FORMATION Wedge
 10. UNIT scouts OCCUPY OBJ-Tango FORMATION Diamond
 11. UNIT scouts STOP
)",
                             kTestdata);
  ASSERT_NE(mission, nullptr);
  EXPECT_EQ(mission->steps.size(), 12U);
  EXPECT_EQ(mission->robots.size(), 4U);
  EXPECT_EQ(mission->steps[7].commands.size(), 2U);
}

TEST(MdlTolerance, AnythingMayStandOnOneLineOrOnMany) {
  const auto mission = check(
      "MISSION NAME\nx UNIT\n<\nu\n>\nROBOT COMMAND LIST: 0. UNIT u\nSTART\n1\n1 5. UNIT u STOP 5x. QUIT");
  ASSERT_NE(mission, nullptr);
  ASSERT_EQ(mission->steps.size(), 3U);
  EXPECT_EQ(mission->steps[2].label, "5x");
}

TEST(MdlTolerance, RobotsInQuotesAndInAnyCaseAreTheStandardRobot) {
  const auto mission =
      check("NEW-ROBOT Mine robot\nUNIT <u> \"ROBOT\" robot MINE\nCOMMAND LIST:\n0. UNIT u START 1 1 5 0\n");
  ASSERT_NE(mission, nullptr);
  EXPECT_EQ(mission->robots[0].type, 0U);
  EXPECT_EQ(mission->robots[1].type, 0U);
  EXPECT_EQ(mission->robots[2].type, 1U);
  EXPECT_EQ(mission->types[1].program, "robot");
}

}  // namespace
}  // namespace mlab::mdl
