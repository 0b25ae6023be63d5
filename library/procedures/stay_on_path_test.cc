#include <numbers>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Point;
using geom::Vector;

Vector stay(Point robot, double heading, Point start, Point end, double width) {
  flow::BehaviorProbe p = probe("StayOnPath");
  p.percepts.pose = {robot, heading};
  p.set("start", start).set("end", end).set("width", width).step();
  return p.output<Vector>();
}

TEST(StayOnPath, PullsFullyBesideThePath) {
  expect_near(stay({5.0, 30.0}, 0.0, {0.0, 0.0}, {10.0, 0.0}, 4.0), {0.0, -1.0});
}

TEST(StayOnPath, PullsEverMoreGentlyOnThePath) {
  expect_near(stay({5.0, 2.0}, 0.0, {0.0, 0.0}, {10.0, 0.0}, 4.0), {0.0, -1.0});
  expect_near(stay({5.0, 1.0}, 0.0, {0.0, 0.0}, {10.0, 0.0}, 4.0), {0.0, -0.5});
  expect_near(stay({5.0, -1.0}, 0.0, {0.0, 0.0}, {10.0, 0.0}, 4.0), {0.0, 0.5});
  expect_near(stay({5.0, 0.0}, 0.0, {0.0, 0.0}, {10.0, 0.0}, 4.0), {});
}

TEST(StayOnPath, PullsToTheLineBeyondItsEnds) {
  expect_near(stay({99.0, 1.0}, 0.0, {0.0, 0.0}, {10.0, 0.0}, 4.0), {0.0, -0.5});
}

TEST(StayOnPath, TurnsWithTheRobot) {
  expect_near(stay({5.0, 30.0}, -std::numbers::pi / 2.0, {0.0, 0.0}, {10.0, 0.0}, 4.0), {1.0, 0.0});
}

TEST(StayOnPath, WantsNothingWithoutALine) {
  expect_near(stay({5.0, 30.0}, 0.0, {1.0, 1.0}, {1.0, 1.0}, 4.0), {});
}

TEST(StayOnPath, PullsFullyToAPathWithoutWidth) {
  expect_near(stay({5.0, 0.1}, 0.0, {0.0, 0.0}, {10.0, 0.0}, 0.0), {0.0, -1.0});
}

}  // namespace
}  // namespace mlab::library_test
