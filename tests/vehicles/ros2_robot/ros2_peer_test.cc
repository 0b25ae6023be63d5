// Our binding, on Cyclone DDS, and a ROS 2 robot on Fast DDS that shares no code with it, in real time.

#include <chrono>
#include <cmath>
#include <thread>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "peer_fixture.h"
#include "robot.h"

namespace mlab::ros2_robot {
namespace {

using vehicle::Clock;
using vehicle::Readiness;

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
  const auto end = Clock::now() + std::chrono::seconds(20);
  while (!robot->has_said("nobody has told it anything since") && Clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
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

}  // namespace
}  // namespace mlab::ros2_robot
