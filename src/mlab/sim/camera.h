#pragma once

#include "mlab/geom/vector.h"
#include "mlab/sim/body.h"

namespace mlab::sim {

/// Where the camera looks one cycle later.
/// @param pan     now, in (-pi, pi], counter-clockwise from ahead [rad]
/// @param wanted  [rad]; beyond the camera's limits it goes as far as it can, and a wish that is no number is
/// none
/// @param dt      [s], > 0
double turned_camera(const CameraSpec& camera, double pan, double wanted, double dt);

/// What of its surroundings a camera sees.
class FieldOfView {
 public:
  FieldOfView(const CameraSpec& camera, double pan);
  /// @param center  of the thing [m, robot frame]
  bool contains(geom::Vector center) const;

 private:
  bool is_all_round_;
  geom::Vector axis_;
  double cosine_ = 0.0;  ///< of half the field of view
};

}  // namespace mlab::sim
