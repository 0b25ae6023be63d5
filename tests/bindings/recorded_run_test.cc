// A mission on the percepts of a run does what that run did, bit for bit.

#include <algorithm>
#include <variant>

#include "recorded.h"

namespace mlab::testing {
namespace {

class RecordedRun : public ::testing::TestWithParam<const char*> {};

TEST_P(RecordedRun, DoesTheSameBitForBit) {
  constexpr int kCycles = 600;
  const TemporaryFile file(std::string("percepts_") + GetParam());
  const std::string report = record(Plan(GetParam()), kCycles, file.path());
  for (const int threads : {1, 4}) {
    const Replay replay(Plan(GetParam(), 3, threads), file.path());
    ASSERT_TRUE(replay.run);
    carry_out(*replay.run, kCycles);
    EXPECT_TRUE(replay.bodies->differences().empty()) << replay.bodies->differences().front().what;
    EXPECT_GT(replay.bodies->same_actions(), 500U);
    EXPECT_EQ(report_of(*replay.run), report);
  }
}

// One with formations and questions; one whose robots carry objects and look through cameras; one with range
// sensors and a body that counts its wheels' turns; one with an area that nobody enters; one with obstacles
// that move.
INSTANTIATE_TEST_SUITE_P(Missions, RecordedRun,
                         ::testing::Values("demo_c", "forage", "rover", "mrv2", "minefield", "crossing"));

TEST(RecordedRun, IsTheSameAsTheRunThatIsNotRecorded) {
  const TemporaryFile file("percepts_plain");
  const Plan plan("demo_c");
  const auto run = simulated::make_run(plan.crew, plan.settings);
  carry_out(*run, 300);
  EXPECT_EQ(record(plan, 300, file.path()), report_of(*run));
}

TEST(RecordedRun, TellsWhichRobotActsOtherwiseAndHow) {
  const TemporaryFile file("percepts_changed");
  const Plan plan("demo_c");
  record(plan, 300, file.path());
  const Replay replay(plan, file.path());
  ASSERT_TRUE(replay.run);
  const base::RobotId changed = plan.crew->mission->robots.front().id;
  ASSERT_EQ(replay.run->set_parameter(changed, "base_velocity", "0.01"), std::nullopt);
  carry_out(*replay.run, 300);
  ASSERT_EQ(replay.bodies->differences().size(), 1U);
  const recording::Difference& difference = replay.bodies->differences().front();
  EXPECT_EQ(difference.robot, changed);
  EXPECT_NE(difference.what.find(" m/s; recorded is ("), std::string::npos) << difference.what;
}

TEST(RecordedRun, RobotsWithoutPerceptsStandAndSayWhy) {
  const TemporaryFile file("percepts_short");
  const Plan plan("demo_c");
  record(plan, 50, file.path());
  const Replay replay(plan, file.path());
  ASSERT_TRUE(replay.run);
  carry_out(*replay.run, 60);
  const fleet::FleetRobot& robot = replay.run->fleet().robots().front();
  EXPECT_EQ(robot.life, fleet::RobotLife::kFaulted);
  EXPECT_EQ(robot.ailment, "has no more percepts: `" + file.path() + "` ends after cycle 50");
}

TEST(RecordedRun, ShowsTheWorldThatWasThere) {
  const TemporaryFile file("percepts_world");
  const Plan plan("forage");
  record(plan, 100, file.path());
  const Replay replay(plan, file.path());
  ASSERT_TRUE(replay.run);
  const auto simulated = simulated::make_run(plan.crew, plan.settings);
  carry_out(*replay.run, 100);
  carry_out(*simulated, 100);
  const binding::WorldView& was = simulated->world();
  const binding::WorldView& is = replay.run->world();
  ASSERT_EQ(is.discs().size(), was.discs().size());
  ASSERT_EQ(is.objects().size(), was.objects().size());
  ASSERT_FALSE(is.objects().empty());
  for (std::size_t i = 0; i < is.objects().size(); ++i) {
    EXPECT_EQ(is.objects()[i].center, was.objects()[i].center);
    EXPECT_EQ(is.objects()[i].carrier, was.objects()[i].carrier);
  }
}

TEST(RecordedRun, KeepsAreasThatStopNobodyApartFromWalls) {
  const TemporaryFile file("percepts_walls");
  const Plan plan("minefield");
  record(plan, 2, file.path());
  const Replay replay(plan, file.path());
  ASSERT_TRUE(replay.run);
  const auto simulated = simulated::make_run(plan.crew, plan.settings);
  const auto was = simulated->world().walls();
  const auto is = replay.run->world().walls();
  ASSERT_EQ(is.size(), was.size());
  ASSERT_FALSE(is.empty());
  for (std::size_t i = 0; i < is.size(); ++i) EXPECT_EQ(is[i].is_solid, was[i].is_solid);
  EXPECT_FALSE(is.front().is_solid);
}

TEST(RecordedRun, OfAnotherMissionTellsOfRobotsThatItDoesNotHave) {
  const TemporaryFile file("percepts_other");
  record(Plan("demo_c"), 20, file.path());  // four robots
  const Replay fewer(Plan("forage"), file.path());
  ASSERT_TRUE(fewer.run);
  carry_out(*fewer.run, 20);
  const auto& differences = fewer.bodies->differences();
  const auto fourth = std::ranges::find(differences, base::RobotId{4}, &recording::Difference::robot);
  ASSERT_NE(fourth, differences.end());
  EXPECT_EQ(fourth->what, "does not act; it did when percepts were recorded");

  record(Plan("forage"), 20, file.path());  // three
  const Replay more(Plan("demo_c"), file.path());
  ASSERT_TRUE(more.run);
  std::string told;
  more.run->set_observer([&](const mission::Effect& effect) {
    if (const auto* tell = std::get_if<mission::effect::Tell>(&effect)) told += tell->text + "\n";
  });
  carry_out(*more.run, 20);
  EXPECT_EQ(more.run->fleet().find({4})->life, fleet::RobotLife::kNotStarted);
  EXPECT_NE(told.find("robot 4 can't start: `"), std::string::npos) << told;
  EXPECT_NE(told.find("` has no percepts of it"), std::string::npos) << told;
}

}  // namespace
}  // namespace mlab::testing
