#include "mlab/vehicle/local_map.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace mlab::vehicle {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();

Clock::time_point at(double seconds) {
  return Clock::time_point(
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)));
}

// 36 beams all round, beam 0 ahead.
Scan ring(double seconds) {
  Scan out;
  out.step = std::numbers::pi / 18.0;
  out.farthest = 10.0;
  out.distances.assign(36, kNothing);
  out.at = at(seconds);
  return out;
}

TEST(LocalMap, HasOneThingForNeighbouringBeams) {
  LocalMap map;
  Scan scan = ring(0.0);
  scan.distances[0] = scan.distances[1] = scan.distances[2] = 2.0F;
  map.add(scan, {});
  const auto seen = map.obstacles({}, 5.0, {});
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_NEAR(geom::length(seen[0].center), 2.0 * std::cos(std::numbers::pi / 18.0), 0.01);
  EXPECT_GT(seen[0].radius, 0.3);
}

TEST(LocalMap, KeepsWhatItSeesNoMoreWhereItStandsWhileTheVehicleMovesOn) {
  LocalMap map;
  Scan scan = ring(0.0);
  scan.distances[0] = 2.0F;
  map.add(scan, {});
  // It has gone past, and no beam points there: nothing is known in any direction.
  Scan blind = ring(1.0);
  blind.distances.assign(36, std::numeric_limits<float>::quiet_NaN());
  const geom::Pose beyond{{4.0, 0.0}, 0.0};
  map.add(blind, beyond);
  map.age(beyond, at(1.0));
  const auto seen = map.obstacles(beyond, 5.0, {});
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_NEAR(seen[0].center.x, -2.0, 1e-9);
}

TEST(LocalMap, ForgetsWhatABeamGoesThrough) {
  LocalMap map;
  Scan scan = ring(0.0);
  scan.distances[0] = 2.0F;
  map.add(scan, {});
  map.add(ring(0.1), {});
  EXPECT_TRUE(map.obstacles({}, 5.0, {}).empty());
}

TEST(LocalMap, KeepsWhatIsBehindSomethingElse) {
  LocalMap map;
  Scan scan = ring(0.0);
  scan.distances[0] = 4.0F;
  map.add(scan, {});
  scan.at = at(0.1);
  scan.distances[0] = 2.0F;
  map.add(scan, {});
  EXPECT_EQ(map.obstacles({}, 5.0, {}).size(), 2U);
}

TEST(LocalMap, ForgetsWithTimeAndWithDistance) {
  LocalMap map;
  Scan scan = ring(0.0);
  scan.distances[0] = 2.0F;
  map.add(scan, {});
  map.age({}, at(LocalMap::kMemory - 0.1));
  EXPECT_EQ(map.obstacles({}, 5.0, {}).size(), 1U);
  map.age({}, at(LocalMap::kMemory + 0.1));
  EXPECT_TRUE(map.obstacles({}, 5.0, {}).empty());
  scan.at = at(20.0);
  map.add(scan, {});
  map.age({{-30.0, 0.0}, 0.0}, at(20.0));
  EXPECT_TRUE(map.obstacles({}, 50.0, {}).empty());
}

TEST(LocalMap, KeepsWhatItSawLastWhereThereIsTooMuch) {
  LocalMap map;
  for (int i = 0; i < 300; ++i) {
    Scan scan = ring(0.01 * i);
    scan.distances.assign(36, std::numeric_limits<float>::quiet_NaN());
    scan.distances[0] = 1.0F;
    map.add(scan, {{0.0, static_cast<double>(i)}, 0.0});
  }
  const auto seen = map.obstacles({{0.0, 299.0}, 0.0}, 1.0, {});
  ASSERT_FALSE(seen.empty());
  EXPECT_NEAR(seen[0].center.y, 0.0, 1e-9) << "the newest is among them";
  EXPECT_EQ(map.obstacles({}, 1e6, {}).size(), LocalMap::kMost);
}

TEST(LocalMap, FindsTheBeamThatLooksAtAThingWhicheverWayTheyGoRound) {
  for (const double step : {1.0, -1.0}) {
    LocalMap map;
    Scan scan = ring(0.0);
    scan.step *= step;
    scan.first_angle = 1.0;
    scan.distances[35] = 3.0F;  // just before beam 0
    map.add(scan, {});
    ASSERT_EQ(map.obstacles({}, 50.0, {}).size(), 1U);
    scan.at = at(0.1);
    scan.distances[35] = 8.0F;
    map.add(scan, {});
    const auto seen = map.obstacles({}, 50.0, {});
    ASSERT_EQ(seen.size(), 1U) << "the beam went through what was there";
    EXPECT_NEAR(geom::length(seen[0].center), 8.0, 1e-6);
  }
}

TEST(LocalMap, BearsBeamsThatMakeNoSense) {
  LocalMap map;
  Scan scan = ring(0.0);
  scan.distances[0] = 2.0F;
  map.add(scan, {});
  scan.at = at(0.1);
  scan.step = 1e-300;
  scan.first_angle = 2.0;
  map.add(scan, {});
  EXPECT_FALSE(map.obstacles({}, 5.0, {}).empty());
}

TEST(LocalMap, LeavesOutBodiesThatAreKnownOtherwise) {
  LocalMap map;
  Scan scan = ring(0.0);
  scan.distances[0] = 2.0F;
  scan.distances[9] = 3.0F;
  map.add(scan, {});
  percept::RobotReading other;
  other.center = {2.2, 0.0, 0.0};
  const auto seen = map.obstacles({}, 5.0, {&other, 1});
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_NEAR(seen[0].center.y, 3.0, 1e-6);
}

TEST(LocalMap, TellsNothingOfReadingsThatAreNone) {
  LocalMap map;
  Scan scan = ring(0.0);
  scan.nearest = 0.5;
  scan.distances[0] = 0.1F;   // too near to be one
  scan.distances[9] = 12.0F;  // beyond what it can see
  scan.distances[18] = std::numeric_limits<float>::quiet_NaN();
  map.add(scan, {});
  EXPECT_TRUE(map.obstacles({}, 50.0, {}).empty());
}

}  // namespace
}  // namespace mlab::vehicle
