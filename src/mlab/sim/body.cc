#include "mlab/sim/body.h"

#include <algorithm>
#include <numbers>

namespace mlab::sim {
namespace {

/// Nothing is sensed farther away [m]: twice the way across the largest world.
constexpr double kLongestRange = 6e8;

double within(double value, double most) {
  return value >= 0.0 ? std::min(value, most) : 0.0;
}

}  // namespace

double usable_range(double range) {
  return range > 0.0 ? std::min(range, kLongestRange) : 0.0;
}

BodySpec usable(BodySpec spec) {
  spec.radius = spec.radius >= 0.0 ? std::min(spec.radius, 1e4) : 0.0;
  spec.ring.range = usable_range(spec.ring.range);
  spec.camera.field_of_view = within(spec.camera.field_of_view, 2.0 * std::numbers::pi);
  spec.camera.max_pan = within(spec.camera.max_pan, std::numbers::pi);
  spec.ring.arc = spec.ring.arc > 0.0 && spec.ring.arc < 2.0 * std::numbers::pi ? spec.ring.arc : 0.0;
  spec.radio.range = usable_range(spec.radio.range);
  spec.radio.loss = within(spec.radio.loss, 1.0);
  spec.odometry_noise = spec.odometry_noise > 0.0 ? std::min(spec.odometry_noise, 1.0) : 0.0;
  return spec;
}

}  // namespace mlab::sim
