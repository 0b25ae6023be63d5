// Each assemblage does what it says, in a small world.

#include <cstdint>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "mlab/library/library.h"

#include "../testing/library_probe.h"
#include "../testing/trial.h"

namespace mlab::library_test {
namespace {

using geom::Point;
using percept::ObjectClass;
using percept::ObjectStyle;
sim::World with(std::vector<sim::Disc> discs, std::vector<sim::Object> objects = {}) {
  sim::World world;
  world.discs = std::move(discs);
  world.objects = std::move(objects);
  return world;
}
sim::Object object(std::uint32_t id, ObjectClass object_class, ObjectStyle style, Point center) {
  return {{id}, object_class, style, center, 0.2, {}, {}};
}
sim::Object mine(std::uint32_t id, Point center) {
  return object(id, ObjectClass::kMine, ObjectStyle::kMovable, center);
}
sim::Object basket(std::uint32_t id, Point center) {
  return object(id, ObjectClass::kBasket, ObjectStyle::kContainer, center);
}
// A room of 10 m by 10 m with a door in its south wall, and a hallway below.
sim::World building() {
  sim::World world;
  const auto wall = [&](Point a, Point b) { world.walls.push_back({{a, b}, 0}); };
  wall({0, 0}, {4, 0});
  wall({6, 0}, {10, 0});
  wall({10, 0}, {10, 10});
  wall({10, 10}, {0, 10});
  wall({0, 10}, {0, 0});
  wall({-10, -4}, {30, -4});
  world.building.doors.push_back({{4, 0}, {6, 0}});
  world.building.rooms.push_back({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  world.building.hallways.push_back({{-10, -2}, {30, -2}, 4});
  return world;
}

TEST(Configurations, OfTheLibraryAreFreeOfMistakes) {
  for (const library::ConfigurationText& one : library::configuration_texts()) {
    text::Diagnostics sink;
    const auto source = std::make_shared<const text::Source>(std::string(one.file), std::string(one.text));
    robot::check_configuration(source, {}, sink);
    EXPECT_TRUE(sink.items().empty()) << text::render(sink);
  }
}

TEST(Configurations, OfTheLibraryExplainAllTheirAssemblages) {
  for (const auto& [name, assemblage] : robot::library_configuration().assemblages)
    EXPECT_FALSE(assemblage->help.empty()) << name;
}

TEST(Wander, CoversGroundAndTouchesNothing) {
  std::vector<sim::Disc> discs;
  for (const double y : {-6.0, 0.0, 6.0}) {
    for (const double x : {-9.0, -3.0, 3.0, 9.0}) discs.push_back({{x, y}, 0.5});
  }
  Trial trial("Wander()", with(discs), {{-6, 0}, 0});
  std::set<std::pair<int, int>> cells;
  trial.run(200, [&] {
    cells.insert({static_cast<int>(trial.place().x / 4), static_cast<int>(trial.place().y / 4)});
    return false;
  });
  EXPECT_GT(cells.size(), 5U);
  EXPECT_EQ(trial.simulator().contacts(trial.body()), 0U);
}

TEST(FollowSignalAdvice, ComesBackIntoReachByEachMethod) {
  for (int method = 0; method <= 4; ++method) {
    SCOPED_TRACE(method);
    // 50 % of its radio's 30 m are heard within 5.5 m.
    Trial trial(fmt::format("FollowSignalAdvice(method = {})", method), with({{{8, 1}, 0.5}}), {{15, 0}, 0},
                "Scout", {.range = 30.0});
    trial.add({0, 0}, 0, 0);
    const bool is_back = trial.run(60, [&] { return trial.distance_to({0, 0}) < 6; });
    EXPECT_EQ(is_back, method != 2) << "the plan is to meet where it began, and there it is";
    trial.run(5);
    if (is_back) {
      EXPECT_GT(trial.distance_to({0, 0}), 3) << "near enough is near enough";
    }
    EXPECT_EQ(trial.simulator().contacts(trial.body()), 0U);
  }
}

TEST(TravelToLocation, ArrivesAroundAnObstacle) {
  Trial trial("TravelToLocation(goal = [20 m, 0 m])", with({{{10, 0.2}, 1.0}}), {{0, 0}, 0});
  EXPECT_TRUE(trial.run(60, [&] { return trial.distance_to({20, 0}) < 1.2; }));
  EXPECT_EQ(trial.simulator().contacts(trial.body()), 0U);
}

TEST(OccupyLocation, ComesBackWhereItWasPushedAway) {
  Trial trial("OccupyLocation(goal = [5 m, 0 m])", {}, {{0, 0}, 0});
  EXPECT_TRUE(trial.run(60, [&] { return trial.distance_to({5, 0}) < 1.0; }));
  trial.add({5, -3}, kNorth, 0.5);
  EXPECT_TRUE(trial.run(20, [&] { return trial.distance_to({5, 0}) > 1.2; })) << "makes room";
  EXPECT_TRUE(trial.run(60, [&] { return trial.distance_to({5, 0}) < 1.0; })) << "returns";
}

TEST(Teleoperation, GoesWhereTheStickPointsAndNotIntoObstacles) {
  Trial trial("Teleoperation()", with({{{10, 0}, 1.0}}), {{0, 0}, 0});
  trial.run(5);
  EXPECT_LT(trial.distance_to({0, 0}), 0.1);
  trial.percepts().joystick = {.x = 1.0, .y = 0.0, .magnitude = 1.0};
  trial.run(30);
  EXPECT_GT(trial.place().x, 6.0);
  EXPECT_LT(trial.place().x, 8.8);
  EXPECT_EQ(trial.simulator().contacts(trial.body()), 0U);
}

sim::World with_a_mine(geom::Point place) {
  sim::World world;
  world.objects.push_back({{1}, ObjectClass::kMine, percept::ObjectStyle::kMovable, place, 0.2, {}, {}});
  return world;
}

TEST(RunEODTask, PicksUpTheMine) {
  Trial trial("RunEODTask()", with_a_mine({40, 0}), {{0, 0}, 0});
  EXPECT_TRUE(trial.run(90, [&] { return trial.has_heard("EODTask completed."); }));
  EXPECT_EQ(trial.percepts().carried.value, 1U);
  EXPECT_GT(trial.place().x, 15.0) << "from near";
}

TEST(RunEODTask, IsDoneAtOnceWithoutAMine) {
  Trial trial("RunEODTask()", {}, {{0, 0}, 0});
  EXPECT_TRUE(trial.run(2, [&] { return trial.has_heard("EODTask completed."); }));
}

TEST(RunInspectTask, GoesToTheEnemyAndTellsTheOperatorWhatItFound) {
  Trial trial("RunInspectTask()", {}, {{0, 0}, 0});
  trial.add({25, 0}, 0, 0.0, ObjectClass::kEnemyRobot);
  EXPECT_TRUE(trial.run(90, [&] { return trial.has_heard("InspectTask completed."); }));
  EXPECT_TRUE(trial.has_heard("Enemy put down weapons."));
  EXPECT_EQ(trial.alert().substr(0, 24), "Warning: No weapon found");
  EXPECT_LT(trial.distance_to({25, 0}), 8.0);
}

TEST(RunTrackTask, FollowsTheEnemyAndGivesUpWhereThereIsNone) {
  Trial trial("RunTrackTask()", {}, {{0, 0}, 0});
  const sim::BodyIndex enemy = trial.add({30, 0}, 0, 0.3, ObjectClass::kEnemyRobot);
  trial.run(120);
  EXPECT_GT(trial.place(enemy).x, 60.0);
  EXPECT_LT(geom::distance(trial.place(), trial.place(enemy)), 22.0);
  EXPECT_FALSE(trial.has_heard("TrackTask reneged."));
  Trial alone("RunTrackTask()", {}, {{0, 0}, 0});
  EXPECT_TRUE(alone.run(2, [&] { return alone.has_heard("TrackTask reneged."); }));
}

TEST(RunObserveTask, TellsTheOperatorWhenTheEnemyLeaves) {
  Trial trial("RunObserveTask()", {}, {{0, 0}, 0});
  trial.add({90, 0}, 0, 1.0, ObjectClass::kEnemyRobot);
  EXPECT_FALSE(trial.run(15, [&] { return !trial.alert().empty(); }));
  EXPECT_TRUE(trial.run(15, [&] { return trial.has_heard("ObserveTask completed."); }));
  EXPECT_EQ(trial.alert().substr(0, 25), "Warning: Enemy is leaving");
  EXPECT_LT(trial.distance_to({0, 0}), 0.1);
}

TEST(RunInterceptTask, MeetsTheEnemyAndTellsHimToStop) {
  Trial trial("RunInterceptTask()", {}, {{0, 0}, 0});
  trial.add({60, -20}, kNorth, 0.4, ObjectClass::kEnemyRobot);
  EXPECT_TRUE(trial.run(120, [&] { return trial.has_heard("InterceptTask completed."); }));
  EXPECT_TRUE(trial.has_heard("Enemy stop."));
  EXPECT_GT(trial.place().x, 20.0);
}

// The requests of that kind in this cycle.
int asks(const Trial& trial, percept::Request::Kind kind) {
  int out = 0;
  for (std::uint8_t i = 0; i < trial.action().request_count; ++i)
    out += trial.action().requests[i].kind == kind ? 1 : 0;
  return out;
}

TEST(TellTarget, TellsWhereTheTargetIs) {
  Trial trial("TellTarget(classes = Mine)", with_a_mine({9, 3}), {{0, 0}, 0});
  EXPECT_TRUE(trial.run(1, [&] { return asks(trial, percept::Request::Kind::kSharePlace) == 1; }));
  EXPECT_NEAR(trial.action().requests[0].place.x, 9.0, 1e-9);
  EXPECT_TRUE(trial.run(2, [&] { return trial.has_heard("Dynamic constraints saved."); }));
}

TEST(ExecuteTask, DoesWhatItsNameSaysAndTellsThatItIsDone) {
  using Kind = percept::Request::Kind;
  for (const char* name : {"EODTask", "Visit"}) {
    std::vector<percept::Contract> contracts(1);
    contracts[0].task = base::hash_text(name);
    contracts[0].place = {0, 12};
    contracts[0].state = percept::ContractState::kAwarded;
    contracts[0].contractor = {1};
    Trial trial("ExecuteTask()", with_a_mine({15, 0}), {{0, 0}, 0});
    trial.percepts().id = {1};
    trial.percepts().contracts = contracts;
    EXPECT_TRUE(trial.run(1, [&] { return asks(trial, Kind::kStartTask) == 1; }));
    contracts[0].state = percept::ContractState::kStarted;
    EXPECT_TRUE(trial.run(90, [&] {
      EXPECT_EQ(asks(trial, Kind::kKeepTasks), 1);
      return asks(trial, Kind::kFinishTask) == 1;
    }));
    const bool has_mine = trial.percepts().carried.value == 1;
    EXPECT_EQ(has_mine, std::string(name) == "EODTask");
    if (!has_mine) {
      EXPECT_LT(trial.distance_to({0, 12}), 1.2);
    }
  }
}

TEST(ExecuteTask, GivesBackATaskThatItCannotDo) {
  std::vector<percept::Contract> contracts(1);
  contracts[0].task = base::hash_text("TrackTask");
  contracts[0].state = percept::ContractState::kStarted;
  contracts[0].contractor = {1};
  Trial trial("ExecuteTask()", {}, {{0, 0}, 0});
  trial.percepts().id = {1};
  trial.percepts().contracts = contracts;
  EXPECT_TRUE(trial.run(5, [&] { return asks(trial, percept::Request::Kind::kRenegeTask) == 1; }));
}

// Ordered to a place, or along a route.
percept::Order command(percept::Task task, geom::Point goal) {
  percept::Order order;
  order.sequence = 1;
  order.task = task;
  order.goal = goal;
  return order;
}

TEST(FollowCommands, GoesToTheGoalOfTheCommandAndTellsThatItIsThere) {
  Trial trial("FollowCommands()", with({{{10, 0.2}, 1.0}}), {{0, 0}, 0});
  trial.run(5);
  EXPECT_LT(trial.distance_to({0, 0}), 0.1) << "without a command";
  trial.percepts().order = command(percept::Task::kMoveTo, {20, 0});
  EXPECT_TRUE(trial.run(60, [&] { return trial.action().status.done; }));
  EXPECT_LT(trial.distance_to({20, 0}), 1.1);
  EXPECT_EQ(trial.simulator().contacts(trial.body()), 0U);
}

TEST(FollowCommands, StandsWhileItsUnitHasToHold) {
  Trial trial("FollowCommands()", {}, {{0, 0}, 0});
  trial.percepts().order = command(percept::Task::kMoveTo, {20, 0});
  trial.percepts().order.halted = true;
  trial.run(10);
  EXPECT_LT(trial.distance_to({0, 0}), 0.1);
}

TEST(FollowCommands, FollowsTheRouteToItsEnd) {
  const std::vector<geom::Point> route = {{0, 0}, {20, 0}, {20, 20}};
  Trial trial("FollowCommands()", {}, {{0, 0}, 0});
  trial.percepts().order = command(percept::Task::kFollow, {20, 20});
  trial.percepts().order.route = route;
  EXPECT_TRUE(trial.run(120, [&] { return trial.action().status.done; }));
  EXPECT_LT(trial.distance_to({20, 20}), 1.1);
}

TEST(FollowRoad, KeepsToTheMiddleAndComesToTheEnd) {
  Trial trial("FollowRoad(start = [0 m, 0 m], end = [40 m, 0 m], width = 4 m)", with({{{20, 1.5}, 0.5}}),
              {{0, 5}, 0});
  double farthest = 0.0;
  EXPECT_TRUE(trial.run(90, [&] {
    if (trial.place().x > 10 && trial.place().x < 38)
      farthest = std::max(farthest, std::abs(trial.place().y));
    return trial.distance_to({40, 0}) < 1.5;
  }));
  EXPECT_LT(farthest, 2.0);
}

TEST(AvoidDynamicObstacles, MakesWayForARobotThatComes) {
  Trial trial("AvoidDynamicObstacles(sphere = 3 m, min_range = 1 m)", {}, {{0, 0}, 0});
  const sim::BodyIndex other = trial.add({-8, 0.1}, 0, 0.5);
  double nearest = 100.0;
  trial.run(40, [&] {
    nearest = std::min(nearest, geom::distance(trial.place(), trial.place(other)));
    return false;
  });
  EXPECT_GT(nearest, 0.8);
  EXPECT_LT(nearest, 3.0);
}

TEST(StayInFormation, GoesToItsStation) {
  Trial trial("StayInFormation(formation = Line, spacing = 6 m, heading = 0)", {}, {{0, 0}, 0});
  percept::UnitPercept& unit = trial.percepts().unit;
  unit.size = 2;
  unit.rank = 0;
  trial.run(0.1);
  EXPECT_GT(geom::length(trial.action().velocity), 0.1);
}

TEST(Acquire, FetchesTheNearestObjectOfItsClass) {
  Trial trial("Acquire(classes = Mine)", with({}, {mine(1, {8, 0}), mine(2, {-30, 0}), basket(3, {2, 0})}),
              {{0, 0}, 0});
  EXPECT_TRUE(trial.run(60, [&] { return trial.simulator().carried(trial.body()).value == 1; }));
}

TEST(Deliver, BringsHomeWhatItCarries) {
  Trial trial(
      "sequence { start A: Acquire(); when Holding() goto B; B: Deliver(); when not Holding() goto C; final "
      "C: Stand(); }",
      with({}, {mine(1, {3, 0}), basket(2, {0, 6})}), {{0, 0}, 0});
  EXPECT_TRUE(trial.run(90, [&] { return trial.simulator().basket_count({2}) == 1; }));
}

TEST(Forage, BringsAllAttractorsHome) {
  Trial trial("Forage(attractor = Orange, home = Basket, range = 15 m)",
              with({{{4, 4}, 0.5}}, {mine(1, {6, 0}), mine(2, {-5, 3}), mine(3, {0, -7}), basket(4, {1, 1})}),
              {{0, 0}, 0});
  EXPECT_TRUE(trial.run(400, [&] { return trial.simulator().basket_count({4}) == 3; }));
}

TEST(DockAssemblage, ComesFromTheSideThatIsAskedFor) {
  Trial trial("Dock(place = [0 m, 0 m], approach = 0, obstacle_gain = 0)", {}, {{-6, 1}, 0});
  double x_at_one_metre = 0.0;
  EXPECT_TRUE(trial.run(60, [&] {
    if (trial.distance_to({0, 0}) > 1.0) x_at_one_metre = trial.place().x;
    return trial.distance_to({0, 0}) < 0.2;
  }));
  EXPECT_GT(x_at_one_metre, 0.5) << "from the east";
}

TEST(EnterRoom, IsInTheRoomThenAndLeaveRoomIsOutOfIt) {
  Trial in("EnterRoom()", building(), {{2, -2}, 0});
  EXPECT_TRUE(in.run(60, [&] { return in.place().y > 0.7; }));
  Trial out("LeaveRoom()", building(), {{3, 5}, 0});
  EXPECT_TRUE(out.run(60, [&] { return out.place().y < -0.7; }));
}

TEST(GoThroughDoor, StandsBehindTheDoor) {
  Trial trial("GoThroughDoor()", building(), {{8, -2}, 0});
  EXPECT_TRUE(trial.run(60, [&] { return trial.place().y > 0.7; }));
  trial.run(10);
  EXPECT_GT(trial.place().y, 0.7);
  EXPECT_LT(trial.place().y, 2.0);
}

TEST(ProceedAlongHallway, GoesOnToItsEnd) {
  Trial trial(
      "sequence { start Along: ProceedAlongHallway(); when AtEndOfHall(tolerance = 1.5 m) goto End; final "
      "End: Stand(); }",
      building(), {{0, -2.5}, 0});
  EXPECT_TRUE(trial.run(90, [&] { return trial.distance_to({30, -2}) < 2.0; }));
  trial.run(10);
  EXPECT_LT(trial.distance_to({30, -2}), 2.5);
}

TEST(MarkDoorway, IsDoneAtTheDoorThatItPasses) {
  Trial trial(
      "sequence { start Along: ProceedAlongHallway(); when AtDoorway(side = 1, only_unmarked = true) goto "
      "Marking;"
      " Marking: MarkDoorway(); when MarkedDoorway() goto End; final End: Stand(); }",
      building(), {{-2, -2}, 0});
  EXPECT_TRUE(trial.run(60, [&] {
    percept::Percepts now;
    sim::SenseBuffer buffer;
    trial.simulator().sense(trial.body(), {}, buffer, now);
    return now.map.doors[0].is_marked;
  }));
  EXPECT_NEAR(trial.place().x, 4.5, 1.2);
}

TEST(Follow, StaysBehindAnotherRobot) {
  Trial trial("Follow()", {}, {{0, 0}, 0});
  const sim::BodyIndex other = trial.add({5, 5}, 0.5, 0.5);
  trial.run(60);
  EXPECT_LT(geom::distance(trial.place(), trial.place(other)), 1.5);
}

TEST(TrackTarget, KeepsBetweenItsDistances) {
  Trial trial("TrackTarget(minimum_distance = 3 m, maximum_distance = 6 m)", {}, {{0, 0}, 0});
  const sim::BodyIndex other = trial.add({5, 0}, 0, 0.3, ObjectClass::kEnemyRobot);
  double least = 100.0;
  double most = 0.0;
  trial.run(100, [&] {
    const double away = geom::distance(trial.place(), trial.place(other));
    least = std::min(least, away);
    most = std::max(most, away);
    return false;
  });
  EXPECT_GT(least, 2.5);
  EXPECT_LT(most, 7.0);
}

TEST(Intercept, MeetsAnEnemyThatCrosses) {
  Trial trial("Intercept()", {}, {{0, 0}, 0});
  const sim::BodyIndex other = trial.add({10, -5}, kNorth, 0.6, ObjectClass::kEnemyRobot);
  EXPECT_TRUE(trial.run(30, [&] { return geom::distance(trial.place(), trial.place(other)) < 0.6; }));
}

TEST(GoTo, ArrivesAndAtGoalKnows) {
  Trial trial(
      "sequence { start A: GoTo(goal = [6 m, 3 m]); when AtGoal(goal = [6 m, 3 m]) goto B; final B: "
      "NotifySelf(\"there\"); }",
      {}, {{0, 0}, 0});
  EXPECT_TRUE(trial.run(30, [&] { return trial.has_heard("there"); }));
  EXPECT_LT(trial.distance_to({6, 3}), 1.2);
}

TEST(GoTo_Dstar, LeavesATrapThatGoToStaysIn) {
  std::vector<sim::Disc> trap;
  for (int i = 0; i < 9; ++i) trap.push_back({{4.0, i - 4.0}, 0.6});
  for (int i = 0; i < 5; ++i) {
    trap.push_back({{static_cast<double>(i), 4.0}, 0.6});
    trap.push_back({{static_cast<double>(i), -4.0}, 0.6});
  }
  Trial reactive("GoTo(goal = [12 m, 0 m])", with(trap), {{0, 0}, 0});
  EXPECT_FALSE(reactive.run(90, [&] { return reactive.distance_to({12, 0}) < 0.5; }));
  Trial planning("GoTo_Dstar(goal = [12 m, 0 m])", with(trap), {{0, 0}, 0});
  EXPECT_TRUE(planning.run(90, [&] { return planning.distance_to({12, 0}) < 0.5; }));
}

TEST(GoTo_LM, ArrivesBehindAnObstacle) {
  Trial trial("GoTo_LM(goal = [12 m, 0 m])", with({{{6, 0}, 1.0}}), {{0, 0}, 0});
  EXPECT_TRUE(trial.run(200, [&] { return trial.distance_to({12, 0}) < 0.7; }));
}

TEST(MoveToward, ReachesTheNearestObjectOfItsClasses) {
  Trial trial("MoveToward(classes = Flag)",
              with({}, {object(1, ObjectClass::kFlag, ObjectStyle::kFixed, {5, 5})}), {{0, 0}, 0});
  EXPECT_TRUE(trial.run(30, [&] { return trial.distance_to({5, 5}) < 0.4; }));
}

TEST(MoveAway, GetsAwayFromAnEnemy) {
  Trial trial("MoveAway(avoid_objects_sphere = 8 m)", {}, {{0, 0}, 0});
  trial.add({2, 0}, 0, 0.0, ObjectClass::kEnemyRobot);
  EXPECT_TRUE(trial.run(60, [&] { return trial.distance_to({2, 0}) > 6.0; }));
}

TEST(GoStraight, KeepsItsDirection) {
  Trial trial("GoStraight()", {}, {{0, 0}, 0.5});
  trial.run(10);
  EXPECT_NEAR(std::atan2(trial.place().y, trial.place().x), 0.5, 0.05);
  EXPECT_GT(trial.distance_to({0, 0}), 5.0);
}

TEST(AboutFace, TurnsRoundAndSaysSo) {
  Trial trial(
      "sequence { start A: AboutFace(); when AboutFaceCompleted() goto B; final B: NotifySelf(\"round\"); }",
      {}, {{0, 0}, 0});
  EXPECT_TRUE(trial.run(10, [&] { return trial.has_heard("round"); }));
  EXPECT_NEAR(std::abs(trial.simulator().pose(trial.body()).heading), std::numbers::pi, 0.1);
}

TEST(LookFor, EndsWhenItSeesSomething) {
  sim::World world = with({}, {object(1, ObjectClass::kUnknown, ObjectStyle::kFixed, {40, 0})});
  Trial trial(
      "sequence { start A: LookFor(range = 5 m); when Detect(Unknown, range = 5 m) goto B; final B: "
      "NotifySelf(\"seen\"); }",
      world, {{0, 0}, 0});
  trial.run(10);
  EXPECT_FALSE(trial.has_heard("seen"));
  std::vector<sim::Object> nearer = {object(1, ObjectClass::kUnknown, ObjectStyle::kFixed, {2, 0})};
  trial.simulator().set_objects(nearer, {});
  EXPECT_TRUE(trial.run(10, [&] { return trial.has_heard("seen"); }));
}

TEST(TestObject, MarksDangerousAndSafeObjects) {
  for (const bool is_dangerous : {true, false}) {
    const ObjectStyle style = is_dangerous ? ObjectStyle::kMovable : ObjectStyle::kFixed;
    Trial trial("TestObject()", with({}, {object(1, ObjectClass::kUnknown, style, {0.6, 0})}), {{0, 0}, 0});
    EXPECT_TRUE(
        trial.run(10, [&] { return trial.has_heard(is_dangerous ? "TestPositive" : "TestNegative"); }));
    EXPECT_EQ(trial.simulator().objects()[0].object_class,
              is_dangerous ? ObjectClass::kMine : ObjectClass::kTree);
  }
}

TEST(MarkObjectAs, MarksTheNearestObjectWithinReach) {
  Trial trial("MarkObjectAs(classes = Flag, range = 1 m)",
              with({}, {object(1, ObjectClass::kUnknown, ObjectStyle::kFixed, {0.6, 0}),
                        object(2, ObjectClass::kUnknown, ObjectStyle::kFixed, {4, 0})}),
              {{0, 0}, 0});
  trial.run(1);
  EXPECT_EQ(trial.simulator().objects()[0].object_class, ObjectClass::kFlag);
  EXPECT_EQ(trial.simulator().objects()[1].object_class, ObjectClass::kUnknown);
}

TEST(SigSense, HearsWhatProbeNearestObjectFound) {
  const auto heard = [](ObjectStyle style) {
    Trial trial(
        "sequence { start A: ProbeNearestObject(); when SigSense(key = 100) goto B; when SigSense(key = 115) "
        "goto C; final B: NotifySelf(\"danger\"); final C: NotifySelf(\"safe\"); }",
        with({}, {object(1, ObjectClass::kUnknown, style, {0.6, 0})}), {{0, 0}, 0});
    trial.run(2);
    return std::pair(trial.has_heard("danger"), trial.has_heard("safe"));
  };
  EXPECT_EQ(heard(ObjectStyle::kMovable), std::pair(true, false));
  EXPECT_EQ(heard(ObjectStyle::kFixed), std::pair(false, true));
}

TEST(SurveyRoom, FindsTheDangerousOneAmongThree) {
  Trial trial("SurveyRoom()",
              with({}, {object(1, ObjectClass::kUnknown, ObjectStyle::kFixed, {3, 0}),
                        object(2, ObjectClass::kUnknown, ObjectStyle::kFixed, {3, 4}),
                        object(3, ObjectClass::kUnknown, ObjectStyle::kMovable, {-2, 6})}),
              {{0, 0}, 0});
  EXPECT_TRUE(trial.run(200, [&] { return trial.has_heard("TARGET FOUND"); }));
  EXPECT_EQ(trial.simulator().objects()[2].object_class, ObjectClass::kMine);
  EXPECT_EQ(trial.simulator().objects()[0].object_class, ObjectClass::kTree);
}

TEST(SurveyRoom, GivesUpWhereNothingIsLeft) {
  Trial trial("SurveyRoom(patience = 5 s)", {}, {{0, 0}, 0});
  EXPECT_TRUE(trial.run(60, [&] { return trial.has_heard("NO TARGET FOUND"); }));
}

TEST(Survey, GoesOverItsRectangleAndSaysWhenItIsDone) {
  Trial trial("Survey(center = [0 m, 0 m], half_width = 10 m, half_height = 10 m, duration = 120 s)", {},
              {{0, 0}, 0});
  std::set<std::pair<bool, bool>> quarters;
  EXPECT_TRUE(trial.run(130, [&] {
    quarters.insert({trial.place().x > 0, trial.place().y > 0});
    return trial.has_heard("SurveyCompleted");
  }));
  EXPECT_EQ(quarters.size(), 4U);
}

TEST(PickUpObject, TakesAndPutInBasketPutsIn) {
  Trial trial(
      "sequence { start A: PickUpObject(Mine); when Holding(Mine) goto B; B: PutInBasket(); when "
      "NotHolding(Mine) goto C; final C: Stand(); }",
      with({}, {mine(1, {2, 0}), basket(2, {0, 3})}), {{0, 0}, 0});
  EXPECT_TRUE(trial.run(5, [&] { return trial.simulator().basket_count({2}) == 1; }));
}

TEST(NotDetected, IsTheOppositeOfDetect) {
  Trial trial(
      "sequence { start A: Stand(); when NotDetected(Flag, range = 5 m) goto B; final B: "
      "NotifySelf(\"gone\"); }",
      with({}, {object(1, ObjectClass::kFlag, ObjectStyle::kFixed, {3, 0})}), {{0, 0}, 0});
  EXPECT_FALSE(trial.run(2, [&] { return trial.has_heard("gone"); }));
  trial.simulator().set_objects({}, {});
  EXPECT_TRUE(trial.run(2, [&] { return trial.has_heard("gone"); }));
}

TEST(DetectMotivated, NeedsTheMoodAsWell) {
  const auto heard = [](const std::string& mood) {
    Trial trial("sequence { start A: Stand(); when DetectMotivated(Flag, fear_upper = 0.5, fear = " + mood +
                    ") goto B; final B: NotifySelf(\"yes\"); }",
                with({}, {object(1, ObjectClass::kFlag, ObjectStyle::kFixed, {3, 0})}), {{0, 0}, 0});
    return trial.run(2, [&] { return trial.has_heard("yes"); });
  };
  EXPECT_TRUE(heard("0.4"));
  EXPECT_FALSE(heard("0.6"));
}

TEST(GoToSoundSource, GoesToTheSoundAndStandsInSilence) {
  Trial loud("GoToSoundSource(volume = 1, direction_x = 0, direction_y = 2)", {}, {{0, 0}, 0});
  loud.run(5);
  EXPECT_GT(loud.place().y, 3.0);
  Trial silent("GoToSoundSource(direction_x = 0, direction_y = 2)", {}, {{0, 0}, 0});
  silent.run(5);
  EXPECT_LT(silent.distance_to({0, 0}), 1e-9);
}

TEST(Standby, GoesOnWithTheOperatorsWordAndAlertsHimWhenStuck) {
  Trial free("Standby()", {}, {{0, 0}, 0});
  EXPECT_TRUE(free.run(5, [&] {
    return free.action().request_count > 0 &&
           free.action().requests[0].kind == percept::Request::Kind::kProceed;
  }));
  Trial stuck("Standby()", with({{{0.5, 0}, 0.3}}), {{0, 0}, 0});
  EXPECT_TRUE(stuck.run(15, [&] { return stuck.has_heard("MOTOR FAILURE DETECTED"); }));
  EXPECT_EQ(stuck.alert().substr(0, 23), "Motor Failure Detected:");
}

TEST(MoveToward_NotifiedObject, GoesWhereAnotherRobotSaid) {
  Trial trial(
      "sequence { start A: MoveToward_NotifiedObject(); when NearNotifiedObject(distance = 1 m) goto B; "
      "final B: NotifySelf(\"there\"); }",
      {}, {{0, 0}, 0});
  const std::vector<percept::SharedPlace> told = {{{2}, {5}, ObjectClass::kMine, {6, 2}, 0.0}};
  trial.percepts().id = {1};
  trial.percepts().shared_places = told;
  EXPECT_TRUE(trial.run(30, [&] { return trial.has_heard("there"); }));
  EXPECT_LT(trial.distance_to({6, 2}), 1.5);
}

TEST(NotifyRobots_ObjectLocation, TellsWhereItIs) {
  Trial trial("NotifyRobots_ObjectLocation(classes = Mine)", with({}, {mine(1, {4, 3})}), {{1, 0}, 0.7});
  trial.run(0.1);
  ASSERT_GE(trial.action().request_count, 1);
  EXPECT_NEAR(trial.action().requests[0].place.x, 4.0, 1e-9);
  EXPECT_NEAR(trial.action().requests[0].place.y, 3.0, 1e-9);
}

}  // namespace
}  // namespace mlab::library_test
