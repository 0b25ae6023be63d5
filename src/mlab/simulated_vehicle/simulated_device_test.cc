#include "mlab/simulated_vehicle/simulated_device.h"

#include <chrono>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace mlab::vehicle {
namespace {

using std::chrono::milliseconds;

sim::World world_with(std::vector<binding::Disc> discs) {
  sim::World out;
  out.area_low = {0.0, 0.0};
  out.area_high = {100.0, 50.0};
  out.discs = std::move(discs);
  return out;
}

class Simulated : public testing::Test {
 protected:
  static SimulatedDevice::Settings at(double x, double y) {
    SimulatedDevice::Settings out;
    out.start.position = {x, y};
    return out;
  }
  void pass(double seconds) {
    for (double left = seconds; left > 0.0; left -= 0.02) {
      now_ += milliseconds(20);
      device_.work(now_);
    }
  }
  double speed() { return device_.report(now_).motion->speed; }

  SimulatedDevice device_{world_with({{{20.0, 25.0}, 1.0}}), at(10.0, 25.0)};
  Clock::time_point now_{std::chrono::seconds(1000)};
};

TEST_F(Simulated, GoesWhereItIsDriven) {
  for (int i = 0; i < 20; ++i) {
    device_.drive({1.0, 0.0}, now_);
    pass(0.1);
  }
  const Motion motion = *device_.report(now_).motion;
  EXPECT_NEAR(motion.speed, 1.0, 1e-9);
  EXPECT_NEAR(motion.pose.position.x, 10.0 + 2.0 - 0.25, 0.05);
  EXPECT_EQ(device_.report(now_).readiness, Readiness::kReady);
}

TEST_F(Simulated, StandsInItsStatedTimeWhereNobodyDrivesItAnyMore) {
  for (int i = 0; i < 10; ++i) {
    device_.drive({1.0, 0.0}, now_);
    pass(0.1);
  }
  ASSERT_NEAR(speed(), 1.0, 1e-9);
  pass(device_.limits().standstill);
  EXPECT_EQ(speed(), 0.0);
}

TEST_F(Simulated, SaysThatItIsAndThatItHasAWatchdog) {
  EXPECT_TRUE(device_.is_simulated());
  const std::vector<Check> checks = device_.checks(now_);
  ASSERT_EQ(checks.size(), 1U);
  EXPECT_EQ(checks[0], (Check{"watchdog", CheckResult::kPass, "brakes 0.5 s after its last command",
                              "stands within 1.0 s"}));
}

TEST_F(Simulated, SeesWhatStandsInItsWorld) {
  pass(0.1);
  const Report& report = device_.report(now_);
  ASSERT_EQ(report.scans.size(), 1U);
  const Scan& scan = report.scans.front();
  ASSERT_EQ(scan.distances.size(), 60U);
  EXPECT_NEAR(scan.distances[0], 9.0, 1e-3) << "ahead, from its middle";
  EXPECT_TRUE(std::isinf(scan.distances[30])) << "nothing is behind it";
}

TEST_F(Simulated, DoesNotCatchUpWithTimeThatPassedWithoutIt) {
  device_.drive({1.0, 0.0}, now_);
  pass(0.1);
  const double before = device_.report(now_).motion->pose.position.x;
  now_ += std::chrono::seconds(60);
  device_.work(now_);
  device_.work(now_);
  EXPECT_LT(device_.report(now_).motion->pose.position.x - before, 1.0);
}

}  // namespace
}  // namespace mlab::vehicle
