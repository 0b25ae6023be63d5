#include "mlab/fleet/fence.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mlab::fleet {
namespace {

using geom::Point;

constexpr std::array<Point, 4> kField = {{{0, 0}, {100, 0}, {100, 60}, {0, 60}}};
// A field with a tongue that reaches into it.
constexpr std::array<Point, 7> kNotched = {
    {{0, 0}, {100, 0}, {100, 60}, {60, 60}, {50, 20}, {40, 60}, {0, 60}}};

percept::Action drive(double x, double y) {
  percept::Action out;
  out.drives = true;
  out.velocity = {x, y, 0.0};
  return out;
}

// A body that is moved as the simulator moves it, through a fence.
struct Body {
  binding::Kinematics kinematics;
  Motion motion;
  double radius = 0.2;

  void step(const Fence& fence, percept::Action action, double dt) {
    if (!fence.allows(kinematics, action, motion, radius, dt)) action = {};
    const geom::Offset ahead{std::cos(motion.pose.heading), std::sin(motion.pose.heading)};
    const binding::Momentum now{motion.velocity, dot(motion.velocity, ahead), motion.turn_rate};
    const binding::WantedMotion wanted =
        binding::drive(kinematics, action, motion.pose.heading, ahead, now, dt);
    motion = {{motion.pose.position + wanted.step, wanted.heading},
              wanted.momentum.velocity,
              wanted.momentum.turn_rate};
  }
};

TEST(Fence, TellsInsideFromOutsideByTheSignOfTheDepth) {
  const Fence fence(kField);
  EXPECT_DOUBLE_EQ(fence.depth({50, 30}), 30.0);
  EXPECT_DOUBLE_EQ(fence.depth({98, 30}), 2.0);
  EXPECT_DOUBLE_EQ(fence.depth({103, 30}), -3.0);
  EXPECT_DOUBLE_EQ(fence.depth({103, 64}), -5.0);
  const Fence notched(kNotched);
  EXPECT_LT(notched.depth({50, 40}), 0.0) << "in the tongue";
  EXPECT_GT(notched.depth({50, 10}), 0.0);
}

TEST(Fence, StopsABodyBeforeTheLineFromAnySpeed) {
  const Fence fence(kField);
  for (const double speed : {0.1, 1.0, 5.0, 20.0}) {
    Body body{{.max_speed = speed, .max_acceleration = 2.0}, {{{50, 30}, 0.0}, {}, 0.0}};
    for (int i = 0; i < 20'000; ++i) body.step(fence, drive(speed, 0.0), 0.1);
    EXPECT_LE(body.motion.pose.position.x, 99.8 + 1e-3) << speed;
    EXPECT_GT(body.motion.pose.position.x, 99.0 - speed * 0.2) << "nor far from it: " << speed;
    EXPECT_NEAR(length(body.motion.velocity), 0.0, 0.2 + 1e-9);
  }
}

TEST(Fence, LetsABodyBeDrivenBack) {
  const Fence fence(kField);
  Body body{{.max_speed = 5.0, .max_acceleration = 2.0}, {{{50, 30}, 0.0}, {}, 0.0}};
  for (int i = 0; i < 500; ++i) body.step(fence, drive(5.0, 0.0), 0.1);
  for (int i = 0; i < 100; ++i) {
    const double back = std::numbers::pi - body.motion.pose.heading;
    body.step(fence, drive(3.0 * std::cos(back), 3.0 * std::sin(back)), 0.1);
  }
  EXPECT_LT(body.motion.pose.position.x, 75.0);
}

TEST(Fence, LetsWhoIsOutsideComeBackAndGoNoFurther) {
  const Fence fence(kField);
  Body body{{}, {{{110, 30}, 0.0}, {}, 0.0}};
  body.step(fence, drive(1.0, 0.0), 0.1);
  EXPECT_DOUBLE_EQ(body.motion.pose.position.x, 110.0);
  for (int i = 0; i < 200; ++i) {
    const double back = std::numbers::pi - body.motion.pose.heading;
    body.step(fence, drive(std::cos(back), std::sin(back)), 0.1);
  }
  EXPECT_NEAR(body.motion.pose.position.x, 90.0, 1e-6);
}

RC_GTEST_PROP(FenceLaws, NobodyWhoIsWithinGetsOut, ()) {
  const Fence fence(kNotched);
  const auto number = [](int least, int most) { return *rc::gen::inRange(least, most) / 100.0; };
  Body body;
  body.kinematics.drive = *rc::gen::element(binding::Drive::kHolonomic, binding::Drive::kDifferential,
                                            binding::Drive::kCar, binding::Drive::kSynchro);
  body.kinematics.max_acceleration = number(0, 500);
  body.kinematics.max_speed = number(0, 2000);
  body.kinematics.max_turn_rate = number(0, 300);
  body.radius = number(0, 100);
  body.motion.pose = {{20.0, 30.0}, number(-314, 314)};
  for (int i = 0; i < 40; ++i) {
    percept::Action action = drive(number(-2000, 2000), number(-2000, 2000));
    action.spins = *rc::gen::arbitrary<bool>();
    action.spin = number(-300, 300);
    for (int cycle = 0; cycle < 25; ++cycle) {
      body.step(fence, action, 0.1);
      RC_ASSERT(fence.depth(body.motion.pose.position) >= body.radius - 1e-3);
    }
  }
}

}  // namespace
}  // namespace mlab::fleet
