#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mlab/ways/clearing.h"

namespace mlab::ways {

/// Which way something is gone round.
enum class Sense : std::int8_t { kClockwise = -1, kCounterClockwise = 1 };

/// A straight piece that touches two circles, each gone round in its sense.
struct Tangent {
  geom::Segment piece;
  double length = 0.0;  ///< [m]
};

/// Nothing where one circle lies in the other, or they cross and their senses differ.
/// A point is a circle of radius 0, whose sense means nothing.
std::optional<Tangent> tangent(const Round& from, Sense leaving, const Round& to, Sense meeting);

/// How far it is round a circle from one angle to the other in that sense, from 0 to less than a turn [rad].
double turned(double from, double to, Sense sense);

}  // namespace mlab::ways
