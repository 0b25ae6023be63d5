#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/flow/program.h"
#include "mlab/mission/parameter.h"
#include "mlab/robot/program/configuration_file.h"

#include "../testing/network.h"

namespace mlab::library_test {
namespace {

using geom::Point;
using geom::Vector;
using percept::Formation;
using percept::FormationReference;
using percept::Task;

// The standard robot as a program.
const flow::Program& standard() {
  static const std::shared_ptr<const flow::Program> kProgram = [] {
    text::Diagnostics sink;
    const auto robot = robot::library_robot("Scout", {}, {}, sink);
    EXPECT_TRUE(robot && sink.items().empty()) << text::render(sink);
    return robot ? robot->built.program : nullptr;
  }();
  return *kProgram;
}

// One standard robot that only reacts, with its percepts, and what it did last.
struct Robot {
  Robot() { set("plans_ways", "0"); }

  flow::Frame frame = standard().make_frame();
  percept::Percepts percepts;
  percept::Action action;
  std::vector<percept::RobotReading> others;
  std::uint32_t id = 1;

  Robot& set(std::string_view parameter, const char* value) {
    const flow::Port* port = standard().find(parameter);
    EXPECT_NE(port, nullptr) << parameter;
    if (port != nullptr) {
      EXPECT_EQ(standard().set(frame.data(), *port, value).value_or(""), "");
    }
    return *this;
  }
  void step() {
    action = {};
    standard().step(frame.data(), percepts, action, 1, id);
    percepts.time += percepts.cycle_duration;
  }
  // Velocity in the world.
  geom::Offset velocity() {
    step();
    return percepts.pose.to_world(action.velocity);
  }
};

// A robot alone, without noise, ordered to go from the origin to a goal.
Robot ordered(Task task, Point goal) {
  Robot robot;
  robot.percepts.order.task = task;
  robot.percepts.order.goal = goal;
  robot.percepts.order.sequence = 1;
  robot.set("navigation_noise_gain", "0");
  return robot;
}

void expect_close(geom::Offset a, geom::Offset b) {
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
}

TEST(StandardRobot, StandsWithoutACommand) {
  Robot robot;
  expect_close(robot.velocity(), {0.0, 0.0});
  EXPECT_TRUE(robot.action.drives);
  EXPECT_EQ(robot.action.status.sequence, 0U);
}

TEST(StandardRobot, TravelsAtTheGainOfTheGoalTimesItsBaseVelocity) {
  expect_close(ordered(Task::kMoveTo, {0.0, 300.0}).velocity(), {0.0, 4.0});
  expect_close(ordered(Task::kSweepTo, {0.0, 300.0}).velocity(), {0.0, 4.0});
  expect_close(ordered(Task::kOccupy, {0.0, 300.0}).velocity(), {0.0, 2.0});
}

TEST(StandardRobot, TravelsAtTheSpeedOfTheCommand) {
  for (const Task task : {Task::kMoveTo, Task::kOccupy}) {
    Robot robot = ordered(task, {300.0, 0.0});
    robot.percepts.order.speed = 3.0;
    expect_close(robot.velocity(), {3.0, 0.0});
    robot.percepts.order.speed = 50.0;
    expect_close(robot.velocity(), {7.0, 0.0});
  }
}

TEST(StandardRobot, IsPulledUntilItIsFiveMetresFromTheGoal) {
  expect_close(ordered(Task::kMoveTo, {5.01, 0.0}).velocity(), {4.0, 0.0});
  expect_close(ordered(Task::kMoveTo, {5.0, 0.0}).velocity(), {0.0, 0.0});
}

TEST(StandardRobot, IsDoneTenMetresFromTheGoalAndStaysDone) {
  Robot robot = ordered(Task::kMoveTo, {25.0, 0.0});
  robot.percepts.order.sequence = 7;
  robot.step();
  EXPECT_EQ(robot.action.status.sequence, 7U);
  EXPECT_FALSE(robot.action.status.done);
  EXPECT_DOUBLE_EQ(robot.action.status.remaining, 15.0);
  robot.percepts.pose.position = robot.percepts.unit.center = {15.0, 0.0};
  robot.step();
  EXPECT_TRUE(robot.action.status.done);
  robot.percepts.pose.position = robot.percepts.unit.center = {-50.0, 0.0};
  robot.step();
  EXPECT_TRUE(robot.action.status.done);
}

TEST(StandardRobot, ArrivesWithItsUnitNotAlone) {
  Robot robot = ordered(Task::kMoveTo, {100.0, 0.0});
  robot.percepts.unit.size = 2;
  robot.percepts.pose.position = {100.0, 0.0};
  robot.percepts.unit.center = {80.0, 0.0};
  expect_close(robot.velocity(), {4.0, 0.0});
  EXPECT_FALSE(robot.action.status.done);
}

TEST(StandardRobot, OccupiesOnlyFromItsStation) {
  Robot robot = ordered(Task::kOccupy, {0.0, 0.0});
  robot.percepts.order.formation = Formation::kColumn;
  robot.percepts.unit.size = 2;
  robot.percepts.unit.rank = 0;
  robot.step();
  EXPECT_FALSE(robot.action.status.done);
  EXPECT_DOUBLE_EQ(robot.action.status.remaining, 15.0);
  robot.percepts.pose.position = {16.0, 0.0};
  robot.step();
  EXPECT_TRUE(robot.action.status.done);
}

TEST(StandardRobot, StandsWhileItsUnitIsHalted) {
  Robot robot = ordered(Task::kMoveTo, {300.0, 0.0});
  robot.percepts.order.halted = true;
  expect_close(robot.velocity(), {0.0, 0.0});
  EXPECT_DOUBLE_EQ(robot.action.status.remaining, 290.0);
}

TEST(StandardRobot, GivesWayToObstacles) {
  Robot robot = ordered(Task::kMoveTo, {300.0, 0.0});
  const std::vector<percept::Obstacle> ahead = {{{22.0, 0.0}, 2.0}};  // d - R = 15: half of the sphere
  robot.percepts.obstacles = ahead;
  expect_close(robot.velocity(), {(0.8 - 1.5 * 0.5) * 5.0, 0.0});
  const std::vector<percept::Obstacle> near = {{{0.0, 6.0}, 2.0}};
  robot.percepts.obstacles = near;
  expect_close(robot.velocity(), {0.0, -7.0});
  robot.set("cautious_mode", "true");
  expect_close(robot.velocity(), {0.0, -0.5});
  robot.set("navigation_avoid_obstacle_gain", "0");
  expect_close(robot.velocity(), {4.0, 0.0});
}

TEST(StandardRobot, GivesWayToRobots) {
  Robot robot = ordered(Task::kMoveTo, {300.0, 0.0});
  const std::vector<percept::RobotReading> ahead = {{.id = {2}, .center = {27.0, 0.0}}};
  robot.percepts.robots = ahead;
  expect_close(robot.velocity(), {(0.8 - 2.0 * 0.2) * 5.0, 0.0});
  const std::vector<percept::RobotReading> near = {{.id = {2}, .center = {0.0, 14.0}}};
  robot.percepts.robots = near;
  expect_close(robot.velocity(), {0.0, -7.0});
}

TEST(StandardRobot, BlendsTheStickWithItsOwnMotion) {
  Robot robot = ordered(Task::kTeleoperate, {300.0, 0.0});
  expect_close(robot.velocity(), {0.0, 0.0});
  EXPECT_FALSE(robot.action.status.done);
  robot.percepts.joystick = {
      .x = 0.0, .y = 0.5, .magnitude = 0.5, .is_robot_frame = false, .complete = false};
  expect_close(robot.velocity(), {0.0, 2.5});
  robot.percepts.order.task = Task::kMoveTo;
  expect_close(robot.velocity(), {4.0, 2.5});
  robot.percepts.order.task = Task::kTeleoperate;
  robot.percepts.joystick = {.complete = true};
  robot.step();
  EXPECT_TRUE(robot.action.status.done);
}

TEST(StandardRobot, TakesTheStickFromItsParametersToo) {
  Robot robot = ordered(Task::kTeleoperate, {300.0, 0.0});
  robot.percepts.pose.heading = kNorth;
  robot.set("telop_mode", "1").set("joystick_y", "1").set("joystick_magnitude", "1");
  expect_close(robot.velocity(), {0.0, 5.0});
}

TEST(StandardRobot, SensesNoFartherThanItsTaskNeeds) {
  Robot robot = ordered(Task::kMoveTo, {300.0, 0.0});
  robot.set("navigation_avoid_robot_sphere", "40")
      .set("occupy_avoid_robot_sphere", "45")
      .set("detect_obs_range", "33");
  robot.step();
  const percept::Needs needs = standard().needs(robot.frame.data());
  EXPECT_GE(needs[percept::Sensor::kObstacles], 33.0);
  EXPECT_GE(needs[percept::Sensor::kRobots], 40.0);
  EXPECT_LE(needs[percept::Sensor::kRobots], 45.0);
  EXPECT_DOUBLE_EQ(needs[percept::Sensor::kObjects], 0.0);
  EXPECT_FALSE(needs.has(percept::Sensor::kRanges));
}

TEST(StandardRobot, DriftsByItsNoise) {
  Robot robot = ordered(Task::kMoveTo, {300.0, 0.0});
  robot.set("navigation_noise_gain", "0.1");
  const geom::Offset noise = robot.velocity() - geom::Offset{4.0, 0.0};
  EXPECT_NEAR(geom::length(noise), 0.5, 1e-9);
}

// Several standard robots that move as they want to; they see each other and the obstacles.
class Team {
 public:
  Team(int count, Point start, geom::Offset step) {
    for (int k = 0; k < count; ++k) {
      Robot robot = ordered(Task::kNone, {});
      robot.id = static_cast<std::uint32_t>(k + 1);
      robot.percepts.pose.position = start + step * k;
      robot.percepts.unit.size = static_cast<std::uint16_t>(count);
      robot.percepts.unit.rank = static_cast<std::uint16_t>(k);
      robots.push_back(std::move(robot));
    }
  }

  void order(const percept::Order& order) {
    for (Robot& robot : robots) robot.percepts.order = order;
  }

  Point center() const {
    geom::Offset sum;
    for (const Robot& robot : robots) sum = sum + (robot.percepts.pose.position - Point{});
    return Point{} + sum * (1.0 / static_cast<double>(robots.size()));
  }

  bool is_done() const {
    return std::ranges::all_of(robots, [](const Robot& robot) { return robot.action.status.done; });
  }

  // Runs until all are done; @return whether they were done in time.
  bool run(double seconds) {
    for (double t = 0.0; t < seconds; t += 0.1) {
      step();
      if (is_done()) return true;
    }
    return false;
  }

  void step() {
    const Point now = center();
    const geom::Offset moved = now - last_center_;
    for (Robot& robot : robots) perceive(robot, now, is_first_ ? geom::Offset{} : moved);
    last_center_ = now;
    is_first_ = false;
    for (Robot& robot : robots) move(robot);
  }

  std::vector<Robot> robots;

 private:
  void perceive(Robot& robot, Point center_now, geom::Offset center_step) {
    robot.others.clear();
    for (const Robot& other : robots) {
      if (other.id == robot.id) continue;
      robot.others.push_back(
          {.id = {other.id}, .center = robot.percepts.pose.to_robot(other.percepts.pose.position)});
    }
    robot.percepts.robots = robot.others;
    robot.percepts.unit.center = center_now;
    robot.percepts.unit.center_step = center_step;
    robot.percepts.unit.leader = robots.front().percepts.pose;
    robot.percepts.unit.neighbor =
        robots[robot.percepts.unit.rank == 0 ? 0U : robot.percepts.unit.rank - 1U].percepts.pose;
  }

  static void move(Robot& robot) {
    robot.step();
    const geom::Offset v = robot.percepts.pose.to_world(robot.action.velocity);
    if (geom::length(v) < 1e-6) return;
    robot.percepts.pose.position = robot.percepts.pose.position + v * 0.1;
    robot.percepts.pose.heading = geom::direction(v);
  }

  Point last_center_;
  bool is_first_ = true;
};

// The largest error of any robot from its station, when the formation looks in that direction.
double station_error(const Team& team, Formation formation, double heading) {
  double worst = 0.0;
  for (const Robot& robot : team.robots) {
    const Vector place = geom::rotated(
        percept::station(formation, robot.percepts.unit.rank, robot.percepts.unit.size, 50.0), heading);
    const Point station = team.center() + geom::Offset{place.x, place.y};
    worst = std::max(worst, geom::distance(station, robot.percepts.pose.position));
  }
  return worst;
}

percept::Order command(Task task, Point goal, Formation formation) {
  percept::Order order;
  order.sequence = 1;
  order.task = task;
  order.goal = goal;
  order.formation = formation;
  return order;
}

TEST(StandardTeam, TakesUpItsFormationOnTheWay) {
  for (const Formation formation :
       {Formation::kColumn, Formation::kLine, Formation::kWedge, Formation::kDiamond}) {
    Team team(4, {50.0, 400.0}, {0.0, 20.0});
    team.order(command(Task::kMoveTo, {800.0, 400.0}, formation));
    EXPECT_TRUE(team.run(600.0)) << percept::name(formation);
    EXPECT_LE(geom::distance(team.center(), {800.0, 400.0}), 10.0) << percept::name(formation);
    EXPECT_LT(station_error(team, formation, 0.0), 10.0) << percept::name(formation);
  }
}

TEST(StandardTeam, OccupiesInFormation) {
  Team team(4, {50.0, 400.0}, {0.0, 20.0});
  team.order(command(Task::kOccupy, {400.0, 400.0}, Formation::kDiamond));
  EXPECT_TRUE(team.run(900.0));
  EXPECT_LE(geom::distance(team.center(), {400.0, 400.0}), 10.0);
}

TEST(StandardTeam, TurnsWithItsGoal) {
  Team team(4, {50.0, 100.0}, {0.0, 20.0});
  team.order(command(Task::kMoveTo, {400.0, 100.0}, Formation::kDiamond));
  EXPECT_TRUE(team.run(600.0));
  percept::Order next = command(Task::kMoveTo, {400.0, 500.0}, Formation::kDiamond);
  next.sequence = 2;
  team.order(next);
  EXPECT_TRUE(team.run(600.0));
  EXPECT_LT(station_error(team, Formation::kDiamond, kNorth), 10.0);
}

TEST(StandardTeam, KeepsItsFormationByTheLeaderOrTheNeighbour) {
  for (const FormationReference reference : {FormationReference::kLeader, FormationReference::kNeighbor}) {
    Team team(4, {50.0, 400.0}, {0.0, 20.0});
    percept::Order order = command(Task::kMoveTo, {900.0, 400.0}, Formation::kColumn);
    order.reference = reference;
    team.order(order);
    EXPECT_TRUE(team.run(900.0));
    EXPECT_LT(station_error(team, Formation::kColumn, 0.0), 25.0);
  }
}

TEST(StandardTeam, LooksWhereItsCommandSays) {
  Team team(4, {50.0, 400.0}, {0.0, 20.0});
  percept::Order order = command(Task::kMoveTo, {800.0, 400.0}, Formation::kColumn);
  order.has_heading = true;
  order.heading = kNorth;
  team.order(order);
  EXPECT_TRUE(team.run(600.0));
  EXPECT_LT(station_error(team, Formation::kColumn, kNorth), 10.0);
}

TEST(StandardTeam, FollowsARouteToItsEnd) {
  const std::vector<Point> route = {{100.0, 100.0}, {400.0, 100.0}, {400.0, 400.0}, {100.0, 400.0}};
  Team team(2, {50.0, 100.0}, {0.0, 20.0});
  percept::Order order = command(Task::kFollow, route.back(), Formation::kColumn);
  order.route = route;
  team.order(order);
  bool saw_first_corner = false;
  bool saw_second_corner = false;
  for (int i = 0; i < 20000 && !team.is_done(); ++i) {
    team.step();
    saw_first_corner = saw_first_corner || geom::distance(team.center(), route[1]) < 20.0;
    saw_second_corner =
        saw_second_corner || (saw_first_corner && geom::distance(team.center(), route[2]) < 20.0);
  }
  EXPECT_TRUE(team.is_done());
  EXPECT_TRUE(saw_first_corner);
  EXPECT_TRUE(saw_second_corner);
  EXPECT_LE(geom::distance(team.center(), route.back()), 12.0);
}

TEST(StandardTeam, OfOneIsAsGoodAsAlone) {
  Team team(1, {50.0, 400.0}, {});
  team.order(command(Task::kOccupy, {200.0, 400.0}, Formation::kWedge));
  EXPECT_TRUE(team.run(200.0));
  EXPECT_NEAR(team.center().y, 400.0, 1e-6);
}

// What is checked and shared out before a mission runs asks no program.
TEST(StandardRobot, HasTheDefaultsThatMissionsAreCheckedBy) {
  const std::vector<std::pair<const char*, double>> kDefaults = {
      {"robot_radius", mission::kDefaultBodyRadius},
      {"avoid_obstacle_safety_margin", mission::kDefaultMargin},
      {"navigation_avoid_robot_sphere", mission::kDefaultRobotSphere},
      {"occupy_avoid_robot_sphere", mission::kDefaultRobotSphere},
      {"navigation_success_radius", mission::kDefaultSuccessRadius},
      {"formation_spacing", mission::kDefaultSpacing},
      {"formation_slop", mission::kDefaultSlop},
      {"formation_default_trigger", mission::kDefaultTrigger},
  };
  for (const auto& [name, value] : kDefaults) {
    const flow::Port* const port = standard().find(name);
    ASSERT_NE(port, nullptr) << name;
    EXPECT_EQ(flow::Program::number(standard().initial_frame().data(), *port), value) << name;
  }
}

// | `name` | default | unit | meaning |, one for each parameter, in the order of the network.
TEST(StandardRobotPage, ListsEveryParameterAsItIs) {
  std::ifstream file(base::source_folder() + "/docs/standard_robot.md");
  ASSERT_TRUE(file.good());
  std::string page;
  std::string line;
  while (std::getline(file, line) && line != "## Parameters") {
  }
  while (std::getline(file, line)) {
    if (line.starts_with("| `")) page += line + "\n";
  }
  std::string expected;
  for (const flow::Port& port : standard().ports()) {
    if (port.role != flow::Port::Role::kParameter) continue;
    expected +=
        fmt::format("| `{}` | {} | {} | {} |\n", port.path,
                    flow::Program::print(standard().initial_frame().data(), port), port.unit, port.help);
  }
  EXPECT_EQ(page, expected);
}

}  // namespace
}  // namespace mlab::library_test
