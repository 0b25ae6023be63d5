#pragma once

#include <span>
#include <vector>

#include "mlab/base/random.h"
#include "mlab/binding/world_view.h"
#include "mlab/geom/pose.h"
#include "mlab/percept/percepts.h"

namespace mlab::model_vehicles {

/// What ultrasonic sensors do besides measuring.
struct SonarSpec {
  double nearest = 0.15;     ///< what is nearer is heard as this far [m]
  double range = 7.0;        ///< [m]
  double beam_width = 0.26;  ///< full angle [rad]
  double noise = 0.02;       ///< standard deviation [m]
  double dropout = 0.01;     ///< chance that an echo is not heard, 0 .. 1
  /// A wall that is heard under a larger angle than this from straight on throws the sound elsewhere, and is
  /// not heard; its ends always are. pi/2: none does [rad]
  double glancing = 0.44;
};

/// Whether what a beam hears is the smooth side of a wall under a larger angle than `glancing`.
/// @param pose      of the vehicle; beams begin in its middle
/// @param axis      of the beam [rad, robot frame]
/// @param distance  at which something is heard, from the middle [m]
bool is_thrown_elsewhere(const SonarSpec& spec, const geom::Pose& pose, double axis, double distance,
                         std::span<const binding::Wall> walls);

/// What the sensors tell of what is there.
/// @param edge      radius of the vehicle [m]
/// @param readings  what is there, from its edge
/// @return  by sensor, from its edge [m]; infinite: no echo
std::vector<float> heard(const SonarSpec& spec, const geom::Pose& pose, double edge,
                         std::span<const percept::RangeReading> readings,
                         std::span<const binding::Wall> walls, base::Random& random);

}  // namespace mlab::model_vehicles
