// Places and ways at which robots that plan their ways could be trapped, and crowds in which they could
// touch.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "begun_run.h"
#include "mlab/lang/mdl/mdl.h"

namespace mlab {
namespace {

class Trapped : public testing::Test {
 protected:
  /// @param commands  of units of robots `r`, which are 5 m apart in formations
  void carry_out(const std::string& map, const std::string& commands, const std::string& parameters = "",
                 double patience = 60.0) {
    text::Diagnostics sink;
    mdl::LoadOptions options;
    options.files.is_file = [](const std::string& path) { return path == "map.odl"; };
    options.files.read = [&](const std::string& path) -> text::Result<text::SourcePtr> {
      return std::make_shared<const text::Source>(path, map);
    };
    const auto source = std::make_shared<const text::Source>(
        "test.mdl",
        fmt::format("OVERLAY map.odl\nNEW-ROBOT r \"robot\" blue \"\" (formation_spacing = 5{})\n{}",
                    parameters, commands));
    const auto mission = mdl::check_mission(source, "", sink, options);
    ASSERT_NE(mission, nullptr) << text::render(sink);
    run_ = begun_run(mission, patience, told_);
    ASSERT_NE(run_, nullptr);
    for (int i = 0; i < 10'000 && run_->step() != run::MissionRun::Progress::kOver; ++i) {
      if (i % 5 == 0) explain();
    }
    for (const fleet::FleetRobot& robot : run_->fleet().robots()) {
      const binding::BodyState body = run_->world().body(robot.body);
      contacts_ += body.contacts + body.run_over;
    }
  }
  /// What robots say of why they move as they do, as far as it is about others.
  void explain() {
    for (const fleet::FleetRobot& robot : run_->fleet().robots()) {
      for (const std::string& line : run_->explain(robot)) {
        for (const char* words : {"makes way for", "waits here until", "let it through"}) {
          if (line.find(words) != std::string::npos) explained_ += line + "\n";
        }
      }
    }
  }
  bool is_done() const { return run_->state().outcome == mission::Outcome::kDone; }
  double farthest_from(geom::Point place) const {
    double out = 0.0;
    for (const fleet::FleetRobot& robot : run_->fleet().robots())
      out = std::max(out, distance(run_->fleet().pose(robot).position, place));
    return out;
  }

  std::unique_ptr<run::MissionRun> run_;
  std::string told_;
  std::string explained_;
  unsigned contacts_ = 0;
};

const std::string kPlain = "MISSION-AREA 300 300\nCONTROL MEASURES:\n";

TEST_F(Trapped, WhoStandsInANotchBetweenRocksDrivesOut) {
  // Behind the rocks, through a gap that is too narrow, free ground is nearest.
  carry_out(
      "MISSION-AREA 400 200\nCONTROL MEASURES:\nOBSTACLE 380.71 89.1 5.96\nOBSTACLE 364.38 77.67 11.51\n"
      "OBSTACLE 382.97 80.83 2.43\n",
      "UNIT <t> r\nCOMMAND LIST:\n0. UNIT t START 381.306 82.919\n1. UNIT t MOVETO 323 155\n");
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(contacts_, 0U);
}

TEST_F(Trapped, WhoIsPutBesideTwoRocksThatMeetDrivesOut) {
  carry_out(
      "MISSION-AREA 400 300\nCONTROL MEASURES:\nOBSTACLE 80.83 216.62 2.53\nOBSTACLE 78.24 213.55 2.53\n"
      "OBSTACLE 76.23 210.07 2.53\nOBSTACLE 87.83 208.92 3.19\nOBSTACLE 82.5 200.32 3.19\n",
      "UNIT <t> r\nCOMMAND LIST:\n0. UNIT t START 79.2 211.1\n1. UNIT t MOVETO 344 215\n");
  EXPECT_TRUE(is_done()) << told_;
}

TEST_F(Trapped, WhoStartsInAMinefieldLeavesItByTheNearestEdge) {
  for (const char* task : {"MOVETO", "VISIT", "OCCUPY"}) {
    told_.clear();
    carry_out("MISSION-AREA 200 200\nCONTROL MEASURES:\nMINEFIELD mines 50 50 50\n",
              fmt::format("UNIT <t> r\nCOMMAND LIST:\n0. UNIT t START 50 55\n1. UNIT t {} 50 12\n", task));
    EXPECT_TRUE(is_done()) << task << "\n" << told_;
    EXPECT_LT(run_->time(), 60.0) << task;
    EXPECT_EQ(told_.find("no way"), std::string::npos) << told_;
  }
}

TEST_F(Trapped, NobodyTouchesAnotherOneWhereAllArePutRoundOnePlace) {
  const std::string robots = " r r r r r r r r r r r r";
  carry_out(kPlain, "UNIT <t>" + robots + robots +
                        "\nCOMMAND LIST:\n0. UNIT t START 50 150\n1. UNIT t MOVETO 270 150\n");
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(contacts_, 0U);
}

TEST_F(Trapped, WhoHaltsToWatchDoesNotHaltInADoor) {
  // The first bound ends in the door.
  carry_out("MISSION-AREA 60 30\nCONTROL MEASURES:\nWALL low 23 0 23 14.5\nWALL high 23 15.5 23 30\n",
            "UNIT <t> r r\nCOMMAND LIST:\n0. UNIT t START 8 15 0 2\n"
            "1. UNIT t MOVETO 52 15 FORMATION No-Formation TECHNIQUE Bounding-Overwatch\n");
  EXPECT_TRUE(is_done()) << told_;
}

TEST_F(Trapped, TheMiddleOfAUnitMayBeClosedOff) {
  carry_out(kPlain + "WALL box 130 130 170 130 170 170 130 170 130 130\n",
            "UNIT <t> r r\nCOMMAND LIST:\n0. ROBOT 1 START 110 150 AND ROBOT 2 START 190 150\n"
            "1. UNIT t MOVETO 270 20 Column\n");
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_LT(farthest_from({270, 20}), 10.0);
}

TEST_F(Trapped, ARouteMayLeadBackAlongItself) {
  carry_out(kPlain + "AXIS through 30 150 270 150\n",
            "UNIT <t> r r r\nCOMMAND LIST:\n0. UNIT t START 30 150 0 3\n1. UNIT t FOLLOW through Column\n"
            "2. UNIT t FOLLOW through Column\n");
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_LT(farthest_from({270, 150}), 15.0);
}

TEST_F(Trapped, DoorsThatBarelyLetThemPass) {
  std::string rooms = kPlain;
  for (int x = 1; x < 6; ++x) {
    // A door of 1.5 m that is elsewhere in each of the walls.
    const double door = 5.0 + 17.0 * (x * 7 % 5);
    rooms += fmt::format("WALL a{0} {1} 0 {1} {2}\nWALL b{0} {1} {3} {1} 300\n", x, 40 * x, door, door + 1.5);
  }
  carry_out(rooms,
            "UNIT <t> r r r r r r\nCOMMAND LIST:\n0. UNIT t START 15 40 0 2\n"
            "1. UNIT t MOVETO 250 40 Wedge\n2. UNIT t MOVETO 15 40 Line\n");
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(contacts_, 0U);
}

TEST_F(Trapped, UnitsThatMeetInACorridorForTwoPass) {
  for (const char* formation : {"Column", "Wedge", "Line"}) {
    contacts_ = 0;
    carry_out(
        kPlain + "WALL low 80 0 80 149.25 220 149.25 220 0\nWALL high 80 300 80 150.75 220 150.75 220 300\n",
        fmt::format("UNIT <a> r r r r\nUNIT <b> r r r r\nCOMMAND LIST:\n"
                    "0. UNIT a START 40 140 0 5 AND UNIT b START 260 140 0 5\n"
                    "1. UNIT a MOVETO 260 150 {0} AND UNIT b MOVETO 40 150 {0}\n",
                    formation));
    EXPECT_TRUE(is_done()) << formation << "\n" << told_;
    EXPECT_EQ(contacts_, 0U) << formation;
    EXPECT_LT(run_->time(), 120.0) << formation;
  }
}

TEST_F(Trapped, UnitsThatMeetAtADoorForOneTakeTurns) {
  for (const char* formation : {"Column", "Wedge", "Line"}) {
    contacts_ = 0;
    carry_out(kPlain + "WALL low 150 0 150 149.65\nWALL high 150 150.35 150 300\n",
              fmt::format("UNIT <a> r r r\nUNIT <b> r r r\nCOMMAND LIST:\n"
                          "0. UNIT a START 60 140 0 5 AND UNIT b START 240 140 0 5\n"
                          "1. UNIT a MOVETO 240 150 {0} AND UNIT b MOVETO 60 150 {0}\n"
                          "2. UNIT a MOVETO 60 150 {0} AND UNIT b MOVETO 240 150 {0}\n",
                          formation));
    EXPECT_TRUE(is_done()) << formation << "\n" << told_;
    EXPECT_EQ(contacts_, 0U) << formation;
  }
}

// A wall with a door of 0.8 m, or a passage of 10 m as wide.
const std::string kDoor =
    "MISSION-AREA 80 30\nCONTROL MEASURES:\nWALL a 40 0 40 14.6\nWALL b 40 15.4 40 30\n";
const std::string kPassage =
    "MISSION-AREA 80 30\nCONTROL MEASURES:\nWALL a 35 0 35 14.6\nWALL b 35 15.4 35 30\nWALL c 45 0 45 14.6\n"
    "WALL d 45 15.4 45 30\nWALL e 35 14.6 45 14.6\nWALL f 35 15.4 45 15.4\n";

TEST_F(Trapped, WhoHasArrivedInADoorMakesWayAndComesBack) {
  for (const std::string& map : {kDoor, kPassage}) {
    told_.clear();
    carry_out(map,
              "UNIT <p> r\nUNIT <q> r r r\nCOMMAND LIST:\n0. UNIT p START 10 15 AND UNIT q START 10 8 0 1\n"
              "1. UNIT p OCCUPY 40.5 15\n2. UNIT q MOVETO 70 15 FORMATION Column\n"
              "3. UNIT q VISIT 72 28 75 5 50 25\n");
    EXPECT_TRUE(is_done()) << told_;
    EXPECT_LT(distance(run_->fleet().pose(run_->fleet().robots()[0]).position, {40.5, 15}), 1.5);
    EXPECT_EQ(contacts_, 0U);
  }
  for (const char* words : {"makes way for robot", "waits here until robot", "let it through"})
    EXPECT_NE(explained_.find(words), std::string::npos) << words << " in\n" << explained_;
}

TEST_F(Trapped, WhoStandsInADoorWithoutACommandMakesWay) {
  carry_out(
      kDoor,
      "UNIT <p> r r\nUNIT <q> r r r\nCOMMAND LIST:\n0. UNIT p START 39 15 1 0 AND UNIT q START 10 8 0 1\n"
      "1. UNIT q MOVETO 70 15 FORMATION Column\n");
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(contacts_, 0U);
}

TEST_F(Trapped, UnitsThatMeetInACorridorForOnePass) {
  const std::string walls =
      "MISSION-AREA 120 40\nCONTROL MEASURES:\nWALL a 30 19.65 90 19.65\nWALL b 30 20.35 90 20.35\nWALL c 30 "
      "0 30 "
      "19.65\nWALL d 30 20.35 30 40\nWALL e 90 0 90 19.65\nWALL f 90 20.35 90 40\n";
  for (const char* robots : {"r", "r r", "r r r r"}) {
    // In the corridor already, and in front of it.
    for (const char* start : {"36", "15"}) {
      told_.clear();
      carry_out(
          walls,
          fmt::format(
              "UNIT <a> {0}\nUNIT <b> {0}\nCOMMAND LIST:\n0. UNIT a START {1} 20 0.8 0 AND UNIT b START "
              "105 20 0.8 0\n1. UNIT a MOVETO 105 20 FORMATION Column AND UNIT b MOVETO 15 20 "
              "FORMATION Column\n",
              robots, start));
      EXPECT_TRUE(is_done()) << robots << " from " << start << "\n" << told_;
      EXPECT_EQ(contacts_, 0U) << robots << " from " << start;
    }
  }
}

TEST_F(Trapped, ACorridorAsWideAsAWayMustBeIsPassed) {
  carry_out(
      "MISSION-AREA 120 40\nCONTROL MEASURES:\nWALL a 30 19.69 90 19.69\nWALL b 30 20.31 90 20.31\nWALL c 30 "
      "0 30 "
      "19.69\nWALL d 30 20.31 30 40\nWALL e 90 0 90 19.69\nWALL f 90 20.31 90 40\n",
      "UNIT <a> r\nCOMMAND LIST:\n0. UNIT a START 15 20\n1. UNIT a MOVETO 105 20\n");
  EXPECT_TRUE(is_done()) << told_;
}

TEST_F(Trapped, NobodyWaitsForEverForWhoCanNotCome) {
  // One of them is closed in, and the others are told to keep together.
  carry_out(kPlain + "WALL room 20 200 60 200 60 240 20 240 20 200\n",
            "SET COHESION 2\nUNIT <t> r r r\nCOMMAND LIST:\n"
            "0. ROBOT 1 START 30 100 AND ROBOT 2 START 30 110 AND ROBOT 3 START 40 220\n"
            "1. UNIT t MOVETO 270 150 Column\n");
  EXPECT_FALSE(is_done());
  for (const std::uint32_t id : {1U, 2U})
    EXPECT_LT(distance(run_->fleet().pose(*run_->fleet().find({id})).position, {270, 150}), 15.0)
        << id << told_;
}

TEST_F(Trapped, AGapThatIsTooNarrowIsNamed) {
  carry_out(kPlain + "WALL low 150 0 150 149.8\nWALL high 150 150.2 150 300\n",
            "UNIT <t> r r\nCOMMAND LIST:\n0. UNIT t START 50 148 0 4\n1. UNIT t MOVETO 250 150 Column\n");
  EXPECT_FALSE(is_done());
  EXPECT_NE(told_.find("a gap of 0.4 m at (150.0, 150.0), which is too narrow, is in front of it"),
            std::string::npos)
      << told_;
  // The robots' own ways lead nowhere then either, which says nothing new.
  EXPECT_EQ(told_.find("no way to (250, 150)"), told_.rfind("no way to (")) << told_;
}

TEST_F(Trapped, CornersOfALineThatAreClosedOffAreToldAndLeftOut) {
  carry_out(
      kPlain +
          "WALL room 120 120 180 120 180 180 120 180 120 120\nAXIS Road 60 150 140 150 160 150 250 150\n",
      "UNIT <t> r r\nCOMMAND LIST:\n0. UNIT t START 30 148 0 4\n1. UNIT t FOLLOW AXIS-Road\n");
  EXPECT_TRUE(is_done()) << told_;
  const std::string text = "no way to (140, 150) is known: a wall at (120.0, 150.0) is in front of it";
  EXPECT_NE(told_.find(text), std::string::npos) << told_;
  EXPECT_NE(told_.find("it and 1 corner more are left out"), std::string::npos) << told_;
  EXPECT_EQ(told_.find(text), told_.rfind(text)) << "once\n" << told_;
}

TEST_F(Trapped, WhatSwaysIsGoneRound) {
  for (const char* sway : {"51 SPEED 0.5", "56 SPEED 0.3"}) {
    contacts_ = 0;
    carry_out(
        "MISSION-AREA 200 100\nCONTROL MEASURES:\nOBSTACLE 100 49 8 ROUTE 100 " + std::string(sway) + "\n",
        "UNIT <t> r r r\nCOMMAND LIST:\n0. UNIT t START 15 50 0 2\n1. UNIT t MOVETO 185 50 Wedge\n"
        "2. UNIT t MOVETO 15 50 Column\n");
    EXPECT_TRUE(is_done()) << sway << "\n" << told_;
    EXPECT_EQ(contacts_, 0U) << sway;
  }
}

TEST_F(Trapped, TheNearestPlaceIsOneThatAWayLeadsTo) {
  // On the wall of a closed room: inside is as near.
  carry_out(kPlain + "WALL room 180 80 220 80 220 120 180 120 180 80\n",
            "UNIT <t> r r r\nCOMMAND LIST:\n0. UNIT t START 20 100 0 3\n1. UNIT t MOVETO 180 100 Wedge\n");
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_LT(farthest_from({180, 100}), 20.0);
  EXPECT_NE(told_.find("is the nearest place to it"), std::string::npos) << told_;
}

TEST_F(Trapped, AClosedRoomIsToldWithTheSideThatIsNearest) {
  carry_out(kPlain + "WALL room 180 80 220 80 220 120 180 120 180 80\n",
            "UNIT <t> r\nCOMMAND LIST:\n0. UNIT t START 20 100\n1. UNIT t MOVETO 195 100\n");
  EXPECT_FALSE(is_done());
  EXPECT_NE(told_.find("a wall at (180.0, 100.0) is in front of it, 15 m away"), std::string::npos) << told_;
}

TEST_F(Trapped, WhoIsClosedInSaysSo) {
  carry_out(kPlain + "WALL room 20 200 60 200 60 240 20 240 20 200\n",
            "UNIT <t> r r\nCOMMAND LIST:\n0. ROBOT 1 START 30 100 AND ROBOT 2 START 40 220\n"
            "1. UNIT t MOVETO 270 150 Column\n");
  EXPECT_FALSE(is_done());
  EXPECT_NE(told_.find("robot 2: Way: no way to"), std::string::npos) << told_;
}

TEST_F(Trapped, AWideWreckIsGoneRoundAsAnObstacleIs) {
  for (const char* command : {"FOLLOW AXIS-Road Column", "VISIT PP-C PP-G", "MOVETO PP-C Line"}) {
    contacts_ = 0;
    told_.clear();
    carry_out(kPlain + "AXIS Road 60 50 150 50 150 150 250 150\nPP C 150 50\nPP G 250 150\n",
              std::string("NEW-ROBOT wreck \"./nothing\" blue \"\" (robot_radius = 6)\n"
                          "UNIT <t> r r r\nUNIT <w> wreck\nCOMMAND LIST:\n"
                          "0. UNIT t START 40 50 0 5 AND UNIT w START PP-C\n1. UNIT t ") +
                  command + "\n");
    EXPECT_TRUE(is_done()) << command << "\n" << told_;
    EXPECT_LT(run_->time(), 120.0) << command << "\n" << told_;
    EXPECT_EQ(contacts_, 0U) << command;
  }
}

TEST_F(Trapped, WhatNoWayLeadsToFailsSoon) {
  for (const char* command : {"MOVETO PP-G Column", "RALLY PP-G", "OCCUPY PP-G Line", "FOLLOW AXIS-Road"}) {
    for (const char* closed : {"MINEFIELD m", "WALL w"}) {
      told_.clear();
      carry_out(kPlain + "PP G 230 150\nAXIS Road 100 150 230 150\n" + closed +
                    " 200 120 260 120 260 180 200 180 200 120\n",
                std::string("UNIT <t> r r r\nCOMMAND LIST:\n0. UNIT t START 40 150 0 5\n1. UNIT t ") +
                    command + "\n",
                "", 600.0);
      EXPECT_FALSE(is_done()) << command << "\n" << told_;
      EXPECT_LT(run_->time(), 320.0) << command << "\n" << told_;
      EXPECT_NE(told_.find("failed: no way leads there, and none was opened for 180 s"), std::string::npos)
          << command << "\n"
          << told_;
      EXPECT_NE(told_.find("no way leads farther"), std::string::npos) << told_;
    }
  }
}

TEST_F(Trapped, CrowdsThatCrossDoNotTouch) {
  std::string units;
  for (const char* name : {"a", "b", "c", "d"})
    units += fmt::format("UNIT <{}> r r r r r r r r r r r r\n", name);
  carry_out("MISSION-AREA 200 200\nCONTROL MEASURES:\n",
            units +
                "COMMAND LIST:\n"
                "0. UNIT a START 100 190 0 -1 AND UNIT b START 100 10 0 1 AND UNIT c START 190 100 -1 0 AND\n"
                "   UNIT d START 10 100 1 0\n"
                "1. UNIT a MOVETO 100 10 Line AND UNIT b MOVETO 100 190 Wedge AND\n"
                "   UNIT c MOVETO 10 100 Diamond AND UNIT d MOVETO 190 100 Column\n",
            ", formation_spacing = 1");
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(contacts_, 0U);
}

TEST_F(Trapped, LargeBodiesKnowHowLargeTheyAre) {
  carry_out(kPlain,
            "UNIT <t> r r r r\nCOMMAND LIST:\n0. UNIT t START 30 150 0 10\n1. UNIT t MOVETO 270 150 Column\n",
            ", robot_radius = 1");
  EXPECT_TRUE(is_done()) << told_;
  EXPECT_EQ(contacts_, 0U);
}

}  // namespace
}  // namespace mlab
