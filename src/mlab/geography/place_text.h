#pragma once

#include <string_view>

#include "mlab/geography/geo_point.h"
#include "mlab/text/diagnostic.h"

namespace mlab::geography {

/// Reads a place on the Earth, in whichever of these it is written:
///
///     48.2082 16.3738                    degrees, latitude first, north and east positive
///     48.2082 N 16.3738 E                letters before or behind, then in any order
///     48°12'29.52'' N 16°22'25.68'' E    minutes and seconds; blanks do as marks, too
///     33N 602065.21 5340353.59           UTM: zone, hemisphere, easting and northing [m]
///     33UXP0206540353                    MGRS: the south-western corner of the square; 2 to 14 digits
///
/// Commas are blanks; letter case does not count.
/// @errors  `place-not-understood`, `place-out-of-range` (what was seen and what is expected), `place-polar`
/// (beyond 80 S or 84 N). Without a place in a source: who calls knows where the text stands.
[[nodiscard]] text::Result<GeoPoint> read_place(std::string_view text);

}  // namespace mlab::geography
