#pragma once

#include "mlab/geography/geo_point.h"
#include "mlab/geom/pose.h"

namespace mlab::overlay {

using geography::GeoPoint;

/// The zone, 1..60, each 6 degrees wide, zone 1 beginning at 180 degrees west. The exceptions of Norway and
/// Svalbard are not made.
int utm_zone(double longitude_deg);
/// The middle of a zone.
constexpr double central_meridian_deg(int zone) {
  return zone * 6.0 - 183.0;
}
/// How far a place lies east of the middle of a zone, in [-180, 180] degrees.
double degrees_from_center(GeoPoint place, int zone);

/// Easting and northing [m], on the Clarke 1866 ellipsoid (6378206.4 m, 6356583.8 m) with scale 0.9996, false
/// easting 500 km and no false northing, as historic maps have them.
///
/// @param place  latitude within 84 degrees, and within kMaxZoneDistance of the middle of the zone; good to
/// centimetres there
/// @source J. P. Snyder, "Map Projections: A Working Manual", USGS Professional Paper 1395 (1987), equations
/// 8-9 to 8-15
geom::Offset utm_project(GeoPoint place, int zone);

inline constexpr double kMaxUtmLatitude = 84.0;  ///< [degrees]
inline constexpr double kMaxZoneDistance =
    9.0;  ///< of a place from the middle of the zone it is projected in [degrees]

}  // namespace mlab::overlay
