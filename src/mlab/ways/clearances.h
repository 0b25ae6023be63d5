#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace mlab::ways {

/// What a body's centre keeps from things, widest first: all of its margin, and where no way is so wide a
/// half of it, a quarter, at last a tenth of a metre.
class Clearances {
 public:
  /// One that does not bend [m], >= 0.
  Clearances(double only) : Clearances(only, 0.0) {}
  /// @param radius, margin  [m], >= 0
  Clearances(double radius, double margin) : radius_(radius) {
    const double least = radius + std::min(margin, kLeastMargin);
    for (const double share : {1.0, 0.5, 0.25}) {
      if (radius + share * margin > least) values_[count_++] = radius + share * margin;
    }
    values_[count_++] = least;
  }

  std::span<const double> all() const { return std::span(values_).first(count_); }
  double widest() const { return values_[0]; }
  double least() const { return values_[count_ - 1]; }
  /// Those of the same body whose margin is what it keeps at one of these.
  Clearances bent(std::size_t to) const { return {radius_, values_[to] - radius_}; }

 private:
  static constexpr double kLeastMargin = 0.1;  // [m]
  double radius_;
  std::array<double, 4> values_{};
  std::size_t count_ = 0;
};

}  // namespace mlab::ways
