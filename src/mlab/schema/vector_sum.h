#pragma once

#include <algorithm>
#include <cmath>

#include "mlab/geom/vector.h"
#include "mlab/schema/constants.h"

namespace mlab::schema {

/// Adds up vectors among which some may be absolute demands (strength kAbsolute and more).
///
/// The total is the plain sum, with one exception: where absolute demands cancel each other (two obstacles on
/// opposite sides), nothing but rounding noise is left of them, millions of times smaller than they were and
/// yet larger than any ordinary vector. Then the ordinary vectors alone decide.
class VectorSum {
 public:
  void add(geom::Vector v) {
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
