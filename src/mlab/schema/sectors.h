#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "mlab/geom/vector.h"
#include "mlab/schema/constants.h"

namespace mlab::schema {

/// Twelve sectors of 30 degrees around the robot; sector 0 is centred straight ahead, 3 to the left, 9 to the
/// right.
class Sectors {
 public:
  static constexpr int kCount = 12;

  static std::size_t index(geom::Vector toward) {
    const long turned = std::lround(geom::direction(toward) / kWidth);  // -6 .. 6
    return static_cast<std::size_t>((turned + kCount) % kCount);
  }
  void block(geom::Vector toward) { is_blocked_[index(toward)] = true; }

  /// Into the middle of the clear sector nearest to straight ahead, left before right; length 1 ahead,
  /// falling by 1/6 with each sector off it. Zero where all are blocked, and where only the one behind is
  /// clear.
  geom::Vector freest() const {
    for (int off = 0; off <= kCount / 2; ++off) {
      const double strength = 1.0 - off / 6.0;
      if (!is_blocked_[static_cast<std::size_t>(off)]) return geom::polar(strength, off * kWidth);
      if (!is_blocked_[static_cast<std::size_t>((kCount - off) % kCount)])
        return geom::polar(strength, -off * kWidth);
    }
    return {};
  }

 private:
  static constexpr double kWidth = 2.0 * kPi / kCount;
  std::array<bool, kCount> is_blocked_{};
};

}  // namespace mlab::schema
