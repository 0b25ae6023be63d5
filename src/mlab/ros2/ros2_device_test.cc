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
  begin({.has_navigator = true}, with_goals());
  pass(500);
  EXPECT_EQ(why(), "");
  pass(5000, vehicle::Command{0.5, 0.0});
  EXPECT_GT(robot->pose.position.x, 1.2);
  EXPECT_GE(robot->goals, 3);
  EXPECT_LE(robot->goals, 10) << "twice a second at most";
  ASSERT_TRUE(robot->goal);
  EXPECT_EQ(robot->goal->frame, "odom");
  EXPECT_NEAR(robot->goal->x - robot->pose.position.x, 2.0, 0.5);
  EXPECT_EQ(robot->velocities, 0);
}

TEST_F(Ros2DeviceTest, TakesGoalsBackWhereItIsStoppedLeftOrToldToStand) {
  begin({.has_navigator = true}, with_goals());
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
  begin({.has_navigator = true}, with_goals());
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

  begin({.has_navigator = true}, with_goals());
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

TEST(Goals, AreSentAnewOnceTheyHaveEnded) {
  Goals goals(2.0, 0.5, 1);
  vehicle::Clock::time_point now{std::chrono::hours(1)};
  const auto first = goals.next({0.5, 0.0}, {}, "odom", {}, now);
  ASSERT_TRUE(first);
  goals.sent(1);
  now += milliseconds(600);
  EXPECT_FALSE(goals.next({0.5, 0.0}, {}, "odom", {}, now)) << "it has not moved";
  Heard heard;
  heard.goals = {{GoalId{}, GoalState::kAborted}};
  goals.take(heard);
  EXPECT_FALSE(goals.next({0.5, 0.0}, {}, "odom", {}, now)) << "that was somebody else's";
  heard.goals = {{first->id, GoalState::kAborted}};
  goals.take(heard);
  EXPECT_EQ(goals.problem(), "finds no way to where it is to go");
  const auto second = goals.next({0.5, 0.0}, {}, "odom", {}, now);
  ASSERT_TRUE(second);
  EXPECT_NE(second->id, first->id);
  EXPECT_NE(Goals(2.0, 0.5, 2).next({0.5, 0.0}, {}, "odom", {}, now)->id, first->id);
  goals.sent(2);
  heard = {};
  heard.answers = {{2, false}};
  goals.take(heard);
  EXPECT_EQ(goals.problem(), "does not take the goal that it is given");
}

}  // namespace
}  // namespace mlab::ros2
