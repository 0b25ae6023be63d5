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

  /// What a product, or with `sign` -1 a quotient, measures: in SI units.
  Unit times(const Unit& other, int sign = 1) const {
    return {length + sign * other.length, time + sign * other.time, angle + sign * other.angle, 1.0, 1.0};
  }
  /// The number in SI units.
  double in_si(double value) const {
    return numerator == denominator ? value : value * numerator / denominator;
  }
  bool same_dimension(const Unit& other) const {
    return length == other.length && time == other.time && angle == other.angle;
  }
};

/// `m`, `cm`, `km/h`, `deg/s`, ...; the empty unit is that of plain numbers. Nothing where nobody knows it.
/// Also products of units, as arithmetic makes them: `m*m`, `m/s/s`, `1/s`.
std::optional<Unit> unit_named(std::string_view name);
/// The SI unit of what this one measures: `m/s` of `km/h`; of plain numbers none.
std::string si_unit(const Unit& unit);
/// All base units, for "did you mean".
const std::vector<std::string>& unit_names();

/// The value in another unit. Nothing where they measure different things.
std::optional<double> converted(double value, const Unit& from, const Unit& to);

}  // namespace mlab::cdl
