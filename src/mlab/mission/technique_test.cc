#include "mlab/mission/technique.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mlab/mission/executive.h"
#include "mlab/mission/testing/toy_fleet.h"

namespace mlab::mission {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the test's own vocabulary

// The unit starts in a row at x = 50 and goes to the goal in the given technique.
std::shared_ptr<const Mission> leg(MissionMaker m, std::uint32_t unit, Technique technique,
                                   geom::Point goal = {650, 250}) {
  UnitCommand move = move_to(unit, "A", goal);
  move.technique = technique;
  m.step({start(unit, {50, 200}, {0, 20})}).step({move});
  m.step({occupy(unit, "A", goal)});
  return m.make();
}

std::shared_ptr<const Mission> two_teams(Technique technique, geom::Point goal = {650, 250}) {
  MissionMaker m;
  const auto first = m.unit("first", 2);
  const auto second = m.unit("second", 2);
  const auto unit = m.unit("unit", {first, second});
  return leg(m, unit, technique, goal);
}

bool moves(ToyFleet& fleet, std::uint32_t id) {
  return geom::length(fleet.robot(id).step) > 0.0;
}

// Runs the command of step 1 to its end and looks at every cycle of it.
void watch_leg(ToyFleet& fleet, const std::function<void()>& look) {
  fleet.send(event::Execute{});
  while (fleet.state().mode == State::Mode::kRunning && fleet.state().step < 2 && fleet.time() < 2000.0) {
    fleet.cycle();
    if (fleet.state().step == 1) look();
  }
}

TEST(BoundingOverwatch, NeverMovesBothPartsAndAlternates) {
  ToyFleet fleet(two_teams(Technique::kBoundingOverwatch), {.proceed_all = true});
  std::vector<int> movers;
  watch_leg(fleet, [&] {
    const bool first = moves(fleet, 1) || moves(fleet, 2);
    const bool second = moves(fleet, 3) || moves(fleet, 4);
    EXPECT_FALSE(first && second) << "at " << fleet.time();
    const int mover = first ? 1 : second ? 2 : 0;
    if (mover != 0 && (movers.empty() || movers.back() != mover)) movers.push_back(mover);
  });
  EXPECT_EQ(movers, (std::vector<int>{1, 2, 1, 2, 1})) << "bounds of 150 m on a leg of 600 m";
  EXPECT_EQ(fleet.state().step, 2U);
}

TEST(BoundingOverwatch, PassesTheHaltedPartByABound) {
  ToyFleet fleet(two_teams(Technique::kBoundingOverwatch), {.proceed_all = true});
  double widest = 0.0;
  watch_leg(fleet, [&] { widest = std::max(widest, std::abs(fleet.position(1).x - fleet.position(3).x)); });
  EXPECT_NEAR(widest, 150.0, 12.0);
}

TEST(BoundingOverwatch, EndsSideBySideAroundTheGoal) {
  ToyFleet fleet(two_teams(Technique::kBoundingOverwatch), {.proceed_all = true});
  watch_leg(fleet, [] {});
  const geom::Point first = fleet.centre({{1}, {2}});
  const geom::Point second = fleet.centre({{3}, {4}});
  EXPECT_NEAR(geom::distance(first, second), 50.0, 3.0);
  EXPECT_LE(geom::distance(fleet.centre({{1}, {2}, {3}, {4}}), {650, 250}), 2.0);
  EXPECT_GT(second.y, first.y) << "who was on the left stays there";
}

TEST(BoundingOverwatch, ComesTogetherAgainForTheNextCommand) {
  ToyFleet fleet(two_teams(Technique::kBoundingOverwatch), {.proceed_all = true});
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run());
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
  EXPECT_EQ(fleet.robot(1).order.members.size(), 4U);
  EXPECT_FALSE(fleet.robot(1).order.order.halted);
}

TEST(BoundingOverwatch, WorksOnAShortLegToo) {
  ToyFleet fleet(two_teams(Technique::kBoundingOverwatch, {80, 230}), {.proceed_all = true});
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run(300.0));
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
}

TEST(BoundingOverwatch, EndsWhereTheUnitIsAtItsGoalAlready) {
  ToyFleet fleet(two_teams(Technique::kBoundingOverwatch, {50, 230}), {.proceed_all = true});
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run(300.0));
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
}

TEST(BoundingOverwatch, DividesAFlatUnitIntoHalvesByRank) {
  MissionMaker m;
  const auto unit = m.unit("unit", 5);
  ToyFleet fleet(leg(m, unit, Technique::kBoundingOverwatch), {.proceed_all = true});
  bool together = false;
  watch_leg(fleet, [&] { together = together || (moves(fleet, 3) && moves(fleet, 4)); });
  EXPECT_FALSE(together) << "3 is in the first half, 4 in the second";
  EXPECT_EQ(fleet.state().step, 2U);
}

TEST(BoundingOverwatch, TakesTurnsAmongThreeParts) {
  MissionMaker m;
  const auto unit = m.unit("unit", {m.unit("a", 1), m.unit("b", 1), m.unit("c", 1)});
  ToyFleet fleet(leg(m, unit, Technique::kBoundingOverwatch), {.proceed_all = true});
  watch_leg(fleet, [&] { EXPECT_LE(moves(fleet, 1) + moves(fleet, 2) + moves(fleet, 3), 1); });
  EXPECT_EQ(fleet.state().step, 2U);
}

TEST(BoundingOverwatch, WaitsForARollingPartToComeToRest) {
  ToyFleet fleet(two_teams(Technique::kBoundingOverwatch), {.proceed_all = true});
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run_until([&] { return fleet.state().step == 1; }));
  const auto report = [&](double x) {
    event::Cycle cycle{.time = fleet.state().time + 0.1, .robots = {}};
    for (const auto& [id, body] : fleet.robots()) {
      cycle.robots.push_back(body.report);
      cycle.robots.back().pose.position.x += x;
    }
    fleet.send(cycle);
  };
  for (int i = 1; i <= 10; ++i) report(i * 0.1);  // everybody still rolls at 1 m/s
  EXPECT_TRUE(fleet.robot(1).order.order.halted);
  report(1.0);  // at rest
  EXPECT_FALSE(fleet.robot(1).order.order.halted);
  EXPECT_TRUE(fleet.robot(3).order.order.halted);
}

TEST(BoundingOverwatch, NamesTheHaltedPartWhenTheOtherIsStuck) {
  ToyFleet fleet(two_teams(Technique::kBoundingOverwatch), {.patience = 50.0});
  fleet.robot(1).is_stuck = fleet.robot(2).is_stuck = true;
  fleet.send(event::Execute{});
  fleet.run(200.0);
  EXPECT_EQ(fleet.state().outcome, Outcome::kFailed);
  EXPECT_TRUE(fleet.has_told("m to go: no progress; robot 2")) << fleet.transcript();
  EXPECT_TRUE(fleet.has_told("m to go: halted while another part of the unit moves; robot 4"))
      << fleet.transcript();
}

TEST(BoundingOverwatch, GoesOnWithoutWhoIsLost) {
  for (const std::vector<std::uint32_t>& lost : {std::vector{2U}, std::vector{1U, 2U}, std::vector{3U, 4U}}) {
    ToyFleet fleet(two_teams(Technique::kBoundingOverwatch), {.patience = 600.0});
    fleet.send(event::Execute{});
    fleet.run(40.0);
    for (const std::uint32_t id : lost) fleet.robot(id).report.is_running = false;
    fleet.run(500.0);
    EXPECT_TRUE(fleet.state().in_step) << fleet.transcript();  // it waits for who is lost
    for (const RobotState& robot : fleet.state().robots)
      EXPECT_EQ(robot.done, robot.is_running) << robot.id.value;
  }
}

TEST(TravelingOverwatch, LeadsWithOnePartAndLetsTheOtherFollowAtADistance) {
  ToyFleet fleet(two_teams(Technique::kTravelingOverwatch), {.proceed_all = true});
  double closest = 1e9;
  double farthest = 0.0;
  int lead_halts = 0;
  int trail_halts = 0;
  double lead_arrived = 0.0;
  watch_leg(fleet, [&] {
    const double lead = geom::distance(fleet.centre({{1}, {2}}), {650, 250});
    const double gap = geom::distance(fleet.centre({{3}, {4}}), {650, 250}) - lead;
    if (fleet.robot(1).report.done) {
      if (lead_arrived == 0.0) lead_arrived = fleet.time();
      return;
    }
    if (moves(fleet, 3)) closest = std::min(closest, gap);
    farthest = std::max(farthest, gap);
    lead_halts += moves(fleet, 1) ? 0 : 1;
    trail_halts += moves(fleet, 3) ? 0 : 1;
  });
  EXPECT_LE(lead_halts, 2) << "the leading part moves all the time";
  EXPECT_GT(trail_halts, 50) << "the trailing part lets it get ahead first";
  EXPECT_GT(closest, 45.0);
  EXPECT_LT(farthest, 60.0);
  EXPECT_GT(lead_arrived, 0.0);
  EXPECT_EQ(fleet.state().step, 2U);
  EXPECT_LE(geom::distance(fleet.centre({{1}, {2}, {3}, {4}}), {650, 250}), 2.0);
}

TEST(TravelingOverwatch, HaltsTheTrailingPartWhenTheLeadingOneIsHeldUp) {
  ToyFleet fleet(two_teams(Technique::kTravelingOverwatch), {.proceed_all = true});
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run_until([&] { return fleet.position(1).x > 300.0; }));
  fleet.robot(1).is_stuck = fleet.robot(2).is_stuck = true;
  fleet.run_cycles(300);
  EXPECT_TRUE(fleet.robot(3).order.order.halted);
  EXPECT_LT(fleet.position(3).x, 275.0);
  fleet.robot(1).is_stuck = fleet.robot(2).is_stuck = false;
  ASSERT_TRUE(fleet.run());
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
}

TEST(TravelingOverwatch, HoldsAllPartsAtAPhaseLine) {
  MissionMaker m;
  const auto unit = m.unit("unit", {m.unit("first", 1), m.unit("second", 1)});
  UnitCommand move = move_to(unit, "A", {650, 210});
  move.technique = Technique::kTravelingOverwatch;
  PhaseLine& line = move.phase_lines.emplace_back();
  line.points = {{300, 0}, {300, 500}};
  line.waits = true;
  m.step({start(unit, {50, 200}, {0, 20})}).step({move});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run_until([&] { return !fleet.questions().empty(); }));
  EXPECT_TRUE(fleet.robot(1).order.order.halted);
  EXPECT_TRUE(fleet.robot(2).order.order.halted);
  fleet.answer(1);
  ASSERT_TRUE(fleet.run());
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
}

TEST(Technique, AppliesToARouteToo) {
  for (const Technique technique : {Technique::kBoundingOverwatch, Technique::kTravelingOverwatch}) {
    MissionMaker m;
    const auto unit = m.unit("unit", 4);
    UnitCommand follow = command(unit, Task::kFollow, "AXIS-Blue");
    follow.route = {{100, 200}, {400, 200}, {400, 500}};
    follow.technique = technique;
    m.step({start(unit, {50, 180}, {0, 10})}).step({follow});
    ToyFleet fleet(m.make(), {.proceed_all = true});
    bool both = false;
    bool cut_corner = false;
    watch_leg(fleet, [&] {
      both = both || (moves(fleet, 1) && moves(fleet, 3));
      cut_corner = cut_corner || (fleet.position(1).x < 330.0 && fleet.position(1).y > 280.0);
    });
    EXPECT_EQ(both, technique == Technique::kTravelingOverwatch);
    EXPECT_FALSE(cut_corner);
    EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
    EXPECT_LE(geom::distance(fleet.centre({{1}, {2}, {3}, {4}}), {400, 500}), 5.0);
    EXPECT_GE(geom::distance(fleet.centre({{1}, {2}}), fleet.centre({{3}, {4}})), 40.0);
  }
}

TEST(Technique, OfAUnitOfOneRobotIsTraveling) {
  MissionMaker m;
  const auto unit = m.unit("unit", 1);
  ToyFleet fleet(leg(m, unit, Technique::kBoundingOverwatch), {.proceed_all = true});
  bool halted = false;
  watch_leg(fleet, [&] { halted = halted || fleet.robot(1).order.order.halted; });
  EXPECT_FALSE(halted);
  EXPECT_EQ(fleet.state().step, 2U);
}

TEST(Technique, MovesAllTogetherWhenTheUnitTravels) {
  ToyFleet fleet(two_teams(Technique::kTraveling), {.proceed_all = true});
  watch_leg(fleet, [&] { EXPECT_EQ(moves(fleet, 1), moves(fleet, 3)); });
  EXPECT_EQ(fleet.state().step, 2U);
}

TEST(BoundingOverwatch, GoesInFileWhereAnObstacleOrAWallLeavesNoRoomToPass) {
  for (const bool wall : {false, true}) {
    MissionMaker m;
    const auto unit = m.unit("unit", 4);
    if (wall) {
      overlay::ControlMeasure measure;
      measure.kind = overlay::MeasureKind::kWall;
      measure.points = {{600, 255}, {700, 255}};
      m.mission().overlay.measures.push_back(measure);
    } else {
      m.mission().overlay.obstacles.push_back(
          {.center = {650, 275}, .radius = 5.0, .height = 0.0, .place = {}});
    }
    ToyFleet fleet(leg(m, unit, Technique::kBoundingOverwatch), {.proceed_all = true});
    std::vector<int> movers;
    watch_leg(fleet, [&] {
      EXPECT_FALSE(moves(fleet, 1) && moves(fleet, 3));
      if (fleet.time() > 60.0) {
        EXPECT_GT(fleet.position(1).x, fleet.position(3).x);
      }
      const int mover = moves(fleet, 1) ? 1 : moves(fleet, 3) ? 2 : 0;
      if (mover != 0 && (movers.empty() || movers.back() != mover)) movers.push_back(mover);
    });
    EXPECT_EQ(fleet.state().step, 2U);
    EXPECT_EQ(movers, (std::vector<int>{1, 2, 1, 2, 1, 2, 1, 2}));
    EXPECT_NEAR(fleet.centre({{1}, {2}}).x - fleet.centre({{3}, {4}}).x, 50.0, 3.0);
  }
}

TEST(BoundingOverwatch, FollowsARouteInLanes) {
  MissionMaker m;
  const auto unit = m.unit("unit", {m.unit("left", 1), m.unit("right", 1)});
  UnitCommand follow = command(unit, Task::kFollow, "AXIS-Blue");
  follow.route = {{100, 300}, {400, 300}, {400, 600}};
  follow.technique = Technique::kBoundingOverwatch;
  m.step({start(unit, {100, 325}, {0, -50})}).step({follow});
  ToyFleet fleet(m.make(), {.proceed_all = true});
  double nearest = 1e9;
  watch_leg(fleet,
            [&] { nearest = std::min(nearest, geom::distance(fleet.position(1), fleet.position(2))); });
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
  EXPECT_GT(nearest, 45.0) << "they pass each other at the distance of their lanes";
  EXPECT_NEAR(fleet.position(1).x, 375.0, 2.0);
  EXPECT_NEAR(fleet.position(2).x, 425.0, 2.0);
}

TEST(Technique, TakesTheSpacingOfTheRobotType) {
  MissionMaker m;
  const auto unit = m.unit("unit", 2);
  m.mission().types[0].parameters.push_back(
      {.key = "formation_spacing", .value = "20", .place = {}, .value_place = {}});
  ToyFleet fleet(leg(m, unit, Technique::kBoundingOverwatch), {.proceed_all = true});
  watch_leg(fleet, [] {});
  EXPECT_NEAR(geom::distance(fleet.position(1), fleet.position(2)), 20.0, 3.0);
}

}  // namespace
}  // namespace mlab::mission
