#include "mlab/ways/coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "mlab/base/testing/processor_time.h"
#include "mlab/geom/outline.h"
#include "mlab/ways/bending_planner.h"
#include "mlab/ways/testing/searches.h"

namespace mlab::ways {
namespace {

using testing::room_at;
using testing::SeenPlaces;

constexpr std::uint64_t kCoverageSeed = 20261128;

using Outline = std::vector<geom::Point>;

Outline rectangle(double width, double height) {
  return {{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}};
}

/// On a square [0, side], two thirds of it wide at least where it is no L.
template <class Random>
Outline any_outline(Random& random, double side, int kind) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  if (kind == 0) return rectangle(side, (0.7 + 0.3 * share(random)) * side);
  if (kind == 1) {
    const double w = (0.4 + 0.2 * share(random)) * side;
    return {{0.0, 0.0}, {side, 0.0}, {side, w}, {w, w}, {w, side}, {0.0, side}};
  }
  if (kind == 2) return {{0.0, 0.1 * side * share(random)}, {side, 0.0}, {side * share(random), side}};
  Outline out;
  const int corners = 5 + static_cast<int>(6.0 * share(random));
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.8 * share(random)) / corners;
    const double far = side * (0.35 + 0.15 * share(random));
    out.push_back({0.5 * side + far * std::cos(angle), 0.5 * side + far * std::sin(angle)});
  }
  return out;
}

/// Discs of radius 2 to 12 m that cover a share of a square.
template <class Random>
Ground any_discs(Random& random, double side, double share) {
  std::uniform_real_distribution<double> place(0.0, side);
  std::uniform_real_distribution<double> radius(2.0, 12.0);
  Ground out;
  for (double covered = 0.0; covered < share * side * side;) {
    out.discs.push_back({{place(random), place(random)}, radius(random)});
    covered += std::numbers::pi * out.discs.back().radius * out.discs.back().radius;
  }
  return out;
}

/// What the way really is, planned anew.
struct Walked {
  double length = 0.0;
  double seen = 0.0;
  double room = 1e9;
  double ratio = 0.0;  // of its length, and of what a straight way needs for as large an area
};
Walked walked(const Coverage& coverage, const Ground& ground, const Clearances& clearances, double swath,
              SeenPlaces& places) {
  Walked out;
  BendingPlanner planner(ground, clearances);
  if (!coverage.waypoints.empty()) places.pass({coverage.waypoints.front(), coverage.waypoints.front()});
  for (std::size_t i = 1; i < coverage.waypoints.size(); ++i) {
    const auto way = planner.find(coverage.waypoints[i - 1], coverage.waypoints[i]);
    EXPECT_TRUE(way) << i;
    for (std::size_t k = 1; way && k < way->corners.size(); ++k) {
      const geom::Segment piece{way->corners[k - 1], way->corners[k]};
      places.pass(piece);
      out.length += distance(piece.a, piece.b);
      for (int j = 0; j <= 10; ++j)
        out.room = std::min(out.room, room_at(ground, piece.a + (piece.b - piece.a) * (j / 10.0)));
    }
  }
  out.seen = places.seen_share();
  out.ratio = out.length * swath / places.free_area();
  return out;
}

TEST(Coverage, GoesToAndFroAlongTheLongerSide) {
  const Coverage out = coverage_route(rectangle(200.0, 50.0), {}, 1.0, 10.0);
  ASSERT_EQ(out.end, CoverageEnd::kCovered);
  EXPECT_NEAR(out.free_area, 10'000.0, 100.0);
  EXPECT_EQ(out.visible, 1.0);
  EXPECT_LT(out.length, 5 * 190.0 + 4 * 10.0 + 30.0);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(std::fmod(out.waypoints[i].y, 10.0), 5.0, 1.0);
}

TEST(Coverage, SeesWhatCanBeSeenOnAShortWay) {
  for (int round = 0; round < base::examples(24); ++round) {
    const std::uint64_t seed = kCoverageSeed + static_cast<std::uint64_t>(round);
    std::mt19937_64 random(seed);
    const double swath = round / 4 % 2 == 0 ? 10.0 : 20.0;
    const double clearance = std::array{0.7, 2.5, 5.2}[static_cast<std::size_t>(round) % 3];
    const double share = std::array{0.10, 0.0, 0.03, 0.06}[static_cast<std::size_t>(round / 2) % 4];
    const double side = 18.0 * swath;
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Outline outline = any_outline(random, side, round % 4);
    const Ground ground = any_discs(random, side, share);
    const Coverage out = coverage_route(outline, ground, clearance, swath);
    EXPECT_EQ(out.end, CoverageEnd::kCovered);
    SeenPlaces places(outline, ground, clearance, swath, side, 0.06 * swath);
    EXPECT_NEAR(out.free_area, places.free_area(), 0.01 * places.free_area());
    EXPECT_NEAR(out.visible, places.visible_share(), 0.003);
    const Walked real = walked(out, ground, clearance, swath, places);
    EXPECT_GE(real.seen, Coverage::kWanted);
    EXPECT_LE(real.ratio, 1.3);
    EXPECT_NEAR(real.length, out.length, 1e-6 * out.length);
    // Corners of planned ways round things may come so near to others beside them.
    EXPECT_GE(real.room, clearance - 0.01 * (clearance + 8.0));
  }
}

TEST(Coverage, AnswersTheSameEachTime) {
  std::mt19937_64 random(kCoverageSeed);
  const Outline outline = any_outline(random, 150.0, 3);
  const Ground ground = any_discs(random, 150.0, 0.1);
  const Coverage one = coverage_route(outline, ground, 2.0, 10.0);
  const Coverage other = coverage_route(outline, ground, 2.0, 10.0);
  EXPECT_EQ(one.waypoints, other.waypoints);
  EXPECT_EQ(one.length, other.length);
  const Outline turned(outline.rbegin(), outline.rend());
  EXPECT_EQ(coverage_route(turned, ground, 2.0, 10.0).end, CoverageEnd::kCovered);
}

TEST(Coverage, LooksWhereAWayLeadsFromWhereRobotsAre) {
  Ground ground;  // more of the area is in the room than outside
  ground.bounds = {-50.0, -50.0, 150.0, 150.0};
  const Outline room = {{10.0, 10.0}, {100.0, 10.0}, {100.0, 100.0}, {10.0, 100.0}};
  for (std::size_t i = 0; i < room.size(); ++i)
    ground.walls.push_back({room[i], room[(i + 1) % room.size()]});
  const Outline area = rectangle(100.0, 100.0);
  const auto is_in_room = [](geom::Point p) {
    return std::min(p.x, p.y) > 10.0 && std::max(p.x, p.y) < 100.0;
  };
  for (const bool is_within : {false, true}) {
    const geom::Point from = is_within ? geom::Point{50.0, 50.0} : geom::Point{-30.0, 40.0};
    const Coverage out = coverage_route(area, ground, 1.0, 10.0, std::array{from});
    EXPECT_EQ(out.end, CoverageEnd::kCovered);
    EXPECT_TRUE(
        std::ranges::all_of(out.waypoints, [&](geom::Point p) { return is_in_room(p) == is_within; }));
    // To either side of a wall a robot sees 4 m far beyond it.
    EXPECT_NEAR(out.visible, is_within ? 0.9 * 0.9 : 1.0 - 0.9 * 0.9, 0.01);
    const auto outlook = coverage_outlook(area, ground, 1.0, 10.0, from);
    ASSERT_TRUE(outlook);
    EXPECT_EQ(outlook->visible, out.visible);
    EXPECT_EQ(outlook->free_area, out.free_area);
    EXPECT_TRUE(outlook->waypoints.empty());
  }
  EXPECT_EQ(coverage_outlook(rectangle(40.0, 40.0), ground, 1.0, 0.001)->end, CoverageEnd::kTooLarge);
}

TEST(Coverage, OutlookIsGivenUpWhereItWouldTakeLong) {
  std::mt19937_64 random(kCoverageSeed);
  std::uniform_real_distribution<double> place(0.0, 1000.0);
  Ground ground;
  for (int i = 0; i < 3500; ++i) ground.discs.push_back({{place(random), place(random)}, 3.0});
  EXPECT_FALSE(coverage_outlook(rectangle(1000.0, 1000.0), ground, 5.2, 10.0));
}

TEST(Coverage, LeavesOutWhatIsClosedOffAndSaysHowMuch) {
  Ground ground;  // a room of 40 m x 40 m without a door
  const Outline room = {{30.0, 30.0}, {70.0, 30.0}, {70.0, 70.0}, {30.0, 70.0}};
  for (std::size_t i = 0; i < room.size(); ++i)
    ground.walls.push_back({room[i], room[(i + 1) % room.size()]});
  const Coverage out = coverage_route(rectangle(100.0, 100.0), ground, 1.0, 10.0);
  EXPECT_EQ(out.end, CoverageEnd::kCovered);
  EXPECT_NEAR(out.free_area, 10'000.0, 100.0);
  EXPECT_NEAR(out.visible, 1.0 - 0.0001 * 40.0 * 40.0, 0.003) << "nobody sees through its walls";
  for (const geom::Point p : out.waypoints) EXPECT_FALSE(geom::is_within(room, p));
}

TEST(Coverage, FindsTheDoorOfARoom) {
  Ground ground;
  ground.walls = {{{30.0, 30.0}, {70.0, 30.0}},
                  {{70.0, 30.0}, {70.0, 70.0}},
                  {{70.0, 70.0}, {51.2, 70.0}},
                  {{48.8, 70.0}, {30.0, 70.0}},
                  {{30.0, 70.0}, {30.0, 30.0}}};
  const Outline outline = rectangle(100.0, 100.0);
  const Coverage out = coverage_route(outline, ground, 1.0, 10.0);
  EXPECT_EQ(out.end, CoverageEnd::kCovered);
  EXPECT_GT(out.visible, 0.999);
  SeenPlaces places(outline, ground, 1.0, 10.0, 100.0, 0.4);
  const Walked real = walked(out, ground, 1.0, 10.0, places);
  EXPECT_GE(real.seen, Coverage::kWanted);
  EXPECT_LE(real.ratio, 1.5);
}

TEST(Coverage, LooksBehindAWallThatItPassesCloseBy) {
  // What is behind a wall is near enough to lanes on the other side, which do not see it.
  Ground ground;
  ground.walls = {{{2.0, 8.0}, {98.0, 8.0}}};
  const Outline outline = rectangle(100.0, 11.0);
  const Coverage out = coverage_route(outline, ground, 0.5, 20.0, std::array{geom::Point{50.0, 4.0}});
  EXPECT_EQ(out.end, CoverageEnd::kCovered);
  SeenPlaces places(outline, ground, 0.5, 20.0, 100.0, 0.5);
  const Walked real = walked(out, ground, 0.5, 20.0, places);
  EXPECT_GE(real.seen, Coverage::kWanted);
  EXPECT_TRUE(std::ranges::any_of(out.waypoints, [](geom::Point p) { return p.y > 8.0; }));
}

TEST(Coverage, SeesOverAnEdgeThatIsNotOpaque) {
  Ground ground;  // an area of 20 m x 20 m that robots keep out of
  const Outline area = {{40.0, 40.0}, {60.0, 40.0}, {60.0, 60.0}, {40.0, 60.0}};
  for (std::size_t i = 0; i < area.size(); ++i)
    ground.walls.push_back({area[i], area[(i + 1) % area.size()]});
  const auto visible = [&](const std::optional<std::vector<geom::Segment>>& opaque) {
    return coverage_route(rectangle(100.0, 100.0), ground, 1.0, 10.0, std::array{geom::Point{5.0, 5.0}},
                          opaque)
        .visible;
  };
  EXPECT_NEAR(visible(std::nullopt), 0.96, 0.003);
  // 4 m far into it.
  EXPECT_NEAR(visible(std::vector<geom::Segment>()), 1.0 - 0.0001 * 12.0 * 12.0, 0.003);
}

/// Walls from corner to corner that hang together.
void add_walls(Ground& ground, const Outline& corners) {
  for (std::size_t i = 1; i < corners.size(); ++i) ground.walls.push_back({corners[i - 1], corners[i]});
}

/// A square of 100 m with walls round it and two across, which make four rooms with doors between them.
Ground four_rooms(double door) {
  Ground out;
  add_walls(out, {{0.0, 0.0}, {100.0, 0.0}, {100.0, 100.0}, {0.0, 100.0}, {0.0, 0.0}});
  const double low = 25.0 - 0.5 * door;
  const double high = 75.0 - 0.5 * door;
  add_walls(out, {{50.0, 0.0}, {50.0, low}});
  add_walls(out, {{50.0, low + door}, {50.0, high}});
  add_walls(out, {{50.0, high + door}, {50.0, 100.0}});
  add_walls(out, {{0.0, 50.0}, {low, 50.0}});
  add_walls(out, {{low + door, 50.0}, {100.0, 50.0}});
  return out;
}

TEST(Coverage, GoesThroughEveryDoorThatTheLeastClearancePasses) {
  const Clearances clearances(0.2, 5.0);
  const Outline outline = rectangle(100.0, 100.0);
  for (const double door : {1.2, 2.0, 4.0, 6.0, 9.0, 10.0, 11.0}) {
    if (base::kIsSlowBuild && door != 1.2 && door != 11.0) continue;
    SCOPED_TRACE("a door of " + std::to_string(door) + " m");
    const Ground ground = four_rooms(door);
    const Coverage out =
        coverage_route(outline, ground, clearances, 10.0, std::array{geom::Point{20.0, 20.0}});
    EXPECT_EQ(out.end, CoverageEnd::kCovered);
    EXPECT_GT(out.visible, 0.999);
    SeenPlaces places(outline, ground, clearances.least(), 10.0, 100.0, 0.4);
    const Walked real = walked(out, ground, clearances.bent(1), 10.0, places);
    EXPECT_GE(real.seen, Coverage::kWanted);
    EXPECT_LE(real.ratio, 1.5);
    EXPECT_GE(real.room, 0.9 * clearances.least());
  }
}

TEST(Coverage, KeepsTheWidestClearanceFromWhichAllIsSeen) {
  const Clearances clearances(0.2, 5.0);
  const Ground ground = four_rooms(2.0);
  const auto kept = [&](double swath) {
    return coverage_route(rectangle(100.0, 100.0), ground, clearances, swath).clearance;
  };
  EXPECT_EQ(kept(20.0), clearances.widest());
  EXPECT_EQ(kept(10.0), 2.7);
  EXPECT_EQ(kept(2.0), clearances.least());
  EXPECT_EQ(coverage_route(rectangle(100.0, 100.0), {}, clearances, 2.0).clearance, clearances.widest());
}

TEST(Coverage, SearchesRoomsThatAreTooNarrowForTheWholeMargin) {
  Ground ground;  // four of 6 m by 8 m beside a corridor of 4 m
  add_walls(ground, {{24.0, 4.0}, {24.0, 12.0}, {0.0, 12.0}, {0.0, 0.0}, {24.0, 0.0}});
  for (const double x : {0.0, 6.0, 12.0, 18.0}) {
    add_walls(ground, {{x, 12.0}, {x, 4.0}, {x + 2.0, 4.0}});
    add_walls(ground, {{x + 3.0, 4.0}, {x + 6.0, 4.0}});
  }
  const Clearances clearances(0.2, 5.0);
  const Outline outline = rectangle(24.0, 12.0);
  const Coverage out = coverage_route(outline, ground, clearances, 3.0, std::array{geom::Point{40.0, 2.0}});
  EXPECT_EQ(out.end, CoverageEnd::kCovered);
  EXPECT_GT(out.visible, 0.99);
  for (const double x : {3.0, 9.0, 15.0, 21.0}) {
    EXPECT_TRUE(std::ranges::any_of(out.waypoints, [&](geom::Point p) {
      return std::abs(p.x - x) < 3.0 && p.y > 5.0;
    })) << x;
  }
}

TEST(Coverage, StaysWithinBounds) {
  Ground ground;
  ground.bounds = {10.0, 5.0, 90.0, 95.0};
  const Coverage out = coverage_route(rectangle(100.0, 100.0), ground, 1.0, 10.0);
  EXPECT_EQ(out.end, CoverageEnd::kCovered);
  EXPECT_NEAR(out.free_area, 80.0 * 90.0, 100.0);
  for (const geom::Point p : out.waypoints) EXPECT_TRUE(ground.bounds.contains(p));
}

TEST(Coverage, IsOnePlaceWhereAllIsSeenFromThere) {
  const Coverage out = coverage_route(rectangle(3.0, 2.0), {}, 1.0, 10.0);
  EXPECT_EQ(out.end, CoverageEnd::kCovered);
  EXPECT_EQ(out.waypoints.size(), 1U);
  EXPECT_EQ(out.length, 0.0);
  EXPECT_EQ(coverage_route(rectangle(1e-9, 1e-9), {}, 1.0, 10.0).waypoints.size(), 1U);
}

TEST(Coverage, IsEmptyWhereNothingIsToBeSearched) {
  const auto is_nothing = [](const Outline& outline, const Ground& ground) {
    const Coverage out = coverage_route(outline, ground, 1.0, 10.0);
    return out.end == CoverageEnd::kNothingToSearch && out.waypoints.empty();
  };
  EXPECT_TRUE(is_nothing({}, {}));
  EXPECT_TRUE(is_nothing({{0.0, 0.0}, {100.0, 0.0}}, {}));
  EXPECT_TRUE(is_nothing(rectangle(100.0, 100.0), {{{{50.0, 50.0}, 200.0}}, {}, {}}));
  EXPECT_TRUE(is_nothing(rectangle(100.0, 100.0), {{}, {}, {200.0, 200.0, 300.0, 300.0}}));
  EXPECT_TRUE(is_nothing(rectangle(100.0, 100.0), {{}, {}, {300.0, 300.0, 200.0, 200.0}}));
}

TEST(Coverage, IsEmptyWhereTheOutlineHasNoArea) {
  const auto has_none = [](const Outline& outline) {
    const Coverage out = coverage_route(outline, {}, 1.0, 10.0);
    return out.end == CoverageEnd::kNoArea && out.waypoints.empty();
  };
  EXPECT_TRUE(has_none({{0.0, 0.0}, {50.0, 50.0}, {100.0, 100.0}}));
  EXPECT_TRUE(has_none({{0.1, 0.3}, {0.7, 2.1}, {0.2, 0.6}, {0.5, 1.5}}));
  EXPECT_TRUE(has_none(Outline(5, {3.0, 4.0})));
  EXPECT_FALSE(has_none({{0.0, 0.0}, {50.0, 51.0}, {100.0, 100.0}}));
}

TEST(Coverage, SearchesOutlinesThatTouchOrCrossThemselves) {
  const Outline bow = {{0.0, 0.0}, {100.0, 100.0}, {100.0, 0.0}, {0.0, 100.0}};
  const Coverage crossed = coverage_route(bow, {}, 1.0, 10.0);
  EXPECT_EQ(crossed.end, CoverageEnd::kCovered);
  EXPECT_NEAR(crossed.free_area, 5'000.0, 100.0);
  const Outline ring = {{0.0, 0.0},   {100.0, 0.0}, {100.0, 100.0}, {0.0, 100.0}, {0.0, 0.0},
                        {30.0, 30.0}, {30.0, 70.0}, {70.0, 70.0},   {70.0, 30.0}, {30.0, 30.0}};
  const Coverage hollow = coverage_route(ring, {}, 1.0, 10.0);
  EXPECT_EQ(hollow.end, CoverageEnd::kCovered);
  EXPECT_NEAR(hollow.free_area, 8'400.0, 200.0);
}

/// How far a robot goes that follows a share, from where it is: straight on to its beginning.
double length_of_share(const Coverage& coverage, std::size_t share, geom::Point robot,
                       BendingPlanner& planner, SeenPlaces& places) {
  const std::size_t first = coverage.shares[share];
  const bool is_last = share + 1 == coverage.shares.size();
  const std::size_t end = is_last ? coverage.waypoints.size() : coverage.shares[share + 1];
  EXPECT_GE(end, first + 2);
  EXPECT_TRUE(coverage.corners[end - 1].empty());
  double out = geom::distance(robot, coverage.waypoints[first]);
  for (std::size_t i = first + 1; i < end; ++i) {
    const auto way = planner.find(coverage.waypoints[i - 1], coverage.waypoints[i]);
    EXPECT_TRUE(way) << i;
    for (std::size_t k = 1; way && k < way->corners.size(); ++k) {
      places.pass({way->corners[k - 1], way->corners[k]});
      out += geom::distance(way->corners[k - 1], way->corners[k]);
    }
  }
  return out;
}

TEST(Coverage, IsSharedByRobotsThatGoAboutAsFar) {
  for (int round = 0; round < base::examples(6); ++round) {
    const std::uint64_t seed = kCoverageSeed + 500 + static_cast<std::uint64_t>(round);
    std::mt19937_64 random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const double side = 200.0;
    const Outline outline = any_outline(random, side, round % 4);
    const Ground ground = any_discs(random, side, std::array{0.0, 0.05}[static_cast<std::size_t>(round) % 2]);
    Outline robots;
    for (int i = 0; i < 2 + round % 4; ++i) robots.push_back({-30.0, 10.0 * i});
    const Coverage alone = coverage_route(outline, ground, 1.0, 10.0);
    const Coverage out = coverage_route(outline, ground, 1.0, 10.0, robots);
    ASSERT_EQ(out.end, CoverageEnd::kCovered);
    ASSERT_EQ(out.shares.size(), robots.size());
    BendingPlanner planner(ground, 1.0);
    SeenPlaces places(outline, ground, 1.0, 10.0, side, 1.0);
    double total = 0.0;
    double longest = 0.0;
    for (std::size_t share = 0; share < out.shares.size(); ++share) {
      const double length = length_of_share(out, share, robots[share], planner, places);
      total += length;
      longest = std::max(longest, length);
    }
    EXPECT_GE(places.seen_share(), 0.99);
    EXPECT_LE(longest, 1.15 * total / static_cast<double>(robots.size()));
    EXPECT_LE(out.length, 1.1 * alone.length) << "of all together, without the ways there";
    EXPECT_EQ(coverage_route(outline, ground, 1.0, 10.0, robots).waypoints, out.waypoints);
  }
}

TEST(Coverage, HasFewerSharesThanRobotsWhereThereIsLittleToDo) {
  const Outline robots(12, {-5.0, 5.0});
  EXPECT_EQ(coverage_route(rectangle(3.0, 2.0), {}, 1.0, 10.0, robots).shares.size(), 1U);
  const Coverage few = coverage_route(rectangle(60.0, 30.0), {}, 1.0, 10.0, robots);
  EXPECT_GT(few.shares.size(), 1U);
  EXPECT_LT(few.shares.size(), 5U);
  EXPECT_TRUE(coverage_route({}, {}, 1.0, 10.0, robots).shares.empty());
}

TEST(Coverage, RefusesWhatCanNotBeComputed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Outline square = rectangle(100.0, 100.0);
  const auto end = [](const Outline& outline, const Ground& ground, double clearance, double swath) {
    const Coverage out = coverage_route(outline, ground, clearance, swath);
    EXPECT_TRUE(out.waypoints.empty());
    return out.end;
  };
  for (const double bad : {nan, infinity, -infinity, -1.0}) {
    EXPECT_EQ(end(square, {}, 1.0, bad), CoverageEnd::kUnusable);
    EXPECT_EQ(end(square, {}, bad, 10.0), CoverageEnd::kUnusable);
    EXPECT_EQ(end(square, {{{{1.0, 1.0}, bad}}, {}, {}}, 1.0, 10.0), CoverageEnd::kUnusable);
  }
  EXPECT_EQ(end(square, {}, 1.0, 0.0), CoverageEnd::kUnusable);
  for (const double bad : {nan, infinity, -infinity}) {
    EXPECT_EQ(end({{0.0, 0.0}, {bad, 0.0}, {1.0, 1.0}}, {}, 1.0, 10.0), CoverageEnd::kUnusable);
    EXPECT_EQ(end(square, {{}, {{{0.0, bad}, {1.0, 1.0}}}, {}}, 1.0, 10.0), CoverageEnd::kUnusable);
    EXPECT_EQ(end(square, {{}, {}, {bad, nan, 1.0, 1.0}}, 1.0, 10.0), CoverageEnd::kNothingToSearch);
  }
  for (const double large : {1e5, 1e9, 1e160, 1e300, 1.7e308})
    EXPECT_EQ(end(rectangle(large, large), {}, 1.0, 10.0), CoverageEnd::kTooLarge) << large;
  EXPECT_EQ(end(rectangle(1e300, 1.0), {}, 1.0, 10.0), CoverageEnd::kTooLarge);
  EXPECT_EQ(end(square, {}, 1.0, 1e-3), CoverageEnd::kTooLarge);
  EXPECT_EQ(end(square, {}, 1.0, 1e-300), CoverageEnd::kTooLarge);
}

TEST(Coverage, IsComputedForAllSizesInBetween) {
  for (const double size : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    const Coverage out = coverage_route(rectangle(7.0 * size, 5.0 * size), {}, 0.0, size);
    EXPECT_EQ(out.end, CoverageEnd::kCovered) << size;
    EXPECT_LT(out.length, 1.3 * 35.0 * size) << size;
  }
  const Coverage narrow = coverage_route(rectangle(500.0, 0.01), {}, 1.0, 10.0);
  EXPECT_EQ(narrow.end, CoverageEnd::kCovered);
  EXPECT_NEAR(narrow.length, 494.0, 5.0);
  EXPECT_EQ(coverage_route(rectangle(50.0, 50.0), {}, 1.0, 1e6).waypoints.size(), 1U);
}

}  // namespace
}  // namespace mlab::ways
