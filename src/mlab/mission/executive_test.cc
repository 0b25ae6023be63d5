#include "mlab/mission/executive.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mlab/mission/testing/toy_fleet.h"

namespace mlab::mission {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the test's own vocabulary
using percept::Formation;
// All orders that were given, without those that only repeat a sequence.
std::vector<effect::Order> new_orders(const ToyFleet& fleet) {
  std::vector<effect::Order> orders;
  for (const Effect& effect : fleet.all_effects()) {
    const auto* order = std::get_if<effect::Order>(&effect);
    const auto same = [&](const effect::Order& o) { return o.order.sequence == order->order.sequence; };
    if (order != nullptr && std::ranges::none_of(orders, same)) orders.push_back(*order);
  }
  return orders;
}

TEST(Executive, CarriesOutAMissionStepByStep) {
  MissionMaker m;
  const auto first = m.unit("scouts-1", 1);
  const auto second = m.unit("scouts-2", 1);
  const auto scouts = m.unit("scouts", {first, second});
  m.step({start(scouts, {100, 100})});
  m.step({move_to(scouts, "ATK-AP1", {200, 110})});
  m.step({move_to(first, "ATK-BP1", {300, 150}), move_to(second, "ATK-BP2", {220, 60})});
  m.step({stop(scouts)});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run());
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
  EXPECT_EQ(fleet.transcript(), R"(step 0
step 0: unit scouts START StartPlace
step 0: unit scouts START StartPlace done
step 0 done
step 1
step 1: unit scouts MOVETO ATK-AP1
step 1: unit scouts MOVETO ATK-AP1 done
step 1 done
step 2
step 2: unit scouts-1 MOVETO ATK-BP1
step 2: unit scouts-2 MOVETO ATK-BP2
step 2: unit scouts-2 MOVETO ATK-BP2 done
step 2: unit scouts-1 MOVETO ATK-BP1 done
step 2 done
step 3
step 3: unit scouts STOP
step 3: unit scouts STOP done
step 3 done
mission done
)");
  EXPECT_LE(geom::distance(fleet.position(1), {300, 150}), ToyFleet::kSuccess);
  EXPECT_FALSE(fleet.robot(1).report.is_running);
}

TEST(Executive, StartsRobotsOneStepApartWithTheHeadingOfTheOverlay) {
  MissionMaker m;
  const auto unit = m.unit("u", 3);
  m.mission().overlay.heading = 1.5;
  m.step({start(unit, {610, 120}, {5, 20})});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  EXPECT_EQ(fleet.robot(1).report.pose, (geom::Pose{{610, 120}, 1.5}));
  EXPECT_EQ(fleet.robot(3).report.pose, (geom::Pose{{620, 160}, 1.5}));
  EXPECT_EQ(fleet.state().outcome, Outcome::kRunning) << "they have not reported yet";
  fleet.cycle();
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
}

TEST(Executive, WarnsOfAStartOfRobotsThatRunAndLeavesThemWhereTheyAre) {
  MissionMaker m;
  const auto unit = m.unit("u", 2);
  m.step({start(unit, {10, 10})}).step({start(unit, {500, 500})});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run());
  EXPECT_TRUE(fleet.has_told("step 1: robots 1 and 2 run already and can't be started again"));
  EXPECT_EQ(fleet.position(1), (geom::Point{10, 10}));
}

TEST(Executive, StartsStoppedRobotsAgain) {
  MissionMaker m;
  const auto unit = m.unit("u", 1);
  m.step({start(unit, {10, 10})}).step({stop(unit)}).step({start(unit, {50, 50})});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run());
  EXPECT_EQ(fleet.position(1), (geom::Point{50, 50}));
}

UnitCommand rally(std::uint32_t unit, geom::Point goal, double radius) {
  UnitCommand c = command(unit, Task::kRally, "Camp", goal);
  c.radius = radius;
  return c;
}

TEST(Rally, SendsEachRobotByItselfToThePlace) {
  MissionMaker m;
  const auto unit = m.unit("u", 3);
  m.step({start(unit)}).step({rally(unit, {100, 0}, 5.0)});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run());
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
  EXPECT_TRUE(fleet.has_told("unit u RALLY Camp"));
  for (std::uint32_t id = 1; id <= 3; ++id) {
    EXPECT_LE(geom::distance(fleet.position(id), {100, 0}), 5.0) << "as a unit they would stay 20 m apart";
    EXPECT_EQ(fleet.robot(id).order.members.size(), 1U);
    EXPECT_EQ(fleet.robot(id).order.order.task, percept::Task::kMoveTo);
    EXPECT_EQ(fleet.robot(id).order.order.formation, percept::Formation::kNone);
  }
}

TEST(Rally, IsDoneWhenAllAreWithinTheRadiusAndNotBefore) {
  MissionMaker m;
  const auto unit = m.unit("u", 2);
  m.step({start(unit)}).step({rally(unit, {100, 0}, 30.0)});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  fleet.run_cycles(5);
  fleet.robot(2).is_stuck = true;
  EXPECT_FALSE(fleet.run(60.0)) << "robot 2 is not there";
  EXPECT_LE(geom::distance(fleet.position(1), {100, 0}), 30.0);
  fleet.robot(1).report.pose.position = {300, 0};
  fleet.robot(1).is_stuck = true;
  fleet.robot(2).is_stuck = false;
  EXPECT_FALSE(fleet.run(60.0)) << "robot 1 has left again";
  fleet.robot(1).is_stuck = false;
  EXPECT_TRUE(fleet.run(120.0));
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
}

TEST(Rally, OfOneRobotAndOfRobotsByTheirNumbersIsTheSame) {
  MissionMaker m;
  const auto unit = m.unit("u", 3);
  const auto single = m.unit("single", 1);
  UnitCommand of_two = rally(kNoUnit, {0, 90}, 5.0);
  of_two.robots = {{3}, {1}};
  m.step({start(unit), start(single, {50, 60})}).step({of_two, rally(single, {50, 0}, 2.0)});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run());
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
  for (const std::uint32_t id : {1U, 3U}) EXPECT_LE(geom::distance(fleet.position(id), {0, 90}), 5.0);
  EXPECT_LE(geom::distance(fleet.position(4), {50, 0}), 2.0);
  EXPECT_EQ(fleet.position(2), (geom::Point{0, 20})) << "it was not asked";
}

TEST(Rally, LeavesAFormationAndTakesItUpAgain) {
  MissionMaker m;
  const auto unit = m.unit("u", 3);
  UnitCommand wedge = move_to(unit, "A", {50, 0});
  wedge.formation = percept::Formation::kWedge;
  UnitCommand back = wedge;
  back.goal = {0, 0};
  m.step({start(unit)}).step({wedge}).step({rally(unit, {100, 0}, 10.0)}).step({back});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run_until([&] { return fleet.state().step == 2; }));
  EXPECT_EQ(fleet.state().groups.size(), 3U);
  ASSERT_TRUE(fleet.run());
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
  ASSERT_EQ(fleet.state().groups.size(), 1U) << "one unit again";
  EXPECT_EQ(fleet.robot(3).order.members.size(), 3U);
  EXPECT_EQ(fleet.robot(3).order.order.formation, percept::Formation::kWedge);
}

TEST(Rally, WaitsForARobotThatIsLostOnTheWayAndCountsOneThatWasThere) {
  MissionMaker m;
  const auto unit = m.unit("u", 2);
  m.step({start(unit)}).step({rally(unit, {100, 0}, 30.0)});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  fleet.run_cycles(5);
  fleet.robot(2).reports = false;
  fleet.robot(2).is_stuck = true;
  EXPECT_FALSE(fleet.run(60.0));
  EXPECT_TRUE(fleet.has_told("robot 2 is not running, but `unit u RALLY Camp` waits for it"))
      << fleet.transcript();
  fleet.robot(1).reports = false;
  fleet.robot(2).reports = true;
  fleet.robot(2).is_stuck = false;
  EXPECT_TRUE(fleet.run(60.0)) << "robot 1 was there when it was last seen";
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
}

TEST(Rally, EndsAtATimeWhoeverIsThere) {
  MissionMaker m;
  const auto unit = m.unit("u", 2);
  UnitCommand until = rally(unit, {1000, 0}, 5.0);
  until.until = MissionTime{MissionTime::Kind::kSinceReached, 20.0};
  m.step({start(unit)}).step({until});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run(30.0));
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
  for (std::uint32_t id = 1; id <= 2; ++id) EXPECT_TRUE(fleet.robot(id).order.order.halted);
}

TEST(Visit, IsLedBySomebodyWhoRuns) {
  MissionMaker m;
  const auto unit = m.unit("u", 3);
  UnitCommand until = rally(unit, {1000, 0}, 5.0);
  until.until = MissionTime{MissionTime::Kind::kSinceReached, 20.0};
  UnitCommand visit = command(unit, Task::kVisit, "Camp", {50, 0});
  visit.route = {{50, 0}, {80, 0}};
  m.step({start(unit)}).step({until}).step({visit});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run_until([&] { return fleet.time() > 10.0; }));
  fleet.robot(1).report.is_running = false;
  const auto visits = [&](std::uint32_t id) {
    return fleet.robot(id).order.order.task == percept::Task::kVisit;
  };
  ASSERT_TRUE(fleet.run_until([&] { return visits(2); }, 60.0)) << fleet.transcript();
  ASSERT_EQ(fleet.robot(2).order.members.size(), 3U) << "who is lost may come back";
  EXPECT_EQ(fleet.robot(2).order.members.front().value, 2U);
  EXPECT_EQ(fleet.robot(2).order.members.back().value, 1U);
}

/// A RALLY whose robots stop 12 m before the place and say that they are there.
std::unique_ptr<ToyFleet> rally_beside(bool is_taken, double width = 1000.0) {
  MissionMaker m;
  m.mission().overlay.area = overlay::Area{width, 1000.0};
  const auto unit = m.unit("u", 2);
  if (is_taken) m.mission().overlay.obstacles.push_back({{100, 0}, 9.0, 0.0, {}});
  m.step({start(unit)}).step({rally(unit, {100, 0}, 3.0)});
  auto fleet = std::make_unique<ToyFleet>(m.make());
  fleet->send(event::Execute{});
  fleet->run_cycles(5);
  for (const std::uint32_t id : {1U, 2U}) {
    fleet->robot(id).report.pose.position = {88, id == 1 ? -2.0 : 2.0};
    fleet->robot(id).is_stuck = fleet->robot(id).report.done = true;
  }
  return fleet;
}

TEST(Rally, IsDoneBesideWhatStandsAtThePlace) {
  const auto fleet = rally_beside(true);
  ASSERT_TRUE(fleet->run(20.0));
  EXPECT_EQ(fleet->state().outcome, Outcome::kDone) << fleet->transcript();
  EXPECT_TRUE(fleet->has_told("unit u RALLY Camp: something stands at the place")) << fleet->transcript();
}

TEST(Rally, IsDoneBesideAPlaceOutsideOfTheArea) {
  const auto fleet = rally_beside(false, 90.0);
  ASSERT_TRUE(fleet->run(20.0));
  EXPECT_EQ(fleet->state().outcome, Outcome::kDone) << fleet->transcript();
  EXPECT_TRUE(fleet->has_told("unit u RALLY Camp: the mission area ends before the place"))
      << fleet->transcript();
}

TEST(Rally, WaitsBesideAPlaceWhereNothingStands) {
  const auto fleet = rally_beside(false);
  EXPECT_FALSE(fleet->run(60.0)) << fleet->transcript();
}

TEST(Rally, WaitsForOneThatHasLeftAPlaceWhereSomethingStands) {
  const auto fleet = rally_beside(true);
  fleet->run_cycles(5);
  fleet->robot(2).report.pose.position = {60, 0};
  EXPECT_FALSE(fleet->run(60.0)) << fleet->transcript();
  fleet->robot(2).report.pose.position = {88, 2};
  EXPECT_TRUE(fleet->run(20.0)) << fleet->transcript();
}

TEST(Rally, FailsWithThoseThatAreNotThereWhenNobodyComesNearer) {
  MissionMaker m;
  const auto unit = m.unit("u", 2);
  m.step({start(unit)}).step({rally(unit, {100, 0}, 5.0)});
  ExecutiveOptions options;
  options.patience = 30.0;
  ToyFleet fleet(m.make(), options);
  fleet.send(event::Execute{});
  fleet.run_cycles(5);
  fleet.robot(2).is_stuck = true;
  ASSERT_TRUE(fleet.run(600.0));
  EXPECT_EQ(fleet.state().outcome, Outcome::kFailed);
  EXPECT_TRUE(fleet.has_told("robot 2 at")) << fleet.transcript();
}

TEST(Executive, DoesSetAndPrintAtOnceAndGoesOn) {
  MissionMaker m;
  m.step({SetBoolean{BooleanOption::kShowTrails, true}, Print{true}})
      .step({SetNumber{NumberOption::kCycleDuration, 0.5}});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
  EXPECT_EQ(fleet.count<effect::Set>(), 2);
  EXPECT_EQ(fleet.count<effect::Print>(), 1);
  EXPECT_TRUE(fleet.has_told("step 0: SET SHOW-TRAILS ON"));
  EXPECT_TRUE(fleet.has_told("step 1: SET CYCLE-DURATION 0.5 done"));
}

TEST(Executive, QuitsAndDoesNothingAfterwards) {
  MissionMaker m;
  const auto unit = m.unit("u", 1);
  m.step({start(unit), Quit{}, Print{}}).step({stop(unit)});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  EXPECT_EQ(fleet.count<effect::Quit>(), 1);
  EXPECT_EQ(fleet.count<effect::Print>(), 0);
  EXPECT_EQ(fleet.state().mode, State::Mode::kQuit);
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
  const State before = fleet.state();
  fleet.send(event::Execute{});
  fleet.cycle();
  EXPECT_EQ(fleet.state(), before);
  EXPECT_TRUE(fleet.last_effects().empty());
}

TEST(Executive, RewindsAfterTheLastStepAndLeavesTheRobotsTheirLastCommand) {
  MissionMaker m;
  const auto unit = m.unit("u", 2);
  m.step({start(unit)}).step({move_to(unit, "A", {50, 0})});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run());
  EXPECT_EQ(fleet.state().step, 0U);
  ASSERT_EQ(standing_orders(fleet.state()).size(), 1U);
  EXPECT_EQ(standing_orders(fleet.state())[0].order.goal, (geom::Point{50, 0}));
  EXPECT_EQ(fleet.count<effect::Stop>(), 0);
}

TEST(Executive, OrdersSayWhatTheCommandSays) {
  MissionMaker m;
  const auto unit = m.unit("u", 2);
  UnitCommand move = move_to(unit, "A", {50, 0});
  move.formation = Formation::kWedge;
  move.has_formation = true;
  move.speed = 3.0;
  move.heading = 0.5;
  m.step({start(unit)}).step({move});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run());
  const auto orders = new_orders(fleet);
  ASSERT_EQ(orders.size(), 1U);
  EXPECT_EQ(orders[0].members, (std::vector<base::RobotId>{{1}, {2}}));
  EXPECT_EQ(orders[0].order.task, percept::Task::kMoveTo);
  EXPECT_EQ(orders[0].order.formation, Formation::kWedge);
  EXPECT_EQ(orders[0].order.speed, 3.0);
  EXPECT_TRUE(orders[0].order.has_heading);
  EXPECT_EQ(orders[0].order.heading, 0.5);
  EXPECT_FALSE(orders[0].order.halted);
  EXPECT_TRUE(fleet.has_told("step 1: unit u MOVETO A (Wedge)"));
}

TEST(Executive, FollowsARouteToItsEnd) {
  MissionMaker m;
  const auto unit = m.unit("u", 2);
  UnitCommand follow = command(unit, Task::kFollow, "AXIS-Blue", {1, 1});
  follow.route = {{20, 0}, {20, 50}, {80, 50}};
  m.step({start(unit, {}, {})}).step({follow});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  bool was_at_corner = false;
  while (fleet.state().mode == State::Mode::kRunning && fleet.time() < 100) {
    fleet.cycle();
    was_at_corner = was_at_corner || geom::distance(fleet.position(1), {20, 50}) < 2.0;
  }
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
  EXPECT_TRUE(was_at_corner);
  EXPECT_EQ(new_orders(fleet).at(0).order.goal, (geom::Point{80, 50}));
  EXPECT_LE(geom::distance(fleet.position(1), {80, 50}), 2.0);
}

TEST(Executive, SweepsInASweepUnlessAClauseSaysOtherwise) {
  MissionMaker m;
  const auto unit = m.unit("u", 2);
  UnitCommand in_line = command(unit, Task::kSweepTo, "B", {90, 0});
  in_line.formation = Formation::kLine;
  in_line.has_formation = true;
  m.step({start(unit)}).step({command(unit, Task::kSweepTo, "A", {50, 0})}).step({in_line});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run());
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
  const auto orders = new_orders(fleet);
  ASSERT_EQ(orders.size(), 2U);
  EXPECT_EQ(orders[0].order.formation, Formation::kSweep);
  EXPECT_EQ(orders[1].order.formation, Formation::kLine);
}

TEST(Executive, TellsTheCompletionMessage) {
  MissionMaker m;
  const auto unit = m.unit("u", 1);
  UnitCommand move = move_to(unit, "A", {50, 0});
  move.on_completion = "in place";
  m.step({start(unit)}).step({move});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run());
  EXPECT_TRUE(fleet.has_told("u: in place\n"));
}

TEST(Executive, LatchesDoneForEachRobotAndOrder) {
  MissionMaker m;
  const auto unit = m.unit("u", 2);
  m.step({start(unit)}).step({move_to(unit, "A", {50, 0})});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  fleet.cycle();
  const auto report = [&](std::uint32_t sequence, bool first, bool second) {
    event::Cycle cycle{.time = fleet.time() + 1.0, .robots = {}};
    for (const auto& [id, body] : fleet.robots()) {
      RobotReport r = body.report;
      r.sequence = sequence;
      r.done = id == 1 ? first : second;
      r.remaining = 5.0;
      cycle.robots.push_back(r);
    }
    fleet.send(cycle);
  };
  const std::uint32_t sequence = fleet.state().last_sequence;
  report(sequence - 1, true, true);  // done with something else
  report(sequence, true, false);
  report(sequence, false, false);  // drifts away, and back
  EXPECT_EQ(fleet.state().outcome, Outcome::kRunning);
  report(sequence, false, true);
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
}

TEST(Executive, TellsTheRobotsThatAreLeftWhoTheirMatesAre) {
  MissionMaker m;
  const auto first = m.unit("a", 2);
  const auto second = m.unit("b", 2);
  const auto both = m.unit("ab", {first, second});
  m.step({start(both)}).step({move_to(both, "A", {50, 0})}).step({move_to(first, "B", {200, 0})});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run());
  ASSERT_EQ(fleet.state().outcome, Outcome::kDone);
  const auto& order = fleet.robot(3).order;
  EXPECT_EQ(order.order.goal, (geom::Point{50, 0})) << "its last command stands";
  EXPECT_EQ(order.members, (std::vector<base::RobotId>{{3}, {4}}));
  EXPECT_EQ(standing_orders(fleet.state()).size(), 2U);
}

TEST(Executive, KeepsAHistoryOfStepsAndCommands) {
  MissionMaker m;
  const auto unit = m.unit("u", 1);
  UnitCommand place = occupy(unit, "AA-AA1", {50, 0});
  place.formation = Formation::kColumn;
  m.step("1", {start(unit)}).step("2a", {place, SetBoolean{}});
  ToyFleet fleet(m.make(), {.proceed_all = true});
  fleet.send(event::Execute{});
  ASSERT_TRUE(fleet.run());
  const State& s = fleet.state();
  ASSERT_EQ(s.steps.size(), 2U);
  EXPECT_EQ(s.steps[1].label, "2a");
  EXPECT_EQ(s.steps[1].outcome, Outcome::kDone);
  EXPECT_EQ(s.steps[1].first_command, 1U);
  EXPECT_EQ(s.steps[1].command_count, 2U);
  EXPECT_NEAR(s.steps[1].end - s.steps[1].start, 9.8, 0.3);
  ASSERT_EQ(s.commands.size(), 3U);
  EXPECT_EQ(s.commands[1].text, "unit u OCCUPY AA-AA1 (Column)");
  EXPECT_EQ(s.commands[1].unit, "u");
  EXPECT_EQ(s.commands[1].task, "OCCUPY");
  EXPECT_EQ(s.commands[1].place, "AA-AA1");
  EXPECT_EQ(s.commands[1].formation, "Column");
  EXPECT_EQ(s.commands[1].outcome, Outcome::kDone);
  EXPECT_EQ(s.commands[1].end, s.steps[1].end);
  EXPECT_EQ(s.commands[2].task, "SET");
  EXPECT_EQ(s.commands[2].end, s.steps[1].start);
}

TEST(Executive, EndsAMissionWithoutStepsAtOnce) {
  ToyFleet fleet(MissionMaker().make());
  fleet.send(event::Execute{});
  EXPECT_EQ(fleet.state().outcome, Outcome::kDone);
  EXPECT_TRUE(fleet.has_told("mission done"));
}

TEST(Executive, NamesAnUnnamedUnitByItsRobots) {
  MissionMaker m;
  const auto unit = m.unit("", 2);
  m.step({start(unit)});
  ToyFleet fleet(m.make());
  fleet.send(event::Execute{});
  EXPECT_TRUE(fleet.has_told("step 0: unit of robots 1 and 2 START StartPlace"));
}

}  // namespace
}  // namespace mlab::mission
