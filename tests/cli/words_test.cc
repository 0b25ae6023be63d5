// What the command line understands by itself: near misses, standard input, completion, manual pages, `new`.

#include <sys/stat.h>

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "command.h"

namespace mlab {
namespace {

TEST_F(Command, AMisspeltCommandOrOptionIsToldWithTheNearest) {
  const Outcome command = mlab("rnu m.mdl");
  EXPECT_EQ(command.status, 2);
  EXPECT_TRUE(has(command.err, "there is no command `rnu`; did you mean `run`?")) << command.err;
  const Outcome option = mlab("run m.mdl --headles");
  EXPECT_EQ(option.status, 2);
  EXPECT_TRUE(has(option.err, "mlab run: there is no option `--headles`; did you mean `--headless`?"))
      << option.err;
  EXPECT_TRUE(has(mlab("--verison").err, "did you mean `--version`?"));
  EXPECT_FALSE(has(mlab("zzzzzz").err, "did you mean"));
}

TEST_F(Command, WhatIsMissingTooMuchOrOfTheWrongKindIsToldWithWhatIsExpected) {
  const auto expect_told = [&](const std::string& arguments, const std::string& words) {
    const Outcome o = mlab(arguments);
    EXPECT_EQ(o.status, 2) << arguments;
    EXPECT_EQ(o.err, words + "\nRun with --help for all of them.\n") << arguments;
  };
  expect_told("", "mlab: a command is missing; the first to try: mlab run MISSION.mdl");
  expect_told("compare a.mcap", "mlab compare: B.mcap is missing: another one");
  expect_told("replay a.mcap b.mcap c.mcap", "mlab replay: there is no place for `b.mcap`, `c.mcap`");
  expect_told("trace a.mcap --robot three", "mlab trace: --robot: expected a number (N), found `three`");
  expect_told("batch m.mdl --runs", "mlab batch: --runs: expected N behind it");
  expect_told("run m.mdl --limit 3 --limit 4", "mlab run: --limit is given twice: expected it once");
  expect_told("batch m.mdl --runs 3 --runs 4", "mlab batch: --runs is given twice: expected it once");
  expect_told("robot --binding simulated --at 1,2,3 --at 1,2,3",
              "mlab robot: --at is given twice: expected it once");
  expect_told("robot --binding simulated --at 1,2", "mlab robot: --at: expected X,Y,DEGREES behind it");
  expect_told("--set x=1 run m.mdl", "mlab run: expected `--set` behind the command, not in front of it");
  expect_told("run m.mdl -x", "mlab run: there is no option `-x`");
  expect_told("keys --add a --withdraw b", "mlab keys: --add excludes --withdraw");
  EXPECT_TRUE(has(mlab("run m.mdl --robots far").err, "mlab run: --robots: far not in {")) << "in words";
}

TEST_F(Command, AFileOfAnotherLanguageIsToldWithWhatTakesIt) {
  for (const char* file : {"m.mdl", "map.odl", "robot.cdl", "robot.cnl", "rocks.env"}) write(file, "");
  const auto expect_told = [&](const std::string& arguments, const std::string& words) {
    const Outcome o = mlab(arguments);
    EXPECT_EQ(o.status, 2) << arguments;
    EXPECT_EQ(o.err, words + "\n") << arguments;
  };
  expect_told(
      "run robot.cdl --headless",
      "mlab run: robot.cdl is a configuration, a robot's program; a mission names it: NEW-ROBOT robot "
      "\"robot.cdl\"");
  expect_told("run robot.cnl",
              "mlab run: robot.cnl is a network, a robot's program; a mission names it: NEW-ROBOT robot "
              "\"robot.cnl\"");
  expect_told("run map.odl --headless",
              "mlab run: map.odl is an overlay, a map; a mission names it: OVERLAY \"map.odl\"");
  expect_told(
      "run rocks.env --headless",
      "mlab run: rocks.env says how a world changes; `mlab run MISSION --environment rocks.env` takes it");
  expect_told("build m.mdl", "mlab build: m.mdl is a mission; `mlab run` carries it out");
  expect_told("edit m.mdl --no-browser", "mlab edit: m.mdl is a mission; `mlab run` carries it out");
}

TEST_F(Command, HelpOfACommandIsShownByHelpToo) {
  const Outcome help = mlab("help check");
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.out, mlab("check --help").out);
  EXPECT_EQ(mlab("help").out, mlab("--help").out);
  EXPECT_EQ(mlab("help rnu").status, 2);
}

TEST_F(Command, ADashIsStandardInput) {
  write("map.odl", kMap);
  write("m.mdl", kMission);
  const Outcome checked = mlab("check -", "cat m.mdl |");
  EXPECT_EQ(checked.status, 0) << checked.err;
  EXPECT_EQ(checked.out, "-: mission, ok\n");
  write("bad.mdl", "OVERLAY map.odl\nUNIT <u> ROBOT\nCOMMAND LIST:\n0. UNIT u START Hree\n");
  EXPECT_TRUE(has(mlab("check -", "cat bad.mdl |").err, "<stdin>:4:17: error:"));
  const Outcome run = mlab("run - --headless", "cat m.mdl |");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(has(run.out, "mission done")) << run.out;
  EXPECT_EQ(mlab("fmt -", "printf 'SITE   Test\\nCONTROL MEASURES: PP Here 1 2\\n' |").out,
            "SITE Test\n\nCONTROL MEASURES:\n\nPP Here 1 2\n");
  EXPECT_EQ(mlab("run -", "cat m.mdl |").status, 2) << "a console needs a file";
  const Outcome described = mlab("describe -", "echo 'robot Tin is Scout { movement = Stand(); }' |");
  EXPECT_TRUE(has(described.out, "Tin")) << described.out << described.err;
  EXPECT_EQ(mlab("run m.mdl --headless --environment -", "echo STEP_COUNT 5 REMOV |").status, 2);
  EXPECT_EQ(
      mlab("run m.mdl --headless --environment -", "echo STEP_COUNT 5 ADD OBSTACLE 130 103 12 |").status, 0);
  EXPECT_EQ(mlab("build -", "echo |").status, 2);
  EXPECT_FALSE(fs::exists(folder_ / "-"));
}

TEST_F(Command, APipeIsReadAndOneThatNobodyWritesToIsRefused) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe.odl").c_str(), 0600), 0);
  write("map.odl", kMap);
  const Outcome read = mlab("check pipe.odl", "(cat map.odl > pipe.odl &) ; timeout 60");
  EXPECT_EQ(read.status, 0) << read.err;
  EXPECT_EQ(read.out, "pipe.odl: overlay, ok\n");
  const Outcome refused = mlab("check pipe.odl", "timeout 60");
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(has(refused.err, "cannot read `pipe.odl`: it is a pipe, and nobody writes to it"))
      << refused.err;
}

TEST_F(Command, BashCompletesWhatTheDefinitionsOfTheOptionsSay) {
  write("m.mdl", kMission);
  write("r.json", "{}");
  const Outcome script = mlab("completion bash");
  ASSERT_EQ(script.status, 0);
  write("mlab.bash", script.out);
  const auto offers = [&](const std::string& words) {
    const std::string line = "source ./mlab.bash; COMP_WORDS=(mlab " + words +
                             "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _mlab; echo \"${COMPREPLY[@]}\"";
    write("ask.bash", line);
    return mlab("--version > /dev/null && bash ask.bash").out;
  };
  EXPECT_EQ(offers("ru"), "run\n");
  EXPECT_EQ(offers("check --format ''"), "text json\n");
  EXPECT_EQ(offers("check --format = j"), "json\n");
  EXPECT_EQ(offers("run --headl"), "--headless\n");
  EXPECT_EQ(offers("run --report ''"), "r.json\n");
  EXPECT_EQ(offers("run ''"), "m.mdl\n");
  EXPECT_EQ(offers("new ''"), "mission behavior configuration\n");
  EXPECT_EQ(offers("new mission ''"), "\n");
  EXPECT_EQ(offers("help che"), "check\n");
  EXPECT_EQ(offers("completion ''"), "bash zsh fish\n");
  for (const std::string shell : {"zsh", "fish"}) {
    const std::string text = mlab("completion " + shell).out;
    for (const char* word : {"headless", "allow-native", "configuration", "describe"})
      EXPECT_TRUE(has(text, word)) << shell << " " << word;
  }
}

TEST_F(Command, EachCommandHasAManualPageWithItsOptions) {
  ASSERT_EQ(mlab("write-shell-files share").status, 0);
  const std::string own = text_of(folder_ / "share/man/man1/mlab.1");
  for (const char* name :
       {"run", "edit", "check", "fmt", "describe", "build", "import", "bench", "lsp", "new", "help"}) {
    EXPECT_TRUE(has(own, std::string("mlab\\-") + name)) << name;
    const std::string page = text_of(folder_ / "share/man/man1" / (std::string("mlab-") + name + ".1"));
    EXPECT_TRUE(page.starts_with(".TH MLAB\\-")) << name;
    const std::string help = mlab(std::string(name) + " --help").out;
    for (std::size_t at = help.find("--"); at != std::string::npos; at = help.find("--", at + 2)) {
      std::string option = help.substr(at + 2, help.find_first_of(" ,\n", at) - at - 2);
      for (std::size_t i = 0; (i = option.find('-', i)) != std::string::npos; i += 2) option.insert(i, "\\");
      EXPECT_TRUE(has(page, "\\-\\-" + option)) << name << " " << option;
    }
  }
  EXPECT_TRUE(has(text_of(folder_ / "share/man/man1/mlab-check.1"), "text|json"));
}

TEST_F(Command, WhatNewMakesIsInTheCanonicalLayoutAndRuns) {
  for (const std::string kind : {"mission", "behavior", "configuration"}) {
    const std::string name = "my/first_" + kind;
    const Outcome made = mlab("new " + kind + " " + name);
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_TRUE(made.err.empty()) << made.err;
    const Outcome checked = mlab("check --strict " + name + ".*");
    EXPECT_EQ(checked.status, 0) << checked.err;
    EXPECT_EQ(mlab("fmt --check " + name + ".*").status, 0);
    const Outcome run = mlab("run " + name + ".mdl --headless");
    EXPECT_EQ(run.status, 0) << run.out << run.err;
    EXPECT_TRUE(has(run.out, "mission done")) << run.out;
    EXPECT_TRUE(has(run.out, " 0 collisions")) << run.out;
  }
}

TEST_F(Command, WritesThroughALinkToWhatIsNotThereYet) {
  write("map.odl", kMap);
  write("m.mdl", kMission);
  fs::create_symlink("later.csv", folder_ / "linked.csv");
  const Outcome out = mlab("batch m.mdl --runs 1 --table linked.csv");
  EXPECT_EQ(out.status, 0) << out.err;
  EXPECT_TRUE(fs::is_symlink(folder_ / "linked.csv"));
  EXPECT_TRUE(has(text_of(folder_ / "later.csv"), "done"));
}

TEST_F(Command, FmtWritesThroughALinkAndKeepsTheModeOfTheFile) {
  write("kept.cdl", "assemblage   A() {\n Noise();\n}\n");
  const fs::perms shared = fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_write;
  fs::permissions(folder_ / "kept.cdl", shared);
  fs::create_symlink("kept.cdl", folder_ / "linked.cdl");
  EXPECT_EQ(mlab("fmt linked.cdl").status, 0);
  EXPECT_TRUE(fs::is_symlink(folder_ / "linked.cdl"));
  EXPECT_EQ(text_of(folder_ / "kept.cdl"), "assemblage A() {\n  Noise();\n}\n");
  EXPECT_EQ(fs::status(folder_ / "kept.cdl").permissions(), shared);
}

TEST_F(Command, NewLeavesWhatIsThereAndRefusesNamesThatWouldNotWork) {
  write("town.odl", "mine");
  const Outcome there = mlab("new mission town");
  EXPECT_EQ(there.status, 2);
  EXPECT_TRUE(has(there.err, "town.odl is there already")) << there.err;
  EXPECT_EQ(text_of(folder_ / "town.odl"), "mine");
  EXPECT_FALSE(fs::exists(folder_ / "town.mdl"));
  EXPECT_TRUE(has(mlab("new behavior move_to_goal").err, "has a `MoveToGoal` already"));
  for (const char* name : {"1st", "'a b'", "../", "'x\"y'"})
    EXPECT_EQ(mlab(std::string("new mission ") + name).status, 2) << name;
  // Words of the languages are names like others.
  for (const char* name : {"unit", "robot", "sequence"}) {
    ASSERT_EQ(mlab(std::string("new configuration ") + name).status, 0) << name;
    const Outcome checked = mlab(std::string("check ") + name + ".*");
    EXPECT_EQ(checked.status, 0) << checked.err;
  }
}

TEST_F(Command, WhereThePageIsMissingTheConsoleSaysWhyAndAllElseWorks) {
  // An installation of the command alone.
  fs::create_directories(folder_ / "bin");
  fs::copy_file(MLAB_COMMAND, folder_ / "bin" / "mlab");
  write("map.odl", kMap);
  write("m.mdl", kMission);
  const auto alone = [&](const std::string& arguments) {
    return mlab("--version > /dev/null && ./bin/mlab " + arguments);
  };
  const Outcome console = alone("run m.mdl --no-browser --port 0");
  EXPECT_EQ(console.status, 2);
  EXPECT_TRUE(has(console.err, "there is no page to show")) << console.err;
  EXPECT_TRUE(has(console.err, "--headless")) << console.err;
  EXPECT_EQ(alone("edit --no-browser --port 0").status, 2);
  EXPECT_EQ(alone("run m.mdl --headless").status, 0);
  EXPECT_EQ(alone("check m.mdl map.odl").status, 0);
  // The launcher leaves what npm said.
  fs::create_directories(folder_ / "share" / "mlab");
  write("share/mlab/web_missing.txt", "npm error code ENOTFOUND\n");
  EXPECT_TRUE(has(alone("run m.mdl --no-browser --port 0").err, "npm error code ENOTFOUND"));
}

TEST_F(Command, QuietlyARunSaysWhyItFailed) {
  write("map.odl", std::string(kMap) + "WALL w 130 0 130 1000\n");
  write("m.mdl", kMission);
  const Outcome o = mlab("run m.mdl --headless --quiet --patience 20");
  EXPECT_EQ(o.status, 1);
  EXPECT_TRUE(has(o.out, "step 1: unit u MOVETO There failed: no progress for 20 s")) << o.out;
  EXPECT_FALSE(has(o.out, "step 0")) << o.out;
}

TEST_F(Command, ARobotThatTheEdgeOfTheAreaHoldsIsSaidToBeHeldByIt) {
  write("map.odl", "SITE Test\nMISSION-AREA 200 200\nCONTROL MEASURES:\nPP Here 100 100\nPP There 300 100\n");
  write("mission.mdl", kMission);
  const Outcome o = mlab("run mission.mdl --headless --patience 30 --set plans_ways=0");
  EXPECT_EQ(o.status, 1);
  EXPECT_TRUE(has(o.out, "edge of the mission area to the east")) << o.out;
  EXPECT_FALSE(has(o.out, "to the west")) << o.out;
  const Outcome planned = mlab("run mission.mdl --headless --patience 30");
  EXPECT_EQ(planned.status, 0) << "it is as near as it can be";
  EXPECT_TRUE(has(planned.out,
                  "Way: the mission area ends before (300, 100); (199.5, 100.0) is the nearest place to it"))
      << planned.out;
}

TEST_F(Command, AUnitThatGetsNowhereFailsTheMissionAndIsNamed) {
  write("map.odl", std::string(kMap) + "WALL w 130 0 130 1000\n");
  write("m.mdl", kMission);
  for (const char* plans : {"0", "1"}) {
    const Outcome o =
        mlab("run m.mdl --headless --proceed --patience 20 --set plans_ways=" + std::string(plans));
    EXPECT_EQ(o.status, 1);
    EXPECT_TRUE(has(o.out, "no progress for 20 s; robot 1 at (")) << o.out;
    EXPECT_TRUE(has(o.out, *plans == '0' ? "from_obstacles" : "Way: no way to")) << o.out;
  }
}

TEST_F(Command, RepeatedWarningsAreCounted) {
  write("map.odl", kMap);
  std::string text = "OVERLAY map.odl\nUNIT <u>";
  for (int i = 0; i < 60; ++i) text += " ROBOT";
  text += "\nCOMMAND LIST:\n";
  for (int i = 0; i < 40; ++i) text += std::to_string(i) + ". UNIT u START Here\n";
  write("m.mdl", text);
  const Outcome o = mlab("run m.mdl --headless --quiet --proceed");
  const auto lines = std::ranges::count(o.out, '\n');
  EXPECT_LT(lines, 60) << o.out;
  EXPECT_TRUE(has(o.out, " more like: robot ")) << o.out;
}

TEST_F(Command, WhatWasWarnedOfAtTheStartIsSaidAgainAtTheEnd) {
  write("map.odl", kMap);
  write("m.mdl",
        "OVERLAY map.odl\nNEW-ROBOT r \"robot\" blue (base_velosity = 1, formation_spcing = 2)\nUNIT <u> "
        "r\nCOMMAND "
        "LIST:\n0. UNIT u START Here\n");
  for (const char* quiet : {"", " --quiet"}) {
    const Outcome o = mlab(std::string("run m.mdl --headless") + quiet);
    EXPECT_EQ(o.status, 0) << o.err;
    const std::size_t summary = o.out.find("done after");
    ASSERT_NE(summary, std::string::npos) << o.out;
    const std::string rest = o.out.substr(summary);
    EXPECT_TRUE(has(rest, "2 warnings:")) << rest;
    EXPECT_TRUE(has(rest, "base_velosity") && has(rest, "formation_spcing")) << rest;
  }
}

TEST_F(Command, ASummarySaysWhichRobotsFailedThoughTheOthersDidAll) {
  write("map.odl", kMap);
  write("m.mdl",
        "MISSION NAME Test\nOVERLAY map.odl\nSET FAILING-ROBOTS 1\nSET FAILURES-WITHIN 5\nUNIT <u> ROBOT "
        "ROBOT\nCOMMAND LIST:\n0. UNIT u START Here 0 10\n1. UNIT u VISIT There Here\n");
  const Outcome run = mlab("run m.mdl --headless --proceed");
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(has(run.out, "all steps were done, but not by all robots")) << run.out;
  EXPECT_TRUE(has(run.out, "; it failed: its body has broken down")) << run.out;
}

}  // namespace
}  // namespace mlab
