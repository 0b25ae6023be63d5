#include "mlab/ros2/frames.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

namespace mlab::ros2 {
namespace {

using Time = vehicle::Clock::time_point;
constexpr double kPi = std::numbers::pi;
constexpr Time kNow{std::chrono::hours(1)};

Quaternion yaw(double angle) {
  return {0.0, 0.0, std::sin(angle / 2.0), std::cos(angle / 2.0)};
}

TEST(Frames, LeadFromOneToAnotherByWhatIsAboveBoth) {
  Frames frames;
  frames.take({"base_footprint", "base_link", {0.0, 0.0, 0.1}, {}, true, false}, kNow);
  frames.take({"/base_link", "mast", {0.5, 0.0, 0.0}, yaw(kPi / 2.0), true, false}, kNow);
  frames.take({"mast", "laser", {0.2, 0.0, 1.0}, {}, true, false}, kNow);
  const auto found = frames.find("laser", "base_footprint", kNow);
  ASSERT_TRUE(found);
  const auto seen = flat(*found);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->position.x, 0.5, 1e-12);
  EXPECT_NEAR(seen->position.y, 0.2, 1e-12);
  EXPECT_NEAR(seen->heading, kPi / 2.0, 1e-12);
  const auto back = flat(*frames.find("base_link", "mast", kNow));
  EXPECT_NEAR(back->position.y, 0.5, 1e-12);
  EXPECT_NEAR(back->heading, -kPi / 2.0, 1e-12);
  EXPECT_FALSE(frames.find("camera", "base_link", kNow));
  EXPECT_TRUE(frames.find("camera", "/camera", kNow));
}

TEST(Frames, ForgetWhatMovesAndWasToldLongAgo) {
  Frames frames;
  frames.take({"map", "odom", {1.0, 0.0, 0.0}, {}, false, false}, kNow);
  EXPECT_TRUE(frames.find("odom", "map", kNow));
  EXPECT_FALSE(frames.find("odom", "map", kNow + std::chrono::seconds(1)));
}

TEST(Frames, BelieveTheRobotsOwnTopicRatherThanOneThatAllShare) {
  Frames frames;
  frames.take({"base_link", "laser", {1.0, 0.0, 0.0}, {}, true, true}, kNow);
  frames.take({"base_link", "laser", {9.0, 0.0, 0.0}, {}, true, false}, kNow);
  EXPECT_EQ(frames.find("laser", "base_link", kNow)->translation.x, 1.0);
}

TEST(Frames, LeaveOutWhatIsNoPlaceAndEndInRings) {
  Frames frames;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  frames.take({"a", "b", {nan, 0.0, 0.0}, {}, true, false}, kNow);
  frames.take({"a", "c", {}, {0.0, 0.0, 0.0, 0.0}, true, false}, kNow);
  frames.take({"a", "d", {}, {nan, 0.0, 0.0, 1.0}, true, false}, kNow);
  frames.take({"a", "a", {}, {}, true, false}, kNow);
  frames.take({"", "e", {}, {}, true, false}, kNow);
  frames.take({"a", std::string(1000, 'x'), {}, {}, true, false}, kNow);
  for (const char* const one : {"b", "c", "d", "e"}) EXPECT_FALSE(frames.find(one, "a", kNow)) << one;
  frames.take({"f", "g", {}, {}, true, false}, kNow);
  frames.take({"g", "f", {}, {}, true, false}, kNow);
  EXPECT_FALSE(frames.find("f", "a", kNow));
  for (int i = 0; i < 5000; ++i) frames.take({"a", "x" + std::to_string(i), {}, {}, true, false}, kNow);
  EXPECT_TRUE(frames.find("x10", "a", kNow));
  EXPECT_FALSE(frames.find("x4000", "a", kNow));
}

TEST(Frames, TellWhatIsUpsideDownAndTilted) {
  const auto rolled = placement_of({}, {1.0, 0.0, 0.0, 0.0});
  ASSERT_TRUE(rolled);
  EXPECT_TRUE(is_upside_down(*rolled));
  EXPECT_NEAR(tilt_of(*rolled), 0.0, 1e-9);
  const auto pitched = placement_of({}, {0.0, std::sin(0.25), 0.0, std::cos(0.25)});
  EXPECT_FALSE(is_upside_down(*pitched));
  EXPECT_NEAR(tilt_of(*pitched), 0.5, 1e-9);
  EXPECT_FALSE(flat(*placement_of({}, {0.0, std::sin(kPi / 4.0), 0.0, std::cos(kPi / 4.0)})));
}

}  // namespace
}  // namespace mlab::ros2
