#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Point;

const std::vector<Point> kRoute = {{0.0, 0.0}, {100.0, 0.0}, {100.0, 100.0}};

class FollowRoute : public testing::Test {
 protected:
  FollowRoute() {
    track_.percepts.order.route = kRoute;
    track_.percepts.order.sequence = 1;
    track_.set("lookahead", 20.0);
  }
  double progress_at(Point center) {
    track_.percepts.unit.center = center;
    track_.step();
    return track_.output<double>();
  }
  Point carrot_at(Point center) {
    flow::BehaviorProbe p = probe("FollowRoute");
    p.set("progress", progress_at(center)).set("lookahead", 20.0);
    p.percepts = track_.percepts;
    p.step();
    return p.output<Point>();
  }
  double remaining_at(Point center) {
    flow::BehaviorProbe p = probe("RouteRemaining");
    p.set("progress", progress_at(center));
    p.percepts = track_.percepts;
    p.step();
    return p.output<double>();
  }
  flow::BehaviorProbe track_ = probe("TrackRoute");
};

TEST_F(FollowRoute, HeadsForTheBeginningFirst) {
  EXPECT_EQ(carrot_at({50.0, 30.0}), (Point{0.0, 0.0}));
  EXPECT_DOUBLE_EQ(progress_at({50.0, 30.0}), -1.0);
  EXPECT_DOUBLE_EQ(remaining_at({30.0, 40.0}), 250.0);
}

TEST_F(FollowRoute, LooksAheadAlongTheRoute) {
  EXPECT_EQ(carrot_at({0.0, 5.0}), (Point{20.0, 0.0}));
  EXPECT_EQ(carrot_at({15.0, 5.0}), (Point{35.0, 0.0}));
  EXPECT_EQ(carrot_at({30.0, 0.0}), (Point{50.0, 0.0}));
  EXPECT_DOUBLE_EQ(remaining_at({30.0, 0.0}), 170.0);
}

TEST_F(FollowRoute, GoesRoundTheCornerToTheEnd) {
  for (double x = 0.0; x <= 95.0; x += 5.0) progress_at({x, 0.0});
  EXPECT_EQ(carrot_at({95.0, 0.0}), (Point{100.0, 15.0}));
  for (double y = 5.0; y <= 95.0; y += 5.0) progress_at({100.0, y});
  EXPECT_EQ(carrot_at({100.0, 95.0}), (Point{100.0, 100.0}));
  EXPECT_NEAR(remaining_at({100.0, 98.0}), 2.0, 1e-9);
}

TEST_F(FollowRoute, NeverFallsBack) {
  for (double x = 0.0; x <= 60.0; x += 10.0) progress_at({x, 0.0});
  EXPECT_DOUBLE_EQ(progress_at({20.0, 0.0}), 60.0);
}

TEST_F(FollowRoute, BeginsAnewWithTheNextCommand) {
  for (double x = 0.0; x <= 60.0; x += 10.0) progress_at({x, 0.0});
  track_.percepts.order.sequence = 2;
  EXPECT_DOUBLE_EQ(progress_at({60.0, 0.0}), -1.0);
}

TEST_F(FollowRoute, GoesToTheGoalWhereThereIsNoRoute) {
  track_.percepts.order.route = {};
  track_.percepts.order.goal = {3.0, 4.0};
  EXPECT_EQ(carrot_at({0.0, 0.0}), (Point{3.0, 4.0}));
  EXPECT_DOUBLE_EQ(remaining_at({0.0, 0.0}), 5.0);
}

}  // namespace
}  // namespace mlab::library_test
