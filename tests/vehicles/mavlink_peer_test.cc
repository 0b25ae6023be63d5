// A rover that speaks MAVLink by somebody else's implementation, driven over UDP. Its time and the device's
// run faster than the machine's.

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <numbers>
#include <thread>

#include <gtest/gtest.h>

#include "mlab/mavlink/rover_device.h"
#include "rover_peer.h"

namespace mlab::vehicles {
namespace {

using mavlink::RoverDevice;
using mavlink::RoverSettings;
using vehicle::Readiness;
using Clock = vehicle::Clock;

// The device's time: it begins when the test does.
Clock::time_point fast_now() {
  static const auto kBegan = Clock::now();
  return kBegan + (Clock::now() - kBegan) * kSpeed;
}

RoverSettings settings_of(const std::string& key = "") {
  RoverSettings out;
  out.limits.kinematics.max_speed = 2.0;
  out.limits.kinematics.max_turn_rate = 1.0;
  out.limits.min_speed = -1.0;
  if (!key.empty()) out.key = mavlink::parse_key(key).value();
  return out;
}

std::unique_ptr<RoverDevice> device_at(std::uint16_t port, const RoverSettings& settings) {
  const auto address = vehicle::parse_address("udp:" + std::to_string(port));
  return std::make_unique<RoverDevice>(vehicle::make_stream(*address), settings);
}

class MavlinkPeer : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::is_directory(std::filesystem::path(MLAB_VEHICLES_FOLDER) / "node_modules"))
      GTEST_SKIP() << "no node-mavlink in " << MLAB_VEHICLES_FOLDER << ": ./mlab test --only e2e installs it";
  }

  // Goes on until this is so, at most so many seconds of the device's time; in each step something is done.
  bool until(RoverDevice& device, double seconds, const std::function<bool()>& is_so,
             const std::function<void()>& each = {}) {
    const auto end =
        fast_now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    while (!is_so()) {
      if (fast_now() > end) return false;
      if (relay) relay->work();
      device.work(fast_now());
      if (each) each();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
  }
  void pass(RoverDevice& device, double seconds, const std::function<void()>& each = {}) {
    until(device, seconds, [] { return false; }, each);
  }
  // Until it is ready, while it is driven.
  bool begin(RoverDevice& device, const vehicle::Command& command = {}) {
    const bool is_well = until(device, 30.0, [&] { return device.report(fast_now()).why == "is not armed"; });
    return is_well &&
           until(
               device, 20.0, [&] { return device.report(fast_now()).readiness == Readiness::kReady; },
               [&] { device.drive(command, fast_now()); });
  }

  std::unique_ptr<Relay> relay;
};

TEST_F(MavlinkPeer, IsArmedDrivenStoppedAndLeftToWhoTakesIt) {
  const std::uint16_t port = free_port();
  RoverPeer rover(port);
  const auto device = device_at(port, settings_of());
  ASSERT_TRUE(begin(*device)) << device->report(fast_now()).why;
  EXPECT_EQ(rover.ask()["mode"], 15);
  EXPECT_EQ(rover.ask()["armed"], true);
  const auto motion = [&] { return device->report(fast_now()).motion.value_or(vehicle::Motion{}); };

  // North, which is our y. Where a busy machine keeps us from driving, the rover stands meanwhile.
  const auto goes_north = [&] {
    return motion().pose.position.y > 2.0 && std::abs(motion().speed - 1.0) < 0.01;
  };
  EXPECT_TRUE(until(*device, 20.0, goes_north, [&] { device->drive({1.0, 0.0}, fast_now()); }));
  EXPECT_NEAR(motion().pose.position.x, 0.0, 1e-3);
  // To the left, which is west.
  EXPECT_TRUE(until(
      *device, 20.0, [&] { return motion().pose.heading > std::numbers::pi * 0.9; },
      [&] { device->drive({0.5, 1.0}, fast_now()); }));
  EXPECT_LT(rover.ask()["east"].get<double>(), 0.0);
  EXPECT_TRUE(until(
      *device, 10.0, [&] { return motion().speed < -0.5; }, [&] { device->drive({-1.0, 0.0}, fast_now()); }));

  const vehicle::Report report = device->report(fast_now());
  ASSERT_TRUE(report.battery);
  EXPECT_NEAR(report.battery->share, 0.77, 1e-9);
  EXPECT_NEAR(report.battery->voltage, 12.6, 1e-6);
  ASSERT_EQ(report.scans.size(), 1U);
  const vehicle::Scan& scan = report.scans[0];
  // The eighteenth of 72 lies to the right.
  for (std::size_t i = 0; i < scan.distances.size(); ++i) {
    const double angle =
        std::remainder(scan.first_angle + scan.step * static_cast<double>(i), 2.0 * std::numbers::pi);
    const bool is_right = std::abs(angle + std::numbers::pi / 2.0) < 0.01;
    EXPECT_EQ(std::isinf(scan.distances[i]), !is_right) << angle;
    if (is_right) {
      EXPECT_NEAR(scan.distances[i], 2.5, 1e-6);
    }
  }
  const auto checks = device->checks(fast_now());
  const auto firmware = std::ranges::find(checks, "firmware", &vehicle::Check::name);
  ASSERT_NE(firmware, checks.end());
  EXPECT_EQ(firmware->is, "is ArduPilot 4.5.7, revision 9c2f1e4a");
  ASSERT_TRUE(device->place(fast_now()));
  EXPECT_NEAR(device->place(fast_now())->latitude, 49.0 * std::numbers::pi / 180.0, 1e-9);

  device->stop(fast_now());
  EXPECT_TRUE(until(*device, 2.0, [&] { return rover.ask()["speed"] == 0.0; }));
  EXPECT_TRUE(
      until(*device, 2.0, [&] { return device->report(fast_now()).why == "is in mode HOLD, not GUIDED"; }));
  EXPECT_EQ(rover.ask()["armed"], true);
  EXPECT_EQ(rover.ask()["forced"], 0);

  const auto drive = [&] { device->drive({1.0, 0.0}, fast_now()); };
  EXPECT_TRUE(until(*device, 10.0, [&] { return rover.ask()["speed"] == 1.0; }, drive));
  rover.ask("mode 0");
  EXPECT_TRUE(until(
      *device, 5.0, [&] { return device->report(fast_now()).why.starts_with("was put into mode MANUAL"); },
      drive));
  const int set_points = rover.ask()["setPoints"];
  pass(*device, 1.0, drive);
  EXPECT_EQ(rover.ask()["mode"], 0);
  EXPECT_EQ(rover.ask()["setPoints"], set_points);
}

TEST_F(MavlinkPeer, IsSilentWhileTheLinkIsCutAndWhenItIsKilled) {
  const std::uint16_t port = free_port();
  relay = std::make_unique<Relay>(port, 1);
  RoverPeer rover(relay->port());
  const auto device = device_at(port, settings_of());
  const auto is_silent = [&] { return device->report(fast_now()).readiness == Readiness::kSilent; };
  ASSERT_TRUE(begin(*device)) << device->report(fast_now()).why;
  EXPECT_TRUE(until(
      *device, 5.0, [&] { return rover.ask()["speed"] == 1.0; },
      [&] { device->drive({1.0, 0.0}, fast_now()); }));
  relay->is_cut = true;
  EXPECT_TRUE(until(*device, 4.0, is_silent, [&] { device->drive({1.0, 0.0}, fast_now()); }));
  EXPECT_TRUE(until(*device, 2.0, [&] { return rover.ask()["speed"] == 0.0; }));
  relay->is_cut = false;
  EXPECT_TRUE(until(*device, 5.0, [&] { return !is_silent(); }));
  pass(*device, 1.0);
  EXPECT_EQ(rover.ask()["speed"], 0.0) << "it stands until the next drive";
  EXPECT_TRUE(until(
      *device, 15.0, [&] { return rover.ask()["speed"] == 1.0; },
      [&] { device->drive({1.0, 0.0}, fast_now()); }))
      << device->report(fast_now()).why;
  rover.kill();
  EXPECT_TRUE(until(*device, 4.0, is_silent, [&] { device->drive({1.0, 0.0}, fast_now()); }));
  // Another one, from another port of its own.
  RoverPeer again(relay->port());
  EXPECT_TRUE(begin(*device)) << device->report(fast_now()).why;
}

TEST_F(MavlinkPeer, ObeysWhoHasTheKeyAndNobodyElse) {
  const std::uint16_t port = free_port();
  RoverPeer rover(port, {"key=ours"});
  auto device = device_at(port, settings_of("passphrase:ours"));
  ASSERT_TRUE(begin(*device, {1.0, 0.0})) << device->report(fast_now()).why;
  EXPECT_EQ(rover.ask()["refused"], 0);
  EXPECT_EQ(device->refusals().wrong_signatures, 0U);
  device = device_at(port, settings_of("passphrase:theirs"));
  pass(*device, 2.0);
  EXPECT_EQ(device->report(fast_now()).why, "has not been heard yet: what comes is signed with another key");
  EXPECT_GT(rover.ask()["refused"].get<int>(), 0);
}

TEST_F(MavlinkPeer, IsDrivenOverALinkThatLosesAFifthAndIsLate) {
  constexpr std::uint64_t kSeed = 11;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  const std::uint16_t port = free_port();
  relay = std::make_unique<Relay>(port, kSeed);
  relay->loss = 0.2;
  relay->delay = std::chrono::milliseconds(200) / kSpeed;
  RoverPeer rover(relay->port());
  const auto device = device_at(port, settings_of());
  ASSERT_TRUE(begin(*device)) << device->report(fast_now()).why;
  EXPECT_TRUE(until(
      *device, 15.0, [&] { return rover.ask()["north"] > 4.0; },
      [&] { device->drive({1.0, 0.0}, fast_now()); }))
      << device->report(fast_now()).why;
  device->stop(fast_now());
  EXPECT_TRUE(until(*device, 3.0, [&] { return rover.ask()["speed"] == 0.0; }));
}

TEST_F(MavlinkPeer, StandsWithinItsStatedTimeWhenWhoDrivesItIsKilled) {
  const std::uint16_t port = free_port();
  RoverPeer rover(port);
  const pid_t driver = ::fork();
  if (driver == 0) {
    const auto device = device_at(port, settings_of());
    for (;;) {
      device->work(fast_now());
      device->drive({1.0, 0.0}, fast_now());
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
  for (int i = 0; i < 4000 && rover.ask()["speed"] < 1.0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(rover.ask()["speed"], 1.0);
  ::kill(driver, SIGKILL);
  ::waitpid(driver, nullptr, 0);
  const double killed_at = rover.ask()["time"];
  nlohmann::json state = rover.ask();
  while (state["speed"] > 0.0 && state["time"] < killed_at + 60.0) state = rover.ask();
  ASSERT_EQ(state["speed"], 0.0);
  EXPECT_LT(state["stoodAt"].get<double>() - killed_at, settings_of().limits.standstill + 0.4);
}

}  // namespace
}  // namespace mlab::vehicles
