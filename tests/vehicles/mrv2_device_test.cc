// What the suite does not ask of every device: what an MRV-2 says of itself, and what becomes of it.

#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <string>

#include <gtest/gtest.h>

#include "mlab/lang/odl/odl.h"
#include "mlab/model_vehicles/mrv2_model.h"
#include "mlab/vehicle/mrv2/messages.h"
#include "mlab/vehicle/mrv2/mrv2.h"
#include "mlab/vehicle/testing/line.h"

namespace mlab::vehicle {
namespace {

constexpr double kSeconds = 0.02;
constexpr auto kStep = std::chrono::milliseconds(20);

overlay::Overlay room() {
  overlay::Overlay world;
  text::Diagnostics sink;
  const std::string text = "CONTROL MEASURES:\nWALL east 3 -5 3 5\n";
  odl::apply(odl::parse(std::make_shared<const text::Source>("room.odl", text), sink), world, sink);
  return world;
}

/// An MRV-2 and its device.
class Mrv2 : public testing::Test {
 protected:
  void begin(model_vehicles::Mrv2Spec spec = {}) {
    spec.sonar.noise = 0.0;
    spec.sonar.dropout = 0.0;
    model_ = std::make_unique<model_vehicles::Mrv2Model>(room(), spec);
    auto made = make_mrv2_over(line_.device_end());
    ASSERT_TRUE(made.has_value());
    device_ = std::move(*made);
    go(2.0);
  }
  void go(double seconds) {
    for (double time = 0.0; time < seconds; time += kSeconds) {
      now_ += kStep;
      model_->receive(line_.read(now_));
      line_.write(model_->step(kSeconds), now_);
      device_->work(now_);
    }
  }
  const Report& report() { return device_->report(now_); }

  TestLine line_{1};
  std::unique_ptr<model_vehicles::Mrv2Model> model_;
  std::unique_ptr<Device> device_;
  Clock::time_point now_{std::chrono::hours(1)};
};

TEST_F(Mrv2, TellsDistancesFromItsMiddle) {
  begin();
  ASSERT_EQ(report().scans.size(), 1U);
  const Scan& scan = report().scans[0];
  ASSERT_EQ(scan.distances.size(), 24U);
  EXPECT_NEAR(scan.distances[0], 3.0, 0.003);
  EXPECT_TRUE(std::isinf(scan.distances[12]));
  EXPECT_NEAR(scan.step * 24, 2.0 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(scan.nearest, 0.55, 0.001);
  EXPECT_NEAR(scan.farthest, 7.4, 0.001);
}

TEST_F(Mrv2, IsNotReadyWhileItsEmergencyStopIsPressed) {
  begin();
  EXPECT_EQ(report().readiness, Readiness::kReady);
  model_->press_stop(true);
  go(0.3);
  EXPECT_EQ(report().readiness, Readiness::kTaken);
  EXPECT_EQ(report().why, "has its emergency stop pressed");
  EXPECT_TRUE(report().motion.has_value());
  device_->drive({0.1, 0.0}, now_);
  model_->press_stop(false);
  go(0.5);
  EXPECT_EQ(report().readiness, Readiness::kReady);
  EXPECT_EQ(model_->truth().speed, 0.0);  // what it was told before does not count
}

TEST_F(Mrv2, IsNotReadyWhereItCanNotBrakeAsItsLimitsPromise) {
  begin({.max_acceleration = 0.1});
  EXPECT_EQ(report().readiness, Readiness::kNotReady);
  EXPECT_EQ(report().why, "brakes with 0.1 m/s^2; expected are at least 0.5 m/s^2");
}

TEST_F(Mrv2, LeavesOutDistancesThatItsSensorsCanNotMeasure) {
  begin();
  const auto boot = static_cast<std::uint16_t>(0x1234);
  const auto say = [&](const mrv2::Message& message) {
    line_.write(mrv2::bytes_of(message), now_);
    now_ += kStep;
    device_->work(now_);
  };
  say(mrv2::Identity{boot, false, 0.4, 0.1, 1.57, 0.5, 1.0, 3, 7.0, 0.15, 0.26});
  std::uint32_t time = 0;
  for (; time < 600; time += 20) say(mrv2::State{boot, time, {}, 0.0, 0.0, 0, 24.0, 0.5});
  say(mrv2::Ranges{boot, time, {0.05F, 30.0F, 2.0F}});
  go(0.0);
  ASSERT_EQ(report().scans.size(), 1U);
  EXPECT_TRUE(std::isnan(report().scans[0].distances[0]));
  EXPECT_TRUE(std::isnan(report().scans[0].distances[1]));
  EXPECT_NEAR(report().scans[0].distances[2], 2.4, 0.001);
  say(mrv2::Ranges{boot, time + 20, {2.0F}});  // of another ring
  EXPECT_EQ(report().scans[0].distances.size(), 3U);
}

TEST(Mrv2Settings, AreRefusedWithWhatIsExpected) {
  EXPECT_EQ(make_mrv2("serial:/dev/ttyS0:9600", {.max_speed = -1.0}).error(),
            "the MRV-2's speed is -1 m/s; expected is more than 0");
  EXPECT_EQ(make_mrv2("serial:/dev/ttyS0:9600", {.hold = 0.1}).error(),
            "commands hold for 0.1 s; expected is more than 0.2 s");
  const auto nowhere = make_mrv2("ttyS0");
  ASSERT_FALSE(nowhere.has_value());
  EXPECT_NE(nowhere.error().find("ttyS0"), std::string::npos) << nowhere.error();
  EXPECT_EQ((*make_mrv2("serial:/dev/ttyS0:9600"))->name(), "MRV-2 at serial:/dev/ttyS0:9600");
}

}  // namespace
}  // namespace mlab::vehicle
