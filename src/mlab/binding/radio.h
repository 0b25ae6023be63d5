#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "mlab/binding/body.h"

namespace mlab::binding {

/// What a wall takes from a signal [%].
/// @source  COST 231 (1999), "Digital Mobile Radio Towards Future Generation Systems", section 4.7:
///          light walls take some 3.4 dB, others 6.9; here 5 dB of the 50 between a signal at 1 m and the
///          faintest that is heard
inline constexpr double kWallLoss = 10.0;

/// How strong a signal is, of what it is within 1 m [%]; 0: it is not heard. It falls with the logarithm of
/// the distance (so evenly in decibels), and by the same for each wall in between.
/// @param distance  [m], >= 0
/// @param range     of the weaker of the two radios [m]; 0: endless
/// @param walls     in between
/// @source  Rappaport 2002, "Wireless Communications", section 4.9 (log-distance path loss);
///          Motley and Keenan 1988, "Personal communication radio coverage in buildings at 900 MHz and
///          1700 MHz", Electronics Letters 24(12)
inline double signal_strength(double distance, double range, std::uint32_t walls) {
  if (range == 0.0) return 100.0;
  if (!(distance < range)) return 0.0;
  const double in_the_open = distance <= 1.0 ? 100.0 : 100.0 * (1.0 - std::log(distance) / std::log(range));
  return std::max(in_the_open - kWallLoss * walls, 0.0);
}

/// Of two radios: that of the weaker one, for each hears the other or neither does [m]; 0: endless.
inline double common_range(const RadioSpec& a, const RadioSpec& b) {
  if (a.range == 0.0 || b.range == 0.0) return std::max(a.range, b.range);
  return std::min(a.range, b.range);
}

/// Who hears whom in a cycle. What is heard is passed on, so whoever is linked over others hears what they
/// hear.
class RadioLinks {
 public:
  RadioLinks() = default;
  RadioLinks(const RadioLinks&) = delete;
  RadioLinks& operator=(const RadioLinks&) = delete;
  virtual ~RadioLinks() = default;

  /// A number that those have in common who are linked.
  virtual std::uint32_t net_of(BodyIndex body) const = 0;
  /// Whether something that one tells in this cycle arrives at the other: they are linked, and it is not
  /// lost. Asked again: the same.
  virtual bool arrives(BodyIndex from, BodyIndex to) const = 0;
  /// Whether what it tells may be lost on the way to whom it is linked with.
  virtual bool loses(BodyIndex from) const = 0;
};

}  // namespace mlab::binding
