#include <algorithm>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Point;

TEST(RandomPlace, StaysUntilTheRobotIsNearAndThenMoves) {
  flow::BehaviorProbe p = probe("RandomPlace");
  p.set("center", Point{100.0, 200.0})
      .set("half_width", 10.0)
      .set("half_height", 5.0)
      .set("reached", 0.5)
      .step();
  const Point first = p.output<Point>();
  p.step();
  EXPECT_EQ(p.output<Point>(), first);
  p.percepts.pose.position = {first.x + 0.4, first.y};
  p.step();
  EXPECT_NE(p.output<Point>(), first);
}

TEST(RandomPlace, LiesInItsRectangle) {
  flow::BehaviorProbe p = probe("RandomPlace");
  p.set("center", Point{100.0, 200.0}).set("half_width", 10.0).set("half_height", 5.0);
  Point low{1e9, 1e9};
  Point high{-1e9, -1e9};
  for (int i = 0; i < 1000; ++i) {
    p.percepts.pose.position = p.output<Point>();
    p.step();
    const Point place = p.output<Point>();
    low = {std::min(low.x, place.x), std::min(low.y, place.y)};
    high = {std::max(high.x, place.x), std::max(high.y, place.y)};
  }
  EXPECT_GE(low.x, 90.0);
  EXPECT_LT(low.x, 91.0);
  EXPECT_GE(low.y, 195.0);
  EXPECT_LE(high.x, 110.0);
  EXPECT_GT(high.x, 109.0);
  EXPECT_LE(high.y, 205.0);
}

}  // namespace
}  // namespace mlab::library_test
