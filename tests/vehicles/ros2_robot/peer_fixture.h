#pragma once

#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/ros2/dds_link.h"
#include "mlab/ros2/ros2_device.h"
#include "robot_process.h"

namespace mlab::ros2_robot {

/// Our binding, on Cyclone DDS, and a ROS 2 robot on Fast DDS that shares no code with it, in real time.
class Ros2Peer : public ::testing::Test {
 protected:
  std::unique_ptr<RobotProcess> start(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {
        "--domain", std::to_string(domain_), "--namespace", "/veh1", "--drift", "0", "--log"};
    words.insert(words.end(), more.begin(), more.end());
    return std::make_unique<RobotProcess>(words);
  }
  ros2::LinkSettings link_settings(bool has_goals) const {
    ros2::LinkSettings out;
    out.network.domain = domain_;
    out.robot_namespace = "/veh1";
    out.scanners = {"/veh1/scan"};
    out.has_goals = has_goals;
    return out;
  }
  void connect(ros2::Drives drives = ros2::Drives::kVelocities) {
    const ros2::LinkSettings to = link_settings(drives == ros2::Drives::kGoals);
    auto link = ros2::open_link(to);
    ASSERT_TRUE(link) << link.error();
    ros2::RobotSettings settings;
    settings.robot_namespace = to.robot_namespace;
    settings.scanners = to.scanners;
    settings.drives = drives;
    device_ = std::make_unique<ros2::Ros2Device>(std::move(*link), settings);
  }
  const vehicle::Report& report() { return device_->report(vehicle::Clock::now()); }
  double x() { return report().motion ? report().motion->pose.position.x : std::nan(""); }
  bool is_ready() { return report().readiness == vehicle::Readiness::kReady; }

  // In twenty seconds at most; meanwhile the device works, and something is done.
  bool becomes(const std::function<bool()>& is_so, const std::function<void()>& each = {}) {
    const auto end = vehicle::Clock::now() + std::chrono::seconds(20);
    while (!is_so()) {
      if (vehicle::Clock::now() > end) return false;
      device_->work(vehicle::Clock::now());
      if (each) each();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
  }
  void drive(double speed) { device_->drive({speed, 0.0}, vehicle::Clock::now()); }
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

}  // namespace mlab::ros2_robot
