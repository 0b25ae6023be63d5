// What only robots under ROS 2 do; conformance_test.cc has what all devices hold.

#include "mlab/ros2/ros2_device.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>

#include "mlab/ros2/testing/toy_robot.h"

namespace mlab::ros2 {
namespace {

using std::chrono::milliseconds;
using testing::ToyRobot;
using testing::ToySpec;
using vehicle::Readiness;

class Ros2DeviceTest : public ::testing::Test {
 protected:
  void begin(const ToySpec& spec = {}, const RobotSettings& settings = {}) {
    robot.emplace(spec, 1);
    device = std::make_unique<Ros2Device>(robot->link(), settings);
  }
  void pass(int millis, const std::optional<vehicle::Command>& command = {}) {
    for (int i = 0; i < millis; i += 20) {
      now += milliseconds(20);
      robot->step(now, 0.02);
      device->work(now);
      if (command) device->drive(*command, now);
    }
  }
  std::string why() { return device->report(now).why; }
  static RobotSettings with_goals() {
    RobotSettings out;
    out.drives = Drives::kGoals;
    return out;
  }

  vehicle::Clock::time_point now{std::chrono::hours(1)};
  std::optional<ToyRobot> robot;
  std::unique_ptr<Ros2Device> device;
};

TEST_F(Ros2DeviceTest, IsNotReadyWhereNobodyListens) {
  RobotSettings settings;
  settings.robot_namespace = "/veh1";
  begin({}, settings);
  EXPECT_EQ(device->name(), "ROS 2 robot /veh1 in a toy's domain");
  robot->listens = false;
  pass(1000);
  EXPECT_EQ(device->report(now).readiness, Readiness::kNotReady);
  EXPECT_EQ(why(), "would hear nothing: nobody listens to /veh1/cmd_vel");
  EXPECT_TRUE(device->report(now).motion);
  robot->listens = true;
  EXPECT_EQ(device->report(now).readiness, Readiness::kReady);
}

TEST_F(Ros2DeviceTest, SaysBeforeAMissionWhatIsMissing) {
  const auto result = [&](const std::string& name) {
    for (const vehicle::Check& one : device->checks(now))
      if (one.name == name) return one.result;
    ADD_FAILURE() << name;
    return vehicle::CheckResult::kUnknown;
  };
  begin();
  robot->listens = false;
  EXPECT_EQ(result("odometry"), vehicle::CheckResult::kFail);
  pass(1000);
  EXPECT_EQ(result("odometry"), vehicle::CheckResult::kPass);
  EXPECT_EQ(result("listener"), vehicle::CheckResult::kFail);
  robot->listens = true;
  EXPECT_EQ(result("listener"), vehicle::CheckResult::kPass);
  EXPECT_EQ(result("watchdog"), vehicle::CheckResult::kUnknown) << "nobody can know that";
  begin({}, with_goals());
  pass(1000);
  EXPECT_EQ(result("navigator"), vehicle::CheckResult::kFail);
  begin({.navigator = Services::kUnknown}, with_goals());
  pass(1000);
  EXPECT_EQ(result("navigator"), vehicle::CheckResult::kFail);
  EXPECT_EQ(why(), "can't be given goals: its navigator speaks services in no way that is known");
  begin({.navigator = Services::kHeaded}, with_goals());
  pass(1000);
  EXPECT_EQ(result("navigator"), vehicle::CheckResult::kPass);
  EXPECT_EQ(device->checks(now)[1].is, "/navigate_to_pose is served by a navigator on rmw_cyclonedds");
}

TEST_F(Ros2DeviceTest, SaysNothingToCmdVelBeforeItIsDrivenOrStopped) {
  begin();
  pass(2000);
  EXPECT_EQ(robot->velocities, 0);
  pass(300, vehicle::Command{0.3, 0.1});
  EXPECT_GT(robot->velocities, 3);
  EXPECT_LT(robot->velocities, 9) << "the same command not more often than twenty times a second";
  EXPECT_EQ(robot->told->speed, 0.3);
  EXPECT_EQ(robot->told->turn_rate, 0.1);
}

TEST_F(Ros2DeviceTest, TellsZeroUntilItIsSeenToStandAndThenLeavesItAlone) {
  begin();
  pass(500);
  pass(1000, vehicle::Command{0.5, 0.0});
  device->stop(now);
  pass(1000);
  EXPECT_EQ(robot->told->speed, 0.0);
  EXPECT_EQ(robot->speed, 0.0);
  const int told = robot->velocities;
  pass(2000);
  EXPECT_EQ(robot->velocities, told) << "somebody else may drive it";
}

TEST_F(Ros2DeviceTest, TellsZeroWhereOdometryStopsThoughItIsDriven) {
  begin();
  pass(500);
  pass(1000, vehicle::Command{0.5, 0.0});
  robot->publishes = false;
  pass(1100, vehicle::Command{0.5, 0.0});
  EXPECT_EQ(robot->told->speed, 0.0);
  EXPECT_EQ(device->report(now).readiness, Readiness::kSilent);
  pass(2000, vehicle::Command{0.5, 0.0});
  EXPECT_EQ(robot->told->speed, 0.0);
  EXPECT_EQ(robot->speed, 0.0);
}

TEST_F(Ros2DeviceTest, StandsWhereItsOdometryJumps) {
  begin();
  pass(500);
  pass(1000, vehicle::Command{0.5, 0.0});
  robot->change_odometry = [](Odometry& one) { one.position.x += 5.0; };
  pass(300, vehicle::Command{0.5, 0.0});
  EXPECT_TRUE(why().starts_with("has jumped by 5.0 m")) << why();
  EXPECT_EQ(robot->told->speed, 0.0);
  pass(1200, vehicle::Command{0.5, 0.0});
  EXPECT_EQ(why(), "");
}

TEST_F(Ros2DeviceTest, StampsCommandsByTheRobotsOwnClock) {
  begin({.is_stamped = true});
  pass(500);
  pass(200, vehicle::Command{0.5, 0.0});
  ASSERT_TRUE(robot->told);
  EXPECT_EQ(robot->told->frame, "base_link");
  EXPECT_NEAR(robot->stamp_of(now).sec + robot->stamp_of(now).nanosec * 1e-9,
              robot->told->stamp.sec + robot->told->stamp.nanosec * 1e-9, 0.06);
}

TEST_F(Ros2DeviceTest, SaysHowItIsForPeopleWithRosTools) {
  begin();
  pass(300);
  ASSERT_FALSE(robot->states.empty());
  EXPECT_EQ(robot->states.back().level, Level::kStale);
  pass(1500);
  EXPECT_EQ(robot->states.back().level, Level::kOk);
  EXPECT_EQ(robot->states.back().message, "leaves it alone");
  const std::size_t before = robot->states.size();
  pass(500, vehicle::Command{0.25, 0.0});
  EXPECT_EQ(robot->states.back().message, "drives it");
  pass(2000, vehicle::Command{0.25, 0.0});
  EXPECT_LE(robot->states.size(), before + 4);
  EXPECT_EQ(robot->states.back().values[0].value, "0.250");
}

TEST(Goals, LieWhereACommandLeads) {
  const Goals goals(2.0, 0.5, 1);
  const geom::Pose from{{1.0, 1.0}, std::numbers::pi / 2.0};
  const geom::Pose straight = goals.ahead(from, {0.5, 0.0});
  EXPECT_NEAR(straight.position.x, 1.0, 1e-9);
  EXPECT_NEAR(straight.position.y, 3.0, 1e-9);
  EXPECT_EQ(straight.heading, from.heading);
  EXPECT_NEAR(goals.ahead(from, {0.25, 0.0}).position.y, 2.0, 1e-9) << "nearer where it is to be slower";
  const geom::Pose bent = goals.ahead({}, {0.5, 1.0});
  EXPECT_NEAR(bent.heading, 0.4, 1e-9);
  EXPECT_NEAR(bent.position.x, 2.0 * std::cos(0.4), 1e-9);
  EXPECT_NEAR(bent.position.y, 2.0 * std::sin(0.4), 1e-9);
  const geom::Pose spun = goals.ahead({}, {0.0, -0.75});
  EXPECT_NEAR(spun.heading, -0.75, 1e-9);
  EXPECT_EQ(spun.position.x, 0.0);
  EXPECT_NEAR(std::abs(goals.ahead({}, {0.0, 50.0}).heading), std::numbers::pi, 1e-9)
      << "at most half a turn";
}

TEST_F(Ros2DeviceTest, IsDrivenByGoalsThatRollAhead) {
  begin({.navigator = Services::kPlain}, with_goals());
  pass(500);
  EXPECT_EQ(why(), "");
  pass(5000, vehicle::Command{0.5, 0.0});
  EXPECT_GT(robot->pose.position.x, 1.2);
  EXPECT_GE(robot->goals, 3);
  EXPECT_LE(robot->goals, 10) << "twice a second at most";
  ASSERT_TRUE(robot->goal);
  EXPECT_EQ(robot->goal->frame, "odom");
  EXPECT_NEAR(robot->goal->x - robot->pose.position.x, 1.0, 0.25);
  EXPECT_EQ(robot->velocities, 0);
}

TEST_F(Ros2DeviceTest, TakesGoalsBackWhereItIsStoppedLeftOrToldToStand) {
  begin({.navigator = Services::kPlain}, with_goals());
  pass(500);
  for (const int how : {0, 1, 2}) {
    pass(2000, vehicle::Command{0.5, 0.0});
    EXPECT_GT(robot->speed, 0.3);
    robot->cancels = 0;
    if (how == 0) device->stop(now);
    pass(1000, how == 1 ? std::optional(vehicle::Command{}) : std::nullopt);
    EXPECT_EQ(robot->speed, 0.0) << how;
    EXPECT_FALSE(robot->goal);
    EXPECT_GE(robot->cancels, 1);
    EXPECT_LE(robot->cancels, 8);
  }
}

TEST_F(Ros2DeviceTest, TakesGoalsBackWhenTheWayToItIsMended) {
  begin({.navigator = Services::kPlain}, with_goals());
  pass(500);
  pass(2000, vehicle::Command{0.5, 0.0});
  robot->network.is_cut = true;
  pass(1500, vehicle::Command{0.5, 0.0});
  EXPECT_TRUE(robot->goal) << "it goes on to its last goal";
  robot->network.is_cut = false;
  pass(1000);
  EXPECT_FALSE(robot->goal);
  EXPECT_EQ(robot->speed, 0.0);
}

TEST_F(Ros2DeviceTest, LeavesWithAWordThatStopsIt) {
  begin();
  pass(500);
  pass(1000, vehicle::Command{0.5, 0.0});
  device.reset();
  robot->step(now + milliseconds(20), 0.02);
  EXPECT_EQ(robot->told->speed, 0.0);

  begin({.navigator = Services::kPlain}, with_goals());
  pass(500);
  pass(1000, vehicle::Command{0.5, 0.0});
  ASSERT_TRUE(robot->goal);
  device.reset();
  robot->step(now + milliseconds(20), 0.02);
  EXPECT_FALSE(robot->goal);
}

TEST_F(Ros2DeviceTest, IsNotReadyWithoutANavigatorThatIsNeeded) {
  begin({}, with_goals());
  pass(500);
  EXPECT_EQ(why(), "has no navigator: nobody serves /navigate_to_pose");
  pass(500, vehicle::Command{0.5, 0.0});
  EXPECT_EQ(robot->velocities, 0);
}

TEST_F(Ros2DeviceTest, StandsWithinItsTimeWhenItsProcessIsGone) {
  for (const double max_speed : {0.25, 0.5, 1.0}) {
    RobotSettings settings = with_goals();
    settings.limits.kinematics.max_speed = max_speed;
    const double stated = standstill_with_goals(look_ahead_for(max_speed), max_speed);
    // As slow as the statement allows for.
    begin({.navigator = Services::kPlain, .cruise = max_speed / 2.0}, settings);
    pass(500);
    double longest = 0.0;
    for (int i = 0; i < 20; ++i) {
      pass(500 + 100 * i, vehicle::Command{max_speed, i % 2 == 0 ? 0.0 : 0.5});
      const auto left = now;
      while (robot->goal || robot->speed != 0.0) {
        now += milliseconds(20);
        robot->step(now, 0.02);
      }
      longest = std::max(longest, vehicle::seconds_between(left, now));
    }
    EXPECT_LE(longest, stated) << max_speed;
    EXPECT_GT(longest, 0.5 * stated) << max_speed << ": it is no more than has to be";
  }
}

TEST_F(Ros2DeviceTest, SaysThatItsNavigatorDoesNotTakeItsGoalsOrFindsNoWay) {
  begin({.navigator = Services::kPlain}, with_goals());
  pass(500);
  const auto expect = [&](const std::string& problem) {
    EXPECT_EQ(robot->states.back().level, Level::kWarning);
    EXPECT_EQ(robot->states.back().message, "drives it: it " + problem);
    EXPECT_EQ(device->checks(now)[1].result, vehicle::CheckResult::kWarn);
    EXPECT_EQ(device->take_news(), std::vector<std::string>{problem});
  };
  robot->takes_goals = false;
  pass(3500, vehicle::Command{0.5, 0.0});
  EXPECT_EQ(robot->speed, 0.0);
  expect("does not take the goals that it is given");
  robot->takes_goals = true;
  robot->finds_ways = false;
  pass(3000, vehicle::Command{0.5, 0.0});
  expect("finds no way to where it is to go");
  EXPECT_GT(robot->goals, 2) << "it is tried again";
  robot->finds_ways = true;
  pass(5000, vehicle::Command{0.5, 0.0});
  EXPECT_EQ(robot->states.back().message, "drives it");
  robot->recoveries = 2;
  pass(1000, vehicle::Command{0.5, 0.0});
  expect("is held up on its way, and tries to get free");
}

TEST_F(Ros2DeviceTest, LeavesItToWhoeverGivesItsNavigatorAnotherGoal) {
  begin({.navigator = Services::kPlain}, with_goals());
  pass(500);
  pass(2000, vehicle::Command{0.5, 0.0});
  Goal other;
  other.id.bytes[0] = 1;
  other.x = robot->pose.position.x - 1.0;
  robot->give(other);
  pass(1000, vehicle::Command{0.5, 0.0});
  EXPECT_EQ(device->report(now).readiness, Readiness::kTaken);
  EXPECT_EQ(why(), "goes to a goal that somebody else gave its navigator");
  device->stop(now);
  const int velocities = robot->velocities;
  pass(1000);
  ASSERT_TRUE(robot->goal);
  EXPECT_EQ(robot->goal->id, other.id);
  EXPECT_EQ(robot->velocities, velocities) << "nor is it told to stand";

  device->engage(now);
  pass(1000, vehicle::Command{0.5, 0.0});
  ASSERT_TRUE(robot->goal);
  EXPECT_NE(robot->goal->id, other.id) << "a person takes it back";
}

TEST_F(Ros2DeviceTest, TakesAllGoalsBackInAnEmergency) {
  begin({.navigator = Services::kPlain}, with_goals());
  pass(500);
  Goal other;
  other.x = 5.0;
  robot->give(other);
  pass(2000);
  EXPECT_GT(robot->speed, 0.3);
  device->stop(now);
  pass(1000);
  EXPECT_GT(robot->speed, 0.3);
  for (int i = 0; i < 10; ++i) {
    device->stop_in_emergency(now);
    pass(100);
  }
  EXPECT_FALSE(robot->goal);
  EXPECT_EQ(robot->speed, 0.0);
  EXPECT_GE(robot->cancels_of_all, 1);
}

TEST_F(Ros2DeviceTest, TakesBackWhatAProcessBeforeItLeft) {
  RobotSettings settings = with_goals();
  settings.look_ahead = 5.0;
  begin({.navigator = Services::kPlain}, settings);
  pass(500);
  pass(1000, vehicle::Command{0.5, 0.0});
  ASSERT_TRUE(robot->goal);
  const Goal left = *robot->goal;
  device.reset();
  robot->give(left);  // as though nothing of the parting had arrived
  settings.session = 2;
  device = std::make_unique<Ros2Device>(robot->link(), settings);
  pass(1000);
  EXPECT_FALSE(robot->goal);
  EXPECT_EQ(robot->speed, 0.0);
}

TEST_F(Ros2DeviceTest, GivesItsGoalAnewToANavigatorThatBeginsAgain) {
  begin({.navigator = Services::kPlain}, with_goals());
  pass(500);
  pass(2000, vehicle::Command{0.5, 0.0});
  robot->restart_navigator();
  EXPECT_FALSE(robot->goal);
  pass(600, vehicle::Command{0.5, 0.0});
  EXPECT_TRUE(robot->goal);
}

}  // namespace
}  // namespace mlab::ros2
