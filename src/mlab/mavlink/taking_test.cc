// Who has changed what a rover is told to be: this itself, or somebody else.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "mlab/mavlink/testing/drive.h"
#include "mlab/vehicle/server.h"

namespace mlab::mavlink {
namespace {

using testing::Pair;
using vehicle::Readiness;

RoverSettings two_metres_a_second() {
  RoverSettings out;
  out.limits.kinematics.max_speed = 2.0;
  out.limits.kinematics.max_turn_rate = 1.0;
  return out;
}

/// A rover that is driven.
struct Driven : Pair {
  Driven() : Pair(two_metres_a_second()) {
    pass(2.0);
    drive(1.0, {1.0, 0.0});
    EXPECT_EQ(report().readiness, Readiness::kReady) << why();
  }
  void stop_for(double seconds) {
    pass(seconds, [&] { device->stop(now); });
  }
};

TEST(RoverTaking, IsNoticedRightAfterAStopOfOurs) {
  Driven pair;
  pair.stop_for(0.5);
  ASSERT_EQ(pair.rover.mode, Mode::kHold);
  pair.drive(1.0, {1.0, 0.0});
  ASSERT_NEAR(pair.rover.speed, 1.0, 1e-6);
  pair.rover.mode = Mode::kHold;  // by a pilot, one second later
  pair.drive(5.0, {1.0, 0.0});
  EXPECT_EQ(pair.report().readiness, Readiness::kTaken) << pair.why();
  EXPECT_EQ(pair.why(),
            "was put into mode HOLD by itself or by somebody else; Replace in the console takes it back");
  EXPECT_EQ(pair.rover.mode, Mode::kHold);
  pair.device->engage(pair.now);
  pair.drive(2.0, {1.0, 0.0});
  EXPECT_NEAR(pair.rover.speed, 1.0, 1e-6) << "a person wants it driven anew";
}

TEST(RoverTaking, IsNoticedBeforeTheRoverWasSeenToDoWhatWasAsked) {
  Driven pair;
  pair.stop_for(1.0);
  for (int i = 0; i < 20 && pair.rover.mode != Mode::kGuided; ++i) pair.drive(0.05, {1.0, 0.0});
  ASSERT_EQ(pair.rover.mode, Mode::kGuided);
  pair.rover.mode = Mode::kHold;
  pair.drive(3.0, {1.0, 0.0});
  EXPECT_EQ(pair.report().readiness, Readiness::kTaken) << pair.why();
  EXPECT_EQ(pair.rover.mode, Mode::kHold) << "it is not fought about";
}

TEST(RoverTaking, IsNoticedOfARoverThatIsDisarmedWhileItStands) {
  Driven pair;
  pair.stop_for(1.0);
  pair.rover.is_armed = false;
  pair.stop_for(0.5);
  pair.drive(3.0, {1.0, 0.0});
  EXPECT_EQ(pair.report().readiness, Readiness::kTaken) << pair.why();
  EXPECT_FALSE(pair.rover.is_armed);
  pair.device->engage(pair.now);
  pair.drive(3.0, {1.0, 0.0});
  EXPECT_TRUE(pair.rover.is_armed);
}

// Also where what it was told, and what it says of it, is under way at the same time, and some of it lost.
TEST(RoverTaking, IsNotMadeOutOfStopsOfOurs) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Driven pair;
    base::Random random(seed);
    pair.link.random = base::Random(seed + 1000);
    pair.link.delay = std::chrono::milliseconds(50 * random.below(5));
    pair.link.loss = seed % 2 == 0 ? 0.2 : 0.0;
    for (int i = 0; i < 10; ++i) {
      pair.stop_for(0.05 + random.uniform(0.0, 0.8));
      pair.pass(0.05 + random.uniform(0.0, 1.5), [&] {
        pair.device->drive({1.0, 0.0}, pair.now);
        EXPECT_NE(pair.report().readiness, Readiness::kTaken) << pair.why();
      });
    }
  }
}

TEST(RoverTaking, IsNoticedWheneverARoverIsDriven) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Driven pair;
    base::Random random(seed);
    pair.link.delay = std::chrono::milliseconds(50 * random.below(5));
    pair.drive(1.0, {1.0, 0.0});
    pair.stop_for(random.uniform(0.05, 1.0));
    pair.drive(1.5 + random.uniform(0.0, 2.0), {1.0, 0.0});
    pair.rover.mode = Mode::kHold;
    pair.drive(2.0, {1.0, 0.0});
    EXPECT_EQ(pair.report().readiness, Readiness::kTaken) << pair.why();
    EXPECT_EQ(pair.rover.mode, Mode::kHold);
  }
}

TEST(RoverTaking, IsListenedToByItsServer) {
  Pair pair(two_metres_a_second());
  vehicle::Server server(*pair.device, [] { return false; });
  mlab::wire::VehicleReport told;
  std::uint64_t number = 0;
  const auto go = [&](double seconds, bool is_told) {
    for (std::int64_t i = 0; i < std::llround(seconds * 20.0); ++i) {
      pair.now += std::chrono::milliseconds(50);
      pair.rover.work(pair.now);
      ASSERT_TRUE(told.ParseFromString(server.report(pair.now)));
      mlab::wire::VehicleCommand command;
      command.set_session(7);
      command.set_number(++number);
      command.set_answers(told.number());
      command.set_drives(true);
      command.set_velocity_x(1.0);
      command.set_period(0.1);
      if (is_told) server.hear("run", command.SerializeAsString(), pair.now);
      server.work(pair.now);
    }
  };
  go(4.0, true);
  ASSERT_NEAR(pair.rover.speed, 1.0, 1e-6);
  go(1.0, false);
  ASSERT_EQ(pair.rover.mode, Mode::kHold) << server.standing();
  go(1.5, true);
  ASSERT_NEAR(pair.rover.speed, 1.0, 1e-6) << "its own stop has taken it from nobody";
  pair.rover.mode = Mode::kHold;
  go(1.0, true);
  EXPECT_EQ(static_cast<Readiness>(told.readiness()), Readiness::kTaken);
  EXPECT_EQ(server.standing(), "somebody else has taken it");
  pair.rover.mode = Mode::kGuided;  // he lets go of it
  go(3.0, true);
  EXPECT_EQ(static_cast<Readiness>(told.readiness()), Readiness::kTaken);
  EXPECT_EQ(pair.rover.speed, 0.0);
}

}  // namespace
}  // namespace mlab::mavlink
