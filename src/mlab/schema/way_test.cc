#include "mlab/schema/way.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

using geom::Point;
using geom::Vector;
using ways::WayEnd;

/// What is known, with what it consists of.
struct Known {
  std::vector<ways::Round> discs;
  std::vector<geom::Segment> walls;
  std::uint64_t revision = 0;

  percept::KnownGround ground() const { return {revision, discs, walls, {0.0, 0.0, 200.0, 200.0}}; }
};

std::uint64_t next_revision() {
  static std::uint64_t last = 0;
  return ++last;
}

Known with_disc() {
  return {{{{50.0, 50.0}, 10.0}}, {}, next_revision()};
}

TEST(PlanWay, IsStraightWhereNothingIsKnown) {
  const auto way = plan_way({}, {0.0, 0.0}, {30.0, 40.0}, 0.2, 5.0);
  EXPECT_EQ(way.end, WayEnd::kGoal);
  ASSERT_EQ(way.count, 2);
  EXPECT_EQ(way.corners[1], (Point{30.0, 40.0}));
}

TEST(PlanWay, KeepsItsMarginWhereThereIsRoom) {
  const Known known = with_disc();
  const auto way = plan_way(known.ground(), {20.0, 50.0}, {80.0, 51.0}, 0.2, 5.0);
  EXPECT_EQ(way.end, WayEnd::kGoal);
  EXPECT_DOUBLE_EQ(way.clearance, 5.2);
  EXPECT_TRUE(is_open(known.ground(), way));
  for (const Point corner : way.points()) EXPECT_GE(distance(corner, {50.0, 50.0}), 15.2 - 1e-6);
}

TEST(PlanWay, BendsItsMarginInNarrowPlaces) {
  Known known;
  known.walls = {{{50.0, 0.0}, {50.0, 98.5}}, {{50.0, 101.5}, {50.0, 200.0}}};
  known.revision = next_revision();
  const auto way = plan_way(known.ground(), {20.0, 100.0}, {80.0, 100.0}, 0.2, 5.0);
  EXPECT_EQ(way.end, WayEnd::kGoal);
  EXPECT_DOUBLE_EQ(way.clearance, 1.45);
}

TEST(PlanWay, GoesAsNearAsItCanWhereItIsClosedOff) {
  Known known;
  known.walls = {{{50.0, 0.0}, {50.0, 200.0}}};
  known.revision = next_revision();
  const auto way = plan_way(known.ground(), {20.0, 100.0}, {80.0, 100.0}, 0.2, 5.0);
  EXPECT_EQ(way.end, WayEnd::kClosedOff);
  for (const Point corner : way.points()) EXPECT_LT(corner.x, 50.0);
}

TEST(PlanWay, EndsBesideAGoalThatSomethingStandsOn) {
  const Known known = with_disc();
  const auto way = plan_way(known.ground(), {20.0, 50.0}, {44.0, 50.0}, 0.2, 5.0);
  EXPECT_EQ(way.end, WayEnd::kBesideGoal);
  EXPECT_NEAR(distance(way.points().back(), {34.8, 50.0}), 0.0, 1e-3);
}

TEST(PlanWay, IsClosedOffFromAGoalInAWallOfAClosedRoom) {
  Known known;
  known.walls = {{{60.0, 50.0}, {140.0, 50.0}},
                 {{140.0, 50.0}, {140.0, 150.0}},
                 {{140.0, 150.0}, {60.0, 150.0}},
                 {{60.0, 150.0}, {60.0, 50.0}},
                 {{100.0, 90.0}, {100.0, 110.0}}};
  known.revision = next_revision();
  const auto in_the_middle = plan_way(known.ground(), {20.0, 100.0}, {100.0, 100.0}, 0.2, 5.0);
  EXPECT_EQ(in_the_middle.end, WayEnd::kClosedOff) << "what is free beside it is as closed off";
  const auto at_the_side = plan_way(known.ground(), {20.0, 100.0}, {60.1, 100.0}, 0.2, 5.0);
  EXPECT_EQ(at_the_side.end, WayEnd::kBesideGoal) << "the other side of the wall";
}

TEST(PlanWay, GoesOnWhereItIsTooLongToBeToldAlsoToAGoalThatSomethingStandsOn) {
  Known known;
  for (int i = 1; i < 48; ++i)
    known.walls.push_back({{4.0 * i, i % 2 == 0 ? 3.0 : 0.0}, {4.0 * i, i % 2 == 0 ? 200.0 : 197.0}});
  known.revision = next_revision();
  for (const Point goal : {Point{190.0, 100.0}, Point{188.1, 100.0}}) {
    const auto way = plan_way(known.ground(), {2.0, 100.0}, goal, 0.2, 0.1);
    EXPECT_EQ(way.end, WayEnd::kFull);
    EXPECT_FALSE(way.is_closed_off());
    EXPECT_LT(distance(way.whole_last(), goal), 2.0) << "where all of it ends";
    EXPECT_NEAR(way_length(way) + way.length_beyond(), 46 * 194.0, 46 * 4.0 + 200.0);
  }
  EXPECT_EQ(plan_way(known.ground(), {2.0, 100.0}, {188.1, 100.0}, 0.2, 0.1).whole_end(),
            WayEnd::kBesideGoal);
}

TEST(PlanWay, SaysThatNoWayLeadsThereAlsoWhereItIsTooLongToBeTold) {
  Known known;
  for (int i = 1; i < 48; ++i)
    known.walls.push_back({{4.0 * i, i % 2 == 0 ? 3.0 : 0.0}, {4.0 * i, i % 2 == 0 ? 200.0 : 197.0}});
  for (const auto& [a, b] : std::initializer_list<std::pair<Point, Point>>{{{192.0, 80.0}, {198.0, 80.0}},
                                                                           {{198.0, 80.0}, {198.0, 120.0}},
                                                                           {{198.0, 120.0}, {192.0, 120.0}},
                                                                           {{192.0, 120.0}, {192.0, 80.0}}})
    known.walls.push_back({a, b});
  known.revision = next_revision();
  const Point goal{195.0, 100.0};
  const auto way = plan_way(known.ground(), {2.0, 100.0}, goal, 0.2, 0.1);
  EXPECT_EQ(way.end, WayEnd::kFull);
  EXPECT_TRUE(way.is_closed_off());
  EXPECT_LT(distance(way.whole_last(), goal), 10.0) << "as near as a way leads";
}

TEST(PlanWay, EndsAtAGoalNearSomething) {
  const Known known = with_disc();
  const auto way = plan_way(known.ground(), {20.0, 50.0}, {38.0, 50.0}, 0.2, 5.0);
  EXPECT_EQ(way.end, WayEnd::kGoal);
  EXPECT_EQ(way.points().back(), (Point{38.0, 50.0}));
}

TEST(PlanWay, IsNotOpenWhereSomethingNewStands) {
  Known known = with_disc();
  const auto way = plan_way(known.ground(), {10.0, 50.0}, {150.0, 50.0}, 0.2, 5.0);
  EXPECT_TRUE(is_open(known.ground(), way));
  known.discs.push_back({{140.0, 52.0}, 3.0});
  EXPECT_FALSE(is_open(known.ground(), way)) << "on its last piece";
  known.discs.back() = {{20.0, 52.0}, 3.0};
  EXPECT_FALSE(is_open(known.ground(), way)) << "on its first piece";
  known.discs.back() = {way.corners[2], 0.5};
  EXPECT_FALSE(is_open(known.ground(), way)) << "at a corner";
  known.discs.back() = {{100.0, 150.0}, 3.0};
  EXPECT_TRUE(is_open(known.ground(), way)) << "elsewhere";
  known.walls = {{{100.0, 0.0}, {100.0, 200.0}}};
  EXPECT_FALSE(is_open(known.ground(), way)) << "a wall across it";
}

TEST(LeadsOn, NotWhereAWallIsBetweenABodyAndWhatItHeadsFor) {
  const Known known{{}, {{{0.0, 50.0}, {100.0, 50.0}}, {{103.0, 50.0}, {200.0, 50.0}}}, next_revision()};
  const auto way = plan_way(known.ground(), {101.5, 40.0}, {101.5, 60.0}, 0.2, 1.0);
  ASSERT_EQ(way.end, WayEnd::kGoal);
  const auto leads = [&](Point from, bool is_body) {
    double off = 0.0;
    return leads_on(known.ground(), true, way, from, 5.0, is_body, nullptr, off);
  };
  EXPECT_TRUE(leads({101.0, 49.5}, true)) << "in the door";
  EXPECT_TRUE(leads({104.0, 44.0}, true)) << "beside the way, with nothing between";
  EXPECT_FALSE(leads({104.5, 49.6}, true)) << "pushed past the door";
  EXPECT_TRUE(leads({104.5, 49.6}, false)) << "the middle of a unit";
  EXPECT_FALSE(leads({107.0, 45.0}, false)) << "too far off";
}

TEST(PlanWay, LeavesWhatItBeginsNearTo) {
  const Known known = with_disc();
  const auto way = plan_way(known.ground(), {61.0, 50.0}, {150.0, 50.0}, 0.2, 5.0);
  EXPECT_EQ(way.end, WayEnd::kGoal);
  EXPECT_TRUE(is_open(known.ground(), way));
}

TEST(WhatBlocks, IsTheFirstThingOnTheLine) {
  Known known = with_disc();
  known.walls = {{{100.0, 0.0}, {100.0, 200.0}}};
  known.revision = next_revision();
  EXPECT_EQ(what_blocks(known.ground(), {80.0, 50.0}, {150.0, 50.0}), "a wall at (100.0, 50.0)");
  EXPECT_EQ(what_blocks(known.ground(), {20.0, 50.0}, {150.0, 50.0}),
            "an obstacle of radius 10.0 m at (50.0, 50.0)");
  EXPECT_EQ(what_blocks(known.ground(), {150.0, 50.0}, {250.0, 50.0}), "the edge of the mission area");
}

TEST(WhatBlocks, TellsMinefieldsFromWalls) {
  Known known;
  known.walls = {{{50.0, 0.0}, {50.0, 200.0}}, {{100.0, 0.0}, {100.0, 200.0}}};
  known.revision = next_revision();
  percept::KnownGround ground = known.ground();
  ground.edges = 1;  // the last one
  EXPECT_EQ(what_blocks(ground, {20.0, 50.0}, {150.0, 50.0}), "a wall at (50.0, 50.0)");
  EXPECT_EQ(what_blocks(ground, {70.0, 50.0}, {150.0, 50.0}), "the edge of a minefield at (100.0, 50.0)");
}

TEST(WhatBlocks, IsTheGapWhereTheLineLeadsThroughOne) {
  Known known = with_disc();
  known.walls = {{{100.0, 0.0}, {100.0, 149.75}}, {{100.0, 150.25}, {100.0, 200.0}}};
  known.revision = next_revision();
  EXPECT_EQ(what_blocks(known.ground(), {80.0, 150.0}, {150.0, 150.0}),
            "a gap of 0.5 m at (100.0, 150.0), which is too narrow,");
  known.walls.back() = {{110.0, 150.25}, {110.0, 200.0}};
  known.revision = next_revision();
  EXPECT_EQ(what_blocks(known.ground(), {80.0, 150.0}, {150.0, 150.0}), "what stands around it")
      << "these don't face each other";
  known.walls.clear();
  EXPECT_EQ(what_blocks(known.ground(), {80.0, 150.0}, {150.0, 150.0}), "what stands around it");
}

TEST(PlaceOnWay, IsWhereTheRobotIsWithoutAWay) {
  const Known known = with_disc();
  const auto none = [] { return 0.0; };
  EXPECT_EQ(place_on_way(known.ground(), {}, {5.0, 5.0, 0.0}, none, 10.0, {20.0, 30.0}, 7.0).place,
            (Point{20.0, 30.0}));
}

TEST(PlaceOnWay, IsNeverBehindTheWallsOfACorner) {
  Known known;
  known.walls = {{{5.0, 5.0}, {5.0, 45.0}}, {{5.0, 5.0}, {45.0, 5.0}}};
  known.revision = next_revision();
  ways::PlannedWay way;
  way.corners[0] = {20.0, 23.0};
  way.corners[1] = {7.0, 7.0};
  way.count = 2;
  way.clearance = 1.45;
  for (const double ahead : {0.0, 1.0, 2.0, 2.4, 2.6, 4.0, 9.0}) {
    const Point place =
        place_on_way(
            known.ground(), way, {ahead, 0.0, 0.0}, [] { return 3.0; }, 1e3, {20.0, 23.0}, 0.0)
            .place;
    EXPECT_GT(place.x, 6.0) << ahead;
    EXPECT_GT(place.y, 6.0) << ahead;
  }
}

// A house beside the way of who follows a line, its wall 3 m from his station.
TEST(PlaceOnWay, IsOnTheWayWhereItWouldMoveOnTooFar) {
  Known known;
  known.walls = {{{20.0, 53.0}, {180.0, 53.0}}};
  known.revision = next_revision();
  ways::PlannedWay way;
  way.corners[0] = {10.0, 40.0};
  way.corners[1] = {195.0, 40.0};
  way.count = 2;
  way.clearance = 5.2;
  way.end = WayEnd::kGoal;
  const Point here{30.0, 45.0};
  const auto place = [&](double most) {
    return place_on_way(known.ground(), way, {0.0, 10.0, 0.0}, [] { return 0.0; }, 25.0, here, 7.0, most);
  };
  EXPECT_GT(place(1e300).place.x, 180.0) << "where nothing stands at its station";
  EXPECT_EQ(place(36.0).place.y, 40.0);
  EXPECT_LT(place(36.0).place.x, 50.0);
  EXPECT_GE(distance(place(36.0).place, here), 7.0);
  EXPECT_EQ(place(36.0).at, place(36.0).place.x - 10.0);
}

ways::PlannedWay way_along(const std::vector<Point>& corners) {
  ways::PlannedWay out;
  std::ranges::copy(corners, out.corners.begin());
  out.count = static_cast<std::uint16_t>(corners.size());
  return out;
}

TEST(PlaceOnWay, EndsAlsoWhereAWayLiesAboutItsLength) {
  const Known known = with_disc();
  auto way = way_along({{40.0, 50.0}, {50.0, 50.0}});  // all of it where nobody can be
  way.clearance = 5.0;
  way.length = 1e300;
  const auto none = [] { return 0.0; };
  for (const double at : {0.0, -1e300}) {
    const Point place = place_on_way(known.ground(), way, {}, none, at, {50.0, 50.0}, 1e300).place;
    EXPECT_TRUE(is_finite(place)) << at;
  }
}

TEST(PlaceOnWay, IsTheGoalItselfWhereTheWayLeadsThere) {
  const Known known = with_disc();
  const Point goal{62.0, 50.0};  // 2 m from the disc, less than the way keeps elsewhere
  auto way = way_along({{90.0, 50.0}, goal});
  way.clearance = 5.0;
  way.end = WayEnd::kGoal;
  const auto place = [&](Vector station) {
    return place_on_way(known.ground(), way, station, [] { return 0.0; }, 1e3, {90.0, 50.0}, 0.0).place;
  };
  EXPECT_EQ(place({}), goal);
  EXPECT_GE(distance(place({0.0, 0.5, 0.0}), {50.0, 50.0}), 15.0) << "a station keeps off it";
}

// Beside a long straight way nobody looks at each place of a station that stays outside of the area all
// along: which makes no difference. A way with a corner in line is looked along.
TEST(PlaceOnWay, OutsideOfTheAreaIsTheSameHoweverItIsLookedFor) {
  const Known known = with_disc();
  for (const Point goal : {Point{190.0, 90.0}, Point{190.0, 10.0}, Point{20.0, 195.0}}) {
    auto straight = way_along({{10.0, 10.0}, goal});
    auto bent = way_along({{10.0, 10.0}, Point{10.0, 10.0} + (goal - Point{10.0, 10.0}) * 0.5, goal});
    straight.clearance = bent.clearance = 1.0;
    straight.end = bent.end = WayEnd::kGoal;
    straight.length = way_length(straight);
    for (const double aside : {-2000.0, -150.0, -60.0, -15.0, -2.0, 2.0, 15.0, 60.0, 85.0, 150.0, 2000.0}) {
      for (const double at : {-40.0, 0.0, 100.0, 300.0}) {
        const auto place = [&](const ways::PlannedWay& way) {
          return place_on_way(
              known.ground(), way, {5.0, aside, 0.0}, [] { return 0.0; }, at, {10.0, 10.0}, 5.0);
        };
        const PlaceAhead a = place(straight);
        const PlaceAhead b = place(bent);
        EXPECT_NEAR(distance(a.place, b.place), 0.0, 1e-6) << goal.x << ' ' << aside << ' ' << at;
        EXPECT_NEAR(a.at, b.at, 1e-6) << goal.x << ' ' << aside << ' ' << at;
      }
    }
  }
}

TEST(LeadsOn, SaysHowFarOffTheWayOneIs) {
  const Known known{{}, {}, next_revision()};
  auto way = way_along({{0.0, 0.0}, {50.0, 0.0}});
  way.end = WayEnd::kGoal;
  const auto off = [&] {
    double out = 0.0;
    EXPECT_TRUE(leads_on(known.ground(), true, way, {20.0, 3.0}, 5.0, false, nullptr, out));
    return out;
  };
  EXPECT_EQ(off(), 3.0);
  way.end = WayEnd::kFull;
  EXPECT_EQ(off(), std::numeric_limits<double>::infinity()) << "where its end is near it is to be planned on";
}

TEST(LeadsOn, NotToAPlaceThatSomethingNewStandsAt) {
  Known known = with_disc();
  const auto way = plan_way(known.ground(), {10.0, 20.0}, {150.0, 20.0}, 0.2, 5.0);
  known.revision = next_revision();
  double off = 0.0;
  EXPECT_TRUE(leads_on(known.ground(), false, way, {10.0, 20.0}, 5.0, true, nullptr, off));
  known.discs.push_back({{153.0, 20.0}, 6.0});
  EXPECT_FALSE(leads_on(known.ground(), false, way, {10.0, 20.0}, 5.0, true, nullptr, off));
}

// Whether it is known how long a way is makes no difference, to the last bit.
TEST(WayProgress, IsTheSameWhereTheLengthIsKnown) {
  const auto way = way_along({{3.0, -2.0}, {71.3, 40.9}});
  auto known = way;
  known.length = route_length(way.points());
  const double inf = std::numeric_limits<double>::infinity();
  for (const Point p : {Point{10.0, 3.1}, {-9.0, 1.0}, {90.7, 55.1}, {3.0, -2.0}, {1e200, 3.0}, {inf, 0.0}}) {
    for (const double from : {-1e4, 0.0, 13.7, 90.0}) {
      for (const double to : {-3.0, 20.0, 30.3, 1e4}) {
        EXPECT_EQ(nearest_on(known, p, from, to), nearest_way(way.points(), p, from, to));
        if (from > to) continue;
        EXPECT_EQ(way_progress(known, p, from, to), way_progress(way, p, from, to));
      }
    }
  }
  for (const double at : {-inf, -5.0, 0.0, 17.3, 80.6, 81.0, inf})
    EXPECT_EQ(point_on(known, at), route_point(way.points(), at));
}

TEST(WayProgress, GoesOnBeyondTheEnds) {
  const ways::PlannedWay way = way_along({{0.0, 0.0}, {50.0, 0.0}, {50.0, 50.0}});
  EXPECT_DOUBLE_EQ(way_progress(way, {-4.0, 1.0}, -50.0, 150.0), -4.0);
  EXPECT_DOUBLE_EQ(way_progress(way, {4.0, 1.0}, -50.0, 150.0), 4.0);
  EXPECT_DOUBLE_EQ(way_progress(way, {51.0, 53.0}, -50.0, 150.0), 103.0);
  EXPECT_EQ(way_point(way, -4.0), (Point{-4.0, 0.0}));
  EXPECT_EQ(way_point(way, 103.0), (Point{50.0, 53.0}));
}

TEST(WayProgress, GoesOnWhereTheWayLedNotItsLastStep) {
  const ways::PlannedWay way = way_along({{0.0, 0.0}, {50.0, 0.0}, {49.0, 0.5}});
  EXPECT_GT(way_point(way, 80.0).x, 70.0);
}

}  // namespace
}  // namespace mlab::schema
