#include <array>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Point;
// A room of 10 m by 10 m; south of it a hallway of 4 m; a door between them in the middle.
struct Building {
  std::array<Point, 4> outline = {{{0, 0}, {10, 0}, {10, 10}, {0, 10}}};
  std::array<percept::Door, 1> doors = {{{{4.5, 0}, {5.5, 0}}}};
  std::array<percept::Room, 1> rooms = {{{outline}}};
  std::array<percept::Hallway, 1> hallways = {{{{0, -2}, {20, -2}, 4}}};

  flow::BehaviorProbe probe_at(std::string_view name, Point place, double heading) const {
    flow::BehaviorProbe p = probe(name);
    p.percepts.map = {doors, rooms, hallways};
    p.percepts.pose = {place, heading};
    return p;
  }
  bool is_true(std::string_view name, Point place, double heading = 0.0) const {
    flow::BehaviorProbe p = probe_at(name, place, heading);
    p.step();
    return p.output<bool>();
  }
};

TEST(InHallway, IsSoWithinItsWidthOnly) {
  const Building building;
  EXPECT_TRUE(building.is_true("InHallway", {1, -1}));
  EXPECT_FALSE(building.is_true("InHallway", {1, -4.5}));
  EXPECT_FALSE(building.is_true("InHallway", {25, -2}));
}

TEST(InRoom, IsSoInsideOfTheOutlineOnly) {
  const Building building;
  EXPECT_TRUE(building.is_true("IN_ROOM", {1, 1}));
  EXPECT_FALSE(building.is_true("IN_ROOM", {1, -1}));
  EXPECT_TRUE(building.is_true("IN_HALLWAY", {1, -1}));
  EXPECT_FALSE(building.is_true("IN_HALLWAY", {1, 1}));
}

TEST(AtDoorway, LooksToTheSideThatIsAskedFor) {
  const Building building;
  const auto sees = [&](int side, double heading) {
    flow::BehaviorProbe p = building.probe_at("DOORWAY_ULTRASOUND", {5, -2}, heading);
    p.set("side", side).step();
    return p.output<bool>();
  };
  EXPECT_TRUE(sees(1, 0.0)) << "on the left of a robot that goes east";
  EXPECT_FALSE(sees(0, 0.0));
  EXPECT_TRUE(sees(2, 0.0));
  EXPECT_TRUE(sees(0, 2.0 * kNorth));
  EXPECT_FALSE(sees(2, kNorth)) << "ahead";
}

TEST(AtDoorway, LeavesMarkedDoorsOutWhereAsked) {
  Building building;
  building.doors[0].is_marked = true;
  flow::BehaviorProbe p = building.probe_at("AtDoorway", {5, -2}, 0.0);
  p.step();
  EXPECT_TRUE(p.output<bool>());
  p.set("only_unmarked", true).step();
  EXPECT_FALSE(p.output<bool>());
}

// Moves a point by what the probe says, in steps of 2 cm.
Point followed(flow::BehaviorProbe& p, int steps) {
  for (int i = 0; i < steps; ++i) {
    p.step();
    p.percepts.pose.position = p.percepts.pose.point_at(geom::unit(p.output<geom::Vector>()) * 0.02);
  }
  return p.percepts.pose.position;
}

TEST(EnterRoom, LeadsThroughTheDoorToAPlaceBehindIt) {
  const Building building;
  for (const Point start : {Point{5, -3}, Point{1, -1}, Point{9, -1}}) {
    flow::BehaviorProbe p = building.probe_at("ENTER_ROOM", start, 0.7);
    Point last = start;
    double crossed_at = -1.0;
    for (int i = 0; i < 800; ++i) {
      const Point now = followed(p, 1);
      if (last.y < 0.0 && now.y >= 0.0) crossed_at = now.x;
      last = now;
    }
    EXPECT_NEAR(crossed_at, 5.0, 0.5) << start.x;
    EXPECT_LT(geom::distance(last, {5, 1}), 0.1) << start.x;
  }
}

TEST(LeaveRoom, LeadsOutAndStandsWithoutADoor) {
  const Building building;
  flow::BehaviorProbe out = building.probe_at("LeaveByDoor", {2, 6}, 0.0);
  EXPECT_LT(geom::distance(followed(out, 800), {5, -1}), 0.1);
  flow::BehaviorProbe nowhere = probe("LeaveByDoor");
  nowhere.step();
  EXPECT_EQ(nowhere.output<geom::Vector>(), geom::Vector{});
}

TEST(ThroughDoorway, IsTrueOncePastADoorThatWasCrossed) {
  const Building building;
  flow::BehaviorProbe p = building.probe_at("ThroughDoorway", {5, -1}, 0.0);
  const auto at = [&](Point place) {
    p.percepts.pose.position = place;
    p.step();
    return p.output<bool>();
  };
  EXPECT_FALSE(at({5, -1}));
  EXPECT_FALSE(at({5, 0.5}));
  EXPECT_TRUE(at({5, 0.8}));
  EXPECT_FALSE(building.is_true("ThroughDoorway", {5, 3})) << "never crossed";
}

TEST(Dock, ComesFromTheSideThatIsAskedFor) {
  flow::BehaviorProbe p = probe("DOCK");
  p.percepts.pose = {{-3, 0}, 0.3};
  p.set("place", Point{0, 0}).set("approach", 0.0).set("controlled_radius", 4.0);
  p.step();
  const geom::Offset turned = p.percepts.pose.to_world(p.output<geom::Vector>());
  EXPECT_NEAR(std::abs(turned.y), 1.0, 1e-9) << "round it, not through it";
  EXPECT_LT(geom::length(followed(p, 1500) - Point{0, 0}), 0.1);
}

TEST(MarkDoorway, AsksForTheNearestDoor) {
  const Building building;
  flow::BehaviorProbe p = building.probe_at("MARK_DOORWAY", {5, -2}, 0.0);
  p.step();
  ASSERT_EQ(p.action.request_count, 1);
  EXPECT_EQ(p.action.requests[0].kind, percept::Request::Kind::kMarkDoor);
  EXPECT_EQ(p.action.requests[0].object.value, 1U);
  p.action = {};
  p.set("mark", false).step();
  EXPECT_EQ(p.action.requests[0].kind, percept::Request::Kind::kUnmarkDoor);
}

TEST(MarkedDoorway, SpeaksOfTheNearestDoor) {
  Building building;
  EXPECT_FALSE(building.is_true("MARKED_DOORWAY", {5, -2}));
  building.doors[0].is_marked = true;
  EXPECT_TRUE(building.is_true("MARKED_DOORWAY", {5, -2}));
}

TEST(HallwayPlace, KnowsItsEndsAndAGoalAheadAndKeepsIt) {
  const Building building;
  const auto place = [&](const char* which, int side, double heading) {
    flow::BehaviorProbe p = building.probe_at("GET_HALLWAY_INFO_VECTOR", {5, -2}, heading);
    p.set_text("which", which).set("side", side).step();
    p.percepts.pose.position = {5, 5};
    p.step();
    return p.output<Point>();
  };
  EXPECT_EQ(place("Start", 1, 0.0), (Point{0, -2}));
  EXPECT_EQ(place("End", 1, 0.0), (Point{20, -2}));
  EXPECT_GT(place("Goal", 3, 0.3).x, 1e8);
  EXPECT_LT(place("Goal", 4, 0.3).x, -1e8);
  EXPECT_GT(place("Goal", 0, kNorth).x, 1e8) << "on the right of north is east";
}

TEST(AtEndOfHallway, IsSoAtEitherEnd) {
  const Building building;
  EXPECT_TRUE(building.is_true("AtEndOfHallway", {0.3, -2}));
  EXPECT_TRUE(building.is_true("AtEndOfHallway", {19.7, -2}));
  EXPECT_FALSE(building.is_true("AtEndOfHallway", {10, -2}));
}

}  // namespace
}  // namespace mlab::library_test
