#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Vector;

constexpr Vector kTouchedLeft{0.0, 1.0, 0.0};

TEST(DetectTouch, TellsWhereTheBodyIsTouched) {
  flow::BehaviorProbe p = probe("DetectTouch");
  p.step();
  EXPECT_EQ(p.output<Vector>(), Vector{});
  p.percepts.touch = kTouchedLeft;
  p.step();
  EXPECT_EQ(p.output<Vector>(), kTouchedLeft);
}

TEST(IsTouching, IsTrueAsLongAsSomethingIsTouched) {
  flow::BehaviorProbe p = probe("IsTouching");
  p.step();
  EXPECT_FALSE(p.output<bool>());
  p.percepts.touch = kTouchedLeft;
  p.step();
  EXPECT_TRUE(p.output<bool>());
  p.percepts.touch = {};
  p.step();
  EXPECT_FALSE(p.output<bool>());
}

TEST(BackOff, PushesAwayForItsTimeAfterTheLastTouch) {
  flow::BehaviorProbe p = probe("BackOff");
  p.set("duration", 0.5);
  p.step();
  EXPECT_EQ(p.output<Vector>(), Vector{}) << "nothing was touched yet";
  p.percepts.time = 10.0;
  p.percepts.touch = kTouchedLeft;
  p.step();
  EXPECT_EQ(p.output<Vector>(), -kTouchedLeft);
  p.percepts.touch = {};
  p.percepts.time = 10.5;
  p.step();
  EXPECT_EQ(p.output<Vector>(), -kTouchedLeft);
  p.percepts.time = 10.6;
  p.step();
  EXPECT_EQ(p.output<Vector>(), Vector{});
}

TEST(BackOff, GoesAwayFromWhatWasTouchedLast) {
  flow::BehaviorProbe p = probe("BackOff");
  p.percepts.touch = kTouchedLeft;
  p.step();
  p.percepts.touch = {1.0, 0.0, 0.0};
  p.step();
  EXPECT_EQ(p.output<Vector>(), (Vector{-1.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace mlab::library_test
