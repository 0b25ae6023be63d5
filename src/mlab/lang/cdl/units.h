#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mlab::cdl {

/// What a unit measures, and how much of the SI unit it is: numerator / denominator, so that 50 cm is exactly
/// 0.5 m where a product would be off by a bit.
struct Unit {
  int length = 0;
  int time = 0;
  int angle = 0;
  double numerator = 1.0;
  double denominator = 1.0;

  bool same_dimension(const Unit& other) const {
    return length == other.length && time == other.time && angle == other.angle;
  }
};

/// `m`, `cm`, `km/h`, `deg/s`, ...; the empty unit is that of plain numbers. Nothing where nobody knows it.
std::optional<Unit> unit_named(std::string_view name);
/// All base units, for "did you mean".
const std::vector<std::string>& unit_names();

/// The value in another unit. Nothing where they measure different things.
std::optional<double> converted(double value, const Unit& from, const Unit& to);

}  // namespace mlab::cdl
