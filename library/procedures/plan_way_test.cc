#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"
#include "mlab/schema/route.h"
#include "mlab/schema/way.h"

namespace mlab::library_test {
namespace {

using geom::Point;
using geom::Vector;
using ways::PlannedWay;
using ways::WayEnd;

/// A rock between two places.
class Way : public testing::Test {
 protected:
  std::vector<ways::Round> rocks{{{50.0, 50.0}, 8.0}};
  std::vector<geom::Segment> walls;

  percept::KnownGround ground() {
    static std::uint64_t last = 0x77000000U;
    return {++last, rocks, walls, {0.0, 0.0, 200.0, 200.0}};
  }
  static PlannedWay straight(Point from, Point to) {
    PlannedWay out;
    out.corners[0] = from;
    out.corners[1] = to;
    out.count = 2;
    out.clearance = 1.0;
    out.version = 1;
    out.end = WayEnd::kGoal;
    return out;
  }
};

TEST_F(Way, GoesRoundWhatIsKnown) {
  flow::BehaviorProbe p = probe("PlanWay");
  p.percepts.ground = ground();
  p.set("from", Point{20.0, 50.0}).set("goal", Point{80.0, 50.0});
  p.step();
  const auto way = p.output<PlannedWay>();
  EXPECT_EQ(way.end, WayEnd::kGoal);
  EXPECT_GT(way.count, 3);
  EXPECT_EQ(way.points().front(), (Point{20.0, 50.0}));
  EXPECT_EQ(way.points().back(), (Point{80.0, 50.0}));
}

// Through more corners than a way has room for.
TEST_F(Way, OfAUnitGoesOnWhereItWasAndNotWhereItsMiddleIs) {
  rocks.clear();
  for (int i = 1; i < 40; ++i) {
    const double low = i % 2 == 0 ? 20.0 : 0.0;
    walls.push_back({{5.0 * i, low}, {5.0 * i, low + 180.0}});
  }
  for (const bool is_body : {true, false}) {
    flow::BehaviorProbe p = probe("PlanWay");
    p.percepts.ground = ground();
    p.set("from", Point{2.0, 100.0}).set("goal", Point{198.0, 100.0}).set("margin", 1.0).set("stray", 50.0);
    p.set("of_a_body", is_body);
    p.step();
    const auto first = p.output<PlannedWay>();
    ASSERT_EQ(first.end, WayEnd::kFull);
    const double length = schema::route_length(first.points());
    const Point behind_a_wall = schema::route_point(first.points(), 0.8 * length) + geom::Offset{4.0, 0.0};
    p.set("from", behind_a_wall);
    p.step();
    const auto next = p.output<PlannedWay>();
    ASSERT_NE(next.version, first.version);
    const Point begin = next.points().front();
    if (is_body) {
      EXPECT_EQ(begin, behind_a_wall);
    } else {
      const double at = schema::nearest_way(first.points(), begin, 0.0, length);
      EXPECT_LT(distance(schema::route_point(first.points(), at), begin), 0.01);
      EXPECT_GT(distance(begin, behind_a_wall), 0.5);
    }
  }
}

TEST_F(Way, StaysUntilThereIsAReason) {
  flow::BehaviorProbe p = probe("PlanWay");
  p.percepts.ground = ground();
  p.set("from", Point{20.0, 50.0}).set("goal", Point{80.0, 50.0}).set("stray", 10.0).set("tolerance", 0.5);
  const auto version = [&] {
    p.step();
    return p.output<PlannedWay>().version;
  };
  const auto first = version();
  EXPECT_EQ(version(), first);
  p.set("from", Point{24.0, 52.0});
  EXPECT_EQ(version(), first) << "it may go beside it";
  p.set("goal", Point{80.3, 50.0});
  EXPECT_EQ(version(), first) << "the goal may move a little";
  rocks.push_back({{60.0, 150.0}, 3.0});
  p.percepts.ground = ground();
  EXPECT_EQ(version(), first) << "something new stands elsewhere";

  rocks.push_back({p.output<PlannedWay>().corners[2], 1.0});
  p.percepts.ground = ground();
  EXPECT_NE(version(), first) << "something new stands on it";
  const auto second = version();
  p.set("goal", Point{90.0, 50.0});
  EXPECT_NE(version(), second) << "another goal";
  const auto third = version();
  p.set("from", Point{20.0, 90.0});
  EXPECT_NE(version(), third) << "off the way";
}

TEST_F(Way, IsTrackedFromWhereOneWas) {
  flow::BehaviorProbe p = probe("TrackWay");
  p.set("way", straight({0.0, 0.0}, {100.0, 0.0}));
  const auto at = [&](Point place) {
    p.set("place", place);
    p.step();
    return p.output<double>();
  };
  EXPECT_DOUBLE_EQ(at({-7.0, 3.0}), -7.0);
  EXPECT_DOUBLE_EQ(at({4.0, 3.0}), 4.0);
  EXPECT_DOUBLE_EQ(at({30.0, -9.0}), 30.0);
  EXPECT_DOUBLE_EQ(at({104.0, 0.0}), 60.0) << "no farther than the window";
  EXPECT_DOUBLE_EQ(at({104.0, 0.0}), 90.0);
  EXPECT_DOUBLE_EQ(at({104.0, 0.0}), 104.0);
}

TEST_F(Way, IsTrackedOnWhereItLeadsBackAlongItself) {
  flow::BehaviorProbe p = probe("TrackWay");
  PlannedWay way = straight({100.0, 0.0}, {0.0, 0.0});
  way.corners[way.count++] = {100.0, 0.0};
  p.set("way", way);
  for (double x = 100.0; x > 0.0; x -= 4.0) {
    p.set("place", Point{x, 0.5});
    p.step();
    EXPECT_NEAR(p.output<double>(), 100.0 - x, 1e-9);
  }
  for (double x = 8.0; x <= 100.0; x += 4.0) {
    p.set("place", Point{x, 0.5});
    p.step();
    EXPECT_NEAR(p.output<double>(), 100.0 + x, 1e-9);
  }
}

TEST_F(Way, IsTrackedOnAlongOneThatGoesOnAlongTheSameLine) {
  flow::BehaviorProbe p = probe("TrackWay");
  PlannedWay way = straight({0.0, 0.0}, {100.0, 0.0});
  way.corners[way.count++] = {0.0, 0.0};  // and back
  const auto at = [&](Point place) {
    p.set("way", way).set("place", place);
    p.step();
    return p.output<double>();
  };
  for (double x = 0.0; x < 100.0; x += 4.0) EXPECT_DOUBLE_EQ(at({x, 1.0}), x);
  for (double x = 100.0; x > 60.0; x -= 4.0) EXPECT_DOUBLE_EQ(at({x, 1.0}), 200.0 - x);
  const auto version = way.version;
  way = straight({30.0, 0.0}, {100.0, 0.0});
  way.corners[way.count++] = {-50.0, 0.0};
  way.version = static_cast<std::uint16_t>(version + 1);
  way.cut_off = 30.0F;
  EXPECT_DOUBLE_EQ(at({60.0, 1.0}), 110.0) << "not on the way there, which is as near";
  way.version = static_cast<std::uint16_t>(version + 3);
  EXPECT_DOUBLE_EQ(at({60.0, 1.0}), 30.0) << "two ways later it is another one";
}

TEST_F(Way, HasAPlaceForEachRankOfAFormation) {
  flow::BehaviorProbe p = probe("WayStation");
  p.set("way", straight({0.0, 0.0}, {100.0, 0.0})).set("spacing", 10.0);
  p.percepts.unit.size = 2;
  p.percepts.unit.rank = 1;
  p.set("formation", percept::Formation::kColumn);
  p.step();
  expect_near(p.output<Vector>(), percept::station(percept::Formation::kColumn, 1, 2, 10.0));
  p.percepts.unit.size = 1;
  p.step();
  expect_near(p.output<Vector>(), {});
}

TEST_F(Way, WithoutAFormationItsRobotsStayAsTheyStood) {
  flow::BehaviorProbe p = probe("WayStation");
  p.set("way", straight({0.0, 0.0}, {0.0, 100.0})).set("formation", percept::Formation::kNone);
  p.percepts.unit.size = 3;
  p.percepts.unit.center = {0.0, 0.0};
  p.percepts.pose.position = {4.0, -2.0};
  p.step();
  expect_near(p.output<Vector>(), {-2.0, -4.0, 0.0});
  p.percepts.pose.position = {9.0, 9.0};
  p.step();
  expect_near(p.output<Vector>(), {-2.0, -4.0, 0.0});
  p.percepts.order.sequence = 2;
  p.step();
  expect_near(p.output<Vector>(), {9.0, -9.0, 0.0});
}

TEST_F(Way, AStationMovesToWhereItCanBe) {
  flow::BehaviorProbe p = probe("PlaceOnWay");
  const PlannedWay way = straight({0.0, 30.0}, {190.0, 30.0});
  p.set("way", way).set("progress", 42.0).set("lookahead", 8.0);
  const auto place = [&](Vector station) {
    p.set("station", station);
    p.step();
    return p.output<Point>();
  };
  EXPECT_EQ(place({0.0, 20.0, 0.0}), (Point{50.0, 50.0})) << "nothing is known";
  p.percepts.ground = ground();
  EXPECT_EQ(place({0.0, 18.0, 0.0}), (Point{60.0, 48.0})) << "behind a rock of 8 m, with a clearance of 1";
  walls = {{{0.0, 35.0}, {190.0, 35.0}}};
  p.percepts.ground = ground();
  EXPECT_EQ(place({0.0, 18.0, 0.0}), (Point{60.0, 30.0})) << "a wall is in front of it";
}

TEST_F(Way, ItEndsAtTheStation) {
  flow::BehaviorProbe p = probe("PlaceOnWay");
  p.set("way", straight({0.0, 30.0}, {100.0, 30.0}))
      .set("progress", 99.0)
      .set("station", Vector{-10.0, 5.0, 0.0});
  p.step();
  EXPECT_EQ(p.output<Point>(), (Point{90.0, 35.0}));
}

TEST_F(Way, PaceBringsARobotToItsStation) {
  flow::BehaviorProbe p = probe("PaceOnWay");
  const auto pace = [&](double unit, double own, double along) {
    p.set("unit_progress", unit).set("progress", own).set("station", Vector{along, 0.0, 0.0});
    p.step();
    return p.output<double>();
  };
  EXPECT_DOUBLE_EQ(pace(100.0, 110.0, 10.0), 1.0);
  EXPECT_GT(pace(100.0, 105.0, 10.0), 1.0);
  EXPECT_LT(pace(100.0, 112.0, 10.0), 1.0);
  EXPECT_DOUBLE_EQ(pace(0.0, 500.0, 0.0), 0.7);
  EXPECT_DOUBLE_EQ(pace(500.0, 0.0, 0.0), 1.5);
  p.set("cohesion", 40.0);
  EXPECT_DOUBLE_EQ(pace(0.0, 20.0, 0.0), 0.5) << "who is ahead waits";
  EXPECT_DOUBLE_EQ(pace(0.0, 500.0, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(pace(500.0, 0.0, 0.0), 1.5);
}

TEST_F(Way, WhoIsAheadDoesNotWaitForEver) {
  flow::BehaviorProbe p = probe("PaceOnWay");
  p.set("cohesion", 2.0).set("patience", 20.0).set("progress", 110.0).set("station", Vector{});
  const auto pace_at = [&](double time, double unit) {
    p.percepts.time = time;
    p.set("unit_progress", unit);
    p.step();
    return p.output<double>();
  };
  EXPECT_EQ(pace_at(0.0, 100.0), 0.0);
  EXPECT_EQ(pace_at(19.0, 101.0), 0.0);
  EXPECT_EQ(pace_at(21.0, 101.0), 0.7) << "the unit has come no farther";
  EXPECT_EQ(pace_at(22.0, 105.0), 0.75) << "not before it is beside its station";
  EXPECT_GE(pace_at(23.0, 110.0), 1.0);
  EXPECT_EQ(pace_at(24.0, 105.0), 0.0);
  EXPECT_EQ(pace_at(50.0, 108.0), 0.0) << "it comes on";
}

TEST_F(Way, AlongARouteGoesBesideCornersThatSomethingStandsAt) {
  flow::BehaviorProbe p = probe("PlanWay");
  const std::vector<Point> route = {{0.0, 50.0}, {50.0, 50.0}, {100.0, 50.0}, {100.0, 110.0}};
  p.percepts.order.route = route;
  p.percepts.order.sequence = 1;
  p.percepts.ground = ground();
  p.set("along_route", true).set("from", Point{10.0, 50.0}).set("goal", Point{100.0, 110.0});
  p.step();
  const auto way = p.output<PlannedWay>();
  EXPECT_EQ(way.end, WayEnd::kGoal);
  const auto points = way.points();
  ASSERT_GT(points.size(), 3U);
  EXPECT_EQ(points.front(), (Point{10.0, 50.0}));
  EXPECT_EQ(points.back(), (Point{100.0, 110.0}));
  EXPECT_NE(std::ranges::find(points, Point{100.0, 50.0}), points.end());
  EXPECT_EQ(std::ranges::find(points, Point{50.0, 50.0}), points.end());
  EXPECT_TRUE(
      std::ranges::any_of(points, [](Point corner) { return distance(corner, {50.0, 50.0}) < 13.3; }));
  EXPECT_TRUE(schema::is_open(p.percepts.ground, way));
  p.set("along_route", false);
  p.step();
  const auto straight_there = p.output<PlannedWay>();
  EXPECT_EQ(std::ranges::find(straight_there.points(), Point{100.0, 50.0}), straight_there.points().end());
}

TEST_F(Way, AlongARouteLeavesOutCornersThatAreClosedOffAndTheLeaderTells) {
  walls = {{{90.0, 40.0}, {110.0, 40.0}},
           {{110.0, 40.0}, {110.0, 60.0}},
           {{110.0, 60.0}, {90.0, 60.0}},
           {{90.0, 60.0}, {90.0, 40.0}}};
  for (const std::uint16_t rank : {std::uint16_t{0}, std::uint16_t{1}}) {
    flow::BehaviorProbe p = probe("PlanWay");
    const std::vector<Point> route = {{20.0, 20.0}, {100.0, 50.0}, {150.0, 20.0}};
    p.percepts.order.route = route;
    p.percepts.order.sequence = 1;
    p.percepts.unit.rank = rank;
    p.percepts.ground = ground();
    p.set("along_route", true)
        .set("from", Point{10.0, 20.0})
        .set("goal", Point{150.0, 20.0})
        .set("margin", 1.0);
    p.step();
    EXPECT_EQ(p.output<PlannedWay>().end, WayEnd::kGoal);
    const std::string told(p.action.alert.data());
    if (rank == 0)
      EXPECT_NE(told.find("no way to (100, 50) is known: a wall at"), std::string::npos) << told;
    else
      EXPECT_EQ(told, "");
    // What is found elsewhere has the way planned anew, and tells nothing new of the line.
    p.action = {};
    rocks.push_back({{60.0 + rank, 20.0}, 3.0});
    p.percepts.ground = ground();
    p.step();
    EXPECT_STREQ(p.action.alert.data(), "");
  }
}

TEST_F(Way, ATrapIsToldOnceByWhoStandsAboutInIt) {
  flow::BehaviorProbe p = probe("TellOfTrap");
  p.percepts.order.sequence = 1;
  p.percepts.unit.rank = 1;
  const auto tells = [&](double time, Point here, double remaining) {
    p.percepts.time = time;
    p.percepts.pose.position = here;
    p.set("remaining", remaining);
    p.action = {};
    p.step();
    return std::string(p.action.alert.data());
  };
  for (int i = 0; i < 100; ++i) EXPECT_EQ(tells(i, {i * 4.0, 0.0}, 800.0 - 4.0 * i), "") << "it goes on";
  int told = 0;
  for (int i = 100; i < 400; ++i) {
    const std::string text = tells(i, {400.0, i % 5 * 1.0}, 400.0);
    if (text.empty()) continue;
    ++told;
    EXPECT_EQ(
        text,
        "Trap: stands near (400, 0), no nearer to the goal for 60 s; robots that plan their ways get out");
  }
  EXPECT_EQ(told, 1);
  p.percepts.order.sequence = 2;
  p.percepts.order.halted = true;
  for (int i = 400; i < 600; ++i) EXPECT_EQ(tells(i, {400.0, 0.0}, 400.0), "") << "it is told to stand";
}

TEST_F(Way, IsFollowedRoundItsCornersToItsEnd) {
  flow::BehaviorProbe p = probe("FollowWay");
  PlannedWay way = straight({0.0, 0.0}, {10.0, 0.0});
  way.corners[way.count++] = {10.0, 10.0};
  p.set("way", way);
  geom::Point at{0.0, 0.0};
  double farthest = 0.0;
  for (int i = 0; i < 200; ++i) {
    p.percepts.pose.position = at;
    p.step();
    at = at + p.percepts.pose.to_world(p.output<Vector>()) * 0.3;
    const double off = std::min(distance(nearest_point({way.corners[0], way.corners[1]}, at), at),
                                distance(nearest_point({way.corners[1], way.corners[2]}, at), at));
    farthest = std::max(farthest, off);
  }
  EXPECT_LT(farthest, 1.0);
  EXPECT_LT(distance(at, {10.0, 10.0}), 0.1);
}

TEST_F(Way, ASlowRobotSlowsDownLater) {
  flow::BehaviorProbe p = probe("FollowWay");
  p.set("way", straight({0.0, 0.0}, {10.0, 0.0}));
  const auto pull = [&](double base_velocity, double x) {
    p.set("base_velocity", base_velocity);
    p.percepts.pose.position = {x, 0.0};
    p.step();
    return p.output<Vector>().x;
  };
  EXPECT_NEAR(pull(5.0, 8.5), 0.5, 1e-9);
  EXPECT_NEAR(pull(0.1, 8.5), 1.0, 1e-9);
  EXPECT_NEAR(pull(0.1, 9.85), 0.5, 1e-9);
}

// Round the end of a wall, beyond which the way leads back on its other side.
TEST_F(Way, WhoIsPushedBackGoesThatPieceAgain) {
  flow::BehaviorProbe p = probe("FollowWay");
  PlannedWay way = straight({0.0, -0.3}, {10.0, -0.3});
  way.corners[way.count++] = {10.0, 0.3};
  way.corners[way.count++] = {0.0, 0.3};
  p.set("way", way);
  for (const double x : {8.0, 9.0, 10.0}) {
    p.percepts.pose.position = {x, -0.3};
    p.step();
  }
  p.percepts.pose.position = {8.5, -0.3};
  p.step();
  EXPECT_GT(p.output<Vector>().x, 0.5) << "along the wall to its end, not through it";
  EXPECT_LT(std::abs(p.output<Vector>().y), 0.3);
}

TEST_F(Way, NothingRemainsAtTheStation) {
  flow::BehaviorProbe p = probe("WayRemaining");
  p.set("way", straight({0.0, 30.0}, {100.0, 30.0})).set("station", Vector{-10.0, 5.0, 0.0});
  p.percepts.pose.position = {88.0, 34.0};
  p.set("progress", 88.0);
  p.step();
  EXPECT_DOUBLE_EQ(p.output<double>(), 0.0);
  p.percepts.pose.position = {50.0, 35.0};
  p.set("progress", 50.0);
  p.step();
  EXPECT_DOUBLE_EQ(p.output<double>(), 40.0);
}

// As where a sonar hears something at the goal, and what is nearest to it is where the robot is by chance.
TEST_F(Way, NobodyIsThereSinceThePlaceHasJustMovedToHim) {
  flow::BehaviorProbe p = probe("WayRemaining");
  p.percepts.pose.position = {50.0, 30.0};
  p.percepts.order.sequence = 1;
  p.set("way", straight({0.0, 30.0}, {100.0, 30.0})).set("progress", 45.0);
  p.step();
  EXPECT_DOUBLE_EQ(p.output<double>(), 55.0);
  PlannedWay shorter = straight({0.0, 30.0}, {50.0, 30.0});
  shorter.version = 2;
  p.set("way", shorter);
  p.percepts.time = 10.0;
  p.step();
  EXPECT_DOUBLE_EQ(p.output<double>(), 5.0);
  p.percepts.time = 12.9;
  p.step();
  EXPECT_DOUBLE_EQ(p.output<double>(), 5.0);
  p.percepts.time = 13.0;
  p.step();
  EXPECT_DOUBLE_EQ(p.output<double>(), 0.0);
}

TEST_F(Way, IsLeftAlongItUpToItsLastCorner) {
  PlannedWay way;
  way.corners = {Point{10, 0}, {110, 0}, {110, 5}, {13, 5}, {13, 4}};
  way.count = 5;
  way.end = WayEnd::kGoal;
  flow::BehaviorProbe p = probe("WayLeft");
  p.percepts.pose.position = {10, 0};
  p.set("way", way).step();
  EXPECT_NEAR(p.output<double>(), 100 + 5 + 97 + 1, 1e-9) << "straight it is 5 m";
  p.percepts.pose.position = {13.1, 4.0};
  p.step();
  EXPECT_NEAR(p.output<double>(), 0.1, 1e-9);
}

}  // namespace
}  // namespace mlab::library_test
