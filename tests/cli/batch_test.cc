// `mlab batch`: what it says, writes and leaves behind; that its runs are those of `mlab run`.

#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "command.h"

namespace mlab {
namespace {

using Json = nlohmann::json;
using Batches = Command;

TEST_F(Batches, WriteATableAndAPage) {
  const Outcome out = mlab("batch " + kMissions +
                           "patrol/patrol.mdl --runs 20 --set base_velocity=3,5 --table t.csv "
                           "--html p.html --require 'success >= 0.7 @ 0.95'");
  EXPECT_EQ(out.status, 0) << out.err;
  EXPECT_EQ(out.err, "");
  EXPECT_TRUE(has(out.out, "Patrol: 40 runs with seeds from 1 on, 2 combinations; 0 failed")) << out.out;
  EXPECT_TRUE(has(out.out, "base_velocity=5")) << out.out;
  EXPECT_TRUE(has(out.out, "success >= 0.7 @ 0.95: met\ntable: t.csv\npage: p.html\n")) << out.out;
  const std::string table = text_of(folder_ / "t.csv");
  EXPECT_EQ(std::ranges::count(table, '\n'), 41);
  EXPECT_TRUE(table.starts_with("mission,combination,base_velocity,seed,success,outcome,duration_s,"))
      << table;
  EXPECT_TRUE(text_of(folder_ / "p.html").starts_with("<!DOCTYPE html>"));
  EXPECT_FALSE(fs::exists(folder_ / "t.csv.runs"));
}

// As on a full disk; the limit's signal would end it.
TEST_F(Batches, TellThatNothingCanBeWrittenAndWhy) {
  const std::string patrol = kMissions + "patrol/patrol.mdl";
  const Outcome out = mlab("batch " + patrol + " --runs 60 --table t.csv --html p.html", "ulimit -f 8; ");
  EXPECT_EQ(out.status, 1) << out.err;
  EXPECT_TRUE(has(out.err, "t.csv.runs could not be written; no more runs are begun")) << out.err;
  EXPECT_FALSE(fs::exists(folder_ / "t.csv"));
  const Outcome run = mlab("run " + patrol + " --headless --proceed --quiet --plot p.svg", "ulimit -f 4; ");
  EXPECT_EQ(run.status, 1) << run.err;
  EXPECT_TRUE(has(run.err, "p.svg could not be written: File too large")) << run.err;
  EXPECT_FALSE(fs::exists(folder_ / "p.svg"));
}

// Of missions of all kinds: with programs of their own, with obstacles by seed, with questions.
TEST_F(Batches, HaveTheRunsThatRunHas) {
  write(
      "field.mdl",
      "MISSION NAME Field\nOVERLAY map.odl\nSET OBSTACLE-COVERAGE 3\nCREATE-OBSTACLES\nUNIT <u> ROBOT ROBOT\n"
      "COMMAND LIST:\n0. UNIT u START Here 5 0\n1. UNIT u OCCUPY There\n");
  write("map.odl", kMap);
  for (const std::string& mission :
       {kMissions + "demo_c/demo_c.mdl", kMissions + "forage/forage.mdl", kMissions + "ugv/ugv.mdl",
        base::source_folder() + "/examples/14_behavior/pond.mdl", std::string("field.mdl")}) {
    const std::string common = " --start-time '2026-03-01 08:30' --limit 2000";
    const Outcome batch = mlab("batch " + mission + " --runs 3 --seed 41 --table t.json" + common);
    ASSERT_EQ(batch.status, 0) << batch.out << batch.err;
    const Json table = Json::parse(text_of(folder_ / "t.json"));
    for (int i = 0; i < 3; ++i) {
      const Json& row = table["runs"][static_cast<std::size_t>(i)];
      EXPECT_EQ(row["seed"], 41 + i);
      const Outcome run = mlab("run " + mission + " --headless --proceed --quiet --report r.json --seed " +
                               std::to_string(41 + i) + common);
      const Json report = Json::parse(text_of(folder_ / "r.json"));
      EXPECT_EQ(row["outcome"], report["outcome"]) << mission;
      EXPECT_EQ(row["duration_s"], report["mission"]["simulated_s"]) << mission;
      double distance = 0.0;
      int contacts = 0;
      for (const Json& robot : report["robots"]) {
        distance += robot["distance_m"].get<double>();
        contacts += robot["collisions"].get<int>();
      }
      EXPECT_NEAR(row["distance_m"].get<double>(), distance, 1e-5) << mission << run.err;
      EXPECT_EQ(row["contacts"], contacts) << mission;
      EXPECT_EQ(row["deliveries"], report["deliveries"].size()) << mission;
    }
  }
}

TEST_F(Batches, SayHowAFailureIsRepeated) {
  const Outcome out = mlab("batch " + kMissions +
                           "patrol/patrol.mdl --runs 2 --set base_velocity=0 --patience 60 "
                           "--start-time '2026-03-01 08:30' --table t.csv");
  EXPECT_EQ(out.status, 0) << out.err;
  EXPECT_TRUE(has(out.out, "2 x step 1: unit scouts MOVETO Gate (Column): no progress")) << out.out;
  const std::string command = "run " + kMissions +
                              "patrol/patrol.mdl --headless --proceed --seed 1 --set base_velocity=0 "
                              "--start-time 2026-03-01T08:30:00 --patience 60";
  EXPECT_TRUE(has(out.out, "mlab " + command)) << out.out;
  EXPECT_TRUE(has(text_of(folder_ / "t.csv"), command));
  const Outcome again = mlab(command);
  EXPECT_EQ(again.status, 1);
  EXPECT_TRUE(has(again.out, "no progress for 60 s")) << again.out;
}

// A batch of which both runs fail, each with a page and a table of this name.
std::string failing(const std::string& name) {
  return "batch " + kMissions +
         "patrol/patrol.mdl --runs 2 --set base_velocity=0 --patience 60 --start-time '2026-03-01 08:30' "
         "--quiet --table '" +
         name + ".json' --html '" + name + ".html'";
}

TEST_F(Batches, RecordOneRunOfEachCause) {
  const Outcome out = mlab(failing("out"));
  EXPECT_EQ(out.status, 0) << out.err;
  EXPECT_TRUE(has(out.out, "recordings: out.failures/\n")) << out.out;
  const std::string file = "out.failures/seed-1.mcap";
  const Outcome replay = mlab("replay --headless " + file);
  EXPECT_EQ(replay.status, 0) << replay.err;
  EXPECT_TRUE(has(replay.out, "as recorded: ")) << replay.out;
  const Json table = Json::parse(text_of(folder_ / "out.json"));
  EXPECT_EQ(table["runs"][0]["recording"], file);
  EXPECT_TRUE(table["runs"][1]["recording"].is_null());
  ASSERT_EQ(table["summary"]["failures"].size(), 1U);
  EXPECT_EQ(table["summary"]["failures"][0]["runs"], 2);
  EXPECT_EQ(table["summary"]["failures"][0]["recording"], file);
  const std::string page = text_of(folder_ / "out.html");
  EXPECT_TRUE(has(page, "<a href=\"./out.failures/seed-1.mcap\">its recording</a>")) << page;
  EXPECT_TRUE(has(page, "<code>mlab replay out.failures/seed-1.mcap</code>"));
  // Nothing is written over.
  const std::string before = text_of(folder_ / file);
  EXPECT_EQ(mlab(failing("out")).status, 0);
  EXPECT_EQ(text_of(folder_ / file), before);
  EXPECT_TRUE(has(text_of(folder_ / "out.html"), "out.failures/seed-1-2.mcap"));
}

TEST_F(Batches, RecordUnderAnyName) {
  const std::string name = "a <b> \"c\" #1 %20 &amp;";
  EXPECT_EQ(mlab(failing(name)).status, 0);
  const std::string page = text_of(folder_ / (name + ".html"));
  EXPECT_TRUE(has(page, "href=\"./a%20%3Cb%3E%20%22c%22%20%231%20%2520%20%26amp%3B.failures/seed-1.mcap\""))
      << page;
  EXPECT_TRUE(has(page, "mlab replay &#39;a &lt;b&gt;") || has(page, "mlab replay 'a &lt;b&gt;")) << page;
  EXPECT_EQ(mlab("replay --headless '" + name + ".failures/seed-1.mcap'").status, 0);
}

TEST_F(Batches, RecordNothingWhereNothingFailsOrNobodyWantsIt) {
  EXPECT_EQ(mlab("batch " + kMissions + "patrol/patrol.mdl --runs 1 --html ok.html").status, 0);
  EXPECT_FALSE(fs::exists(folder_ / "ok.failures"));
  EXPECT_EQ(mlab(failing("out") + " --recordings none").status, 0);
  EXPECT_FALSE(fs::exists(folder_ / "out.failures"));
  EXPECT_FALSE(fs::exists(folder_ / "none"));
  EXPECT_EQ(mlab(failing("out") + " --recordings 'some where/else'").status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "some where/else/seed-1.mcap"));
  write("file", "mine");
  const Outcome refused = mlab(failing("out") + " --recordings file");
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(has(refused.err, "--recordings file: that is no folder")) << refused.err;
  EXPECT_EQ(text_of(folder_ / "file"), "mine");
}

// A folder that can't be made, as a disk that is full or read only: the table is there all the same.
TEST_F(Batches, SayThatTheyCouldNotRecord) {
  const Outcome out = mlab(failing("out") + " --recordings /proc/none/x");
  EXPECT_EQ(out.status, 1);
  EXPECT_TRUE(has(out.err, "mlab batch: there can't be a folder /proc/none/x")) << out.err;
  EXPECT_TRUE(Json::parse(text_of(folder_ / "out.json"))["runs"][0]["recording"].is_null());
}

TEST_F(Batches, LetRobotsFailByTheSeed) {
  const Outcome out =
      mlab("batch " + kMissions +
           "patrol/patrol.mdl --runs 4 --set FAILING-ROBOTS=0,1 --set FAILURES-WITHIN=20 --patience "
           "60 --table t.json --quiet");
  EXPECT_EQ(out.status, 0) << out.err;
  const Json table = Json::parse(text_of(folder_ / "t.json"));
  ASSERT_EQ(table["runs"].size(), 8U);
  for (int i = 0; i < 8; ++i) {
    const Json& row = table["runs"][static_cast<std::size_t>(i)];
    EXPECT_EQ(row["faults"], i < 4 ? 0 : 1) << row.dump();
    if (i < 4) {
      EXPECT_EQ(row["outcome"], "done") << row.dump();
    }
  }
  for (const Json& group : table["summary"]["failures"]) {
    EXPECT_TRUE(has(group["cause"], "robots that it waits for do not run")) << group.dump();
    const Outcome replay = mlab("replay --headless '" + group["recording"].get<std::string>() + "'");
    EXPECT_EQ(replay.status, 0) << replay.err;
    EXPECT_TRUE(has(replay.out, "its body has broken down")) << replay.out;
  }
}

TEST_F(Batches, EndAsTheirRequirementsDo) {
  const std::string patrol = "batch " + kMissions + "patrol/patrol.mdl --quiet --runs 10 --require ";
  EXPECT_EQ(mlab(patrol + "'success >= 0.6'").status, 0);
  // Ten of ten are not enough to know that.
  const Outcome unmet = mlab(patrol + "'success >= 0.95 @ 0.99'");
  EXPECT_EQ(unmet.status, 1);
  EXPECT_EQ(unmet.out, "success >= 0.95 @ 0.99: not met (58.9 to 100 %)\n");
}

TEST_F(Batches, StopOnceAllIsDecided) {
  const Outcome out = mlab("batch " + kMissions +
                           "patrol/patrol.mdl --runs 2000 --require 'success >= 0.5' --until "
                           "decided --table t.csv");
  EXPECT_EQ(out.status, 0) << out.err;
  EXPECT_LT(std::ranges::count(text_of(folder_ / "t.csv"), '\n'), 30);
}

TEST_F(Batches, GoOnAfterTheyWereKilled) {
  const std::string batch = "batch " + kMissions +
                            "demo_c/demo_c.mdl --runs 40 --threads 2 --start-time '2026-03-01 "
                            "08:30' --set base_velocity=4,5 --quiet --table ";
  ASSERT_EQ(mlab(batch + "whole.csv").status, 0);
  int killed = 0;
  Outcome out;
  for (int i = 0; i < 60; ++i) {
    // Each time it has a little more time, so that it comes to an end on any machine.
    out = mlab(batch + "t.csv --resume", "timeout -s KILL " + std::to_string(0.2 + 0.1 * i));
    if (out.status == 0) break;
    ++killed;
    // `timeout` kills itself as well: the other one may still be on its way out.
    Outcome other = mlab(batch + "t.csv");
    for (int again = 0; again < 100 && has(other.err, "is in use by another batch"); ++again)
      other = mlab(batch + "t.csv");
    // Nothing was kept yet, and this one did it all; or it is refused.
    if (other.status == 0) break;
    EXPECT_TRUE(has(other.err, "--resume goes on with them")) << other.err;
  }
  EXPECT_GT(killed, 0);
  EXPECT_EQ(text_of(folder_ / "t.csv"), text_of(folder_ / "whole.csv"));
  EXPECT_FALSE(fs::exists(folder_ / "t.csv.runs"));
}

TEST_F(Batches, KeepWhatIsDoneWhereSomebodyWantsAnEnd) {
  const std::string batch = "batch " + kMissions + "demo_c/demo_c.mdl --runs 100000 --table t.csv";
  const Outcome out = mlab(batch, "timeout -s INT 1.5");
  EXPECT_TRUE(has(out.err, "of 100000 runs; they are kept in t.csv.runs, and --resume goes on")) << out.err;
  EXPECT_TRUE(fs::exists(folder_ / "t.csv.runs"));
  EXPECT_FALSE(fs::exists(folder_ / "t.csv"));
  const Outcome other = mlab(batch + " --seed 2 --resume");
  EXPECT_EQ(other.status, 2);
  EXPECT_TRUE(has(other.err, "holds runs of another batch: its seed is `1`, here it is `2`")) << other.err;
}

// Told to end once the first recording is there.
TEST_F(Batches, FinishRecordingsThatWereInterrupted) {
  const std::string batch = "batch " + kMissions +
                            "demo_c/demo_c.mdl --runs 60 --set FAILING-ROBOTS=1 --set FAILURES-WITHIN=400 "
                            "--start-time '2026-01-01 08:00' --patience 60 --quiet --table t.json";
  ASSERT_EQ(mlab(batch).status, 0);
  const std::string whole = text_of(folder_ / "t.json");
  Outcome out{0, "", ""};
  for (int i = 0; i < 20 && out.status == 0; ++i) {
    fs::remove_all(folder_ / "t.failures");
    fs::remove(folder_ / "t.json");
    // The shell lets what it starts beside it ignore SIGINT.
    write("begin.sh",
          "\"$@\" & while kill -0 $! && ! ls t.failures/*.mcap; do :; done 2> none.txt "
          ">&2; kill $!; wait $!");
    out = mlab(batch, "sh begin.sh");
  }
  EXPECT_EQ(out.status, 1);
  EXPECT_TRUE(has(out.err, "interrupted after all 60 runs with ")) << out.err;
  EXPECT_TRUE(has(out.err, "the runs are kept in t.json.runs, and --resume goes on")) << out.err;
  EXPECT_FALSE(fs::exists(folder_ / "t.json"));
  for (const auto& entry : fs::directory_iterator(folder_ / "t.failures"))
    EXPECT_EQ(mlab("replay --headless '" + entry.path().string() + "'").status, 0) << entry.path();
  EXPECT_EQ(mlab(batch + " --resume").status, 0);
  EXPECT_EQ(text_of(folder_ / "t.json"), whole);
  EXPECT_FALSE(fs::exists(folder_ / "t.json.runs"));
}

TEST_F(Batches, CompareTwoVersions) {
  write("map.odl", kMap);
  write("a.mdl", kMission);
  write("b.mdl", std::string(kMission) + "2. UNIT u MOVETO Here\n");
  const Outcome out = mlab("batch a.mdl --against b.mdl --runs 12");
  EXPECT_EQ(out.status, 0) << out.err;
  EXPECT_TRUE(
      has(out.out, "in 12 pairs: only the mission succeeds in 0, only the other in 0 (McNemar: p = 1)"))
      << out.out;
  EXPECT_TRUE(has(out.out, "12 pairs different (signed ranks: p = 0.00049)")) << out.out;
}

TEST_F(Batches, AreDefinedInAFileThatIsChecked) {
  fs::create_directory(folder_ / "study");
  write("study/map.odl", kMap);
  write("study/m.mdl", kMission);
  write("study/study.toml",
        "mission = \"m.mdl\"\nruns = 4\ntable = \"t.csv\"\n[set]\nbase_velocity = [3, 5]\n");
  const Outcome check = mlab("check study/study.toml");
  EXPECT_EQ(check.status, 0) << check.err;
  EXPECT_EQ(check.out, "study/study.toml: study, ok\n");
  const Outcome out = mlab("batch study/study.toml --runs 6 --set base_velocity=4");
  EXPECT_EQ(out.status, 0) << out.err;
  EXPECT_EQ(std::ranges::count(text_of(folder_ / "study/t.csv"), '\n'), 7);

  write("study/study.toml", "mission = \"m.mdl\"\n[set]\nbase_velocty = [3, 5]\n");
  const Outcome wrong = mlab("check study/study.toml");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_TRUE(has(wrong.err, "study/study.toml:3:1: error: program `robot` has no parameter `base_velocty`"))
      << wrong.err;
}

TEST_F(Batches, RefuseWhatTheyCanNotDo) {
  write("map.odl", kMap);
  write("m.mdl", kMission);
  const auto told = [&](const std::string& arguments) {
    const Outcome out = mlab("batch " + arguments);
    EXPECT_EQ(out.status, 2) << arguments << out.out;
    return out.err;
  };
  EXPECT_TRUE(has(told("missing.mdl"), "missing.mdl"));
  EXPECT_TRUE(has(told("m.mdl --table m.mdl"), "that is the mission itself, which would be overwritten"));
  EXPECT_TRUE(has(told("m.mdl --table x.json --results x.json"), "another file goes there as well"));
  EXPECT_TRUE(
      has(told("m.mdl --table x.json --results ./x.json"), "./x.json: another file goes there as well"));
  EXPECT_TRUE(has(told("m.mdl --table x.txt"), "--table x.txt: expected FILE.csv or FILE.json"));
  EXPECT_TRUE(
      has(told("m.mdl --table -"), "--table -: expected FILE.csv or FILE.json; it is written to a file"));
  EXPECT_TRUE(has(told("m.mdl --html -"), "--html -: expected FILE.html"));
  EXPECT_TRUE(has(told("m.mdl --table x.csv --resume --merge"), "expected one of them"));
  EXPECT_TRUE(has(told("m.mdl --set seed=7,8"), "`seed` can't be set: the table has a column of this name"));
  EXPECT_TRUE(has(told("m.mdl --set duration_s=7"), "`duration_s` can't be set"));
  EXPECT_TRUE(has(told("m.mdl --table none/x.csv"),
                  "none/x.csv: the file can't be written: there is no folder `none`"));
  EXPECT_TRUE(has(told("m.mdl --html m.mdl/x.html"), "the file can't be written: `m.mdl` is no folder"));
  fs::create_directory(folder_ / "folder.csv");
  EXPECT_TRUE(has(told("m.mdl --table folder.csv"), "the file can't be written: it is a folder"));
  const std::string long_name(300, 'x');
  EXPECT_TRUE(has(told("m.mdl --table " + long_name + ".csv"), "File name too long"));
  fs::create_symlink("none/later.csv", folder_ / "linked.csv");
  EXPECT_TRUE(has(told("m.mdl --table linked.csv"), "there is no folder `none`"));
  EXPECT_TRUE(has(told("m.mdl --resume"), "which batch?"));
  EXPECT_TRUE(has(told("m.mdl --runs 0"), "expected a whole number from 1"));
  EXPECT_TRUE(has(told("m.mdl --set base_velocity=2,fast"), "fast"));
  EXPECT_FALSE(has(told("m.mdl --set base_velocity=2,fast"), "no robot of the mission")) << "they have one";
  EXPECT_TRUE(has(told("m.mdl --set base_velocity=2 --set base_velocity=3"), "`base_velocity` is set twice"));
  EXPECT_TRUE(has(told("m.mdl --set OBSTACLE-COVERAGE=1..90"), "goes from 0 to 30"));
  EXPECT_TRUE(has(told("m.mdl --start-time soon"), "--start-time:1:1: error: expected YYYY-MM-DD"));
  write("late.toml", "mission = \"m.mdl\"\nstart-time = \"2026-02-30 08:00\"\n");
  EXPECT_TRUE(has(told("late.toml"), "late.toml:2:15: error: expected YYYY-MM-DD"));
  EXPECT_TRUE(has(mlab("check late.toml").err, "late.toml:2:15: error: expected YYYY-MM-DD"));
  write("none.toml", "runs = 2\n");
  EXPECT_TRUE(has(told("none.toml"), "none.toml:1:1: error: no mission is named"));
  EXPECT_TRUE(has(told("-"), "expected a file"));
  EXPECT_EQ(text_of(folder_ / "m.mdl"), kMission);
}

TEST_F(Batches, SetForASingleRunWhatTheySet) {
  write("map.odl", kMap);
  write("m.mdl", kMission);
  const Outcome slow = mlab("run m.mdl --headless --quiet --report r.json --set base_velocity=1");
  EXPECT_EQ(slow.status, 0) << slow.err;
  const double seconds = Json::parse(text_of(folder_ / "r.json"))["mission"]["simulated_s"];
  mlab("run m.mdl --headless --quiet --report r.json --set base_velocity=2");
  EXPECT_GT(seconds, 1.5 * Json::parse(text_of(folder_ / "r.json"))["mission"]["simulated_s"].get<double>());
  EXPECT_EQ(mlab("run m.mdl --headless --set base_velocity").status, 2);
  EXPECT_TRUE(has(mlab("run m.mdl --headless --set base_velocity=1 --set base_velocity=2").err, "set twice"));
  EXPECT_EQ(mlab("run m.mdl --headless --set nothing=1").status, 2);
  EXPECT_TRUE(has(mlab("run m.mdl --set base_velocity=1").err, "--set counts with --headless"));
}

}  // namespace
}  // namespace mlab
