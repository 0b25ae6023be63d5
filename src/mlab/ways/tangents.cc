#include "mlab/ways/tangents.h"

#include <algorithm>
#include <cmath>

#include "mlab/ways/turn.h"

namespace mlab::ways {

// Whoever goes along the unit vector u round a circle counter-clockwise has its centre on the left, so the
// circle is touched at c - r left(u); clockwise at c + r left(u). With s, the difference of the signed radii,
// the centres lie L u + s left(u) apart.
std::optional<Tangent> tangent(const Round& from, Sense leaving, const Round& to, Sense meeting) {
  const double first = from.radius * static_cast<double>(leaving);
  const double second = to.radius * static_cast<double>(meeting);
  const geom::Offset between = to.center - from.center;
  const double square = dot(between, between);
  const double s = second - first;
  const double rest = square - s * s;
  // Who stands at the edge may be a little inside.
  if (square <= 0.0 || rest < -4.0 * Clearing::kTolerance * std::sqrt(square)) return std::nullopt;
  const double length = std::sqrt(std::max(0.0, rest));
  const geom::Offset u{(length * between.x + s * between.y) / square,
                       (length * between.y - s * between.x) / square};
  const geom::Offset left{-u.y, u.x};
  return Tangent{{from.center - left * first, to.center - left * second}, length};
}

double turned(double from, double to, Sense sense) {
  return in_turn((to - from) * static_cast<double>(sense));
}

}  // namespace mlab::ways
