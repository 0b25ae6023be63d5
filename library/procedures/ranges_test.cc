#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Vector;
using percept::RangeReading;

constexpr float kLeft = static_cast<float>(std::numbers::pi / 2.0);

// Four beams; only the one ahead hits, half way.
const std::vector<RangeReading> kWallAhead = {
    {0.0F, 0.5F, true}, {kLeft, 1.0F, false}, {2.0F * kLeft, 1.0F, false}, {-kLeft, 1.0F, false}};

flow::BehaviorProbe ring_probe(const char* name, const std::vector<RangeReading>& ring) {
  flow::BehaviorProbe p = probe(name);
  p.percepts.ranges = ring;
  p.percepts.range_limit = 1.0;
  return p;
}

flow::Ranges whole(const std::vector<RangeReading>& ring) {
  return {static_cast<std::uint16_t>(ring.size())};
}

TEST(DetectRanges, GivesTheWholeRing) {
  flow::BehaviorProbe p = ring_probe("DetectRanges", kWallAhead);
  p.step();
  EXPECT_EQ(p.output<flow::Ranges>().count, 4);
}

TEST(RangeRepulsion, PushesAwayFromWhatIsHit) {
  flow::BehaviorProbe p = ring_probe("RangeRepulsion", kWallAhead);
  p.set("ranges", whole(kWallAhead)).step();
  EXPECT_NEAR(p.output<Vector>().x, -0.125, 1e-7);
  EXPECT_NEAR(p.output<Vector>().y, 0.0, 1e-7);
}

TEST(RangeProximity, IsThatOfTheNearestAhead) {
  flow::BehaviorProbe p = ring_probe("RangeProximity", kWallAhead);
  p.set("ranges", whole(kWallAhead)).step();
  EXPECT_NEAR(p.output<double>(), 0.5, 1e-7);
}

TEST(DriveDifferential, TurnsTowardsItsVectorAndSlowsDown) {
  flow::BehaviorProbe p = probe("DriveDifferential");
  p.set("v", geom::polar(3.0, 0.4)).step();
  EXPECT_NEAR(p.action.velocity.x, 0.2 * std::cos(0.4), 1e-12);
  EXPECT_NEAR(p.action.spin, 0.6, 1e-12);
  EXPECT_TRUE(p.action.drives && p.action.spins);
  p.set("v", Vector{-1.0, 0.001}).step();
  EXPECT_DOUBLE_EQ(p.action.velocity.x, 0.0);
  EXPECT_DOUBLE_EQ(p.action.spin, 1.4286);
}

TEST(DriveDifferential, OnlyTurnsWhileSomethingIsNearAhead) {
  flow::BehaviorProbe p = probe("DriveDifferential");
  p.set("v", geom::polar(1.0, 0.6)).set("proximity", 0.51).step();
  EXPECT_DOUBLE_EQ(p.action.velocity.x, 0.0);
  p.set("v", geom::polar(1.0, 0.4)).step();
  EXPECT_GT(p.action.velocity.x, 0.1);
}

void diffuse(flow::BehaviorProbe& p, const std::vector<RangeReading>& ring) {
  p.set("ranges", whole(ring));
  p.step();
}

TEST(Diffuse, GoesStraightOnInTheOpenAndWithTheWallBehind) {
  const std::vector<RangeReading> behind = {{0.0F, 1.0F, false}, {2.0F * kLeft, 0.1F, true}};
  for (const auto& ring : {std::vector<RangeReading>(24), behind}) {
    flow::BehaviorProbe p = ring_probe("Diffuse", ring);
    diffuse(p, ring);
    EXPECT_DOUBLE_EQ(p.action.velocity.x, 0.2);
    EXPECT_DOUBLE_EQ(p.action.spin, 0.0);
  }
}

TEST(Diffuse, TurnsAwayFromTheSideThatPresses) {
  const std::vector<RangeReading> left = {{0.5F, 0.6F, true}, {-0.5F, 1.0F, false}};
  flow::BehaviorProbe p = ring_probe("Diffuse", left);
  diffuse(p, left);
  EXPECT_DOUBLE_EQ(p.action.velocity.x, 0.1);
  EXPECT_DOUBLE_EQ(p.action.spin, -1.4286);
}

TEST(Diffuse, StopsToTurnWhereSomethingIsNear) {
  const std::vector<RangeReading> near = {{-0.5F, 0.4F, true}, {0.5F, 1.0F, false}};
  flow::BehaviorProbe p = ring_probe("Diffuse", near);
  diffuse(p, near);
  EXPECT_DOUBLE_EQ(p.action.velocity.x, 0.0);
  EXPECT_DOUBLE_EQ(p.action.spin, 1.4286);
}

}  // namespace
}  // namespace mlab::library_test
