#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/mdl/mdl.h"

namespace mlab::mdl {
namespace {

using mission::UnitCommand;

const std::string kMissions = base::source_folder() + "/src/mlab/lang/mdl/testdata";
constexpr const char* kQuit = "COMMAND LIST:\n0. QUIT\n";

std::shared_ptr<const mission::Mission> checked(const std::string& text, const LoadOptions& options = {}) {
  text::Diagnostics sink;
  auto mission =
      check_mission(std::make_shared<const text::Source>("test.mdl", text), kMissions, sink, options);
  EXPECT_NE(mission, nullptr) << text::render(sink);
  return mission ? mission : std::make_shared<const mission::Mission>();
}

// The one command of the one step that follows `START`.
UnitCommand command(const std::string& action) {
  const auto mission = checked(
      "OVERLAY map.odl\nUNIT <u> (<front> ROBOT ROBOT) (<rear> ROBOT)\nCOMMAND LIST:\n0. UNIT u START AA1 0 "
      "20\n1. UNIT u " +
      action);
  return mission->steps.size() == 2 ? std::get<UnitCommand>(mission->steps[1].commands[0]) : UnitCommand{};
}

std::vector<std::uint32_t> ids(const mission::Unit& unit) {
  std::vector<std::uint32_t> out;
  for (const base::RobotId id : unit.members) out.push_back(id.value);
  return out;
}

TEST(MdlUnits, HoldAllRobotsBelowThemInFileOrder) {
  const auto mission =
      checked(std::string("UNIT <g> (<a> ROBOT ROBOT) (ROBOT) (<b> (<c> ROBOT) (ROBOT))\n") + kQuit);
  ASSERT_EQ(mission->units.size(), 6U);
  const auto& units = mission->units;
  EXPECT_EQ(units[0].name, "g");
  EXPECT_EQ(ids(units[0]), (std::vector<std::uint32_t>{1, 2, 3, 4, 5}));
  EXPECT_EQ(units[0].parts, (std::vector<std::uint32_t>{1, 2, 3}));
  EXPECT_EQ(ids(units[1]), (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(units[2].name, "");
  EXPECT_EQ(ids(units[2]), (std::vector<std::uint32_t>{3}));
  EXPECT_EQ(units[3].name, "b");
  EXPECT_EQ(ids(units[3]), (std::vector<std::uint32_t>{4, 5}));
  EXPECT_EQ(units[3].parts, (std::vector<std::uint32_t>{4, 5}));
  EXPECT_EQ(ids(units[5]), (std::vector<std::uint32_t>{5}));
}

TEST(MdlUnits, NumberRobotsFromOneAndFollowTheWishesOfTheirTypes) {
  const auto mission = checked(
      std::string(
          "NEW-ROBOT seven robot (desired_robot_id = 7)\nNEW-ROBOT zero robot (desired_robot_id = 0)\n"
          "UNIT <a> ROBOT seven\nUNIT <b> zero ROBOT\n") +
      kQuit);
  EXPECT_EQ(ids(mission->units[0]), (std::vector<std::uint32_t>{1, 7}));
  EXPECT_EQ(ids(mission->units[1]), (std::vector<std::uint32_t>{8, 9}));
  ASSERT_EQ(mission->robots.size(), 4U);
  EXPECT_EQ(mission->robots[1].id.value, 7U);
}

TEST(MdlUnits, ASecondUnitOfTheSameNameIsTheOneThatCommandsMean) {
  const auto mission =
      checked("UNIT <a> ROBOT\nUNIT <a> ROBOT ROBOT\nCOMMAND LIST:\n0. UNIT a START 5 5 0 5\n");
  EXPECT_EQ(std::get<UnitCommand>(mission->steps[0].commands[0]).unit, 1U);
}

TEST(MdlRobots, KeepTheTextOfTheirParameters) {
  const auto mission = checked(
      std::string("NEW-ROBOT a \"./forager\" green \"host\" (x = 0.3, y = on, z = HUMMER, w = \"a b\")\n") +
      kQuit);
  const mission::RobotType& type = mission->types.at(1);
  EXPECT_EQ(type.program, "./forager");
  EXPECT_EQ(type.color, "green");
  EXPECT_EQ(type.host, "host");
  EXPECT_EQ(type.parameters[0].value, "0.3");
  EXPECT_EQ(type.parameters[1].value, "1");
  EXPECT_EQ(type.parameters[2].value, "HUMMER");
  EXPECT_EQ(type.parameters[3].value, "a b");
  EXPECT_EQ(mission->source->text(type.parameters[2].place.span), "z");
  EXPECT_EQ(mission->source->text(type.parameters[2].value_place.span), "HUMMER");
  EXPECT_EQ(mission->types[0].name, "ROBOT");
}

TEST(MdlRobots, SetAPointByTwoNumbers) {
  const std::string text =
      std::string("NEW-ROBOT a \"a.cdl\" (home = 310 -20.5, out = PP-Gate, x = 3)\n") + kQuit;
  const auto mission = checked(text);
  const mission::RobotType& type = mission->types.at(1);
  EXPECT_EQ(type.parameters[0].value, "310 -20.5");
  EXPECT_EQ(type.parameters[1].value, "PP-Gate");
  EXPECT_EQ(type.parameters[2].value, "3");
}

TEST(MdlCommands, TakePlacesByNameAndByCoordinates) {
  EXPECT_EQ(command("MOVETO PP-Charlie").goal, (geom::Point{300, 200}));
  EXPECT_EQ(command("MOVETO pp-CHARLIE").goal, (geom::Point{300, 200}));
  EXPECT_EQ(command("OCCUPY AA1").goal, (geom::Point{100, 100}));
  const UnitCommand by_numbers = command("SWEEPTO 310 205");
  EXPECT_EQ(by_numbers.goal, (geom::Point{310, 205}));
  EXPECT_EQ(by_numbers.place_name, "310 205");
  EXPECT_EQ(by_numbers.task, mission::Task::kSweepTo);
  EXPECT_EQ(command("TELEOPERATE 10 20").task, mission::Task::kTeleoperate);
}

// As the maps of `mlab world` call their places.
TEST(MdlCommands, GoToPlacesThatAreCalledAsCommandsAre) {
  const auto mission = checked(
      "SP Start 10 20\nSP Goal 30 40\nSP Stop 50 60\nUNIT <u> ROBOT\nCOMMAND LIST:\n0. UNIT u START Start\n"
      "1. UNIT u PATROL Goal Start\n   Stop UNTIL TIMEOUT 9 AND UNIT u VISIT Start Start\n2. UNIT u STOP\n");
  ASSERT_NE(mission, nullptr);
  const auto& patrol = std::get<mission::UnitCommand>(mission->steps[1].commands[0]);
  EXPECT_EQ(patrol.route, (std::vector<geom::Point>{{30, 40}, {10, 20}, {50, 60}}));
  EXPECT_EQ(std::get<mission::UnitCommand>(mission->steps[1].commands[1]).route.size(), 2U);
}

TEST(MdlCommands, RallyAtAPlaceWithARadius) {
  const UnitCommand at_name = command("RALLY PP-Charlie SPEED 2");
  EXPECT_EQ(at_name.task, mission::Task::kRally);
  EXPECT_EQ(at_name.goal, (geom::Point{300, 200}));
  EXPECT_EQ(at_name.radius, 5.0) << "half the diameter";
  EXPECT_EQ(command("RALLY 310 205").radius, 25.0);
  EXPECT_EQ(command("MOVETO PP-Charlie").radius, 0.0) << "only RALLY has one";
}

TEST(MdlCommands, RallyAtAnOutlineWithinItsFarthestCornerAndAtALineAroundItsMiddle) {
  const auto mission = checked(
      "OVERLAY rally.odl\nUNIT <u> ROBOT\nCOMMAND LIST:\n0. UNIT u START 1 2\n1. UNIT u RALLY Meadow\n"
      "2. UNIT u RALLY Fence\n3. UNIT u RALLY Dot\n");
  ASSERT_EQ(mission->steps.size(), 4U);
  const auto radius = [&](std::size_t step) {
    return std::get<UnitCommand>(mission->steps[step].commands[0]).radius;
  };
  EXPECT_DOUBLE_EQ(radius(1), 50.0) << "of 60 by 80 m";
  EXPECT_EQ(radius(2), 25.0);
  EXPECT_EQ(radius(3), 25.0) << "its diameter is 0";
}

TEST(MdlCommands, TakeCoordinatesInTheSystemOfTheOverlay) {
  const auto mission =
      checked("OVERLAY origin.odl\nUNIT <u> ROBOT\nOBSTACLE 500 500 3\nCOMMAND LIST:\n0. UNIT u START 1 2\n");
  EXPECT_EQ(std::get<UnitCommand>(mission->steps[0].commands[0]).goal, (geom::Point{11, 22}));
  EXPECT_EQ(mission->overlay.obstacles.at(0).center, (geom::Point{510, 520}));
}

TEST(MdlCommands, StartRobotsOneStepApart) {
  const auto mission = checked("UNIT <u> ROBOT ROBOT\nCOMMAND LIST:\n0. UNIT u START 310 205 -5 2.5\n");
  const auto& start = std::get<UnitCommand>(mission->steps[0].commands[0]);
  EXPECT_EQ(start.start_step, (geom::Offset{-5, 2.5}));
  EXPECT_EQ(start.goal, (geom::Point{310, 205}));
}

TEST(MdlCommands, FollowAllPointsOfALine) {
  const UnitCommand follow = command("FOLLOW AXIS-Gamma");
  EXPECT_EQ(follow.route, (std::vector<geom::Point>{{300, 200}, {400, 300}, {500, 300}}));
  EXPECT_EQ(follow.goal, (geom::Point{500, 300}));
}

TEST(MdlClauses, AreAllRead) {
  const UnitCommand move = command(
      "MOVETO 500 300 WEDGE-RIGHT TECHNIQUE = BOUNDING-OVERWATCH SPEED 2.5 HEADING 90 ON-COMPLETION MSG \"we "
      "are there\" "
      "PHASE-LINE PL-Dark 12:30 ACK \"at the line\" WAIT PHASE-LINE Charlie");
  EXPECT_EQ(move.formation, percept::Formation::kWedgeRight);
  EXPECT_TRUE(move.has_formation);
  EXPECT_EQ(move.technique, mission::Technique::kBoundingOverwatch);
  EXPECT_EQ(move.speed, 2.5);
  EXPECT_NEAR(*move.heading, std::numbers::pi / 2.0, 1e-12);
  EXPECT_EQ(move.on_completion, "we are there");
  ASSERT_EQ(move.phase_lines.size(), 2U);
  EXPECT_EQ(move.phase_lines[0].points.size(), 2U);
  EXPECT_EQ(move.phase_lines[0].acknowledge, "at the line");
  EXPECT_TRUE(move.phase_lines[0].waits);
  EXPECT_EQ(move.phase_lines[0].not_before->seconds, 45000.0);
  EXPECT_EQ(move.phase_lines[1].radius, 5.0);  // half of a passage point's diameter
  EXPECT_FALSE(command("MOVETO 500 300").has_formation);
  EXPECT_TRUE(command("MOVETO 500 300 NO-FORMATION").has_formation);
}

TEST(MdlClauses, OfAKindOverwriteEachOther) {
  const UnitCommand move = command("MOVETO 500 300 LINE WEDGE SPEED 3 SPEED = 4");
  EXPECT_EQ(move.formation, percept::Formation::kWedge);
  EXPECT_EQ(move.speed, 4.0);
}

TEST(MdlOptions, AreSetInFileOrder) {
  const auto mission = checked(
      std::string(
          "SET SEED 945816565\nSET OBSTACLE-COVERAGE 2\nSET SHOW-TRAILS\nSET USE-MILITARY-STYLE off\nSET "
          "SCALE-ROBOTS NO\n"
          "SET ROBOT-LENGTH 90\nSET CYCLE-DURATION 0.05\nSET MIN-OBSTACLE-RADIUS 5\nSET ZOOM-FACTOR 50\nSET "
          "SHOW-COLORMAP\n"
          "SET DEBUG-ROBOTS\nSET DEBUG-SIMULATOR TRUE\nSET DEBUG-SCHEDULER Yes\nSET SHOW-MOVEMENT-VECTORS\n"
          "SET SHOW-REPELLING-OBSTACLES\n") +
      kQuit);
  const mission::Options& o = mission->options;
  EXPECT_EQ(o.seed, 945816576.0);
  EXPECT_EQ(o.obstacle_coverage, 2.0);
  EXPECT_EQ(o.robot_length, 90.0);
  EXPECT_EQ(o.cycle_duration, 0.05);
  EXPECT_EQ(o.min_obstacle_radius, 5.0);
  EXPECT_EQ(o.zoom_percent, 50.0);
  EXPECT_TRUE(o.show_trails && o.show_colormap && o.debug_robots && o.debug_simulator && o.debug_scheduler &&
              o.show_movement_vectors && o.highlight_repelling_obstacles);
  EXPECT_FALSE(o.use_military_style || o.scale_robots);
}

TEST(MdlOptions, GoBackToWhatFitsWhenTheMissionAreaChanges) {
  const auto mission = checked(
      std::string(
          "SET MIN-OBSTACLE-RADIUS 5\nSET ZOOM-FACTOR 50\nMISSION-AREA 30 20\nSET MAX-OBSTACLE-RADIUS 3\n") +
      kQuit);
  EXPECT_EQ(mission->options.min_obstacle_radius, 2.0);
  EXPECT_EQ(mission->options.max_obstacle_radius, 3.0);
  EXPECT_EQ(mission->options.zoom_percent, 100.0);
  EXPECT_EQ(checked(std::string("MISSION-AREA 30 20\n") + kQuit)->options.max_obstacle_radius, 4.0);
  EXPECT_EQ(checked(std::string("SET MIN-OBSTACLE-RADIUS 5\nOVERLAY map.odl\n") + kQuit)
                ->options.min_obstacle_radius,
            2.0);
  EXPECT_EQ(checked(std::string("SET MIN-OBSTACLE-RADIUS 5\nOVERLAY empty.odl\n") + kQuit)
                ->options.min_obstacle_radius,
            5.0);
}

TEST(MdlOptions, MaySomeOfThemBeSetInSteps) {
  const auto mission = checked(
      "SET SHOW-TRAILS\nCOMMAND LIST:\n0. SET CYCLE-DURATION 0.5 AND SET SHOW-TRAILS OFF AND PRINT "
      "ROBOT-INFO\n1. QUIT\n");
  const auto& commands = mission->steps[0].commands;
  ASSERT_EQ(commands.size(), 3U);
  EXPECT_EQ(std::get<mission::SetNumber>(commands[0]).value, 0.5);
  EXPECT_FALSE(std::get<mission::SetBoolean>(commands[1]).value);
  EXPECT_TRUE(std::get<mission::Print>(commands[2]).robot_info);
  EXPECT_TRUE(mission->options.show_trails);
}

TEST(MdlPreamble, TheLastAreaAndScenarioOfMissionAndOverlaysWin) {
  const auto overlay_last =
      checked(std::string("SCENARIO mine\nMISSION-AREA 50 50\nOVERLAY map.odl\n") + kQuit);
  EXPECT_EQ(overlay_last->scenario, "test");
  EXPECT_EQ(overlay_last->overlay.mission_area().width, 800.0);
  const auto mission_last =
      checked(std::string("OVERLAY map.odl\nSCENARIO mine\nMISSION-AREA 50 50\n") + kQuit);
  EXPECT_EQ(mission_last->scenario, "mine");
  EXPECT_EQ(mission_last->overlay.mission_area().width, 50.0);
  EXPECT_EQ(
      checked(std::string("MISSION-AREA 50 50\nOVERLAY empty.odl\n") + kQuit)->overlay.mission_area().width,
      50.0);
}

TEST(MdlPreamble, OverlaysAccumulate) {
  EXPECT_EQ(
      checked(std::string("OVERLAY map.odl\nOVERLAY empty.odl\nSP x 1 1\n") + kQuit)->overlay.measures.size(),
      8U);
}

TEST(MdlPreamble, KeepsWhatIsToBePrinted) {
  const auto mission = checked(std::string("PRINT CONSOLE-DB\nPRINT ROBOT-INFO\n") + kQuit);
  ASSERT_EQ(mission->prints.size(), 2U);
  EXPECT_TRUE(mission->prints[1].robot_info);
}

TEST(MdlPreamble, LoadsTheBackgroundPicture) {
  const auto mission = checked(std::string("LOAD-MAP \"small.mapinfo\"\n") + kQuit);
  ASSERT_TRUE(mission->overlay.map_picture.has_value());
  EXPECT_EQ(mission->overlay.map_picture->width, 100.0);
}

TEST(MdlObstacles, AreCreatedFromTheMissionsSeedOrElseFromTheRuns) {
  const std::string create = std::string("CREATE-OBSTACLES\n") + kQuit;
  const auto count_and_place = [&](const std::string& text, std::uint64_t seed) {
    const auto mission = checked(text, LoadOptions{seed, {}});
    return std::pair(mission->overlay.obstacles.size(), mission->overlay.obstacles.front().center.x);
  };
  EXPECT_EQ(count_and_place(create, 5), count_and_place("SET SEED 5\n" + create, 77));
  EXPECT_NE(count_and_place(create, 5), count_and_place(create, 6));
}

TEST(MdlObstacles, AreReplacedByCreatedOnesButThoseBelowStay) {
  const auto mission = checked(std::string("OVERLAY map.odl\nCREATE-OBSTACLES\nOBSTACLE 1 1 0.5\n") + kQuit);
  EXPECT_EQ(mission->overlay.obstacles.back().radius, 0.5);
  EXPECT_GT(mission->overlay.obstacles.size(), 2U);
  for (const overlay::ObstacleDisc& disc : mission->overlay.obstacles)
    EXPECT_NE(disc.center, (geom::Point{600, 500}));
}

TEST(MdlObstacles, AreCreatedWithTheOptionsThatHoldAtThatPlace) {
  const auto mission =
      checked(std::string("SET OBSTACLE-COVERAGE 0\nCREATE-OBSTACLES\nSET OBSTACLE-COVERAGE 30\n") + kQuit);
  EXPECT_TRUE(mission->overlay.obstacles.empty());
}

TEST(MdlLoad, LooksForOverlaysBesideTheMissionThenInTheGivenFolders) {
  text::Diagnostics sink;
  EXPECT_NE(load_mission(kMissions + "/good.mdl", sink), nullptr) << text::render(sink);
  const auto source = std::make_shared<const text::Source>("x.mdl", std::string("OVERLAY map.odl\n") + kQuit);
  EXPECT_EQ(check_mission(source, "/nowhere", sink), nullptr);
  text::Diagnostics with_folder;
  EXPECT_NE(check_mission(source, "/nowhere", with_folder, LoadOptions{0, {kMissions}}), nullptr);
}

// Texts that stand nowhere on the disk.
text::Files files_of(const std::map<std::string, std::string>& texts) {
  return {[&texts](const std::string& path) { return texts.contains(path); },
          [&texts](const std::string& path) -> text::Result<text::SourcePtr> {
            return std::make_shared<const text::Source>(path, texts.at(path));
          },
          {}};
}

TEST(MdlLoad, ReadsThroughTheFilesThatItIsGiven) {
  const std::map<std::string, std::string> texts = {
      {"/p/m.mdl", std::string("OVERLAY sub/o.odl\nLOAD-MAP \"m.info\"\n") + kQuit},
      {"/p/sub/o.odl", "LOAD-MAP i.info\nCONTROL MEASURES:\nPP a 1 2\nWAYPOINT-FILE w.wpt\n"},
      {"/p/sub/i.info", "i.png\n0 0 10 10\n"},
      {"/p/sub/i.png", ""},
      {"/p/sub/w.wpt", "PP b 3 4\n"},
      {"/p/m.info", "sub/i.png\n1 1 20 20\n"}};
  text::Diagnostics sink;
  LoadOptions options;
  options.files = files_of(texts);
  const auto mission = load_mission("/p/m.mdl", sink, options);
  ASSERT_NE(mission, nullptr) << text::render(sink);
  EXPECT_EQ(text::render(sink), "");
  EXPECT_EQ(mission->overlay.measures.size(), 2U);
  EXPECT_EQ(mission->overlay.map_picture->width, 20.0);
}

TEST(MdlLoad, GivesTheMapWhateverIsWrongWithTheRest) {
  const std::string text =
      "OVERLAY map.odl\nUNIT <u> GHOST\nOBSTACLE 1 1 0.5\nSP x 3 4\nCOMMAND LIST:\n1. UNIT u MOVETO Nowhere";
  text::Diagnostics sink;
  const overlay::Overlay map =
      check_map(std::make_shared<const text::Source>("test.mdl", text), kMissions, sink);
  EXPECT_EQ(map.obstacles.back().radius, 0.5);
  EXPECT_EQ(map.measures.back().name, "x");
  EXPECT_GT(map.measures.size(), 1U);
}

TEST(MdlLoad, SaysWhyAFileCannotBeRead) {
  text::Diagnostics sink;
  EXPECT_EQ(load_mission("/nowhere/x.mdl", sink), nullptr);
  ASSERT_EQ(sink.error_count(), 1U);
  EXPECT_EQ(sink.items()[0].kind, "cannot-read");
}

TEST(MdlDetect, TellsMissionsFromOtherTexts) {
  EXPECT_TRUE(looks_like_mdl("-- a comment\nMISSION NAME x"));
  EXPECT_TRUE(looks_like_mdl("SET SHOW-TRAILS\nCOMMAND LIST:"));
  EXPECT_TRUE(looks_like_mdl("OVERLAY democ.odl"));
  EXPECT_TRUE(looks_like_mdl("unit <a> ROBOT"));
  EXPECT_FALSE(looks_like_mdl("SCENARIO x\nCONTROL MEASURES:\nPP a 1 1"));
  EXPECT_FALSE(looks_like_mdl("procedure Vector MOVE_TO_GOAL with\nbody\npend"));
  EXPECT_FALSE(looks_like_mdl("int main() { return unit; }"));
  EXPECT_FALSE(looks_like_mdl(""));
}

TEST(MdlFailsafes, AreAtTheirRankWithTheFenceOfTheOverlay) {
  const auto mission = checked(std::string("OVERLAY farm.odl\nfailsafe outside Field reverse inside\n"
                                           "FAILSAFE LINK-LOST AFTER 2.5 RETURN FAILSAFE STUCK STOP\n") +
                               kQuit);
  ASSERT_EQ(mission->failsafes.size(), 3U);
  const auto& rows = mission->failsafes;
  EXPECT_EQ(rows[0].action, mission::FailsafeAction::kReverseInside);
  EXPECT_EQ(rows[0].fence.size(), 4U);
  EXPECT_EQ(mission::words_of(rows[0]), "FAILSAFE OUTSIDE Field REVERSE INSIDE");
  EXPECT_EQ(mission::words_of(rows[1]), "FAILSAFE LINK-LOST AFTER 2.5 RETURN");
  EXPECT_EQ(mission::words_of(rows[2]), "FAILSAFE STUCK AFTER 30 STOP");
  EXPECT_EQ(rows[2].place.span.begin, mission->source->text().rfind("FAILSAFE"));
}

TEST(MdlFailsafes, OfBatteriesSayBelowWhichShare) {
  const auto mission = checked(std::string("NEW-ROBOT scout robot green \"veh-1\"\n"
                                           "failsafe battery below 12.5% after 2 hold\n"
                                           "FAILSAFE BATTERY BELOW 30 % RETURN\nUNIT <v> scout\n") +
                               kQuit);
  ASSERT_EQ(mission->failsafes.size(), 2U);
  EXPECT_EQ(mission->failsafes[0].share, 0.125);
  EXPECT_EQ(mission->failsafes[0].seconds, 2.0);
  EXPECT_EQ(mission::words_of(mission->failsafes[0]), "FAILSAFE BATTERY BELOW 12.5% AFTER 2 HOLD");
  EXPECT_EQ(mission::words_of(mission->failsafes[1]), "FAILSAFE BATTERY BELOW 30% AFTER 5 RETURN");
}

TEST(MdlFailsafes, AreOfTheTypesThatTheyName) {
  const auto mission = checked(std::string("NEW-ROBOT scout robot\nFAILSAFE FOR Scout STUCK HOLD\n"
                                           "FAILSAFE FOR ROBOT STUCK HOLD\nFAILSAFE STUCK HOLD\n") +
                               kQuit);
  ASSERT_EQ(mission->failsafes.size(), 3U);
  EXPECT_TRUE(mission->failsafes[0].is_of("scout"));
  EXPECT_FALSE(mission->failsafes[0].is_of("ROBOT"));
  EXPECT_TRUE(mission->failsafes[1].is_of("ROBOT"));
  EXPECT_TRUE(mission->failsafes[2].is_of("scout"));
  EXPECT_EQ(mission::words_of(mission->failsafes[0]), "FAILSAFE FOR Scout STUCK AFTER 30 HOLD");
}

}  // namespace
}  // namespace mlab::mdl
