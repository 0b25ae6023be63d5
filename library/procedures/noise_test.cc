#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"
#include "mlab/base/angle.h"

namespace mlab::library_test {
namespace {

using geom::Vector;

flow::BehaviorProbe noise(std::uint64_t seed, double persistence) {
  flow::BehaviorProbe p(behavior("Noise"), seed, 1);
  p.percepts.cycle_duration = 0.1;
  p.set("persistence", persistence);
  return p;
}

double world_direction(const flow::BehaviorProbe& p) {
  return base::wrap_angle(geom::direction(p.output<Vector>()) + p.percepts.pose.heading);
}

TEST(Noise, KeepsADirectionForExactlyItsPersistence) {
  flow::BehaviorProbe p = noise(7, 0.6);
  p.step();
  double last = world_direction(p);
  int kept = 1;
  for (int change = 0; change < 20;) {
    p.step();
    if (std::abs(base::wrap_angle(world_direction(p) - last)) < 1e-9) {
      ++kept;
      continue;
    }
    EXPECT_EQ(kept, 6);
    kept = 1;
    last = world_direction(p);
    ++change;
  }
}

TEST(Noise, HoldsItsDirectionInTheWorldWhileTheRobotTurns) {
  flow::BehaviorProbe p = noise(7, 100.0);
  p.step();
  const double before = world_direction(p);
  p.percepts.pose.heading = 2.0;
  p.step();
  EXPECT_NEAR(world_direction(p), before, 1e-12);
}

TEST(Noise, HasFullLengthInEveryQuarter) {
  flow::BehaviorProbe p = noise(3, 0.1);
  int quarters[4] = {};
  for (int i = 0; i < 4000; ++i) {
    p.step();
    const Vector v = p.output<Vector>();
    EXPECT_NEAR(geom::length(v), 1.0, 1e-12);
    ++quarters[(v.x > 0 ? 0 : 1) + (v.y > 0 ? 0 : 2)];
  }
  for (const int n : quarters) EXPECT_NEAR(n, 1000, 120);
}

TEST(Noise, RepeatsWithTheSeedAndDiffersWithAnother) {
  flow::BehaviorProbe a = noise(5, 6.0);
  flow::BehaviorProbe b = noise(5, 6.0);
  flow::BehaviorProbe c = noise(6, 6.0);
  a.step();
  b.step();
  c.step();
  EXPECT_EQ(a.output<Vector>(), b.output<Vector>());
  EXPECT_NE(a.output<Vector>(), c.output<Vector>());
}

TEST(Noise, DrawsAnewWhenItStartsAgain) {
  flow::BehaviorProbe p = noise(5, 100.0);
  p.step();
  const Vector first = p.output<Vector>();
  p.skip();
  p.step();
  EXPECT_NE(p.output<Vector>(), first);
}

TEST(Noise, WithoutPersistenceChangesInEveryCycle) {
  flow::BehaviorProbe p = noise(5, 0.0);
  p.step();
  const Vector first = p.output<Vector>();
  p.step();
  EXPECT_NE(p.output<Vector>(), first);
}

}  // namespace
}  // namespace mlab::library_test
