// Our binding, on Cyclone DDS, and a ROS 2 robot on Fast DDS that shares no code with it, in real time.

#include <signal.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <thread>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/ros2/dds_link.h"
#include "mlab/ros2/ros2_device.h"
#include "robot.h"
#include "robot_process.h"

namespace mlab::ros2_robot {
namespace {

using vehicle::Clock;
using vehicle::Readiness;

class Ros2Peer : public ::testing::Test {
 protected:
  std::unique_ptr<RobotProcess> start(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {
        "--domain", std::to_string(domain_), "--namespace", "/veh1", "--drift", "0", "--log"};
    words.insert(words.end(), more.begin(), more.end());
    return std::make_unique<RobotProcess>(words);
  }
  void connect(ros2::Drives drives = ros2::Drives::kVelocities) {
    ros2::LinkSettings to;
    to.network.domain = domain_;
    to.robot_namespace = "/veh1";
    to.scanners = {"/veh1/scan"};
    to.has_goals = drives == ros2::Drives::kGoals;
    auto link = ros2::open_link(to);
    ASSERT_TRUE(link) << link.error();
    ros2::RobotSettings settings;
    settings.robot_namespace = to.robot_namespace;
    settings.scanners = to.scanners;
    settings.drives = drives;
    device_ = std::make_unique<ros2::Ros2Device>(std::move(*link), settings);
  }
  const vehicle::Report& report() { return device_->report(Clock::now()); }
  double x() { return report().motion ? report().motion->pose.position.x : std::nan(""); }
  bool is_ready() { return report().readiness == Readiness::kReady; }

  // In twenty seconds at most; meanwhile the device works, and something is done.
  bool becomes(const std::function<bool()>& is_so, const std::function<void()>& each = {}) {
    const auto end = Clock::now() + std::chrono::seconds(20);
    while (!is_so()) {
      if (Clock::now() > end) return false;
      device_->work(Clock::now());
      if (each) each();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
  }
  void drive(double speed) { device_->drive({speed, 0.0}, Clock::now()); }
  bool comes_to(double where) {
    return becomes([&] { return x() > where; }, [&] { drive(0.5); });
  }
  /// @return  why it brakes, as it says itself
  std::string stands(RobotProcess& robot) {
    const double went = robot.last("goes at ").value_or(0.0);
    EXPECT_TRUE(becomes([&] { return robot.last("stands at ").value_or(0.0) > went; })) << robot.said();
    const auto at = robot.said().rfind("brakes at ");
    return at == std::string::npos ? "" : robot.said().substr(at, robot.said().find('\n', at) - at);
  }

  std::unique_ptr<ros2::Ros2Device> device_;
  int domain_ = free_domain();
};

TEST_F(Ros2Peer, IsSeenDrivenStoppedAndFoundAgain) {
  const std::vector<std::string> options = {
      "--world",       base::source_folder() + "/tests/fleets/vehicles/yard.odl",
      "--at",          "10,11,0",
      "--range-noise", "0"};
  auto robot = start(options);
  connect();
  ASSERT_TRUE(becomes([&] { return is_ready() && !report().scans.empty() && report().battery; }))
      << report().why;
  EXPECT_NEAR(report().battery->share, 0.9, 0.01);
  const vehicle::Scan& scan = report().scans[0];
  EXPECT_NEAR(scan.mount.position.x, kScannerAhead, 1e-6) << "as tf says";
  ASSERT_EQ(scan.distances.size(), 360U);
  const auto at = [&](double angle) {
    const double beam = std::remainder(angle - scan.first_angle, 2.0 * M_PI) / scan.step;
    return scan.distances.at(static_cast<std::size_t>(std::lround(beam + 360.0)) % 360);
  };
  // The rock that stands 4 m ahead is 0.8 m thick to each side; behind there is nothing.
  EXPECT_NEAR(at(0.0), 4.0 - 0.8 - kScannerAhead, 1e-3);
  EXPECT_TRUE(std::isinf(at(M_PI)));

  ASSERT_TRUE(comes_to(0.2)) << report().why;
  device_->stop(Clock::now());
  EXPECT_TRUE(stands(*robot).ends_with("it was told so")) << robot->said();
  ASSERT_TRUE(comes_to(x() + 0.2)) << report().why;
  // Where nobody calls the device any more, not even `work`, its own watchdog has it stand.
  std::this_thread::sleep_for(std::chrono::milliseconds(1200));
  const std::string why = stands(*robot);
  EXPECT_NE(why.find("nobody has told it anything since"), std::string::npos) << why;

  robot.reset();
  EXPECT_TRUE(becomes([&] { return report().readiness == Readiness::kSilent; }, [&] { drive(0.5); }));
  robot = start(options);
  ASSERT_TRUE(becomes([&] { return is_ready(); })) << report().why;
  EXPECT_FALSE(robot->has_said("goes at ")) << "it stands until the next drive";
  EXPECT_TRUE(comes_to(0.1)) << report().why;
}

TEST_F(Ros2Peer, IsDrivenByTwistsWithAStampWhereItWantsThose) {
  const auto robot = start({"--stamped"});
  connect();
  ASSERT_TRUE(becomes([&] { return is_ready(); })) << report().why;
  EXPECT_TRUE(comes_to(0.2)) << report().why;
  device_.reset();
  EXPECT_FALSE(robot->has_said("too old")) << robot->said();
}

TEST_F(Ros2Peer, GoesByGoalsOfNav2AndStandsWhenTheyAreTakenBack) {
  const auto robot = start({"--nav2"});
  connect(ros2::Drives::kGoals);
  ASSERT_TRUE(becomes([&] { return is_ready(); })) << report().why;
  ASSERT_TRUE(comes_to(0.4)) << report().why;
  device_->stop(Clock::now());
  EXPECT_NE(stands(*robot), "") << robot->said();
  // Its `cmd_vel`, which goes before its goals, was told zero, too: they are seen to be gone when that is
  // over.
  const double stood = robot->last("stands at ").value_or(0.0);
  ASSERT_TRUE(becomes([&] { return robot->last(" at ").value_or(0.0) > stood + 0.8; }));
  EXPECT_LT(robot->last("goes at ").value_or(0.0), stood) << robot->said();
}

}  // namespace
}  // namespace mlab::ros2_robot
