#include "mlab/fleet/fence.h"

#include <algorithm>
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

  void step(const Fence& fence, percept::Action action, double dt, const binding::Passage& passage = {}) {
    if (!fence.allows(kinematics, action, motion, radius, dt, passage)) action = {};
    const geom::Offset ahead{std::cos(motion.pose.heading), std::sin(motion.pose.heading)};
    const binding::WantedMotion wanted =
        binding::drive(kinematics, action, motion.pose.heading, ahead, motion.momentum, dt);
    way = passage.follow(motion.pose.position, wanted.step, radius);
    const geom::Offset gone = way.end() - motion.pose.position;
    const bool is_free = way.end() == motion.pose.position + wanted.step;
    motion = {{way.end(), wanted.heading}, wanted.momentum};
    if (is_free) return;
    const double square = dot(wanted.step, wanted.step);
    motion.momentum.speed *= square > 0.0 ? std::clamp(dot(gone, wanted.step) / square, 0.0, 1.0) : 0.0;
    motion.momentum.velocity = gone * (1.0 / dt);
  }
  binding::Passage::Way way{{}};  ///< of the last step
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
    Body body{{.max_speed = speed, .max_acceleration = 2.0}, {{{50, 30}, 0.0}, {}}};
    for (int i = 0; i < 20'000; ++i) body.step(fence, drive(speed, 0.0), 0.1);
    EXPECT_LE(body.motion.pose.position.x, 99.8 + 1e-3) << speed;
    EXPECT_GT(body.motion.pose.position.x, 99.0 - speed * 0.2) << "nor far from it: " << speed;
    EXPECT_NEAR(length(body.motion.momentum.velocity), 0.0, 0.2 + 1e-9);
  }
}

TEST(Fence, LetsABodyBeDrivenBack) {
  const Fence fence(kField);
  Body body{{.max_speed = 5.0, .max_acceleration = 2.0}, {{{50, 30}, 0.0}, {}}};
  for (int i = 0; i < 500; ++i) body.step(fence, drive(5.0, 0.0), 0.1);
  for (int i = 0; i < 100; ++i) {
    const double back = std::numbers::pi - body.motion.pose.heading;
    body.step(fence, drive(3.0 * std::cos(back), 3.0 * std::sin(back)), 0.1);
  }
  EXPECT_LT(body.motion.pose.position.x, 75.0);
}

TEST(Fence, LetsWhoIsOutsideComeBackAndGoNoFurther) {
  const Fence fence(kField);
  Body body{{}, {{{110, 30}, 0.0}, {}}};
  body.step(fence, drive(1.0, 0.0), 0.1);
  EXPECT_DOUBLE_EQ(body.motion.pose.position.x, 110.0);
  for (int i = 0; i < 200; ++i) {
    const double back = std::numbers::pi - body.motion.pose.heading;
    body.step(fence, drive(std::cos(back), std::sin(back)), 0.1);
  }
  EXPECT_NEAR(body.motion.pose.position.x, 90.0, 1e-6);
}

TEST(Fence, KnowsAWayInsideAlsoOnTheLine) {
  const Fence fence(kNotched);
  const auto expect_way = [&](Point at, geom::Offset way) {
    EXPECT_NEAR(geom::length(fence.inward(at) - way), 0.0, 1e-9) << at.x << ' ' << at.y;
  };
  expect_way({98, 30}, {-1, 0});
  expect_way({103, 30}, {-1, 0});
  expect_way({100, 30}, {-1, 0});
  expect_way({10, 0}, {0, 1});
  EXPECT_GT(fence.inward({55, 40}).x, 0.0) << "on the side of the tongue";
}

TEST(Fence, LetsWhoBeginsExactlyOnTheLineInAndNotOut) {
  const Fence fence(kField);
  for (const Point at : {Point{100, 30}, Point{0, 30}, Point{50, 0}, Point{50, 60}, Point{0, 0}}) {
    const geom::Offset inside = Point{50, 30} - at;
    for (const double ahead : {1.0, -1.0}) {
      Body body{{}, {{at, std::atan2(inside.y, inside.x)}, {}}};
      for (int i = 0; i < 50; ++i) body.step(fence, drive(ahead, 0.0), 0.1);
      if (ahead > 0.0)
        EXPECT_NEAR(geom::distance(body.motion.pose.position, at), 5.0, 1e-6) << at.x << ' ' << at.y;
      else
        EXPECT_GT(fence.depth(body.motion.pose.position), -1e-5) << at.x << ' ' << at.y;
    }
  }
}

TEST(Fence, IsNotJumpedWhereItIsThin) {
  // A tongue of half a metre between two halves.
  const Fence fence(std::array<Point, 8>{
      {{0, 0}, {100, 0}, {100, 60}, {50.25, 60}, {50.25, 5}, {49.75, 5}, {49.75, 60}, {0, 60}}});
  for (const double speed : {1.0, 7.0, 50.0}) {
    Body body{{}, {{{20, 30}, 0.0}, {}}};
    for (int i = 0; i < 100; ++i) body.step(fence, drive(speed, 0.0), 1.0);
    EXPECT_LE(body.motion.pose.position.x, 49.55 + 1e-6) << speed;
  }
}

TEST(Fence, HoldsWhereCyclesBecomeShorter) {
  const Fence fence(kField);
  for (const double x : {20.0, 23.0, 27.0, 31.0}) {
    Body body{{.max_speed = 10.0, .max_acceleration = 2.0}, {{{x, 30}, 0.0}, {}}};
    while (fence.allows(body.kinematics, drive(10.0, 0.0), body.motion, body.radius, 1.0, {}))
      body.step(fence, drive(10.0, 0.0), 1.0);
    for (int i = 0; i < 2000; ++i) body.step(fence, drive(10.0, 0.0), 0.01);
    EXPECT_LE(body.motion.pose.position.x, 99.8 + 1e-3) << x;
  }
}

// @param passage  what is in the way
void expect_nobody_gets_out(const binding::Passage& passage) {
  const Fence fence(kNotched);
  const auto number = [](int least, int most) { return *rc::gen::inRange(least, most) / 100.0; };
  Body body;
  body.kinematics.drive = *rc::gen::element(binding::Drive::kHolonomic, binding::Drive::kDifferential,
                                            binding::Drive::kCar, binding::Drive::kSynchro);
  body.kinematics.max_acceleration = number(0, 500);
  body.kinematics.max_speed = number(0, 2000);
  body.kinematics.max_turn_rate = number(0, 300);
  body.kinematics.max_turn_acceleration = *rc::gen::element(0.0, 1.0);
  body.radius = number(1, 100);
  body.motion.pose = {{20.0, 30.0}, number(-314, 314)};
  const double dt = *rc::gen::element(0.01, 0.1, 0.3, 1.0);
  for (int i = 0; i < 40; ++i) {
    percept::Action action = drive(number(-2000, 2000), number(-2000, 2000));
    action.spins = *rc::gen::arbitrary<bool>();
    action.spin = number(-300, 300);
    for (int cycle = 0; cycle < 25; ++cycle) {
      body.step(fence, action, dt, passage);
      const std::span<const Point> corners = body.way.corners();
      for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
        for (const double share : {0.25, 0.5, 0.75, 1.0}) {
          const Point on_way = corners[k] + (corners[k + 1] - corners[k]) * share;
          RC_ASSERT(fence.depth(on_way) >= body.radius - 1e-3);
        }
      }
    }
  }
}

RC_GTEST_PROP(FenceLaws, NobodyWhoIsWithinGetsOut, ()) {
  expect_nobody_gets_out({});
}

RC_GTEST_PROP(FenceLaws, NobodyIsLedOutByWhatIsInTheWay, ()) {
  const auto number = [](int least, int most) { return *rc::gen::inRange(least, most) / 100.0; };
  binding::Passage passage;
  for (int i = 0; i < 6; ++i)
    passage.add(binding::Disc{{number(3000, 10'000), number(0, 6000)}, number(50, 500)});
  for (int i = 0; i < 3; ++i)
    passage.add(
        geom::Segment{{number(3000, 10'000), number(0, 6000)}, {number(3000, 10'000), number(0, 6000)}});
  passage.keep_within({0.5, 0.5}, {99.5, 59.5});
  expect_nobody_gets_out(passage);
}

}  // namespace
}  // namespace mlab::fleet
