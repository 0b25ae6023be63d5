#pragma once

#include <cmath>

#include "mlab/geom/vector.h"
#include "mlab/percept/action.h"

namespace mlab::schema {

/// Turns the camera to where a vector points; one without length asks for nothing.
inline void look_along(percept::Action& action, geom::Vector where) {
  if (where.x == 0.0 && where.y == 0.0) return;
  action.pan = std::atan2(where.y, where.x);
  action.looks = true;
}

}  // namespace mlab::schema
