#include "mlab/fleet/group.h"

#include <numbers>

#include <gtest/gtest.h>

namespace mlab::fleet {
namespace {

Group group_of(std::vector<std::uint32_t> members) {
  Group group;
  group.members = std::move(members);
  return group;
}

TEST(Group, ItsCentreIsTheMeanOfItsMembers) {
  Group group = group_of({0, 2});
  std::vector<geom::Pose> poses = {{{0, 0}, 0}, {{100, 100}, 0}, {{10, 4}, 0}};
  update_group(group, poses);
  EXPECT_EQ(group.center, (geom::Point{5, 2}));
  EXPECT_EQ(group.center_step, geom::Offset{}) << "it has not been seen before";
  poses[2].position.x = 14;
  update_group(group, poses);
  EXPECT_EQ(group.center_step, (geom::Offset{2, 0}));
}

TEST(Group, TheFormationLooksToAGoalThatIsFarAndKeepsItsHeadingNearIt) {
  Group group = group_of({0});
  group.order.goal = {0, 150};
  std::vector<geom::Pose> poses = {{{0, 0}, 0}};
  update_group(group, poses);
  EXPECT_DOUBLE_EQ(group.formation_heading, std::numbers::pi / 2);
  group.order.goal = {50, 0};  // nearer than the trigger
  update_group(group, poses);
  EXPECT_DOUBLE_EQ(group.formation_heading, std::numbers::pi / 2);
  group.order.has_heading = true;
  group.order.heading = 0.3;
  update_group(group, poses);
  EXPECT_DOUBLE_EQ(group.formation_heading, 0.3);
}

TEST(Group, TellsEachMemberItsRankLeaderAndNeighbour) {
  Group group = group_of({1, 0});
  const std::vector<geom::Pose> poses = {{{0, 0}, 0}, {{10, 0}, 1}};
  update_group(group, poses);
  const percept::UnitPercept second = unit_percept(group, 1, poses);
  EXPECT_EQ(second.size, 2);
  EXPECT_EQ(second.rank, 1);
  EXPECT_EQ(second.leader.position, (geom::Point{10, 0}));
  EXPECT_EQ(second.neighbor.position, (geom::Point{10, 0}));
}

TEST(StationError, IsTheDistanceFromTheStation) {
  Group group = group_of({0, 1});
  group.order.formation = percept::Formation::kColumn;
  group.spacing = 10;
  std::vector<geom::Pose> poses = {{{5, 0}, 0}, {{-5, 0}, 0}};
  update_group(group, poses);
  EXPECT_NEAR(station_error(group, 0, poses), 0.0, 1e-12);
  poses = {{{5, 3}, 0}, {{-5, -3}, 0}};
  update_group(group, poses);
  EXPECT_NEAR(station_error(group, 0, poses), 3.0, 1e-12);
  group.order.formation = percept::Formation::kSweep;  // abreast: only what is ahead or behind counts
  EXPECT_NEAR(station_error(group, 0, poses), 5.0, 1e-12);
  group.order.formation = percept::Formation::kNone;
  EXPECT_EQ(station_error(group, 0, poses), 0.0);
}

TEST(StationError, IsMeasuredFromWhatTheRobotsMeasureTheirStationsFrom) {
  using percept::FormationReference;
  Group group = group_of({0, 1, 2});
  group.order.formation = percept::Formation::kColumn;
  group.spacing = 10;
  const std::vector<geom::Pose> poses = {{{10, 3}, 0}, {{0, 3}, 0}, {{-10, 0}, 0}};
  update_group(group, poses);
  EXPECT_NEAR(station_error(group, 0, poses), 1.0, 1e-12) << "the centre is at y = 2";
  group.reference = FormationReference::kLeader;
  EXPECT_FALSE(has_station(group, 0));
  EXPECT_EQ(station_error(group, 0, poses), 0.0);
  EXPECT_FALSE(station_place(group, 0, poses));
  EXPECT_NEAR(station_error(group, 1, poses), 0.0, 1e-12);
  EXPECT_NEAR(station_error(group, 2, poses), 3.0, 1e-12);
  group.reference = FormationReference::kNeighbor;
  const std::vector<geom::Pose> bent = {{{10, 3}, 0}, {{0, 0}, 0}, {{-10, 0}, 0}};
  update_group(group, bent);
  EXPECT_NEAR(station_error(group, 1, bent), 3.0, 1e-12);
  EXPECT_NEAR(station_error(group, 2, bent), 0.0, 1e-12) << "it is where the second one wants it";
  const auto place = station_place(group, 2, bent);
  ASSERT_TRUE(place);
  EXPECT_NEAR(geom::distance(*place, bent[2].position), 0.0, 1e-12);
}

TEST(StationPlace, IsWhereTheStationErrorIsMeasuredFrom) {
  Group group = group_of({0, 1});
  group.order.formation = percept::Formation::kColumn;
  group.spacing = 10;
  const std::vector<geom::Pose> poses = {{{5, 3}, 0}, {{-5, -3}, 0}};
  update_group(group, poses);
  const auto place = station_place(group, 0, poses);
  ASSERT_TRUE(place.has_value());
  EXPECT_NEAR(geom::distance(*place, poses[0].position), station_error(group, 0, poses), 1e-12);
  group.order.formation = percept::Formation::kNone;
  EXPECT_FALSE(station_place(group, 0, poses).has_value());
}

}  // namespace
}  // namespace mlab::fleet
