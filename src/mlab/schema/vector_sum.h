#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "mlab/geom/vector.h"
#include "mlab/schema/constants.h"

namespace mlab::schema {

/// Whether a vector, and a number that goes with it, can be counted on. The rest of a robot's members can't
/// make good for one that can't: an operator hands on not_a_number() then, and whoever runs the robot tells
/// of it.
inline bool is_finite(geom::Vector v, double number = 0.0) {
  return std::isfinite(v.x + v.y + v.z + number);
}
inline geom::Vector not_a_number() {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  return {kNone, kNone, kNone};
}

/// As geom::unit, and no number for a vector that is none.
inline geom::Vector toward(geom::Vector v) {
  return is_finite(v) ? geom::unit(v) : not_a_number();
}

/// Adds up vectors among which some may be absolute demands (strength kAbsolute and more).
///
/// The total is the plain sum, with one exception: where absolute demands cancel each other (two obstacles on
/// opposite sides), nothing but rounding noise is left of them, millions of times smaller than they were and
/// yet larger than any ordinary vector. Then the ordinary vectors alone decide. With a vector that is not
/// finite among them the total is no number.
class VectorSum {
 public:
  void add(geom::Vector v) {
    // What is no number stays in the sum, whatever else is in it: comparisons with it would drop it.
    if (!is_finite(v)) ordinary_ = not_a_number();
    const double strength = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (strength < kAbsolute) {
      ordinary_ += v;
    } else {
      absolute_ += v;
      absolute_strength_ += strength;
    }
  }

  geom::Vector total() const {
    const double left = std::max({std::abs(absolute_.x), std::abs(absolute_.y), std::abs(absolute_.z)});
    return left > kCancelled * absolute_strength_ ? absolute_ + ordinary_ : ordinary_;
  }

 private:
  static constexpr double kCancelled = 1e-9;  // share of what was added that counts as rounding

  geom::Vector ordinary_;
  geom::Vector absolute_;
  double absolute_strength_ = 0.0;
};

}  // namespace mlab::schema
