#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

TEST(Sound, PointsToItsSourceInTheRobotFrame) {
  flow::BehaviorProbe p = probe("SOUND");
  p.percepts.pose.heading = std::numbers::pi / 2.0;
  p.set("x", 3.0).set("y", 0.0).step();
  EXPECT_NEAR(p.output<geom::Vector>().y, -1.0, 1e-12);
  p.set("x", 0.0).step();
  EXPECT_EQ(p.output<geom::Vector>(), geom::Vector{});
}

TEST(DetectSound, NeedsItsThreshold) {
  flow::BehaviorProbe p = probe("DETECT_SOUND");
  p.set("volume", 2.9).step();
  EXPECT_FALSE(p.output<bool>());
  p.set("volume", 3.0).step();
  EXPECT_TRUE(p.output<bool>());
}

TEST(DetectSoundMotivated, GetsUsedToIt) {
  flow::BehaviorProbe p = probe("DETECT_SOUND_MOTIVATED");
  p.set("volume", 5.0).set("curiosity", 0.6);
  int heard = 0;
  for (int i = 0; i < 10; ++i) {
    p.step();
    heard += p.output<bool>() ? 1 : 0;
  }
  EXPECT_EQ(heard, 3) << "at 0.6, 0.5 and 0.4";
}

TEST(IsObjectMotivated, NeedsAnObjectAndEveryMoodWithinItsBounds) {
  std::array<percept::ObjectReading, 1> seen;
  seen[0].id = {1};
  flow::BehaviorProbe p = probe("IS_AN_OBJECT_MOTIVATED");
  p.percepts.objects = seen;
  p.step();
  EXPECT_FALSE(p.output<bool>());
  p.set("objects", all<flow::Objects>(1)).step();
  EXPECT_TRUE(p.output<bool>());
  p.set("fear", 0.8).set("fear_upper", 0.7).step();
  EXPECT_FALSE(p.output<bool>());
}

}  // namespace
}  // namespace mlab::library_test
