#pragma once

#include <algorithm>

#include "mlab/flow/port_types.h"
#include "mlab/geom/vector.h"
#include "mlab/percept/object_colors.h"
#include "mlab/percept/percepts.h"

namespace mlab::schema {

/// Whether a class belongs to a set of classes.
constexpr bool contains(flow::ObjectClasses classes, percept::ObjectClass one) {
  return classes.has(one);
}

using percept::color_of;
using percept::object_class_of_color;

/// From the robot's centre to an object's edge [m]; 0 inside it.
inline double edge_distance(const percept::ObjectReading& object) {
  return std::max(0.0, geom::length(object.center) - object.radius);
}

/// Whether an object of these classes has its edge within `range` [m].
bool sees(const percept::Percepts& percepts, flow::ObjectClasses classes, double range);

}  // namespace mlab::schema
