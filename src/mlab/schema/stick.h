#pragma once

#include "mlab/geom/pose.h"

namespace mlab::schema {

/// The direction in which a stick is pushed, as a unit vector in the robot frame; zero for a stick at rest.
///
/// @param x, y            of the stick: to the right, up
/// @param is_robot_frame  up is ahead of the robot; else up is north
/// @param heading         of the robot [rad, world]
inline geom::Vector stick_direction(double x, double y, bool is_robot_frame, double heading) {
  if (is_robot_frame) return geom::unit({y, -x, 0.0});
  const geom::Vector pushed = geom::unit({x, y, 0.0});
  return geom::Pose{{}, heading}.to_robot(geom::Offset{pushed.x, pushed.y});
}

}  // namespace mlab::schema
