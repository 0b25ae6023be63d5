// A mission on the percepts of a run does what that run did, bit for bit.

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
// sensors and a body that counts its wheels' turns.
INSTANTIATE_TEST_SUITE_P(Missions, RecordedRun, ::testing::Values("demo_c", "forage", "rover", "mrv2"));

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

}  // namespace
}  // namespace mlab::testing
