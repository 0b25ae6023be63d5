#include "mlab/console/published/status_encoder.h"

#include <cmath>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/console/testing/run_of.h"

namespace mlab::console {
namespace {

Status status_of(const run::MissionRun& run, const Estimates& estimates) {
  Status out;
  encode_run(run, estimates, out);
  return out;
}

TEST(Status, FollowsTheRunFromReadyToEnded) {
  const auto run = testing::run_of(testing::kTravel);
  Estimates estimates;
  EXPECT_EQ(mode_of(*run), Status::READY);
  run->post(mission::event::Execute{});
  EXPECT_EQ(mode_of(*run), Status::RUNNING);
  run->post(mission::event::Pause{});
  EXPECT_EQ(mode_of(*run), Status::PAUSED);
  run->post(mission::event::Resume{});
  run->set_emergency_stop(true);
  EXPECT_EQ(mode_of(*run), Status::STOPPED);
  run->set_emergency_stop(false);
  run->post(mission::event::Abort{});
  EXPECT_EQ(mode_of(*run), Status::ENDED);
  EXPECT_EQ(status_of(*run, estimates).outcome(), Status::ABORTED);
}

TEST(Status, TellsWhatRemainsAndWhenItWillBeDone) {
  const auto run = testing::run_of(testing::kTravel);
  Estimates estimates;
  run->post(mission::event::Execute{});
  for (int i = 0; i < 600; ++i) {
    run->step();
    estimates.look(run->state());
  }
  const Status status = status_of(*run, estimates);
  ASSERT_EQ(status.steps_size(), 2);
  EXPECT_EQ(status.steps(0).outcome(), Status::DONE);
  const Status::Command& travel = status.steps(1).commands(0);
  EXPECT_EQ(travel.outcome(), Status::UNDER_WAY);
  EXPECT_EQ(travel.robots(), 2U);
  EXPECT_GT(travel.remaining(), 0.0);
  EXPECT_LT(travel.remaining(), 590.0);
  EXPECT_GT(travel.progress(), 0.1);
  EXPECT_LT(travel.progress(), 1.0);
  ASSERT_GT(travel.arrival(), status.time());
  const double estimated = travel.arrival();
  while (run->step() == run::MissionRun::Progress::kStepped) estimates.look(run->state());
  EXPECT_NEAR(run->time(), estimated, 0.25 * estimated);
  EXPECT_EQ(mode_of(*run), Status::ENDED);
  EXPECT_EQ(status_of(*run, estimates).steps(1).commands(0).progress(), 1.0);
}

TEST(Status, TellsHowManyPartsAreDoneOfWhatRobotsShare) {
  const auto run = testing::run_of(
      "MISSION-AREA 100 100\nUNIT <pair> ROBOT ROBOT\nCOMMAND LIST:\n0. UNIT pair START 10 10 0 10\n"
      "1. UNIT pair VISIT 20 20 30 60 90 90\n");
  run->post(mission::event::Execute{});
  testing::step(*run, 90);
  const Status status = status_of(*run, {});
  ASSERT_EQ(status.steps_size(), 2);
  const Status::Command& visit = status.steps(1).commands(0);
  EXPECT_TRUE(visit.is_shared());
  EXPECT_EQ(visit.parts(), 3U);
  EXPECT_EQ(visit.parts_done(), 1U);
  EXPECT_NEAR(visit.progress(), 1.0 / 3.0, 1e-9);
  EXPECT_EQ(visit.waits_for(), "what its robots share");
  EXPECT_FALSE(status.steps(0).commands(0).is_shared());
  ASSERT_EQ(visit.shared_size(), 3);
  int done = 0;
  int held = 0;
  for (const Status::Command::Part& part : visit.shared()) {
    EXPECT_EQ(part.way_size(), 2);
    done += part.is_done() ? 1 : 0;
    held += !part.is_done() && part.robot() != 0 ? 1 : 0;
    EXPECT_TRUE(part.robot() != 0 || !part.is_done());
  }
  EXPECT_EQ(done, 1);
  EXPECT_EQ(held, 2);
  EXPECT_EQ(visit.shared(0).way(0), 20.0F);
}

TEST(Status, TellsWhatEachRobotOfAPatrolHasBeforeIt) {
  const auto run = testing::run_of(
      "MISSION-AREA 200 200\nUNIT <pair> ROBOT ROBOT\nCOMMAND LIST:\n0. UNIT pair START 50 50 0 10\n"
      "1. UNIT pair PATROL 50 50 150 50 150 150 50 150 UNTIL TIMEOUT 720\n");
  run->post(mission::event::Execute{});
  testing::step(*run, 1500);
  const Status status = status_of(*run, {});
  ASSERT_EQ(status.steps_size(), 2);
  const Status::Command& patrol = status.steps(1).commands(0);
  EXPECT_TRUE(patrol.is_shared());
  EXPECT_EQ(patrol.parts(), 0U) << "none of it is ever done";
  ASSERT_EQ(patrol.shared_size(), 2);
  EXPECT_NE(patrol.shared(0).robot(), patrol.shared(1).robot());
  double round = 0.0;
  for (const Status::Command::Part& part : patrol.shared()) {
    double length = 0.0;
    for (int i = 3; i < part.way_size(); i += 2)
      length += std::hypot(part.way(i - 1) - part.way(i - 3), part.way(i) - part.way(i - 2));
    EXPECT_NEAR(length, 200.0, 40.0) << "they have spread evenly";
    EXPECT_FALSE(part.is_done());
    round += length;
    const base::RobotId robot{part.robot()};
    const geom::Point at = run->fleet().pose(*run->fleet().find(robot)).position;
    EXPECT_NEAR(part.way(0), at.x, 5.0) << "it begins where the robot is";
    EXPECT_NEAR(part.way(1), at.y, 5.0);
  }
  EXPECT_NEAR(round, 400.0, 0.01);
}

TEST(Status, TellsPartsOfNoMoreCommandsThanCanBeRead) {
  std::string places;
  for (int i = 0; i < 100; ++i) places += fmt::format(" {} {}", 50 + i % 50, 20 + i / 50);
  std::string mission = "MISSION-AREA 200 200\n";
  for (int unit = 0; unit < 11; ++unit) mission += fmt::format("UNIT <u{}> ROBOT\n", unit);
  mission += "COMMAND LIST:\n";
  for (int step = 0; step < 2; ++step) {
    for (int unit = 0; unit < 11; ++unit)
      mission += fmt::format("{} UNIT u{} {}", unit == 0 ? fmt::format("{}.", step) : " AND", unit,
                             step == 0 ? fmt::format("START 10 {}", 10 + 15 * unit) : "VISIT" + places);
    mission += "\n";
  }
  const auto run = testing::run_of(mission);
  run->post(mission::event::Execute{});
  testing::step(*run, 20);
  const Status status = status_of(*run, {});
  ASSERT_EQ(status.steps_size(), 2);
  ASSERT_EQ(status.steps(1).commands_size(), 11);
  for (int unit = 0; unit < 11; ++unit) {
    EXPECT_EQ(status.steps(1).commands(unit).parts(), 100U) << unit;
    EXPECT_EQ(status.steps(1).commands(unit).shared_size(), unit < 10 ? 100 : 0) << unit;
  }
}

TEST(Status, TellsWhoFollowsACommandThatRobotsWereOrderedAwayFrom) {
  const auto run = testing::run_of(testing::kTravel);
  run->post(mission::event::Execute{});
  testing::step(*run, 20);
  text::Diagnostics problems;
  const auto order = mdl::parse_immediate("ROBOT 2 MOVETO 10 10", run->mission(), problems);
  ASSERT_TRUE(order.has_value()) << text::render(problems);
  run->post(mission::event::Typed{order->commands});
  testing::step(*run, 5);
  const Status status = status_of(*run, {});
  ASSERT_EQ(status.steps_size(), 3);
  const Status::Command& left = status.steps(1).commands(0);
  EXPECT_EQ(left.outcome(), Status::UNDER_WAY);
  ASSERT_EQ(left.followers_size(), 1);
  EXPECT_EQ(left.followers(0), 1U);
  const Status::Command& own = status.steps(2).commands(0);
  EXPECT_EQ(own.unit(), "robot 2");
  ASSERT_EQ(own.followers_size(), 1);
  EXPECT_EQ(own.followers(0), 2U);
  EXPECT_EQ(own.waits_for(), "1 of 1 robot");
  EXPECT_EQ(mode_of(*run), Status::RUNNING);
}

TEST(Status, TellsTheMissionClock) {
  mission::ExecutiveOptions options;
  options.epoch_seconds = 86400.0;
  options.zone_offset = 3600.0;
  EXPECT_EQ(clock_time(options, 61.5), "1970-01-02T01:01:01");
}

}  // namespace
}  // namespace mlab::console
