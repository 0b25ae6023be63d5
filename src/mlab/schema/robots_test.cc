#include "mlab/schema/robots.h"

#include <vector>

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

const std::vector<percept::RobotReading> kReadings = {{.id = {4}, .center = {0.0, 30.0}},
                                                      {.id = {2}, .center = {-10.0, 0.0}},
                                                      {.id = {3}, .center = {10.0, 0.0}}};

TEST(Robots, TheNearestIsTheFirstOfThoseEquallyNear) {
  percept::Percepts percepts;
  EXPECT_EQ(nearest_robot(percepts.robots), nullptr);
  percepts.robots = kReadings;
  ASSERT_NE(nearest_robot(percepts.robots), nullptr);
  EXPECT_EQ(nearest_robot(percepts.robots)->id.value, 2U);
}

TEST(Robots, AreCountedUpToTheRangeAndOnIt) {
  EXPECT_EQ(robots_within(kReadings, 9.9), 0);
  EXPECT_EQ(robots_within(kReadings, 10.0), 2);
  EXPECT_EQ(robots_within(kReadings, 1e6), 3);
}

}  // namespace
}  // namespace mlab::schema
