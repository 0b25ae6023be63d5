#include <numbers>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(IsFacing, AllowsItsAccuracyAcrossTheWrap) {
  flow::BehaviorProbe p = probe("IsFacing");
  p.set("heading", kPi).set("accuracy", 0.1);
  const auto at = [&](double heading) {
    p.percepts.pose.heading = heading;
    p.step();
    return p.output<bool>();
  };
  EXPECT_TRUE(at(-kPi + 0.09));
  EXPECT_TRUE(at(kPi - 0.09));
  EXPECT_FALSE(at(kPi - 0.11));
  EXPECT_FALSE(at(0.0));
}

TEST(HasTurned, AddsUpTurningEitherWay) {
  flow::BehaviorProbe p = probe("HasTurned");
  p.set("angle", 1.0);
  const auto at = [&](double heading) {
    p.percepts.pose.heading = heading;
    p.step();
    return p.output<bool>();
  };
  EXPECT_FALSE(at(3.0));
  EXPECT_FALSE(at(3.4 - 2.0 * kPi));
  EXPECT_FALSE(at(3.0));
  EXPECT_TRUE(at(3.3));
  EXPECT_FALSE(at(3.9));
}

TEST(MovedDistance, IsTheWayAlongThePath) {
  flow::BehaviorProbe p = probe("MovedDistance");
  p.set("distance", 10.0);
  const auto at = [&](double x, double y) {
    p.percepts.pose.position = {x, y};
    p.step();
    return p.output<bool>();
  };
  EXPECT_FALSE(at(7.0, 7.0));
  EXPECT_FALSE(at(10.0, 11.0));
  EXPECT_TRUE(at(7.0, 7.0));
  p.skip();
  EXPECT_FALSE(at(7.0, 7.0));
}

TEST(HasStopped, NeedsThePoseToStayForItsDelay) {
  flow::BehaviorProbe p = probe("HasStopped");
  p.percepts.cycle_duration = 1.0;
  p.set("delay", 2.0);
  const auto at = [&](double x) {
    p.percepts.pose.position.x = x;
    p.step();
    return p.output<bool>();
  };
  EXPECT_FALSE(at(0.0));
  EXPECT_FALSE(at(0.0));
  EXPECT_FALSE(at(0.5));
  EXPECT_FALSE(at(0.5));
  EXPECT_TRUE(at(0.5));
}

}  // namespace
}  // namespace mlab::library_test
