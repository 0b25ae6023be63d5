#include "mlab/console/run/targets.h"

#include <gtest/gtest.h>

#include "mlab/console/published/robot_detail.h"
#include "mlab/console/testing/run_of.h"

namespace mlab::console {
namespace {

Targets targets_of(const run::MissionRun& run, const std::string& line) {
  text::Diagnostics problems;
  const auto read = mdl::parse_immediate(line, run.mission(), problems);
  EXPECT_TRUE(read.has_value()) << text::render(problems);
  Targets out;
  if (read) encode_targets(run, read->edited ? *read->edited : run.mission(), read->commands, out);
  return out;
}

TEST(Targets, RobotsThatAreNotStartedAreSkippedAndItIsSaidWhatIsReplaced) {
  const auto run = testing::run_of(testing::kTravel);
  run->post(mission::event::Execute{});
  testing::step(*run, 20);
  const Targets pair = targets_of(*run, "UNIT pair MOVETO 10 10 Column");
  ASSERT_EQ(pair.units_size(), 1);
  EXPECT_EQ(pair.units(0).command(), "MOVETO 10 10, Column");
  EXPECT_EQ(pair.units(0).robots_size(), 2);
  EXPECT_EQ(pair.units(0).skipped_size(), 0);
  EXPECT_NE(pair.units(0).replaces().find("MOVETO 700 120"), std::string::npos);
  const Targets rest = targets_of(*run, "UNIT rest MOVETO 10 10");
  EXPECT_EQ(rest.units(0).robots_size(), 0);
  ASSERT_EQ(rest.units(0).skipped_size(), 2);
  EXPECT_EQ(rest.units(0).skipped(0).reason(), "not started");
  EXPECT_EQ(rest.units(0).replaces(), "");
}

TEST(Targets, EveryUnitIsNamedWithWhatBecomesOfIt) {
  const auto run = testing::run_of(
      "MISSION-AREA 1000 1000\nUNIT <a> ROBOT ROBOT\nUNIT <b> ROBOT ROBOT\nUNIT <c> ROBOT\nCOMMAND LIST:\n"
      "0. UNIT a START 100 100 0 40 AND UNIT b START 100 300 0 40\n"
      "1. UNIT a MOVETO 700 120 AND UNIT b MOVETO 700 320\n");
  run->post(mission::event::Execute{});
  testing::step(*run, 20);
  const Targets targets = targets_of(*run, "ROBOTS 2 3 4 MOVETO 10 10");
  ASSERT_EQ(targets.units_size(), 1);
  EXPECT_EQ(targets.units(0).name(), "robots 2-4");
  EXPECT_EQ(targets.units(0).robots_size(), 3);
  EXPECT_EQ(targets.units(0).replaces(), "unit b MOVETO 700 320");
  ASSERT_EQ(targets.standing_size(), 3);
  EXPECT_EQ(targets.standing(0).unit(), "a");
  EXPECT_EQ(targets.standing(0).fate(), Targets::Standing::GOES_ON_WITHOUT);
  ASSERT_EQ(targets.standing(0).leaving_size(), 1);
  EXPECT_EQ(targets.standing(0).leaving(0), 2U);
  EXPECT_EQ(targets.standing(0).staying(), 1U);
  EXPECT_EQ(targets.standing(1).unit(), "b");
  EXPECT_EQ(targets.standing(1).fate(), Targets::Standing::ENDS);
  EXPECT_EQ(targets.standing(2).unit(), "c");
  EXPECT_EQ(targets.standing(2).fate(), Targets::Standing::IDLE);
  const Targets other = targets_of(*run, "UNIT a MOVETO 10 10");
  EXPECT_EQ(other.standing(1).unit(), "b");
  EXPECT_EQ(other.standing(1).fate(), Targets::Standing::GOES_ON);
}

TEST(Targets, StartSkipsWhoRunsAlready) {
  const auto run = testing::run_of(testing::kTravel);
  run->post(mission::event::Execute{});
  testing::step(*run, 20);
  const Targets targets = targets_of(*run, "UNIT pair START 5 5 0 5 AND UNIT rest START 50 50 0 5");
  ASSERT_EQ(targets.units_size(), 2);
  EXPECT_EQ(targets.units(0).skipped(0).reason(), "runs already");
  EXPECT_EQ(targets.units(1).robots_size(), 2);
}

TEST(RobotDetail, SaysWhatTheRobotFollowsAndWhatItWaitsFor) {
  const auto run = testing::run_of(testing::kTravel);
  run->post(mission::event::Execute{});
  testing::step(*run, 20);
  RobotDetail detail;
  encode_detail(*run, {}, *run->fleet().find({1}), {true, true}, detail);
  EXPECT_EQ(detail.unit(), "pair");
  EXPECT_EQ(detail.task(), "MOVETO");
  EXPECT_EQ(detail.life(), "running");
  EXPECT_EQ(detail.goal().x(), 700.0);
  EXPECT_GT(detail.remaining(), 100.0);
  EXPECT_GT(detail.contributions_size(), 2);
  EXPECT_TRUE(detail.has_station());
  const auto ports = run->fleet().find({1})->workings().program->ports().size();
  EXPECT_EQ(static_cast<std::size_t>(detail.ports_size()), ports);
  EXPECT_EQ(detail.numbers().size(), 8 * ports);
  bool says_what_waits = false;
  for (const std::string& line : waits_for(*run, *run->fleet().find({1})))
    says_what_waits = says_what_waits || line.find("2 of 2 robots") != std::string::npos;
  EXPECT_TRUE(says_what_waits) << detail.DebugString();
}

TEST(RobotDetail, OfARobotThatIsNotStartedSaysSo) {
  const auto run = testing::run_of(testing::kTravel);
  RobotDetail detail;
  encode_detail(*run, {}, *run->fleet().find({3}), {true, true}, detail);
  EXPECT_EQ(detail.life(), "not started");
  EXPECT_EQ(waits_for(*run, *run->fleet().find({3})).size(), 1U);
  EXPECT_LT(detail.remaining(), 0.0);
}

}  // namespace
}  // namespace mlab::console
