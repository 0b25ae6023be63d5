// Two recordings side by side, as who types the command meets them.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "command.h"

namespace mlab {
namespace {

class CompareCommand : public Command {
 protected:
  void SetUp() override {
    Command::SetUp();
    write("map.odl", kMap);
    write("mission.mdl", kMission);
  }
  // All begin at one time, so that two seconds of the clock are not what they differ in.
  void record(const std::string& file, const std::string& options) {
    const Outcome run = mlab("run mission.mdl --headless --quiet --start-time '2026-03-01 08:30' --record " +
                             file + " " + options);
    ASSERT_EQ(run.status, 0) << run.out << run.err;
  }
};

TEST_F(CompareCommand, SaysWhereTwoSeedsPartAndWhy) {
  record("a.mcap", "--seed 1");
  record("b.mcap", "--seed 2");
  const Outcome is = mlab("compare a.mcap b.mcap --html page.html");
  EXPECT_EQ(is.status, 1) << is.err;
  EXPECT_TRUE(has(is.out, "seed:  1  2")) << is.out;
  EXPECT_TRUE(has(is.out, "`noise`")) << is.out;
  EXPECT_TRUE(has(is.out, "the seeds are 1 and 2")) << is.out;
  EXPECT_TRUE(has(is.out, "they part in cycle ")) << is.out;
  EXPECT_TRUE(has(text_of(folder_ / "page.html"), "How far apart the same robots are"));
  const Outcome other_way = mlab("compare b.mcap a.mcap --quiet");
  EXPECT_EQ(other_way.status, 1);
  EXPECT_TRUE(has(is.out, other_way.out)) << other_way.out;
}

TEST_F(CompareCommand, KnowsTheSameRun) {
  record("a.mcap", "");
  record("b.mcap", "--threads 1");
  const Outcome is = mlab("compare a.mcap b.mcap --quiet");
  EXPECT_EQ(is.status, 0) << is.out << is.err;
  EXPECT_EQ(is.out, "the same run\n");
  EXPECT_EQ(mlab("compare a.mcap a.mcap --quiet").out, "the same run\n");
}

TEST_F(CompareCommand, ShowsWhatWasChangedInTheMission) {
  record("a.mcap", "");
  const std::string text = text_of(folder_ / "mission.mdl");
  write("mission.mdl", text + "-- another line\n");
  record("b.mcap", "");
  const Outcome is = mlab("compare a.mcap b.mcap");
  EXPECT_EQ(is.status, 1);
  EXPECT_TRUE(has(is.out, "+-- another line")) << is.out;
  EXPECT_TRUE(has(is.out, "they never part, though they were not made from the same")) << is.out;
}

TEST_F(CompareCommand, GivesJson) {
  record("a.mcap", "--seed 1");
  record("b.mcap", "--seed 2");
  const Outcome is = mlab("compare a.mcap b.mcap --json");
  EXPECT_EQ(is.status, 1);
  EXPECT_TRUE(is.out.starts_with("{\n \"version\": 1,\n \"same\": false,\n")) << is.out.substr(0, 200);
}

TEST_F(CompareCommand, RefusesWhatIsNone) {
  record("a.mcap", "");
  write("text.mcap", "MISSION NAME x\n");
  EXPECT_EQ(mlab("compare a.mcap text.mcap").status, 2);
  EXPECT_EQ(mlab("compare nosuch.mcap a.mcap").status, 2);
  EXPECT_EQ(mlab("compare a.mcap").status, 2);
  const Outcome over = mlab("compare a.mcap a.mcap --html a.mcap");
  EXPECT_EQ(over.status, 2);
  EXPECT_TRUE(has(over.err, "would be overwritten")) << over.err;
}

// Cut anywhere a file is either compared up to there, or refused.
TEST_F(CompareCommand, TakesFilesThatWereCutOffAnywhere) {
  record("a.mcap", "");
  const std::string whole = text_of(folder_ / "a.mcap");
  std::size_t compared = 0;
  for (std::size_t i = 0; i < 12; ++i) {
    const std::size_t size = whole.size() * (2 * i + 1) / 24;
    write("cut.mcap", whole.substr(0, size));
    const Outcome is = mlab("compare cut.mcap a.mcap --quiet");
    // Behind the last message nothing is lost but an index.
    const bool is_usual = is.status == 1 || is.status == 2 || is.out == "the same run\n";
    EXPECT_TRUE(is_usual) << "cut at " << size << ": " << is.out << is.err;
    compared += is.status != 2 ? 1 : 0;
  }
  EXPECT_GT(compared, 0U);
}

TEST_F(CompareCommand, AVerdictOnADamagedFileComesWithTheDamage) {
  record("a.mcap", "");
  std::string whole = text_of(folder_ / "a.mcap");
  whole[whole.size() / 2] = static_cast<char>(~whole[whole.size() / 2]);
  write("damaged.mcap", whole);
  const Outcome is = mlab("compare damaged.mcap a.mcap --quiet");
  EXPECT_TRUE(has(is.err, "mlab compare: warning: damaged.mcap: ")) << is.out << is.err;
}

TEST_F(CompareCommand, RecordingsForViewersAreReplayedAndComparedLikeAllOthers) {
  record("plain.mcap", "");
  record("viewers.mcap", "--record-for viewers --viewer-rate 5");
  EXPECT_EQ(mlab("compare plain.mcap viewers.mcap --quiet").status, 0);
  const Outcome again = mlab("replay plain.mcap --headless --quiet --record made.mcap --record-for viewers");
  EXPECT_EQ(again.status, 0) << again.out << again.err;
  EXPECT_TRUE(has(again.out, "recording: made.mcap")) << again.out;
  EXPECT_GT(fs::file_size(folder_ / "made.mcap"), 2 * fs::file_size(folder_ / "plain.mcap"));
  EXPECT_EQ(mlab("compare made.mcap viewers.mcap --quiet").status, 0);
  EXPECT_EQ(mlab("replay plain.mcap --headless --record made.mcap").status, 2) << "it is there already";
  EXPECT_EQ(mlab("run mission.mdl --headless --record-for viewers").status, 2) << "without a file";
}

}  // namespace
}  // namespace mlab
