#include "mlab/sim/site.h"

#include <gtest/gtest.h>

#include "mlab/sim/simulator.h"

namespace mlab::sim {
namespace {

Building one_door() {
  Building building;
  building.doors.push_back({{4.0, 0.0}, {6.0, 0.0}});
  building.rooms.push_back({{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {0.0, 10.0}});
  building.hallways.push_back({{0.0, -2.0}, {10.0, -2.0}, 4.0});
  return building;
}

TEST(Site, ShowsWhatTheBuildingHas) {
  const Site site(one_door());
  ASSERT_EQ(site.map().doors.size(), 1U);
  ASSERT_EQ(site.map().rooms.size(), 1U);
  EXPECT_EQ(site.map().rooms[0].outline.size(), 4U);
  EXPECT_EQ(site.map().hallways[0].width, 4.0);
}

TEST(Site, MarksOnlyADoorWithinReach) {
  Site site(one_door());
  site.mark(1, true, {5.0, -2.0}, 1.9);
  EXPECT_FALSE(site.doors()[0].is_marked);
  site.mark(2, true, {5.0, -2.0}, 2.0);
  site.mark(1, true, {5.0, -2.0}, 2.0);
  EXPECT_TRUE(site.doors()[0].is_marked);
}

TEST(Site, IsCopiedWithItsMarksButKeepsItsOutlines) {
  Site site(one_door());
  const Site before = site;
  site.mark(1, true, {5.0, 0.0}, 1.0);
  EXPECT_FALSE(before.doors()[0].is_marked);
  EXPECT_EQ(before.map().rooms[0].outline.data(), site.map().rooms[0].outline.data());
}

TEST(Simulator, MarksADoorOnRequestAndForgetsItWithASnapshot) {
  World world;
  world.building = one_door();
  Simulator simulator(world);
  const auto placed = simulator.add_body({{}, {{5.0, -1.0}, 0.0}, {1}});
  ASSERT_TRUE(placed.has_value());
  const auto before = simulator.snapshot();
  std::vector<percept::Action> actions(1);
  percept::Request mark;
  mark.kind = percept::Request::Kind::kMarkDoor;
  mark.object = {1};
  mark.reach = 3.0;
  actions[0].ask(mark);
  simulator.step(actions, 0.1);
  SenseBuffer buffer;
  percept::Percepts percepts;
  simulator.sense(placed->body, {}, buffer, percepts);
  ASSERT_EQ(percepts.map.doors.size(), 1U);
  EXPECT_TRUE(percepts.map.doors[0].is_marked);
  simulator.restore(*before);
  simulator.sense(placed->body, {}, buffer, percepts);
  EXPECT_FALSE(percepts.map.doors[0].is_marked);
}

}  // namespace
}  // namespace mlab::sim
