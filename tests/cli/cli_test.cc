// The built command as its users meet it: what it prints where, its exit status, the files that it writes.

#include <sys/stat.h>

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "command.h"

namespace mlab {
namespace {

using Json = nlohmann::json;

TEST_F(Command, AnEnvironmentFileChangesTheWorldWhileTheMissionRuns) {
  write("map.odl", "SITE Test\nMISSION-AREA 300 200\nCONTROL MEASURES:\nPP Here 40 100\nPP There 260 100\n");
  write("mission.mdl", kMission);
  write("change.env",
        "STEP_COUNT 5\n  ADD OBSTACLE 130 103 12\nSTEP_COUNT 0 2\n  REGION 0 150 300 200 ADD OBSTACLE 80 1 "
        "2\n");
  const auto driven = [&](const std::string& report) {
    return Json::parse(text_of(folder_ / report)).at("robots").at(0).at("distance_m").get<double>();
  };
  const Outcome without = mlab("run mission.mdl --headless --quiet --report without.json");
  ASSERT_EQ(without.status, 0) << without.err;
  const Outcome o =
      mlab("run mission.mdl --headless --environment change.env --report with.json --plot with.svg");
  ASSERT_EQ(o.status, 0) << o.out << o.err;
  EXPECT_GT(driven("with.json"), driven("without.json") + 1.0) << "the way around the new obstacle is longer";
  const std::string no_room = "no room for as many obstacles";
  EXPECT_TRUE(has(o.out, no_room));
  EXPECT_EQ(o.out.find(no_room), o.out.rfind(no_room)) << "told every two seconds it would bury the rest";
}

TEST_F(Command, AnEnvironmentFileWithAMistakeStopsTheRunBeforeItBegins) {
  write("map.odl", kMap);
  write("mission.mdl", kMission);
  write("change.env", "STEP_COUNT 5 REMOV OBSTACLE 1 1\n");
  const Outcome o = mlab("run mission.mdl --headless --environment change.env --report r.json");
  EXPECT_EQ(o.status, 2);
  EXPECT_TRUE(has(o.err, "change.env:1:14: error:")) << o.err;
  EXPECT_TRUE(o.out.empty()) << o.out;
  EXPECT_FALSE(fs::exists(folder_ / "r.json"));
  EXPECT_EQ(mlab("run mission.mdl --headless --environment nosuch.env").status, 2);
}

TEST_F(Command, PrintInThePreambleAndAnOrderToOneRobotAreCarriedOut) {
  write("map.odl", kMap);
  write("mission.mdl",
        "OVERLAY map.odl\nPRINT CONSOLE-DATABASE\nPRINT ROBOT-INFO\nNEW-ROBOT far \"robot\" blue shaft\n"
        "UNIT <u> ROBOT ROBOT\nCOMMAND LIST:\n"
        "0. UNIT u START Here 0 20\n1. UNIT u MOVETO There AND ROBOT 2 MOVETO 130 160 UNTIL TIMEOUT 90\n");
  const Outcome o = mlab("run mission.mdl --headless --report r.json");
  ASSERT_EQ(o.status, 0) << o.out << o.err;
  EXPECT_TRUE(has(o.out, "PP         There")) << o.out;
  EXPECT_TRUE(has(o.out, "robot 2      ROBOT            not started")) << o.out;
  EXPECT_TRUE(has(o.err,
                  "mission.mdl:4:28: note: with `--robots fleet` robots of this type have the vehicle of "
                  "this name as body"))
      << o.err;
  EXPECT_LT(o.out.find("PP         There"), o.out.find("step 0")) << "once, before the mission begins";
  const Json report = Json::parse(text_of(folder_ / "r.json"));
  EXPECT_EQ(report.at("steps").at(1).at("commands").at(1).at("unit"), "robot 2");
  EXPECT_EQ(report.at("steps").at(1).at("commands").at(1).at("outcome"), "done");
  EXPECT_EQ(report.at("steps").at(1).at("commands").at(0).at("outcome"), "done");
}

TEST_F(Command, ProceedNeedsNobodyAtTheTerminalToEndATeleoperation) {
  write("map.odl", kMap);
  write("mission.mdl", std::string(kMission) + "2. UNIT u TELEOPERATE Here\n3. UNIT u MOVETO Here\n");
  const Outcome o = mlab("run mission.mdl --headless --proceed");
  EXPECT_EQ(o.status, 0) << o.out;
  EXPECT_TRUE(has(o.out, "mission done")) << o.out;
}

TEST_F(Command, NumbersThatAreNoneAreUsageErrors) {
  write("map.odl", kMap);
  write("mission.mdl", kMission);
  for (const char* option : {"--seed -1", "--seed 99999999999999999999", "--seed 1.5", "--patience nan",
                             "--patience inf", "--limit nan", "--limit -1", "--limit 1e999"}) {
    const Outcome o = mlab(std::string("run mission.mdl --headless ") + option);
    EXPECT_EQ(o.status, 2) << option;
    EXPECT_TRUE(o.out.empty()) << option;
    EXPECT_TRUE(has(o.err, "expected")) << o.err;
  }
  EXPECT_EQ(mlab("bench --range nan").status, 2);
  EXPECT_EQ(mlab("bench --seed -1").status, 2);
}

TEST_F(Command, OfManyRobotsThatAreMovedAtTheStartOnlyTheFirstAreNamed) {
  write("map.odl", kMap);
  std::string text = "OVERLAY map.odl\nUNIT <u>";
  for (int i = 0; i < 30; ++i) text += " ROBOT";
  write("mission.mdl", text + "\nCOMMAND LIST:\n0. UNIT u START Here\n");
  const Outcome o = mlab("run mission.mdl --headless");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_TRUE(has(o.out, "robot 9 starts at")) << o.out;
  EXPECT_FALSE(has(o.out, "robot 10 starts at")) << o.out;
  EXPECT_TRUE(has(o.out, "21 more robots start at the nearest free place")) << o.out;
}

TEST_F(Command, AProgramThatPutsOutNoNumberIsAFaultThatIsNamed) {
  write("map.odl", kMap);
  write("mine.cnl",
        "procedure Vector Lost with\nheader\nbody\n  output = Vector{0.0 / time, "
        "0.0};\npend\nnode lost is Lost with nend\nnode wheels is Drive with v = lost; nend\n");
  write("mission.mdl",
        "OVERLAY map.odl\nNEW-ROBOT mine \"mine.cnl\"\nUNIT <u> mine\nCOMMAND LIST:\n0. UNIT u START "
        "Here\n1. UNIT u "
        "MOVETO There\n");
  const Outcome o = mlab("run mission.mdl --headless --patience 5 --report r.json");
  EXPECT_EQ(o.status, 1) << o.err;
  EXPECT_TRUE(has(o.out, "no number, first at `lost`")) << o.out << o.err;
  const Json robot = Json::parse(text_of(folder_ / "r.json")).at("robots").at(0);
  EXPECT_EQ(robot.at("state"), "fault");
  EXPECT_EQ(robot.at("fault"), "lost");
}

TEST_F(Command, HelpIsAnsweredOnStandardOutputWithStatusZero) {
  for (const char* arguments : {"--help", "run --help", "check --help", "fmt --help", "describe --help",
                                "bench --help", "--version"}) {
    const Outcome o = mlab(arguments);
    EXPECT_EQ(o.status, 0) << arguments;
    EXPECT_FALSE(o.out.empty()) << arguments;
    EXPECT_TRUE(o.err.empty()) << arguments;
  }
}

TEST_F(Command, WrongUsageIsStatusTwoOnStandardError) {
  for (const char* arguments : {"",
                                "walk",
                                "run --headless",
                                "run a.mdl --speed fast",
                                "run a.mdl --threads 0",
                                "run a.mdl --start-time noon",
                                "run missing.mdl",
                                "run --port 99999",
                                "run --listen nowhere",
                                "run --listen 127.0.0.1:x",
                                "run --listen [::1",
                                "run --plot a.svg",
                                "run --project missing",
                                "run --certificate /etc/hostname",
                                "check",
                                "bench --robots 0",
                                "describe Nonsense",
                                "run missing.mdl --headless",
                                "check missing.mdl",
                                "fmt missing.odl"}) {
    const Outcome o = mlab(arguments);
    EXPECT_EQ(o.status, 2) << arguments;
    EXPECT_FALSE(o.err.empty()) << arguments;
  }
}

// Presses Ctrl-C after two seconds.
constexpr const char* kInterrupted = "timeout --preserve-status -s INT 2";

TEST_F(Command, RunOpensTheConsoleUntilItIsInterrupted) {
  write("map.odl", kMap);
  write("m.mdl", kMission);
  const Outcome o = mlab("run m.mdl --no-browser --port 0 --report r.json", kInterrupted);
  EXPECT_EQ(o.status, 0) << "nobody started the mission" << o.err;
  EXPECT_TRUE(has(o.out, "Open this address in a browser:\n\n    http://127.0.0.1:")) << o.out;
  EXPECT_TRUE(has(o.out, "/?token=")) << o.out;
  EXPECT_TRUE(has(o.out, "Ctrl-C")) << o.out;
  EXPECT_TRUE(has(o.out, "report: r.json")) << o.out;
  EXPECT_EQ(Json::parse(text_of(folder_ / "r.json"))["outcome"], "interrupted");
  EXPECT_TRUE(o.err.empty()) << o.err;
}

TEST_F(Command, TheConsoleOpensWithoutAMissionAndWithOneThatHasErrors) {
  const Outcome empty = mlab("run --no-browser --port 0", kInterrupted);
  EXPECT_EQ(empty.status, 0) << empty.err;
  EXPECT_TRUE(has(empty.out, "without a mission")) << empty.out;
  write("m.mdl", "OVERLAY nowhere.odl\n");
  const Outcome broken = mlab("run m.mdl --no-browser --port 0", kInterrupted);
  EXPECT_TRUE(has(broken.out, "m.mdl has errors")) << broken.out;
  EXPECT_TRUE(has(broken.err, "m.mdl:1:")) << broken.err;
}

TEST_F(Command, TheBrowserIsOpenedWithoutTellingTheTokenToOtherUsers) {
  write("bin_xdg",
        "#!/bin/sh\necho \"$@\" > arguments.txt\ncp \"$1\" page.html\nstat -c %a \"$1\" > mode.txt\n");
  fs::create_directories(folder_ / "bin");
  fs::rename(folder_ / "bin_xdg", folder_ / "bin" / "xdg-open");
  fs::permissions(folder_ / "bin" / "xdg-open", fs::perms::owner_all);
  const Outcome o = mlab("run --port 0", "PATH=\"$PWD/bin:$PATH\" DISPLAY=:9 XDG_RUNTIME_DIR=\"$PWD\" " +
                                             std::string(kInterrupted));
  EXPECT_TRUE(has(o.out, "It opens in a browser")) << o.out;
  EXPECT_FALSE(has(text_of(folder_ / "arguments.txt"), "token"));
  EXPECT_TRUE(has(text_of(folder_ / "page.html"), "url=http://127.0.0.1:"));
  EXPECT_EQ(text_of(folder_ / "mode.txt"), "600\n");
  for (const auto& entry : fs::directory_iterator(folder_))
    EXPECT_FALSE(entry.path().filename().string().starts_with("mlab_console_")) << "left behind";
}

TEST_F(Command, RunWritesAReportWithTheKeysOfItsSchema) {
  write("map.odl", kMap);
  write("m.mdl", kMission);
  const Outcome o = mlab("run m.mdl --headless --proceed --report r.json --plot p.svg");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_TRUE(has(o.out, "step 1: unit u MOVETO There done")) << o.out;
  const Json report = Json::parse(text_of(folder_ / "r.json"));
  for (const char* key :
       {"version", "mission", "seed", "outcome", "steps", "robots", "units", "deliveries", "performance"})
    EXPECT_TRUE(report.contains(key)) << key;
  EXPECT_EQ(report.size(), 9U);
  EXPECT_EQ(report["outcome"], "done");
  EXPECT_EQ(report["steps"].size(), 2U);
  EXPECT_EQ(report["robots"][0]["collisions"], 0);
  EXPECT_NEAR(report["robots"][0]["distance_m"], 50.0, 15.0);
  EXPECT_TRUE(has(text_of(folder_ / "p.svg"), "</svg>"));
}

TEST_F(Command, TheSameSeedGivesTheSameReport) {
  const auto report = [&](const std::string& more) {
    EXPECT_EQ(
        mlab("run " + kMissions + "demo_c/demo_c.mdl --headless --proceed --quiet --report r.json " + more)
            .status,
        0);
    Json out = Json::parse(text_of(folder_ / "r.json"));
    out.erase("performance");
    return out.dump();
  };
  const std::string one = report("--seed 5 --threads 1");
  EXPECT_EQ(one, report("--seed 5 --threads 2"));
  EXPECT_EQ(one, report("--seed 5 --threads 2 --robots process"));
  EXPECT_NE(one, report("--seed 6 --threads 2"));
}

TEST_F(Command, RobotsLiveWhereThereAreSuchPlaces) {
  const Outcome o = mlab("run m.mdl --headless --robots elsewhere");
  EXPECT_EQ(o.status, 2);
  EXPECT_TRUE(has(o.err, "--robots") && has(o.err, "process")) << o.err;
}

TEST_F(Command, AsksWhetherAUnitMayProceedAndTakesTheAnswers) {
  write("map.odl", kMap);
  write("m.mdl", std::string(kMission) + "2. UNIT u OCCUPY There\n3. UNIT u STOP\n");
  const Outcome yes = mlab("run m.mdl --headless --report r.json", "echo y |");
  EXPECT_EQ(yes.status, 0) << yes.out << yes.err;
  EXPECT_TRUE(has(yes.out, "Proceed? [y/n]"));
  EXPECT_EQ(Json::parse(text_of(folder_ / "r.json"))["mission"]["answers"].size(), 1U);
  const Outcome no = mlab("run m.mdl --headless", "echo n |");
  EXPECT_EQ(no.status, 1);
  EXPECT_TRUE(has(no.out, "aborted"));
  const Outcome nobody = mlab("run m.mdl --headless");
  EXPECT_EQ(nobody.status, 1);
  EXPECT_TRUE(has(nobody.out, "--proceed")) << "says how to go on without an operator";
}

TEST_F(Command, TakesTheAnswerToWhatARobotAsksByItself) {
  const Outcome yes = mlab("run '" + kMissions + "ugv/ugv.mdl' --headless --report r.json", "yes |");
  EXPECT_EQ(yes.status, 0) << yes.out << yes.err;
  EXPECT_TRUE(has(yes.out, "Robot 1 asks whether it may go on. Proceed? [y/n]")) << yes.out;
  EXPECT_EQ(Json::parse(text_of(folder_ / "r.json"))["mission"]["answers"].size(), 2U);
  const Outcome no = mlab("run '" + kMissions + "ugv/ugv.mdl' --headless", "echo n |");
  EXPECT_EQ(no.status, 1);
  EXPECT_TRUE(has(no.out, "aborted")) << no.out;
}

TEST_F(Command, AQuestionThatAnswersItselfNeedsNobodyAtTheTerminal) {
  const Outcome run = mlab("run '" + kMissions + "patrol/patrol.mdl' --headless");
  EXPECT_EQ(run.status, 0) << run.out << run.err;
  EXPECT_TRUE(has(run.out, "mission done")) << run.out;
}

TEST_F(Command, NeverOverwritesTheMissionThatItRuns) {
  write("map.odl", kMap);
  write("town.mdl", kMission);
  const Outcome run = mlab("run town.mdl --headless --proceed --report ./town.mdl");
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(has(run.err, "that is the mission itself")) << run.err;
  EXPECT_EQ(text_of(folder_ / "town.mdl"), kMission);
  EXPECT_EQ(mlab("run town.mdl --headless --proceed --report x --plot x").status, 2);
}

TEST_F(Command, AnInterruptEndsTheRunWithAReport) {
  write("map.odl", kMap);
  write("m.mdl", kMission);
  const Outcome o = mlab("run m.mdl --headless --proceed --speed 0.1 --report r.json", "timeout -s INT 2");
  const Json report = Json::parse(text_of(folder_ / "r.json"), nullptr, false);
  ASSERT_TRUE(report.is_object()) << o.out << o.err;
  EXPECT_EQ(report["outcome"], "interrupted");
  EXPECT_EQ(report["steps"][1]["outcome"], "running");
}

TEST_F(Command, MistakesAreReportedWithFileLineAndColumn) {
  write("map.odl", kMap);
  write("m.mdl",
        "OVERLAY map.odl\nUNIT <u> ROBOT\nCOMMAND LIST:\n0. UNIT u START Hree\n1. UNIT v MOVETO There\n");
  const Outcome o = mlab("check m.mdl");
  EXPECT_EQ(o.status, 2);
  EXPECT_TRUE(has(o.err, "m.mdl:4:17: error:")) << o.err;
  EXPECT_TRUE(has(o.err, "did you mean `Here`?")) << o.err;
  EXPECT_TRUE(has(o.err, "m.mdl:5:9: error:")) << o.err;
  EXPECT_EQ(mlab("run m.mdl --headless --report r.json").status, 2);
  EXPECT_FALSE(fs::exists(folder_ / "r.json")) << "nothing is written for a mission that can't be run";
}

TEST_F(Command, CheckAnswersToolsInJson) {
  write("map.odl", std::string(kMap) + "PP Broken 1\n");
  const Outcome o = mlab("check --format json map.odl");
  EXPECT_EQ(o.status, 2);
  const Json answer = Json::parse(o.out);
  EXPECT_EQ(answer["files"][0]["language"], "overlay");
  EXPECT_EQ(answer["files"][0]["diagnostics"][0]["place"]["line"], 5);
}

TEST_F(Command, StrictTurnsWarningsIntoStatusOne) {
  write("map.odl", kMap);
  write("m.mdl",
        "OVERLAY map.odl\nNEW-ROBOT r \"robot\" blue (base_velocty = 1)\nUNIT <u> r\nCOMMAND LIST:\n0. UNIT "
        "u START Here\n");
  const Outcome lenient = mlab("check m.mdl");
  EXPECT_EQ(lenient.status, 0);
  EXPECT_TRUE(has(lenient.err, "did you mean `base_velocity`?")) << lenient.err;
  EXPECT_EQ(mlab("check --strict m.mdl").status, 1);
  EXPECT_EQ(mlab("run --headless --strict m.mdl").status, 1);
}

TEST_F(Command, ExecutesWhatAMissionNamesOnlyWhereThatIsAllowed) {
  write("map.odl", kMap);
  write("evil", "#!/bin/sh\ntouch executed\n");
  fs::permissions(folder_ / "evil", fs::perms::owner_all);
  write("m.mdl",
        "OVERLAY map.odl\nNEW-ROBOT e \"./evil\"\nUNIT <u> e\nCOMMAND LIST:\n0. UNIT u START Here\n");
  const Outcome o = mlab("run m.mdl --headless --proceed");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_TRUE(has(o.err, "m.mdl:2:13: warning: the executable `./evil` is not run")) << o.err;
  EXPECT_FALSE(fs::exists(folder_ / "executed"));
  const Outcome allowed = mlab("run m.mdl --headless --proceed --allow-native");
  EXPECT_EQ(allowed.status, 2);
  EXPECT_TRUE(has(allowed.err, "`./evil` is no robot program: it ended with")) << allowed.err;
  EXPECT_FALSE(fs::exists(folder_ / "executed")) << "in its cell it writes nothing";
  const Outcome free = mlab("run m.mdl --headless --proceed --allow-native --no-cell");
  EXPECT_EQ(free.status, 2);
  EXPECT_TRUE(has(free.err, "`./evil` is no robot program: it ended with exit status 0")) << free.err;
  EXPECT_TRUE(fs::exists(folder_ / "executed")) << "the twin: it would have";
}

TEST_F(Command, WhatCodeOfAMissionMayUseUpIsSaidByOptions) {
  write("map.odl", kMap);
  write("greedy.cnl", R"(init
#include <chrono>
#include <ctime>
#include <thread>
#include <vector>
iend
procedure Vector Greedy with
  double what;
header
  bool is_first = true;
body
  if (is_first && what == 1.0) { std::vector<char> room(std::size_t{200} << 20, 'x'); output.x = room.back(); }
  if (is_first && what == 2.0) while (std::clock() < CLOCKS_PER_SEC) output.x += 1.0;
  if (is_first && what == 3.0) std::this_thread::sleep_for(std::chrono::seconds(1));
  is_first = false;
  output = {1.0, 0.0, 0.0};
pend
parameter double what = 0;
node greedy is Greedy with what = what; nend
node wheels is Drive with v = greedy; nend
)");
  struct Case {
    int what;
    std::string too_little;
    std::string enough;
    std::string told;
  };
  for (const Case& one :
       {Case{1, "--cell-memory 150", "--cell-memory 300", "needed more than 150 MB of memory"},
        Case{2, "--cell-time 0.3", "--cell-time 1.5",
             "did not come to an end within 0.3 s of processor time"},
        Case{3, "--cell-wait 0.3", "--cell-wait 5", "gave no answer for 0.3 s"}}) {
    write("m.mdl", "OVERLAY map.odl\nNEW-ROBOT g \"greedy.cnl\" (what = " + std::to_string(one.what) +
                       ")\nUNIT <u> g\nCOMMAND LIST:\n0. UNIT u START Here\n");
    const Outcome refused = mlab("run m.mdl --headless --proceed --for 2 " + one.too_little);
    EXPECT_EQ(refused.status, 1) << refused.out << refused.err;
    EXPECT_TRUE(has(refused.out + refused.err, one.told)) << refused.out << refused.err;
    const Outcome let = mlab("run m.mdl --headless --proceed --for 2 " + one.enough);
    EXPECT_EQ(let.status, 0) << let.out << let.err;
  }
  for (const char* option : {"--cell-memory 0", "--cell-memory x", "--cell-time 0", "--cell-time nan",
                             "--cell-wait -1", "--cell-wait 1e99"}) {
    for (const char* command : {"run m.mdl --headless ", "edit "}) {
      const Outcome o = mlab(std::string(command) + option);
      EXPECT_EQ(o.status, 2) << command << option;
      EXPECT_TRUE(has(o.err, std::string(option).substr(0, std::string(option).find(' ')))) << o.err;
    }
  }
}

TEST_F(Command, HasNoWayToLoadCode) {
  const auto loads = [](const std::string& program) {
    const std::string command = "nm -D '" + program + "' | grep -qw dlopen";
    return std::system(command.c_str()) == 0;  // NOLINT(concurrency-mt-unsafe): the test has one thread
  };
  EXPECT_FALSE(loads(MLAB_COMMAND));
  EXPECT_TRUE(loads(fs::path(MLAB_COMMAND).parent_path() / "mlab-robots")) << "which runs in a cell";
}

TEST_F(Command, BuildMakesAnExecutableThatRunsAsTheNetworkDoes) {
  write("map.odl", kMap);
  write("walker.cnl",
        "parameter double pace = 1;\nnode noise is Noise with persistence = 3; nend\n"
        "node on is ScaleVector with v = noise; multiplier = pace; nend\n"
        "node wheels is Drive with v = on; base_velocity = 1; max_velocity = 9; nend\n");
  const auto mission = [](const std::string& program) {
    return "OVERLAY map.odl\nNEW-ROBOT w \"" + program +
           "\" (pace = 2)\nUNIT <u> w w w\nCOMMAND LIST:\n0. UNIT u START Here\n1. UNIT u MOVETO There\n";
  };
  write("embedded.mdl", mission("walker.cnl"));
  write("native.mdl", mission("./walker"));
  const Outcome built = mlab("build walker.cnl");
  ASSERT_EQ(built.status, 0) << built.err;
  EXPECT_TRUE(has(built.out, "walker: 2 of 2 files compiled")) << built.out;
  EXPECT_TRUE(has(mlab("build walker.cnl").out, "walker: 0 of 2 files compiled"));
  EXPECT_TRUE(has(mlab("build walker.cnl --emit cpp").out, "w.behavior(\"noise\", \"Noise\")"));
  const auto robots = [&](const std::string& file, const std::string& options) {
    mlab("run " + file + " --headless --proceed --limit 60 --report r.json" + options);
    return Json::parse(text_of(folder_ / "r.json")).at("robots");
  };
  const Json embedded = robots("embedded.mdl", "");
  EXPECT_GT(embedded.at(0).at("distance_m").get<double>(), 50.0);
  EXPECT_EQ(robots("native.mdl", " --allow-native --threads 2"), embedded);
}

TEST_F(Command, BuildTellsAMistakeInTheCodeOnce) {
  write("mine.cnl",
        "procedure Vector Mine with\nheader\nbody\n  output = nonsense;\npend\n"
        "node mine is Mine with nend\nnode wheels is Drive with v = mine; nend\n");
  for (const char* what : {"build mine.cnl", "build mine.cnl --emit cpp", "build mine.cnl --emit cnl"}) {
    const Outcome built = mlab(what);
    EXPECT_EQ(built.status, 2) << what;
    const std::size_t first = built.err.find("mine.cnl:4:12: error: ");
    ASSERT_NE(first, std::string::npos) << what << ": " << built.err;
    EXPECT_EQ(built.err.find("mine.cnl:4:12", first + 1), std::string::npos) << what << ": " << built.err;
    EXPECT_EQ(built.out, "") << what;
  }
}

TEST_F(Command, RobotsThatStandBecauseOfWhatIsNoNumberFailTheirMission) {
  write("map.odl", kMap);
  write("nan.cnl",
        "procedure Vector Break with\nheader\nbody\n  output = {time > 1.0 ? NAN : 1.0, 0, 0};\npend\n"
        "node go is Break with nend\nnode wheels is Drive with v = go; base_velocity = 1; max_velocity = 1; "
        "nend\n");
  write("nan.mdl",
        "OVERLAY map.odl\nNEW-ROBOT r \"nan.cnl\"\nUNIT <u> r\nCOMMAND LIST:\n0. UNIT u START Here\n"
        "1. UNIT u MOVETO There UNTIL TIMEOUT 3\n2. UNIT u STOP\n");
  const Outcome run = mlab("run nan.mdl --headless --proceed --report r.json");
  EXPECT_EQ(run.status, 1) << run.out;
  EXPECT_EQ(Json::parse(text_of(folder_ / "r.json")).at("outcome"), "failed");
}

TEST_F(Command, BuildPutsAnExecutableInPlaceOfFilesOnly) {
  write("still.cnl", "node noise is Noise with nend\nnode wheels is Drive with v = noise; nend\n");
  ASSERT_EQ(mlab("build still.cnl").status, 0);
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  const Outcome built = mlab("build still.cnl -o pipe");
  EXPECT_EQ(built.status, 2);
  EXPECT_EQ(built.err, "mlab build: pipe can't be written; -o names another file\n");
  EXPECT_TRUE(fs::is_fifo(folder_ / "pipe"));
  fs::create_symlink("elsewhere", folder_ / "link");
  EXPECT_EQ(mlab("build still.cnl -o link").status, 0);
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_GT(fs::file_size(folder_ / "elsewhere"), 100'000U);
}

TEST_F(Command, FmtRewritesOnlyWhatIsNotInTheCanonicalLayout) {
  write("map.odl", "SITE   Test CONTROL MEASURES: PP Here 1 2 -- note\n");
  EXPECT_EQ(mlab("fmt --check map.odl").status, 1);
  EXPECT_EQ(text_of(folder_ / "map.odl"), "SITE   Test CONTROL MEASURES: PP Here 1 2 -- note\n");
  EXPECT_EQ(mlab("fmt map.odl").status, 0);
  const std::string once = text_of(folder_ / "map.odl");
  EXPECT_TRUE(has(once, "-- note"));
  EXPECT_EQ(mlab("fmt --check map.odl").status, 0);
  write("broken.odl", "CONTROL\n");
  EXPECT_EQ(mlab("fmt broken.odl").status, 2);
  EXPECT_EQ(text_of(folder_ / "broken.odl"), "CONTROL\n");
}

TEST_F(Command, CompilesLoadsAndRunsABehaviorOfTheMissionsOwn) {
  const std::string good =
      "/// Straight on.\nprocedure Vector GoOn\nwith\n  double pace = 1;\nheader\nbody\n  output = "
      "Vector{pace, 0};\npend\n"
      "parameter double pace = 1;\nnode on is GoOn with pace = pace; nend\n"
      "node wheels is Drive with v = on; base_velocity = 1; max_velocity = 9; nend\n";
  write("map.odl", kMap);
  write("mine.cnl", good);
  write("m.mdl",
        "OVERLAY map.odl\nNEW-ROBOT mine \"mine.cnl\" (pace = 3)\nUNIT <u> mine\nCOMMAND LIST:\n0. UNIT u "
        "START Here\n1. UNIT u MOVETO There\n");
  const Outcome o = mlab("run m.mdl --headless --proceed --patience 10 --report r.json");
  EXPECT_EQ(o.status, 1) << "it reports on no order, so the command fails\n" << o.err;
  EXPECT_NEAR(Json::parse(text_of(folder_ / "r.json"))["robots"][0]["distance_m"], 30.0, 1.0);

  std::string bad = good;
  bad.replace(bad.find("Vector{pace"), 11, "Vector{pcae");
  write("mine.cnl", bad);
  const Outcome wrong = mlab("run m.mdl --headless --proceed");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_TRUE(has(wrong.err, "mine.cnl:7:19: error:")) << wrong.err;
}

TEST_F(Command, RunsRobotsThatActByThemselvesForAsLongAsIsSaid) {
  write("map.odl", kMap);
  write("wander.cdl",
        "class Cart { actuator wheels: Drive(max_velocity = 2 m/s, base_velocity = 1 m/s) binds movement; }\n"
        "robot R is Cart { movement = MoveAhead(); }\n");
  const std::string mission =
      "OVERLAY map.odl\nNEW-ROBOT w \"wander.cdl\"\nUNIT <u> w\nCOMMAND LIST:\n0. UNIT u START Here\n";
  write("started.mdl", mission);
  write("sent.mdl", mission + "1. UNIT u MOVETO There\n");
  EXPECT_TRUE(has(mlab("check started.mdl").err, "[only-started]"));
  EXPECT_TRUE(has(mlab("check sent.mdl").err, "[never-reports]"));
  for (const char* file : {"started.mdl", "sent.mdl"}) {
    const Outcome o = mlab("run " + std::string(file) + " --headless --for 30 --report r.json");
    EXPECT_EQ(o.status, 0) << o.out << o.err;
    const Json report = Json::parse(text_of(folder_ / "r.json"));
    EXPECT_EQ(report.at("outcome"), "done") << file;
    EXPECT_NEAR(report.at("mission").at("simulated_s").get<double>(), 30.0, 0.2) << file;
    EXPECT_GT(report.at("robots").at(0).at("distance_m").get<double>(), 20.0) << file;
  }
  EXPECT_EQ(mlab("run sent.mdl --headless --limit 30").status, 1) << "a limit that is reached is a failure";
  EXPECT_EQ(mlab("run sent.mdl --headless --for 0").status, 2);
}

TEST_F(Command, FilesMayBeCalledAsNothingInCppIs) {
  write("map.odl", kMap);
  for (const char* name : {"class", "1st"}) {
    const std::string file = std::string(name) + ".cnl";
    write(file,
          "procedure Vector Straight\nwith\nheader\nbody\n  output = Vector{1.0, 0.0};\npend\nnode on is "
          "Straight "
          "with nend\n"
          "node wheels is Drive with v = on; base_velocity = 1; max_velocity = 9; nend\n");
    write("mission.mdl",
          "OVERLAY map.odl\nNEW-ROBOT w \"" + file + "\"\nUNIT <u> w\nCOMMAND LIST:\n0. UNIT u START Here\n");
    const Outcome o = mlab("run mission.mdl --headless --for 2");
    EXPECT_EQ(o.status, 0) << file << "\n" << o.err;
    EXPECT_EQ(mlab("check " + file).status, 0) << file;
  }
}

TEST_F(Command, DescribesTheLibraryAndItsComponents) {
  EXPECT_TRUE(has(mlab("describe").out, "MoveToGoal"));
  const Outcome one = mlab("describe MOVE_TO_GOAL");
  EXPECT_EQ(one.status, 0);
  EXPECT_TRUE(has(one.out, "success_radius"));
  EXPECT_TRUE(Json::parse(mlab("describe --format json").out)["components"].size() > 50U);
  EXPECT_TRUE(has(mlab("describe robot").out, "formation_spacing"));
  EXPECT_TRUE(has(mlab("describe MoveToGaol").err, "did you mean `MoveToGoal`?"));
  EXPECT_TRUE(has(mlab("describe nois").err, "did you mean `Noise`?"));
  EXPECT_FALSE(has(mlab("build --help").out, "formula,formula"));
}

TEST_F(Command, BenchWritesTheFiguresThatOthersCompare) {
  ASSERT_EQ(mlab("bench --robots 100 --cycles 20 --json b.json").status, 0);
  const Json figures = Json::parse(text_of(folder_ / "b.json"));
  for (const char* key : {"robot_cycles_per_second", "bytes_per_robot", "hit_share", "mean_hit_distance_m",
                          "mean_displacement_m", "seconds"}) {
    EXPECT_TRUE(figures.contains(key)) << key;
  }
}

TEST_F(Command, TheBenchmarkScenarioMeetsItsCheckValues) {
  ASSERT_EQ(mlab("bench --robots 1000 --control diffusion --json b.json").status, 0);
  const Json figures = Json::parse(text_of(folder_ / "b.json"));
  // 5.6 to 5.8 per cent, 0.70 to 0.72 m, 2.95 to 3.07 m with other positions of the same kind.
  // its spread.
  EXPECT_NEAR(figures["hit_share"], 0.057, 0.004);
  EXPECT_NEAR(figures["mean_hit_distance_m"], 0.71, 0.015);
  EXPECT_NEAR(figures["mean_displacement_m"], 3.01, 0.09);
}

}  // namespace
}  // namespace mlab
