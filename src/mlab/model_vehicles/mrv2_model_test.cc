#include "mlab/model_vehicles/mrv2_model.h"

#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "mlab/lang/odl/odl.h"
#include "mlab/text/diagnostic.h"
#include "mlab/vehicle/mrv2/frames.h"
#include "mlab/vehicle/mrv2/messages.h"

namespace mlab::model_vehicles {
namespace {

namespace mrv2 = vehicle::mrv2;

constexpr double kPeriod = 0.02;

overlay::Overlay world_of_text(const std::string& text) {
  overlay::Overlay world;
  text::Diagnostics sink;
  odl::apply(odl::parse(std::make_shared<const text::Source>("test.odl", text), sink), world, sink);
  EXPECT_EQ(text::render(sink), "");
  return world;
}

/// The vehicle, and what it said last.
class Spoken {
 public:
  explicit Spoken(const Mrv2Spec& spec, const overlay::Overlay& world = {}) : model_(world, spec) {
    go(0.25);
  }

  void say(const mrv2::Message& message) { model_.receive(mrv2::bytes_of(message)); }
  /// Commands hold for a second from now.
  void drive(double speed, double turn_rate = 0.0) {
    say(mrv2::Drive{state.boot, state.time + 1000, speed, turn_rate});
  }
  void go(double seconds) {
    for (double time = 0.0; time < seconds - kPeriod / 2; time += kPeriod) {
      frames_.add(model_.step(kPeriod));
      while (const auto frame = frames_.next()) {
        const auto message = mrv2::message_of(*frame);
        if (!message.has_value()) continue;
        if (const auto* const m = std::get_if<mrv2::State>(&*message)) state = *m;
        if (const auto* const m = std::get_if<mrv2::Ranges>(&*message)) ranges = *m;
        if (const auto* const m = std::get_if<mrv2::Identity>(&*message)) identity = *m;
      }
    }
  }
  Mrv2Model& model() { return model_; }
  double speed() const { return model_.truth().speed; }

  mrv2::State state;
  mrv2::Ranges ranges;
  std::optional<mrv2::Identity> identity;

 private:
  Mrv2Model model_;
  mrv2::FrameReader frames_;
};

TEST(Mrv2Model, SaysWhatItIsWhenItIsAsked) {
  Spoken vehicle({});
  EXPECT_FALSE(vehicle.identity.has_value());
  vehicle.say(mrv2::Ask{});
  vehicle.go(kPeriod);
  ASSERT_TRUE(vehicle.identity.has_value());
  EXPECT_EQ(vehicle.identity->sensors, 24);
  EXPECT_EQ(vehicle.identity->max_speed, 0.1);
  EXPECT_EQ(vehicle.identity->boot, vehicle.state.boot);
}

TEST(Mrv2Model, DrivesUntilTheCommandIsOver) {
  Spoken vehicle({});
  vehicle.drive(0.1);
  vehicle.go(0.8);
  EXPECT_NEAR(vehicle.speed(), 0.1, 1e-9);
  vehicle.go(0.2 + 0.2);  // it was given 50 ms after the state that it counts from, and brakes for 0.2 s
  EXPECT_EQ(vehicle.speed(), 0.0);
  EXPECT_GT(vehicle.model().truth().pose.position.x, 0.07);
}

TEST(Mrv2Model, BrakesByItsWatchdogHoweverLongACommandIsToHold) {
  Spoken vehicle({.watchdog = 0.5});
  vehicle.say(mrv2::Drive{vehicle.state.boot, vehicle.state.time + 60'000, 0.1, 0.0});
  vehicle.go(0.4);
  EXPECT_NEAR(vehicle.speed(), 0.1, 1e-9);
  vehicle.go(0.4);
  EXPECT_EQ(vehicle.speed(), 0.0);
}

TEST(Mrv2Model, RefusesWhatIsOverOrMeantForAnother) {
  Spoken vehicle({});
  vehicle.say(mrv2::Drive{vehicle.state.boot, vehicle.state.time - 1, 0.1, 0.0});
  vehicle.go(0.3);
  EXPECT_EQ(vehicle.speed(), 0.0);
  vehicle.say(
      mrv2::Drive{static_cast<std::uint16_t>(vehicle.state.boot + 1), vehicle.state.time + 1000, 0.1, 0.0});
  vehicle.go(0.3);
  EXPECT_EQ(vehicle.speed(), 0.0);
  const std::uint16_t before = vehicle.state.boot;
  vehicle.model().restart();
  vehicle.go(0.3);
  EXPECT_NE(vehicle.state.boot, before);
}

TEST(Mrv2Model, StandsWhileItsEmergencyStopIsPressed) {
  Spoken vehicle({});
  vehicle.drive(0.1);
  vehicle.go(0.3);
  vehicle.model().press_stop(true);
  vehicle.drive(0.1);
  vehicle.go(0.3);
  EXPECT_EQ(vehicle.speed(), 0.0);
  EXPECT_EQ(vehicle.state.flags, mrv2::State::kStopPressed);
}

TEST(Mrv2Model, LurchesWhenItIsToldTo) {
  Spoken vehicle({.lurches = true});
  int moves = 0;
  int begins = 0;
  bool moved = false;
  for (int i = 0; i < 290; ++i) {  // four lurches of 1.5 s, nearly
    vehicle.drive(0.1);
    vehicle.go(kPeriod);
    const bool is_moving = vehicle.speed() > 0.0;
    begins += is_moving && !moved ? 1 : 0;
    moves += is_moving ? 1 : 0;
    moved = is_moving;
  }
  EXPECT_EQ(begins, 4);
  EXPECT_NEAR(moves * kPeriod, 4 * (1.0 + 0.2), 0.2);  // it brakes for 0.2 s each time
}

TEST(Mrv2Model, HearsTheRoomButForWallsThatItGlancesAt) {
  Mrv2Spec spec{.encoder_noise = 0.0, .place = {{5.0, 3.0}, 0.0}};
  spec.sonar.noise = 0.0;
  spec.sonar.dropout = 0.0;
  Spoken vehicle(spec, world_of_text("CONTROL MEASURES:\nWALL east 7 0 7 6\nOBSTACLE 5 5 0.5\n"));
  ASSERT_EQ(vehicle.ranges.distances.size(), 24U);
  EXPECT_NEAR(vehicle.ranges.distances[0], 2.0 - 0.4, 0.002);
  EXPECT_NEAR(vehicle.ranges.distances[6], 2.0 - 0.5 - 0.4, 0.002);  // to the left
  EXPECT_NEAR(vehicle.ranges.distances[23], 2.0 / std::cos(0.5 * 0.26) - 0.4, 0.01);
  EXPECT_TRUE(std::isinf(vehicle.ranges.distances[21]));  // 45 degrees from straight on
  EXPECT_TRUE(std::isinf(vehicle.ranges.distances[12]));  // nothing is behind it
}

TEST(Mrv2Model, ItsEncodersDriftTheFartherItGoes) {
  Spoken vehicle({.encoder_noise = 0.1, .seed = 4});
  for (int i = 0; i < 600; ++i) {
    vehicle.drive(0.1, 0.05);
    vehicle.go(0.1);
  }
  const geom::Pose truth = vehicle.model().truth().pose;
  EXPECT_GT(geom::distance(vehicle.state.pose.position, truth.position), 0.005);
  EXPECT_LT(geom::distance(vehicle.state.pose.position, truth.position), 1.0);
}

TEST(Mrv2Model, IsStoppedByWhatItMeets) {
  Spoken vehicle({}, world_of_text("CONTROL MEASURES:\nWALL near 0.5 -3 0.5 3\n"));
  for (int i = 0; i < 40; ++i) {
    vehicle.drive(0.1);
    vehicle.go(0.1);
  }
  EXPECT_EQ(vehicle.speed(), 0.0);
  EXPECT_NEAR(vehicle.model().truth().pose.position.x, 0.1, 0.01);
}

TEST(Mrv2Model, SaysTheSameForTheSameSeed) {
  const auto said = [](std::uint64_t seed) {
    Mrv2Model model(world_of_text("CONTROL MEASURES:\nWALL near 3 -3 3 3\n"), {.seed = seed});
    std::string all;
    for (int i = 0; i < 100; ++i) all += model.step(kPeriod);
    return all;
  };
  EXPECT_EQ(said(1), said(1));
  EXPECT_NE(said(1), said(2));
}

}  // namespace
}  // namespace mlab::model_vehicles
