#pragma once

#include <algorithm>
#include <optional>
#include <string_view>

#include "mlab/flow/port_types.h"
#include "mlab/geom/vector.h"
#include "mlab/percept/percepts.h"

namespace mlab::schema {

/// Whether a class belongs to a set of classes.
constexpr bool contains(flow::ObjectClasses classes, percept::ObjectClass one) {
  return classes.has(one);
}

/// The colour that marks a class of objects, in small letters: `orange`, `dark sea green`.
std::string_view color_of(percept::ObjectClass object_class);
/// The class that a colour marks, letter case aside; none where no class has it.
std::optional<percept::ObjectClass> object_class_of_color(std::string_view color);

/// From the robot's centre to an object's edge [m]; 0 inside it.
inline double edge_distance(const percept::ObjectReading& object) {
  return std::max(0.0, geom::length(object.center) - object.radius);
}

/// Whether an object of these classes has its edge within `range` [m].
bool sees(const percept::Percepts& percepts, flow::ObjectClasses classes, double range);

}  // namespace mlab::schema
