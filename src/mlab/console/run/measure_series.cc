#include "mlab/console/run/measure_series.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include <fmt/core.h>

#include "mlab/console/published/overview.h"

namespace mlab::console {
namespace {

using fleet::FleetRobot;
using fleet::RobotLife;

const mission::Unit* find_unit(const mission::Mission& mission, const std::string& name) {
  const auto at = std::ranges::find(mission.units, name, &mission::Unit::name);
  return name.empty() || at == mission.units.end() ? nullptr : &*at;
}

// From edge to edge, of discs and walls [m].
std::optional<double> nearest_obstacle(const run::MissionRun& run, const FleetRobot& robot) {
  double nearest = std::numeric_limits<double>::infinity();
  const geom::Point at = run.fleet().pose(robot).position;
  for (const binding::Disc& disc : run.world().discs())
    nearest = std::min(nearest, geom::distance(disc.center, at) - disc.radius);
  for (const binding::MovingDisc& disc : run.world().moving_discs())
    nearest = std::min(nearest, geom::distance(disc.center, at) - disc.radius);
  for (const binding::Wall& wall : run.world().walls())
    nearest = std::min(nearest, geom::distance(geom::nearest_point(wall.segment, at), at));
  if (nearest == std::numeric_limits<double>::infinity()) return std::nullopt;
  return nearest - robot.capabilities.radius;
}

std::optional<geom::Point> goal_of(const run::MissionRun& run, const FleetRobot& robot) {
  const fleet::Group* group = run.fleet().group(robot);
  if (group == nullptr) return std::nullopt;
  const auto& order = group->order;
  return order.task == percept::Task::kFollow && !order.route.empty() ? order.route.back() : order.goal;
}

// In the unit in which Port.unit says that people read it.
std::optional<double> shown_number(const FleetRobot& robot, const flow::Port& port) {
  const auto number = flow::Program::number(robot.workings().frame, port);
  const bool is_turned = port.edge_unit == "deg" && port.unit != "deg";
  return number && is_turned ? std::optional(*number * 180.0 / std::numbers::pi) : number;
}

std::optional<double> measure_robot(const run::MissionRun& run, const FleetRobot& robot,
                                    const Series& series) {
  if (robot.life == RobotLife::kNotStarted) return std::nullopt;
  switch (series.quantity()) {
    case Series::PORT: {
      if (!robot.workings().program) return std::nullopt;
      const flow::Port* port = robot.workings().program->find(series.port());
      return port == nullptr ? std::nullopt : shown_number(robot, *port);
    }
    case Series::DISTANCE_TO_GOAL: {
      const auto goal = goal_of(run, robot);
      if (!goal) return std::nullopt;
      return geom::distance(*goal, run.fleet().pose(robot).position);
    }
    case Series::FORMATION_ERROR:
      return run.fleet().station_error(robot);
    case Series::SPEED:
      return geom::length(run.world().body(robot.body).velocity);
    case Series::DISTANCE_DRIVEN:
      return run.world().body(robot.body).distance_driven;
    case Series::CONTACTS:
      return run.world().body(robot.body).contacts;
    case Series::NEAREST_OBSTACLE:
      return nearest_obstacle(run, robot);
    case Series::HEADING:
      return run.fleet().pose(robot).heading;
    default:
      return std::nullopt;
  }
}

// Of a unit: the distance of its centre from the goal, the sum of contacts, the nearest obstacle of all, the
// heading of its formation; of everything else the mean.
std::optional<double> measure_unit(const run::MissionRun& run, const mission::Unit& unit,
                                   const Series& series) {
  double sum = 0.0;
  double least = std::numeric_limits<double>::infinity();
  int count = 0;
  for (const base::RobotId id : unit.members) {
    const FleetRobot* robot = run.fleet().find(id);
    if (robot == nullptr) continue;
    const fleet::Group* group = run.fleet().group(*robot);
    if (group != nullptr && series.quantity() == Series::HEADING) return group->formation_heading;
    const auto goal = goal_of(run, *robot);
    if (goal && group != nullptr && group->has_center && series.quantity() == Series::DISTANCE_TO_GOAL)
      return geom::distance(*goal, group->center);
    const std::optional<double> value = measure_robot(run, *robot, series);
    if (!value) continue;
    sum += *value;
    least = std::min(least, *value);
    ++count;
  }
  if (count == 0) return std::nullopt;
  if (series.quantity() == Series::CONTACTS) return sum;
  if (series.quantity() == Series::NEAREST_OBSTACLE) return least;
  return sum / count;
}

}  // namespace

std::optional<double> measure(const run::MissionRun& run, const Series& series) {
  if (series.robot() != 0) {
    const FleetRobot* robot = run.fleet().find({series.robot()});
    return robot == nullptr ? std::nullopt : measure_robot(run, *robot, series);
  }
  const mission::Unit* unit = find_unit(run.mission(), series.unit());
  return unit == nullptr ? std::nullopt : measure_unit(run, *unit, series);
}

std::string problem_of(const run::MissionRun& run, const Series& series) {
  const FleetRobot* robot = nullptr;
  if (series.robot() != 0) {
    robot = run.fleet().find({series.robot()});
    if (robot == nullptr) return fmt::format("there is no robot {}", series.robot());
  } else {
    const mission::Unit* unit = find_unit(run.mission(), series.unit());
    if (unit == nullptr) return fmt::format("there is no unit `{}`", clean(series.unit()));
    if (!unit->members.empty()) robot = run.fleet().find(unit->members.front());
  }
  if (series.quantity() != Series::PORT || robot == nullptr) return "";
  if (!robot->workings().program) return "the robot has no program";
  const flow::Port* port = robot->workings().program->find(series.port());
  if (port == nullptr) return fmt::format("the program has no port `{}`", clean(series.port()));
  if (!flow::Program::number(robot->workings().frame, *port))
    return fmt::format("`{}` is no number", clean(series.port()));
  return "";
}

}  // namespace mlab::console
