#include "mlab/comparison/comparer.h"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mlab/comparison/report.h"
#include "mlab/comparison/testing/two_runs.h"
#include "mlab/comparison/words.h"

namespace mlab::comparison {
namespace {

using history::testing::WrittenRun;
using testing::carried_out;
using testing::compared;
using testing::has;
using testing::HistoryPtr;

constexpr const char* kDemo = "demo_c/demo_c.mdl";
constexpr const char* kCourse = "formations/formations.mdl";

std::string joined(const std::vector<std::string>& sentences) {
  std::string out;
  for (const std::string& one : sentences) out += one + "\n";
  return out;
}

bool has_page(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST(Comparer, FindsNothingInTheSameRunTwice) {
  const Comparison is = compared(carried_out(kDemo, 3, 200), carried_out(kDemo, 3, 200));
  EXPECT_TRUE(is.is_same()) << report_of(is);
  EXPECT_EQ(verdict(is), "the same run");
  EXPECT_TRUE(is.is_recomputed);
  ASSERT_EQ(is.robots.size(), 4U);
  for (const RobotRow& robot : is.robots) EXPECT_EQ(robot.most_apart, 0.0);
  for (const EventRow& event : is.events) EXPECT_TRUE(event.times[0] && event.times[1]) << event.text;
}

// Of what robots in executables hold inside nothing is recorded.
TEST(Comparer, SaysOfWhichRobotsOnlyTheAnswersWereCompared) {
  const auto answered = [] {
    WrittenRun written(kDemo, 3, true, true);
    written.run().post(mission::event::Execute{});
    for (int i = 0; i < 200; ++i) written.step();
    written.end();
    return written.history();
  };
  const Comparison is = compared(answered(), answered());
  ASSERT_TRUE(is.is_recomputed) << report_of(is);
  EXPECT_TRUE(is.is_same()) << report_of(is);
  EXPECT_EQ(verdict(is), "the same run, as far as robots' programs can be seen into");
  for (const std::string& text : {report_of(is), page_of(is, "test")}) {
    EXPECT_FALSE(has_page(text, "all values")) << text;
    EXPECT_TRUE(has_page(text, "what all robots answered and where they were is the same")) << text;
    EXPECT_TRUE(has_page(text, "Of all robots only what was answered and where they were is compared"))
        << text;
  }
  EXPECT_EQ(nlohmann::json::parse(json_of(is))["robots"][0]["are_values_compared"], false);
  // And where one of both has the programs.
  const Comparison other = compared(answered(), carried_out(kDemo, 3, 200));
  EXPECT_FALSE(has_page(report_of(other), "all values")) << report_of(other);
}

TEST(Comparer, SaysWhichRunHasARobotAlone) {
  const Comparison is = compared(carried_out(kDemo, 1, 50), carried_out("forage/forage.mdl", 1, 50));
  ASSERT_TRUE(is.is_recomputed) << report_of(is);
  const std::vector<std::string> alone = alone_words(is);
  ASSERT_EQ(alone.size(), 1U) << report_of(is);
  const std::string where = alone[0].ends_with("in A alone") ? "only in A" : "only in B";
  for (const std::string& text : {report_of(is), page_of(is, "test")}) {
    EXPECT_TRUE(has_page(text, alone[0])) << text;
    EXPECT_TRUE(has_page(text, where)) << text;
  }
}

TEST(Comparer, NamesCycleRobotAndNodeOfTwoSeeds) {
  const Comparison is = compared(carried_out(kCourse, 1, 300), carried_out(kCourse, 2, 300));
  ASSERT_TRUE(is.parting) << report_of(is);
  EXPECT_EQ(is.parting->what, Parting::What::kPort);
  EXPECT_GT(is.parting->robot, 0U);
  EXPECT_NE(is.parting->value.values[0], is.parting->value.values[1]);
  EXPECT_EQ(is.parting->value.path, "noise") << report_of(is);
  EXPECT_TRUE(has(is.parting->causes, "no value that comes into `noise` differs"))
      << joined(is.parting->causes);
  EXPECT_TRUE(has(is.parting->causes, "the seeds are 1 and 2")) << joined(is.parting->causes);
  // From the noise over the sum to what drives the robot.
  ASSERT_FALSE(is.parting->consequences.empty());
  EXPECT_EQ(is.parting->consequences.back().path, "motion") << report_of(is);
  EXPECT_FALSE(is.is_same());
  EXPECT_GT(is.robots.front().most_apart, 0.0);
}

// The values that it names are those that differ, and in no cycle before did any.
TEST(Comparer, NamesTheFirstCycleInWhichAnyValueDiffers) {
  WrittenRun a(kDemo, 1, true);
  WrittenRun b(kDemo, 2, true);
  for (WrittenRun* const one : {&a, &b}) {
    one->run().post(mission::event::Execute{});
    for (int i = 0; i < 300; ++i) one->step();
    one->end();
  }
  std::size_t first = 0;
  while (first < a.values().size() && a.values()[first] == b.values()[first]) ++first;
  const Comparison is = compared(a.history(), b.history());
  ASSERT_TRUE(is.parting);
  EXPECT_EQ(is.parting->cycle, first + 1);
}

TEST(Comparer, LeadsBackToAParameterThatDiffers) {
  WrittenRun written("squeeze/squeeze.mdl", 1, true);
  written.run().post(mission::event::Execute{});
  for (int i = 0; i < 100; ++i) written.step();
  const HistoryPtr other = testing::with_other_texts(written, "base_velocity = 2.5", "base_velocity = 2.25");
  const Comparison is = compared(testing::with_other_texts(written, "Squeeze", "Squeeze"), other);
  ASSERT_TRUE(is.parting) << report_of(is);
  EXPECT_TRUE(has(is.parting->causes, "`base_velocity`, which is 2.5 in A and 2.25 in B")) << report_of(is);
  ASSERT_EQ(is.beginning.texts.size(), 1U);
  EXPECT_TRUE(has(is.beginning.texts[0].lines, "-  base_velocity = 2.5"))
      << joined(is.beginning.texts[0].lines);
  EXPECT_TRUE(has(is.beginning.texts[0].lines, "+  base_velocity = 2.25"));
}

TEST(Comparer, SaysWhatAPersonDidInOneOfThemAlone) {
  const auto stop = [](WrittenRun& written, int cycle) {
    if (cycle == 50) written.run().set_parameter({2}, "base_velocity", "1");
  };
  const Comparison is = compared(carried_out(kDemo, 1, 120), carried_out(kDemo, 1, 120, stop));
  ASSERT_TRUE(is.input);
  EXPECT_EQ(is.input->cycle, 50U);
  EXPECT_EQ(is.input->inputs[0], "");
  EXPECT_EQ(is.input->inputs[1], "parameter `base_velocity` of robot 2: 1");
  ASSERT_TRUE(is.parting) << report_of(is);
  EXPECT_EQ(is.parting->cycle, 51U);
  EXPECT_EQ(is.parting->robot, 2U);
  EXPECT_EQ(is.parting->robots, std::vector<std::uint32_t>{2});
  EXPECT_TRUE(has(is.parting->causes,
                  "after cycle 50, this came in: parameter `base_velocity` of robot 2: 1 in B alone"))
      << joined(is.parting->causes);
}

TEST(Comparer, SaysThatSomebodyHoldsAValue) {
  const auto hold = [](WrittenRun& written, int cycle) {
    if (cycle == 30) written.run().hold_value({1}, "along_way", "{1, 0}");
  };
  const Comparison is = compared(carried_out(kDemo, 1, 60, hold), carried_out(kDemo, 1, 60));
  ASSERT_TRUE(is.parting) << report_of(is);
  EXPECT_EQ(is.parting->value.path, "along_way");
  EXPECT_TRUE(has(is.parting->causes, "somebody holds it in A")) << joined(is.parting->causes);
}

// As if another version of the program had recorded it.
TEST(Comparer, ComparesWhatWasRecordedOfARunThatIsComputedOtherwise) {
  WrittenRun written("squeeze/squeeze.mdl", 1, true);
  written.run().post(mission::event::Execute{});
  for (int i = 0; i < 120; ++i) written.step();
  written.end();
  std::vector<wire::HistoryEntry> entries = written.entries();
  for (wire::HistoryEntry& entry : entries) {
    if (entry.has_mark()) entry.mutable_mark()->set_digest(entry.mark().digest() + 1);
  }
  const Comparison is = compared(testing::of_entries(entries), written.history());
  EXPECT_FALSE(is.is_recomputed);
  EXPECT_TRUE(is.is_same()) << report_of(is);
  EXPECT_NE(is.sides[0].why_not_recomputed.find("computed again it is not as recorded"), std::string::npos);
  EXPECT_EQ(is.sides[1].why_not_recomputed, "");
  EXPECT_EQ(is.robots.front().most_apart, 0.0);
}

TEST(Comparer, TellsThatOneGoesOn) {
  const Comparison is = compared(carried_out(kDemo, 1, 100), carried_out(kDemo, 1, 140));
  ASSERT_TRUE(is.parting);
  EXPECT_EQ(is.parting->what, Parting::What::kEnd);
  EXPECT_EQ(is.parting->cycle, 100U);
  EXPECT_EQ(is.parting->value.values, (Both<std::string>{"ends here", "goes on"}));
}

TEST(Comparer, ComparesOtherMissionsAsFarAsTheyHaveSomethingInCommon) {
  const Comparison is = compared(carried_out(kDemo, 1, 50), carried_out("rally/rally.mdl", 1, 50));
  ASSERT_TRUE(is.parting);
  EXPECT_FALSE(is.beginning.texts.empty());
  EXPECT_TRUE(has_page(page_of(is, "test"), "</html>"));
}

// What it keeps of a long run is no more than of a short one.
TEST(Comparer, ThinsOutWhatItKeeps) {
  const Comparison is = compared(carried_out(kDemo, 1, 1200), carried_out(kDemo, 2, 1200));
  EXPECT_LE(is.times.size(), 1000U);
  EXPECT_GT(is.times.size(), 400U);
  for (const RobotRow& robot : is.robots) {
    ASSERT_EQ(robot.apart.size(), is.times.size());
    ASSERT_EQ(robot.ways[1].size(), is.times.size());
  }
  EXPECT_NEAR(is.times[2] - is.times[1], is.times[1] - is.times[0], 1e-9);
}

TEST(Comparer, OfWhichNobodyWaitsForTheEndSaysSo) {
  Comparer comparer({testing::recorded("a", carried_out(kDemo, 1, 100)),
                     testing::recorded("b", carried_out(kDemo, 1, 100))});
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(comparer.step());
  EXPECT_NEAR(comparer.share_done(), 0.1, 0.01);
  const Comparison is = comparer.finish();
  EXPECT_FALSE(is.is_whole);
  EXPECT_EQ(verdict(is), "the same as far as they were compared");
}

TEST(Comparison, IsTheSameForPeopleAndPrograms) {
  const Comparison is = compared(carried_out(kDemo, 1, 300), carried_out(kDemo, 2, 300));
  const auto json = nlohmann::json::parse(json_of(is));
  EXPECT_EQ(json["same"], false);
  EXPECT_EQ(json["parting"]["cycle"], is.parting->cycle);
  EXPECT_EQ(json["parting"]["value"]["path"], "noise");
  EXPECT_EQ(json["robots"].size(), 4U);
  EXPECT_EQ(json["robots"][0]["apart_m"].size(), json["times_s"].size());
  EXPECT_EQ(json["beginning"]["facts"][0]["what"], "seed");
  const std::string report = report_of(is);
  const std::string page = page_of(is, "test");
  for (const std::string& text : {report, page}) {
    EXPECT_TRUE(has_page(text, "noise")) << text;
    EXPECT_TRUE(has_page(text, "the seeds are 1 and 2")) << text;
    EXPECT_TRUE(has_page(text, "scouts")) << text;
  }
  EXPECT_FALSE(has_page(page, "<script"));
}

}  // namespace
}  // namespace mlab::comparison
