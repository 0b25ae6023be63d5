// A robot under ROS 2 by what every device has to hold, on a clock of its own.

#include <memory>

#include "mlab/ros2/ros2_device.h"
#include "mlab/ros2/testing/toy_robot.h"
#include "mlab/vehicle/testing/conformance.h"

namespace mlab::vehicle {
namespace {

using ros2::testing::ToyRobot;
using ros2::testing::ToySpec;

constexpr auto kPeriod = std::chrono::milliseconds(20);

class Ros2Rig final : public Rig {
 public:
  Ros2Rig(std::uint64_t seed, const ToySpec& spec) : robot_(spec, seed) {
    facts_ = {.silent_after = 1.0,
              .stops_within = 0.5,
              .has_ranges = true,
              .has_battery = true,
              .refuses_late_commands = spec.is_stamped};
    ros2::RobotSettings settings;
    if (spec.navigator != ros2::Services::kNone) {
      settings.drives = ros2::Drives::kGoals;
      settings.limits.standstill = ros2::standstill_with_goals(1.0, 0.5);
      facts_.holds_turn_rates = false;
    }
    device_ = std::make_unique<ros2::Ros2Device>(robot_.link(), settings);
  }
  const Facts& facts() const override { return facts_; }
  Device& device() override { return *device_; }
  void drop_device() override { device_.reset(); }
  Clock::time_point step() override {
    now_ += kPeriod;
    robot_.step(now_, std::chrono::duration<double>(kPeriod).count());
    return now_;
  }
  Truth truth() const override { return {robot_.pose, robot_.speed, robot_.turn_rate}; }
  void impair(const Impairment& impairment) override {
    robot_.network.loss = impairment.loss;
    robot_.network.delay = impairment.delay;
  }
  void cut(Cut how) override {
    robot_.network.is_cut = true;
    robot_.network.clear();
    robot_.listens = how == Cut::kSilence;
    is_off_ = how == Cut::kPowerOff || how == Cut::kRestart;
    robot_.is_on = !is_off_;
    if (is_off_) robot_.restart();
  }
  void mend() override {
    if (is_off_) robot_.restart();
    is_off_ = false;
    robot_.is_on = robot_.listens = true;
    robot_.network.is_cut = false;
  }
  bool take() override {
    if (robot_.spec().navigator == ros2::Services::kNone) return false;
    ros2::Goal far;
    far.x = 1e6;
    robot_.give(far);
    return true;
  }
  void hold_back() override { robot_.network.is_held_back = true; }
  void release() override { robot_.network.is_held_back = false; }

 private:
  Facts facts_;
  ToyRobot robot_;
  std::unique_ptr<Device> device_;
  Clock::time_point now_{std::chrono::hours(1)};
  bool is_off_ = false;
};

RigKind kind(const char* name, const ToySpec& spec) {
  return {name, [spec](std::uint64_t seed) { return std::make_unique<Ros2Rig>(seed, spec); }};
}

INSTANTIATE_TEST_SUITE_P(Ros2, Conformance,
                         testing::Values(kind("Twist", {}), kind("TwistStamped", {.is_stamped = true}),
                                         kind("Goals", {.navigator = ros2::Services::kPlain})),
                         kind_name);

}  // namespace
}  // namespace mlab::vehicle
