#pragma once

#include <cstdint>
#include <vector>

#include "mlab/geom/pose.h"
#include "mlab/overlay/overlay.h"

namespace mlab::overlay {

/// A straight piece of what a map has that robots may not cross.
struct Barrier {
  geom::Segment segment;      ///< [m]
  std::uint32_t group = 0;    ///< pieces of the same measure have the same one
  std::uint32_t measure = 0;  ///< its measure's place among those of the overlay
  bool is_solid = true;  ///< false: of the edge of an area that robots keep out of; nothing stops them there
};

/// What robots can't or may not cross: walls and weather, behind them the edges of areas to keep out of.
std::vector<Barrier> barriers(const Overlay& overlay);

}  // namespace mlab::overlay
