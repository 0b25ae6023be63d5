#pragma once

#include <optional>
#include <string>

#include "mlab/text/diagnostic.h"

namespace mlab::odl {

/// A map-info file, which LOAD-MAP names: a picture and the rectangle of the world that it covers. `#` begins
/// a comment line.
///
///     marc.pgm
///     0 0  45 45
struct MapInfo {
  std::string picture;  ///< as written
  double x = 0.0;       ///< lower left corner [m]
  double y = 0.0;
  double width = 0.0;  ///< [m], > 0
  double height = 0.0;
  bool sets_area = false;  ///< a map scale was given: the picture's size becomes the mission area
};

/// Pixels of a map scaled 1:n are this many to the metre, times n: the historic screen's.
inline constexpr double kPixelsPerScaledMetre = 3272.0;

/// @errors  `map-info-syntax`, `number-out-of-range`: then nothing is returned. More lines are a warning,
///          `map-info-extra-line`
std::optional<MapInfo> parse_map_info(const text::SourcePtr& source, text::Diagnostics& sink);

}  // namespace mlab::odl
