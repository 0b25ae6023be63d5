#pragma once

#include "mlab/geom/vector.h"
#include "mlab/percept/percepts.h"

namespace mlab::schema {

/// Whether a robot's centre is within `range` of this robot's [m].
inline bool is_within(const percept::RobotReading& robot, double range) {
  return geom::length(robot.center) <= range;
}

/// The robot whose centre is nearest, of percepts.robots or of an input; the first of several. Null where
/// there is none, else it lives as long as the cycle's percepts.
template <class Robots>
const percept::RobotReading* nearest_robot(const Robots& robots) {
  const percept::RobotReading* nearest = nullptr;
  for (const percept::RobotReading& robot : robots) {
    if (nearest == nullptr || geom::length(robot.center) < geom::length(nearest->center)) nearest = &robot;
  }
  return nearest;
}

/// How many robots have their centre within `range` [m].
template <class Robots>
int robots_within(const Robots& robots, double range) {
  int count = 0;
  for (const percept::RobotReading& robot : robots) count += is_within(robot, range) ? 1 : 0;
  return count;
}

}  // namespace mlab::schema
