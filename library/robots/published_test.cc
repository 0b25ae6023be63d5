// Published analytic cases of motor schemas, played out: a point robot that moves by a small network of
// procedures.

#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "../testing/network.h"

namespace mlab::library_test {
namespace {

using geom::Point;

constexpr std::string_view kNetwork = R"(
parameter double avoid_gain = 1.5;
parameter double noise_gain = 0;
node goal is DetectGoal with goal = {5, 0}; nend
node pull is MoveToGoal with goal = goal; success_radius = 0.05; nend
node seen is DetectObstacles with range = 100; nend
node push is AvoidStaticObstacles with readings = seen; sphere = 1.5; safety_margin = 0; nend
node noise is Noise with persistence = 6; nend
node sum is WeightedSum with
  members = pull;  gains = 1;
  members = push;  gains = avoid_gain;
  members = noise; gains = noise_gain;
nend
node wheels is Drive with v = sum; base_velocity = 0.1; max_velocity = 0.1; nend
)";

// An obstacle of radius 0.5 at (3, 0) between the robot and its goal at (5, 0); S = 2 m from its centre.
class StallPoint : public testing::Test {
 protected:
  void set(std::string_view parameter, const char* value) {
    EXPECT_FALSE(program_->set(frame_.data(), *program_->find(parameter), value).has_value());
  }
  Point run(Point start, double seconds) {
    percepts_.pose.position = start;
    for (double t = 0.0; t < seconds; t += percepts_.cycle_duration) {
      const std::array<percept::Obstacle, 1> obstacle = {{{percepts_.pose.to_robot(Point{3.0, 0.0}), 0.5}}};
      percepts_.obstacles = obstacle;
      percept::Action action;
      program_->step(frame_.data(), percepts_, action, 3, 1);
      percepts_.pose.position = percepts_.pose.point_at(action.velocity * percepts_.cycle_duration);
      percepts_.time += percepts_.cycle_duration;
    }
    return percepts_.pose.position;
  }

  std::shared_ptr<const flow::Program> program_ = program_of("stall.cnl", kNetwork);
  flow::Frame frame_ = program_->make_frame();
  percept::Percepts percepts_;
};

TEST_F(StallPoint, LiesWherePullAndPushAreEqual) {
  const Point end = run({0.0, 0.0}, 200.0);
  EXPECT_NEAR(end.x, 2.0, 1e-3);
  EXPECT_DOUBLE_EQ(end.y, 0.0);
}

TEST_F(StallPoint, IsStableAlongTheLineAndUnstableAcross) {
  EXPECT_NEAR(run({2.2, 0.0}, 200.0).x, 2.0, 1e-3);
  const Point end = run({2.0, 0.01}, 400.0);
  EXPECT_NEAR(geom::distance(end, {5.0, 0.0}), 0.05, 0.02);
}

TEST_F(StallPoint, IsLeftByNoise) {
  set("noise_gain", "0.1");
  const Point end = run({2.0, 0.0}, 600.0);
  EXPECT_LT(geom::distance(end, {5.0, 0.0}), 0.1);
}

TEST_F(StallPoint, IsReplacedByTheWallWhereThePushIsTooWeak) {
  set("avoid_gain", "0.5");
  EXPECT_NEAR(run({0.0, 0.0}, 100.0).x, 2.5, 0.011);
}

}  // namespace
}  // namespace mlab::library_test
