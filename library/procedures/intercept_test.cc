#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Point;

// How long a robot of 1 m/s takes to meet an object that moves; 60 where it doesn't.
double seconds_to_meet(Point object, geom::Offset velocity) {
  flow::BehaviorProbe p = probe("INTERCEPT");
  p.percepts.pose = {{0, 0}, 0.4};
  for (double t = 0.0; t < 60.0; t += 0.1) {
    const std::array<percept::ObjectReading, 1> seen = {
        {{.id = {3}, .center = p.percepts.pose.to_robot(object)}}};
    p.percepts.objects = seen;
    p.set("objects", all<flow::Objects>(1)).step();
    p.percepts.pose.position = p.percepts.pose.point_at(p.output<geom::Vector>() * 0.1);
    object = object + velocity * 0.1;
    if (geom::distance(object, p.percepts.pose.position) < 0.11) return t;
  }
  return 60.0;
}

TEST(Intercept, MeetsACrossingObjectAsSoonAsItCan) {
  // At (10, 0), north with 0.6 m/s: 10 / sqrt(1 - 0.36) = 12.5 s straight there; behind it the robot takes
  // longer.
  EXPECT_NEAR(seconds_to_meet({10, 0}, {0.0, 0.6}), 12.5, 0.5);
}

TEST(Intercept, GoesStraightToWhatStands) {
  EXPECT_NEAR(seconds_to_meet({3, 4}, {0.0, 0.0}), 5.0, 0.3);
}

TEST(Intercept, PursuesWhatItCanNotMeet) {
  EXPECT_EQ(seconds_to_meet({10, 0}, {3.0, 0.0}), 60.0);
  flow::BehaviorProbe p = probe("InterceptObject");
  p.step();
  EXPECT_EQ(p.output<geom::Vector>(), geom::Vector{});
}

}  // namespace
}  // namespace mlab::library_test
