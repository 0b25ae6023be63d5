// What `mlab check` says of missions and what they name, and what `mlab import` says last.

#include <cstddef>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "command.h"

namespace mlab {
namespace {

using Json = nlohmann::json;

std::size_t counted(const std::string& text, const std::string& part) {
  std::size_t out = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++out;
  return out;
}

TEST_F(Command, CheckTellsANoteAndChangesNoExitStatusForIt) {
  write("map.odl", kMap);
  write("mission.mdl",
        "OVERLAY map.odl\nNEW-ROBOT far \"robot\" blue shaft\nUNIT <u> far\nCOMMAND LIST:\n0. UNIT u START "
        "Here\n"
        "1. UNIT u MOVETO There\n");
  const Outcome told = mlab("check --strict mission.mdl");
  EXPECT_EQ(told.status, 0) << told.err;
  EXPECT_EQ(told.out, "mission.mdl: mission, 0 errors, 0 warnings, 1 note\n");
  EXPECT_TRUE(has(told.err,
                  "mission.mdl:2:28: note: with `--robots fleet` robots of this type have the vehicle of "
                  "this name as body"))
      << told.err;
  const Json json = Json::parse(mlab("check --format json mission.mdl").out);
  EXPECT_EQ(json.at("files").at(0).at("diagnostics").at(0).at("level"), "note");
}

TEST_F(Command, CheckPrintsTheFailsafesThatAreInForce) {
  write("map.odl", std::string(kMap) + "BOUNDARY Field 0 0 900 0 900 900 0 900\n");
  const std::string rest = "UNIT <u> ROBOT\nCOMMAND LIST:\n0. UNIT u START Here\n1. UNIT u MOVETO There\n";
  write("mission.mdl",
        "OVERLAY map.odl\nFAILSAFE OUTSIDE Field REVERSE INSIDE\nFAILSAFE FOR ROBOT LINK-LOST AFTER 5 "
        "RETURN\n" +
            rest);
  const Outcome told = mlab("check --failsafes mission.mdl");
  EXPECT_EQ(told.status, 0) << told.err;
  EXPECT_EQ(
      told.out,
      "mission.mdl: mission, ok\n"
      "  rank  robots       condition                after   action          stated\n"
      "  -     all          emergency stop                   stands          always\n"
      "  1     all          OUTSIDE Field                    REVERSE INSIDE  2:1\n"
      "  2     ROBOT        LINK-LOST                5 s     RETURN          3:1\n"
      "  -     all          program fails                    stands          always\n"
      "  -     all          LINK-LOST                0.5 s   stands          always, with --real-time\n"
      "  -     all          PERCEPTS-STALE           0.5 s   stands          always, with --real-time\n"
      "  -     all          OPERATOR-ABSENT          0.5 s   stick let go    always, under teleoperation\n");
  const Json json = Json::parse(mlab("check --failsafes --format json mission.mdl").out);
  EXPECT_EQ(json.at("files").at(0).at("failsafes").at(1).at("action"), "REVERSE INSIDE");
  write("mission.mdl", "OVERLAY map.odl\nFAILSAFE STUCK REVERSE INSIDE\n" + rest);
  const Outcome refused = mlab("check --failsafes mission.mdl");
  EXPECT_EQ(refused.status, 2);
  EXPECT_FALSE(has(refused.out, "rank")) << "nothing is in force";
}

constexpr const char* kSocieties =
    "class Cart(top: speed = 1 m/s in 0 .. 5) {\n  sensor ring: DetectObstacles() binds sense_obstacles;\n"
    "  actuator wheels: Drive(max_velocity = top) binds movement;\n}\n"
    "robot Scout(top: speed = 2 m/s in 0 .. 5) is Cart { movement = Noise(); }\n"
    "robot Carrier(load: gain = 1 in 0 .. 2) is Cart { movement = cooperate { load: Noise(); }; }\n"
    "society Scouts: team of 2 Scout;\nsociety Party: caste { Scouts; Carrier; };\n";

TEST_F(Command, CheckSaysOnceWhatConcernsAllRobotsOfASociety) {
  write("map.odl", kMap);
  write("party.cdl", kSocieties);
  const std::string steps = "COMMAND LIST:\n0. UNIT p START Here 5 0\n1. UNIT p STOP\n";
  write("mission.mdl", "OVERLAY map.odl\nNEW-ROBOT p \"party.cdl#Party\" (load = 0.5)\n" + steps);
  EXPECT_FALSE(has(mlab("check mission.mdl").err, "unknown-parameter")) << "one of them has it";
  write("mission.mdl", "OVERLAY map.odl\nNEW-ROBOT p \"party.cdl#Party\" (laod = 0.5)\n" + steps);
  const std::string unknown = mlab("check mission.mdl").err;
  EXPECT_EQ(counted(unknown, "[unknown-parameter]"), 1U) << unknown;
  write("mission.mdl", "OVERLAY map.odl\nNEW-ROBOT p \"party.cdl#Party\" (robot_radius = 5000)\n" + steps);
  const std::string range = mlab("check mission.mdl").err;
  EXPECT_EQ(counted(range, ": error:"), 1U) << range;
  write("mission.mdl", "OVERLAY map.odl\nNEW-ROBOT p \"party.cdl#Parti\"\n" + steps);
  const Outcome missing = mlab("check mission.mdl");
  EXPECT_EQ(missing.status, 2);
  EXPECT_EQ(counted(missing.err, ": error:"), 1U) << missing.err;
  EXPECT_TRUE(has(missing.err, "did you mean `Party`?")) << missing.err;
  write("mission.mdl", "OVERLAY map.odl\nNEW-ROBOT p \"party.cdl#Party\"\n" + steps);
  EXPECT_EQ(mlab("fmt --check mission.mdl").status, 1);
  EXPECT_EQ(mlab("fmt mission.mdl").status, 0);
  EXPECT_TRUE(has(text_of(folder_ / "mission.mdl"), "NEW-ROBOT p \"party.cdl#Party\"\n"));
}

TEST_F(Command, RobotsOfASocietyRunTheirOwnPrograms) {
  write("map.odl", kMap);
  write("party.cdl", kSocieties);
  write("mission.mdl",
        "OVERLAY map.odl\nNEW-ROBOT p \"party.cdl#Party\"\nUNIT <team> (<wing> p) (<spare> ROBOT)\n"
        "COMMAND LIST:\n0. UNIT team START Here 5 0\n");
  const Outcome o = mlab("run mission.mdl --headless --for 20 --report r.json");
  ASSERT_EQ(o.status, 0) << o.out << o.err;
  const Json robots = Json::parse(text_of(folder_ / "r.json")).at("robots");
  std::string types;
  for (const Json& robot : robots) types += robot.at("type").get<std::string>() + " ";
  EXPECT_EQ(types, "p#Scout p#Scout p#Carrier ROBOT ");
}

TEST_F(Command, CheckSaysThatANetworkNeverReports) {
  write("map.odl", kMap);
  write("mute.cnl",
        "node drift is Noise with persistence = 10; nend\nnode wheels is Drive with v = drift; nend\n");
  write("mission.mdl",
        "OVERLAY map.odl\nNEW-ROBOT m \"mute.cnl\"\nUNIT <u> m\nCOMMAND LIST:\n0. UNIT u START Here\n"
        "1. UNIT u MOVETO There\n");
  const Outcome o = mlab("check mission.mdl");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_TRUE(has(o.err, "mission.mdl:6:9: warning: robots of the type `m` never say how far")) << o.err;
  EXPECT_TRUE(has(o.err, "[never-reports]")) << o.err;
}

TEST_F(Command, CheckAndBuildGoWithoutCellsWhereTheyAreToldTo) {
  fs::create_directory(folder_ / "project");
  write("body.h", "output = Vector{};\n");
  write("project/mine.cnl",
        "procedure Vector Still with\n  double a = 1;\nheader\nbody\n#include \"../body.h\"\npend\n"
        "node s is Still with nend\nnode wheels is Drive with v = s; nend\n");
  const Outcome walled = mlab("check project/mine.cnl");
  EXPECT_EQ(walled.status, 2) << "nothing outside of the project is read in a cell: " << walled.out;
  const Outcome free = mlab("check project/mine.cnl --no-cell");
  EXPECT_EQ(free.status, 0) << free.err;
  EXPECT_EQ(mlab("build project/mine.cnl -o still --no-cell").status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "still"));
}

TEST_F(Command, TheLastLineOfAnImportTellsTheRobotsThatStand) {
  write("old.cdl",
        "bindArch AuRA;\ninstBP <1,1>|R| $R1 from vehicle( bound_to = one:SPIDER( $W ) );\n"
        "instBP $W from movement( v = RAMBLE() );\n");
  const Outcome o = mlab("import old.cdl -o new.cdl");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_TRUE(
      o.err.ends_with("mlab import: a robot stands still, for nothing here moves it: one (no RAMBLE)\n"))
      << o.err;
  EXPECT_EQ(mlab("import --strict old.cdl -o new.cdl").status, 1);
}

}  // namespace
}  // namespace mlab
