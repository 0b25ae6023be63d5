#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "mlab/geom/pose.h"

namespace mlab::ways {

/// Why a planned way ends where it does.
enum class WayEnd : std::uint32_t {
  kNowhere,     ///< there is no way
  kGoal,        ///< it is there
  kBesideGoal,  ///< something stands at the goal; this is the nearest place to it
  kClosedOff,   ///< no way leads farther towards it
  kFull         ///< it goes on, and has no room for more corners
};

/// A way as it is passed on: of bounded length, copied byte by byte.
struct PlannedWay {
  static constexpr std::size_t kMostCorners = 48;

  std::array<geom::Point, kMostCorners> corners{};  ///< from where it begins to where it ends [m, world]
  double clearance = 0.0;     ///< that it keeps from all that was known, but for its ends [m]
  std::uint16_t count = 0;    ///< of the corners; 0: there is no way
  std::uint16_t version = 0;  ///< another one: it was planned anew
  WayEnd end = WayEnd::kNowhere;

  /// Whatever somebody else's program has left in `count`.
  std::span<const geom::Point> points() const {
    return std::span(corners).first(count <= kMostCorners ? count : kMostCorners);
  }
};

}  // namespace mlab::ways
