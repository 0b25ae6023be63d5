#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::polar;
using geom::Vector;

constexpr double kDegree = std::numbers::pi / 180.0;

Vector run(flow::BehaviorProbe p, const std::vector<percept::Obstacle>& obstacles) {
  p.percepts.obstacles = obstacles;
  p.set("readings", all<flow::Obstacles>(obstacles.size())).step();
  return p.output<Vector>();
}

Vector probing(const std::vector<percept::Obstacle>& obstacles) {
  flow::BehaviorProbe p = probe("Probe");
  p.set("sphere", 2.0).set("safety_margin", 0.5);
  return run(std::move(p), obstacles);
}

TEST(Probe, GoesStraightAheadInTheOpen) {
  expect_near(probing({}), {1.0, 0.0});
  expect_near(probing({{{3.6, 0.0}, 1.0}}), {1.0, 0.0});
}

TEST(Probe, IsBlockedUpToTheEdgeOfTheSphere) {
  expect_near(probing({{{3.5, 0.0}, 1.0}}), polar(5.0 / 6.0, 30.0 * kDegree));
}

TEST(Probe, SeesAnObstacleJustRightOfStraightAhead) {
  expect_near(probing({{polar(2.0, -5.0 * kDegree), 0.5}}), polar(5.0 / 6.0, 30.0 * kDegree));
}

TEST(Probe, TurnsRightWhereTheLeftIsBlocked) {
  expect_near(probing({{{2.0, 0.0}, 0.5}, {polar(2.0, 30.0 * kDegree), 0.5}}),
              polar(5.0 / 6.0, -30.0 * kDegree));
}

TEST(Probe, WantsNothingWhereAllIsBlocked) {
  std::vector<percept::Obstacle> ring;
  for (int i = 0; i < 12; ++i) ring.push_back({polar(2.0, i * 30.0 * kDegree), 0.5});
  expect_near(probing(ring), {});
}

TEST(MoveToFreeSpace, IsBlockedByWhatLiesWithinTheHorizonAsAWhole) {
  flow::BehaviorProbe p = probe("MoveToFreeSpace");
  p.set("horizon", 2.0);
  expect_near(run(p, {{{1.6, 0.0}, 0.3}}), polar(5.0 / 6.0, 30.0 * kDegree));
  expect_near(run(p, {{{1.7, 0.0}, 0.3}}), {1.0, 0.0});
  expect_near(run(p, {}), {1.0, 0.0});
}

}  // namespace
}  // namespace mlab::library_test
