#include "mlab/schema/step_aside.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/schema/way.h"

namespace mlab::schema {
namespace {

using geom::Point;
using geom::Segment;

constexpr double kRadius = 0.2;
constexpr double kReach = 0.65;

percept::KnownGround ground_of(const std::vector<Segment>& walls) {
  static std::uint64_t revision = 0x57e9a51de;
  percept::KnownGround out;
  out.revision = ++revision;
  out.walls = walls;
  out.bounds = {-100.0, -100.0, 100.0, 100.0};
  return out;
}

// Somebody in the west wants to go on eastwards for four metres.
struct Asker {
  explicit Asker(Point from)
      : lanes{{{from, from + geom::Offset{4.0, 0.0}}, kReach}}, bodies{{{from, from}, kReach}} {}
  KeepClear clear() const { return {lanes, bodies, {}}; }
  std::vector<Lane> lanes;
  std::vector<Lane> bodies;
};

TEST(WayAside, LeadsBesideADoorInWhichOneStands) {
  const std::vector<Segment> walls{{{0, -50}, {0, -0.4}}, {{0, 0.4}, {0, 50}}};
  const Asker asker({-1.2, 0.0});
  const auto way = way_aside(ground_of(walls), {0.0, 0.0}, kRadius, asker.clear());
  ASSERT_TRUE(way);
  const Point there = way->points().back();
  EXPECT_FALSE(asker.lanes[0].holds(there));
  EXPECT_LT(way_length(*way), 3.0);
  for (const Segment& wall : walls) EXPECT_GT(distance(nearest_point(wall, there), there), kRadius);
}

TEST(WayAside, LeadsAlongACorridorAwayFromWhoComes) {
  const std::vector<Segment> walls{{{-30, -0.35}, {30, -0.35}}, {{-30, 0.35}, {30, 0.35}}};
  const Asker asker({-0.8, 0.0});
  const auto way = way_aside(ground_of(walls), {0.0, 0.03}, kRadius, asker.clear());
  ASSERT_TRUE(way);
  EXPECT_GT(way->points().back().x, 3.2 + kReach);
  EXPECT_LT(way->points().back().x, 8.0);
}

TEST(WayAside, LeadsPastNobodyWhereThereIsNoRoom) {
  // Beside each other at the walls of a corridor of 1 m.
  const std::vector<Segment> walls{{{-30, -0.5}, {30, -0.5}}, {{-30, 0.5}, {30, 0.5}}};
  const Asker asker({-0.2, -0.25});
  const auto way = way_aside(ground_of(walls), {0.0, 0.25}, kRadius, asker.clear());
  ASSERT_TRUE(way) << "though it first goes a little towards the other one, from the wall";
  EXPECT_GT(way->points().back().x, 3.0);
}

TEST(WayAside, LeadsIntoABranchRoundACorner) {
  // A dead end, with a branch to the north 1 m before its end.
  const std::vector<Segment> walls{{{-30, -0.35}, {1.4, -0.35}},
                                   {{-30, 0.35}, {0.6, 0.35}},
                                   {{0.6, 0.35}, {0.6, 30}},
                                   {{1.4, -0.35}, {1.4, 30}}};
  const Asker asker({-0.8, 0.0});
  const auto way = way_aside(ground_of(walls), {0.0, 0.0}, kRadius, asker.clear());
  ASSERT_TRUE(way);
  EXPECT_GT(way->points().back().y, kReach);
}

TEST(WayAside, IsNoneInADeadEnd) {
  const std::vector<Segment> walls{
      {{-30, -0.35}, {1, -0.35}}, {{-30, 0.35}, {1, 0.35}}, {{1, -0.35}, {1, 0.35}}};
  const Asker asker({-0.8, 0.0});
  EXPECT_FALSE(way_aside(ground_of(walls), {0.0, 0.0}, kRadius, asker.clear()));
  const KeepClear but_for_him{asker.lanes, {}, {}};
  const auto out = way_aside(ground_of(walls), {0.0, 0.0}, kRadius, but_for_him);
  ASSERT_TRUE(out) << "past him there is a place";
  EXPECT_LT(out->points().back().x, -0.8);
}

TEST(WayAside, LeadsToWhereNobodyStandsIfItCan) {
  const Asker asker({-1.0, 0.0});
  const auto free = way_aside(ground_of({}), {0.0, 0.0}, kRadius, asker.clear());
  ASSERT_TRUE(free);
  const std::vector<Lane> others{{{free->points().back(), free->points().back()}, 0.5}};
  const auto way = way_aside(ground_of({}), {0.0, 0.0}, kRadius, {asker.lanes, asker.bodies, others});
  ASSERT_TRUE(way);
  EXPECT_FALSE(others[0].holds(way->points().back()));
}

}  // namespace
}  // namespace mlab::schema
