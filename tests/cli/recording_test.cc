// Recordings of runs, as who types the commands meets them.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "command.h"

namespace mlab {
namespace {

class RecordingCommand : public Command {
 protected:
  void SetUp() override {
    Command::SetUp();
    write("map.odl", kMap);
    write("mission.mdl", kMission);
  }
  void record() {
    const Outcome run = mlab("run mission.mdl --headless --record run.mcap --report then.json");
    ASSERT_EQ(run.status, 0) << run.out << run.err;
    EXPECT_TRUE(has(run.out, "recording: run.mcap")) << run.out;
  }
};

TEST_F(RecordingCommand, AreComputedAgainWithoutTheFilesThatTheyWereMadeFrom) {
  record();
  fs::remove(folder_ / "mission.mdl");
  fs::remove(folder_ / "map.odl");
  const Outcome again = mlab("replay run.mcap --headless --report now.json --threads 2");
  EXPECT_EQ(again.status, 0) << again.out << again.err;
  EXPECT_TRUE(has(again.out, "as recorded: ")) << again.out;
  EXPECT_FALSE(has(again.out, "not as recorded")) << again.out;
  const auto without_performance = [](const std::string& report) {
    return report.substr(0, report.find("\"performance\""));
  };
  EXPECT_EQ(without_performance(text_of(folder_ / "then.json")),
            without_performance(text_of(folder_ / "now.json")));
}

TEST_F(RecordingCommand, ThatDontGoOnAreSaidToAtOnceAndTheRunGoesOn) {
  // Files of 2 KB at most, as a disk would be full then.
  const Outcome run =
      mlab("run mission.mdl --headless --speed 20 --record run.mcap", "trap '' XFSZ && ulimit -f 4 &&");
  EXPECT_EQ(run.status, 1) << run.out << run.err;
  const std::size_t alert = run.out.find("alert: the run goes on, and is not recorded any more: `run.mcap`");
  EXPECT_LT(alert, run.out.find("mission done")) << run.out;
  EXPECT_TRUE(has(run.err, "the recording is not whole")) << run.err;
}

// It was to go on for so long, and so it is done: nobody interrupted it.
TEST_F(RecordingCommand, EndAsTheRunDid) {
  const Outcome run = mlab(
      "run mission.mdl --headless --for 2 --record run.mcap --report then.json --start-time '2026-03-01 "
      "08:30'");
  ASSERT_EQ(run.status, 0) << run.out << run.err;
  const Outcome again = mlab("replay run.mcap --headless --report now.json");
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_TRUE(has(again.out, "done after 2.0 s")) << again.out;
  const auto line_with = [this](const std::string& file, const std::string& key) {
    const std::string all = text_of(folder_ / file);
    const std::size_t begin = std::min(all.find("\"" + key + "\""), all.size());
    return all.substr(begin, all.find('\n', begin) - begin);
  };
  EXPECT_TRUE(has(line_with("now.json", "mission_clock_start"), "2026-03-01T08:30:00"));
  for (const char* key : {"outcome", "mission_clock_start", "started_at"})
    EXPECT_EQ(line_with("now.json", key), line_with("then.json", key));
}

TEST_F(RecordingCommand, ThatCantBeReportedIsToldByWhoReplaysIt) {
  record();
  const Outcome full = mlab("replay run.mcap --headless --report /dev/full");
  EXPECT_EQ(full.status, 1);
  EXPECT_TRUE(has(full.err, "mlab replay: the report /dev/full could not be written: ")) << full.err;
}

TEST_F(RecordingCommand, GiveTheValueOfAnyPortInAnyCycle) {
  record();
  const Outcome trace =
      mlab("trace run.mcap --robot 1 --ports 'to_goal*' --ports noise.x --from 1 --to 2 --every 5");
  EXPECT_EQ(trace.status, 0) << trace.err;
  EXPECT_TRUE(
      trace.out.starts_with("cycle,time,robot,x,y,heading,noise.x,to_goal.x,to_goal.y,to_goal.z\n10,1,1,"))
      << trace.out;
  EXPECT_TRUE(has(trace.out, "\n20,2,1,")) << trace.out;
  EXPECT_FALSE(has(trace.out, "\n25,")) << trace.out;
}

TEST_F(RecordingCommand, SayWhatOfATraceIsNotThere) {
  record();
  const Outcome robot = mlab("trace run.mcap --robot 9");
  EXPECT_EQ(robot.status, 2);
  EXPECT_TRUE(has(robot.err, "--robot 9: there is no such robot in the whole run")) << robot.err;
  const Outcome none = mlab("trace run.mcap --ports nosuch");
  EXPECT_EQ(none.status, 2);
  EXPECT_TRUE(has(none.err, "--ports 'nosuch': no port of these robots matches")) << none.err;
  write("empty.mdl", "MISSION NAME Empty\nCOMMAND LIST:\n0. QUIT\n");
  ASSERT_EQ(mlab("run empty.mdl --headless --record empty.mcap").status, 0);
  const Outcome empty = mlab("trace empty.mcap --ports '*'");
  EXPECT_EQ(empty.status, 2);
  EXPECT_TRUE(has(empty.err, "there are no robots where this run begins")) << empty.err;
  EXPECT_FALSE(has(empty.err, "matches")) << empty.err;
  const Outcome one = mlab("trace run.mcap --ports base_velocty --ports 'to_goal*' --to 1");
  EXPECT_EQ(one.status, 0);
  EXPECT_TRUE(
      has(one.err, "--ports 'base_velocty': no port of these robots matches; did you mean `base_velocity`?"))
      << one.err;
  EXPECT_FALSE(has(one.err, "to_goal")) << one.err;
  const Outcome reversed = mlab("trace run.mcap --from 2 --to 1");
  EXPECT_EQ(reversed.status, 2);
  EXPECT_TRUE(has(reversed.err, "--from 2 --to 1: nothing lies between them")) << reversed.err;
  const Outcome late = mlab("trace run.mcap --from 100000");
  EXPECT_EQ(late.status, 0);
  EXPECT_TRUE(has(late.err, "no row: ")) << late.err;
  for (const char* wrong : {"nan", "inf", "-1", "soon"}) {
    const Outcome out = mlab(std::string("trace run.mcap --from=") + wrong);
    EXPECT_EQ(out.status, 2) << wrong;
    EXPECT_TRUE(has(out.err, std::string("expected simulated seconds, 0 or more, found `") + wrong))
        << out.err;
  }
}

TEST_F(RecordingCommand, CanNotBeMadeWhereThereIsNoFolder) {
  record();
  const Outcome again = mlab("replay run.mcap --headless --record nowhere/again.mcap");
  EXPECT_EQ(again.status, 2);
  EXPECT_EQ(again.out, "");
  EXPECT_TRUE(
      has(again.err, "--record nowhere/again.mcap: the file can't be written: there is no folder `nowhere`"))
      << again.err;
}

TEST_F(RecordingCommand, AreNotWrittenOverByWhatIsMadeOfThem) {
  record();
  const std::string before = text_of(folder_ / "run.mcap");
  fs::create_symlink("run.mcap", folder_ / "linked.json");
  for (const char* arguments :
       {"replay run.mcap --headless --report run.mcap", "replay run.mcap --headless --report linked.json",
        "compare run.mcap run.mcap --html ./run.mcap"}) {
    const Outcome out = mlab(arguments);
    EXPECT_EQ(out.status, 2) << arguments;
    EXPECT_TRUE(has(out.err, "recording itself, which would be overwritten")) << out.err;
    EXPECT_EQ(text_of(folder_ / "run.mcap"), before) << arguments;
  }
  for (const std::string& arguments :
       {std::string("replay run.mcap --headless --report new --record ./new"),
        std::string("run mission.mdl --headless --report new --record new"),
        "run mission.mdl --headless --save-percepts new --plot ../" + folder_.filename().string() + "/new"}) {
    const Outcome out = mlab(arguments);
    EXPECT_EQ(out.status, 2) << arguments;
    EXPECT_TRUE(has(out.err, "another file goes there as well")) << out.err;
    EXPECT_FALSE(fs::exists(folder_ / "new"));
  }
}

TEST_F(RecordingCommand, WritesOverNothingThatTheMissionReads) {
  std::ofstream(folder_ / "map.odl") << "SITE x\nCONTROL MEASURES:\nOBJ G 30 10 5\n";
  std::ofstream(folder_ / "on_map.mdl")
      << "OVERLAY map.odl\nUNIT <a> ROBOT\nCOMMAND LIST:\n0. UNIT a START 5 5\n";
  const std::string before = text_of(folder_ / "map.odl");
  for (const char* const option : {"--report", "--plot", "--save-percepts"}) {
    const Outcome out = mlab(std::string("run on_map.mdl --headless ") + option + " ./map.odl");
    EXPECT_EQ(out.status, 2) << option;
    EXPECT_TRUE(has(out.err, "that is the file of the mission itself, which would be overwritten"))
        << out.err;
    EXPECT_EQ(text_of(folder_ / "map.odl"), before) << option;
  }
  const Outcome page = mlab("run on_map.mdl --no-browser --report map.odl");
  EXPECT_EQ(page.status, 2);
  EXPECT_TRUE(has(page.err, "which would be overwritten")) << page.err;
  EXPECT_EQ(text_of(folder_ / "map.odl"), before);
}

TEST_F(RecordingCommand, ARobotOfTheLibraryIsNoFileOfTheMission) {
  write("wolf.mdl", "NEW-ROBOT wolf \"robot\" red\nUNIT <a> wolf\nCOMMAND LIST:\n0. UNIT a START 5 5\n");
  for (int run = 0; run < 2; ++run) {
    const Outcome out = mlab("run wolf.mdl --headless --report robot");
    EXPECT_EQ(out.status, 0) << run << out.err;
    EXPECT_TRUE(fs::exists(folder_ / "robot"));
  }
}

TEST_F(RecordingCommand, AreNeverWrittenOver) {
  record();
  const Outcome again = mlab("run mission.mdl --headless --record run.mcap");
  EXPECT_EQ(again.status, 2);
  EXPECT_TRUE(has(again.err, "a recording is never written over")) << again.err;
  EXPECT_EQ(mlab("replay run.mcap --headless --quiet").status, 0);
}

TEST_F(RecordingCommand, AreKeptWhereSomebodySaysSo) {
  record();
  EXPECT_EQ(mlab("replay run.mcap --keep").status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "run.mcap.marked"));
  EXPECT_EQ(mlab("replay run.mcap --no-keep").status, 0);
  EXPECT_FALSE(fs::exists(folder_ / "run.mcap.marked"));
  EXPECT_EQ(mlab("replay --keep").status, 2);
  EXPECT_EQ(mlab("replay mission.mdl --keep").status, 2);
  EXPECT_FALSE(fs::exists(folder_ / "mission.mdl.marked"));
}

TEST_F(RecordingCommand, ThatAreNoneAreBadInput) {
  write("text.mcap", "MISSION NAME x\n");
  const Outcome text = mlab("replay text.mcap --headless");
  EXPECT_EQ(text.status, 2);
  EXPECT_TRUE(has(text.err, "[no-mcap]")) << text.err;
  EXPECT_EQ(mlab("replay nosuch.mcap --headless").status, 2);
  EXPECT_EQ(mlab("trace text.mcap").status, 2);
  const Outcome none = mlab("replay");
  EXPECT_EQ(none.status, 0);
  EXPECT_TRUE(has(none.out, "No run of the project")) << none.out;
}

// Whatever moment that is, what stands is a run, and it is the same one.
TEST_F(RecordingCommand, OfRunsThatWereKilledAreComputedAgain) {
  const std::uint32_t seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  int compared = 0;
  for (int kill = 0; kill < 8; ++kill) {
    fs::remove(folder_ / "run.mcap");
    // The last one late enough for something to be in the file beside what people did.
    const double after = kill == 7 ? 2.6 : std::uniform_real_distribution<double>(0.05, 2.4)(random);
    mlab("run '" + kMissions + "demo_c/demo_c.mdl' --headless --proceed --speed 100 --record run.mcap",
         "timeout -s KILL " + std::to_string(after));
    if (!fs::exists(folder_ / "run.mcap")) continue;
    const Outcome again = mlab("replay run.mcap --headless --quiet");
    if (has(again.err, "[no-recording]") || has(again.err, "[no-mcap]")) continue;  // nothing had begun
    EXPECT_EQ(again.status, 0) << again.out << again.err;
    EXPECT_FALSE(has(again.out, "not as recorded")) << again.out << again.err;
    compared += has(again.out, "as recorded: ") ? 1 : 0;
  }
  EXPECT_GT(compared, 0);
}

TEST_F(RecordingCommand, ThatWereCutOffAreShownUpToThere) {
  record();
  fs::resize_file(folder_ / "run.mcap", fs::file_size(folder_ / "run.mcap") - 40);
  const Outcome cut = mlab("replay run.mcap --headless --quiet");
  EXPECT_EQ(cut.status, 0) << cut.err;
  EXPECT_TRUE(has(cut.err, "readable up to byte ")) << cut.err;
  EXPECT_TRUE(has(cut.out, "as recorded: ")) << cut.out;
}

// What is missing at the end was not recorded; what was recorded and can't be read any more is another
// matter.
TEST_F(RecordingCommand, ThatAreDamagedAreShownUpToThereAndAreNoSuccess) {
  record();
  const std::string whole = text_of(folder_ / "run.mcap");
  const std::string all = mlab("replay run.mcap --headless --quiet").out;
  const std::string as_recorded = all.substr(all.find("as recorded: "));
  int damaged = 0;
  for (std::size_t i = 1; i < 20; ++i) {
    std::string bytes = whole;
    bytes[bytes.size() * i / 20] ^= 0x10;
    write("damaged.mcap", bytes);
    const Outcome replayed = mlab("replay damaged.mcap --headless --quiet");
    if (replayed.status == 2) continue;  // its beginning can't be read
    if (replayed.status == 0) {
      EXPECT_TRUE(has(replayed.out, as_recorded)) << i << ": only what finds the entries is damaged";
      continue;
    }
    EXPECT_EQ(replayed.status, 1);
    EXPECT_TRUE(has(replayed.err, "warning: ")) << replayed.err;
    EXPECT_FALSE(has(replayed.out, "not as recorded")) << replayed.out;
    EXPECT_TRUE(has(replayed.out, "the recording is damaged")) << replayed.out;
    if (++damaged > 1) continue;
    EXPECT_EQ(mlab("trace damaged.mcap --robot 1 --ports noise.x --to 1").status, 1);
    EXPECT_EQ(mlab("compare damaged.mcap damaged.mcap --quiet").status, 1) << "nobody knows what stood there";
  }
  EXPECT_GT(damaged, 0);
}

}  // namespace
}  // namespace mlab
