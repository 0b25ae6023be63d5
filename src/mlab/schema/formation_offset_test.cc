#include "mlab/schema/formation_offset.h"

#include <numbers>

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

using geom::Vector;
using percept::Formation;
using percept::FormationReference;

constexpr double kNorth = std::numbers::pi / 2.0;

percept::Percepts member(int rank, int size, geom::Pose pose, geom::Point center) {
  percept::Percepts percepts;
  percepts.pose = pose;
  percepts.unit.rank = static_cast<std::uint16_t>(rank);
  percepts.unit.size = static_cast<std::uint16_t>(size);
  percepts.unit.center = center;
  return percepts;
}

void expect_near(Vector a, Vector b) {
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
}

TEST(FormationOffset, LeadsToTheStationAroundTheCentre) {
  // Column of two heading north, seen by the first, which looks east and stands at the centre.
  const auto percepts = member(0, 2, {{100.0, 100.0}, 0.0}, {100.0, 100.0});
  expect_near(formation_offset(percepts.unit, percepts.pose, Formation::kColumn,
                               FormationReference::kUnitCenter, 50.0, kNorth),
              {0.0, 25.0});
}

TEST(FormationOffset, IsZeroForARobotAtItsStation) {
  for (const Formation formation :
       {Formation::kLine, Formation::kWedge, Formation::kDiamond, Formation::kColumn}) {
    for (int rank = 0; rank < 4; ++rank) {
      const Vector place = geom::rotated(percept::station(formation, rank, 4, 50.0), kNorth);
      const auto percepts =
          member(rank, 4, {geom::Point{7.0, 8.0} + geom::Offset{place.x, place.y}, 0.0}, {7.0, 8.0});
      expect_near(formation_offset(percepts.unit, percepts.pose, formation, FormationReference::kUnitCenter,
                                   50.0, kNorth),
                  {});
    }
  }
}

TEST(FormationOffset, TakesTheCentreOneCycleAhead) {
  auto percepts = member(0, 2, {{0.0, 0.0}, kNorth}, {0.0, 0.0});
  percepts.unit.center_step = {0.0, 0.5};
  expect_near(formation_offset(percepts.unit, percepts.pose, Formation::kColumn,
                               FormationReference::kUnitCenter, 50.0, 0.0),
              {25.5, 0.0});
}

TEST(FormationOffset, KeepsTheDistanceOfTheStationsFromTheLeader) {
  auto percepts = member(3, 4, {{0.0, 0.0}, 0.0}, {1e3, 1e3});
  percepts.unit.leader = {{200.0, 0.0}, 1.0};
  // Diamond: the leader in front at (s, 0), the fourth behind at (-s, 0).
  expect_near(formation_offset(percepts.unit, percepts.pose, Formation::kDiamond, FormationReference::kLeader,
                               50.0, 0.0),
              {100.0, 0.0});
}

TEST(FormationOffset, KeepsTheDistanceOfTheStationsFromTheNeighbour) {
  auto percepts = member(1, 3, {{0.0, 0.0}, 0.0}, {1e3, 1e3});
  percepts.unit.neighbor = {{60.0, 10.0}, 1.0};
  expect_near(formation_offset(percepts.unit, percepts.pose, Formation::kColumn,
                               FormationReference::kNeighbor, 50.0, 0.0),
              {10.0, 10.0});
}

TEST(FormationOffset, LeavesTheLeaderFreeUnlessTheCentreRules) {
  const auto percepts = member(0, 4, {{0.0, 0.0}, 0.0}, {10.0, 0.0});
  EXPECT_EQ(formation_offset(percepts.unit, percepts.pose, Formation::kLine, FormationReference::kLeader,
                             50.0, 0.0),
            Vector{});
  EXPECT_EQ(formation_offset(percepts.unit, percepts.pose, Formation::kLine, FormationReference::kNeighbor,
                             50.0, 0.0),
            Vector{});
}

TEST(FormationOffset, OfASweepCountsAlongTheHeadingOnly) {
  const auto percepts = member(2, 4, {{0.0, 0.0}, 0.0}, {12.0, 77.0});
  expect_near(formation_offset(percepts.unit, percepts.pose, Formation::kSweep,
                               FormationReference::kUnitCenter, 50.0, 0.0),
              {12.0, 0.0});
  expect_near(formation_offset(percepts.unit, percepts.pose, Formation::kSweep,
                               FormationReference::kUnitCenter, 50.0, kNorth),
              {0.0, 77.0});
}

TEST(FormationOffset, IsZeroWithoutAFormationAndForARobotAlone) {
  const auto four = member(2, 4, {{0.0, 0.0}, 0.0}, {12.0, 77.0});
  EXPECT_EQ(
      formation_offset(four.unit, four.pose, Formation::kNone, FormationReference::kUnitCenter, 50.0, 0.0),
      Vector{});
  auto alone = member(0, 1, {{0.0, 0.0}, 0.0}, {0.0, 0.0});
  alone.unit.center_step = {1.0, 0.0};
  EXPECT_EQ(
      formation_offset(alone.unit, alone.pose, Formation::kWedge, FormationReference::kUnitCenter, 50.0, 0.0),
      Vector{});
}

}  // namespace
}  // namespace mlab::schema
