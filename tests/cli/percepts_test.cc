// Percepts of a run in a file, as who types the commands meets them.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "command.h"
#include "mlab/base/testing/source_folder.h"

namespace mlab {
namespace {

class PerceptsCommand : public Command {
 protected:
  void SetUp() override {
    Command::SetUp();
    write("map.odl",
          "SITE Test\nMISSION-AREA 300 200\nCONTROL MEASURES:\nPP Here 40 100\nPP There 160 100\n");
    write("mission.mdl", mission_with("0.5"));
  }
  // Obstacles stand where the seed says.
  static std::string mission_with(const std::string& velocity) {
    return "OVERLAY map.odl\nCREATE-OBSTACLES\nNEW-ROBOT r \"robot\" blue (base_velocity = " + velocity +
           ")\nUNIT <u> r r\nCOMMAND LIST:\n0. UNIT u START Here 0 20\n1. UNIT u MOVETO There\n";
  }
};

TEST_F(PerceptsCommand, OfARunWithAnotherSeedAreActedOnInTheSameWay) {
  const Outcome run = mlab("run mission.mdl --headless --seed 7 --save-percepts run.percepts");
  ASSERT_EQ(run.status, 0) << run.out << run.err;
  const Outcome again = mlab("run mission.mdl --headless --percepts run.percepts --threads 2");
  EXPECT_EQ(again.status, 0) << again.out << again.err;
  EXPECT_TRUE(has(again.out, "as recorded: ")) << again.out;
  EXPECT_FALSE(has(again.out, "not as recorded")) << again.out;
}

TEST_F(PerceptsCommand, KnowWhoHeardWhom) {
  const std::string mission = base::source_folder() + "/missions/out_of_reach/out_of_reach.mdl";
  ASSERT_EQ(mlab("run " + mission + " --headless --save-percepts run.percepts").status, 0);
  const Outcome again = mlab("run " + mission + " --headless --percepts run.percepts");
  EXPECT_EQ(again.status, 0) << again.out << again.err;
  EXPECT_FALSE(has(again.out, "not as recorded")) << again.out;
}

TEST_F(PerceptsCommand, SayWhichRobotsActOtherwiseAfterAChange) {
  ASSERT_EQ(mlab("run mission.mdl --headless --save-percepts run.percepts").status, 0);
  write("mission.mdl", mission_with("0.25"));
  const Outcome again = mlab("run mission.mdl --headless --percepts run.percepts");
  EXPECT_EQ(again.status, 1) << again.out;
  EXPECT_TRUE(has(again.out, "not as recorded: robot 1 in cycle ")) << again.out;
  EXPECT_TRUE(has(again.out, "not as recorded: robot 2 in cycle ")) << again.out;
  EXPECT_FALSE(has(again.out, "\nas recorded")) << again.out;
}

TEST_F(PerceptsCommand, OutOfABrokenFileStopTheRunBeforeItBegins) {
  ASSERT_EQ(mlab("run mission.mdl --headless --save-percepts run.percepts").status, 0);
  fs::resize_file(folder_ / "run.percepts", 1000);
  const Outcome cut = mlab("run mission.mdl --headless --percepts run.percepts --report r.json");
  EXPECT_EQ(cut.status, 2);
  EXPECT_TRUE(has(cut.err, "`run.percepts`: at byte ")) << cut.err;
  EXPECT_TRUE(has(cut.err, "it was cut off")) << cut.err;
  EXPECT_TRUE(cut.out.empty()) << cut.out;
  EXPECT_EQ(mlab("run mission.mdl --headless --percepts nosuch.percepts").status, 2);
  EXPECT_EQ(mlab("run mission.mdl --headless --percepts .").status, 2);
}

TEST_F(PerceptsCommand, AreNotWrittenOverWhatIsRead) {
  ASSERT_EQ(mlab("run mission.mdl --headless --save-percepts run.percepts").status, 0);
  const auto size = fs::file_size(folder_ / "run.percepts");
  const Outcome o = mlab("run mission.mdl --headless --percepts run.percepts --save-percepts ./run.percepts");
  EXPECT_EQ(o.status, 2);
  EXPECT_TRUE(has(o.err, "that is the file of --percepts itself")) << o.err;
  EXPECT_EQ(fs::file_size(folder_ / "run.percepts"), size);
  EXPECT_EQ(mlab("run mission.mdl --headless --save-percepts mission.mdl").status, 2);
  EXPECT_EQ(mlab("run mission.mdl --headless --save-percepts nosuch/run.percepts").status, 2);
}

TEST_F(PerceptsCommand, OfARunThatWasInterruptedHaveAnEnd) {
  ASSERT_EQ(mlab("run mission.mdl --headless --limit 3 --save-percepts run.percepts").status, 1);
  const Outcome again = mlab("run mission.mdl --headless --limit 3 --percepts run.percepts");
  EXPECT_TRUE(has(again.out, "\nas recorded: ")) << again.out << again.err;
}

TEST_F(PerceptsCommand, GoWithHeadless) {
  const Outcome o = mlab("run mission.mdl --save-percepts run.percepts");
  EXPECT_EQ(o.status, 2);
  EXPECT_TRUE(has(o.err, "--percepts and --save-percepts go with --headless")) << o.err;
}

}  // namespace
}  // namespace mlab
