#include "mlab/sim/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mlab/base/angle.h"

namespace mlab::sim {

using std::numbers::pi;

double turned_camera(const CameraSpec& camera, double pan, double wanted, double dt) {
  if (!std::isfinite(wanted)) return pan;
  wanted = base::wrap_angle(wanted);
  const bool is_endless = camera.max_pan >= pi;
  if (!is_endless) wanted = std::clamp(wanted, -camera.max_pan, camera.max_pan);
  // With an end stop the way behind the robot is closed.
  double way = is_endless ? base::wrap_angle(wanted - pan) : wanted - pan;
  if (camera.max_pan_rate > 0.0) way = std::clamp(way, -camera.max_pan_rate * dt, camera.max_pan_rate * dt);
  return base::wrap_angle(pan + way);
}

FieldOfView::FieldOfView(const CameraSpec& camera, double pan)
    : is_all_round_(camera.field_of_view >= 2.0 * pi) {
  if (is_all_round_) return;
  axis_ = {std::cos(pan), std::sin(pan), 0.0};
  cosine_ = std::cos(camera.field_of_view / 2.0);
}

bool FieldOfView::contains(geom::Vector center) const {
  return is_all_round_ || geom::dot(axis_, center) >= cosine_ * geom::length(center);
}

}  // namespace mlab::sim
