#pragma once

#include "mlab/geography/geo_point.h"
#include "mlab/geom/pose.h"

namespace mlab::geography {

/// How the world's plane (x east, y north, metres) lies on the Earth: a transverse Mercator projection.
///
/// A map's own has its origin's meridian as its middle, and scale 1 there. It is conformal: headings and
/// shapes are as on the ground, north is up along that meridian, and lengths are longer by (x / 6371 km)² /
/// 2: at 10 km from the meridian by 1.2 mm each kilometre, so what lies 10 km away is there to 5 mm.
/// @source  C. F. F. Karney, "Transverse Mercator with an accuracy of a few nanometers", J. Geodesy 85 (2011)
struct Projection {
  double semi_major = 0.0;            ///< of the ellipsoid [m]
  double flattening = 0.0;            ///< of the ellipsoid
  double scale = 1.0;                 ///< along the middle meridian
  double central_meridian_deg = 0.0;  ///< [degrees], east is positive
  geom::Offset origin;                ///< where the world's (0, 0) is, from equator and middle meridian [m]

  friend constexpr bool operator==(const Projection&, const Projection&) = default;

  /// The map whose (0, 0) lies at a place: WGS 84, scale 1.
  /// @param origin  a latitude within 90 degrees, and a longitude that is finite
  static Projection around(GeoPoint origin);
  /// The grid of a UTM zone on the Clarke 1866 ellipsoid, as historic maps have it (`ORIGIN UTM`).
  /// @param zone    1..60
  /// @param origin  easting and northing of the world's (0, 0): false easting 500 km, no false northing [m]
  static Projection historic_grid(int zone, geom::Offset origin);

  /// @return  where a place lies in the world; exact to a micrometre up to `kReach`
  geom::Point to_world(GeoPoint place) const;
  /// @return  the place of a world point, longitude within 180 degrees
  GeoPoint to_earth(geom::Point point) const;
};

/// Farther than this from its origin a map has no places that are written as such: at its end lengths are
/// longer by 12 cm each kilometre [m].
inline constexpr double kReach = 100e3;

/// Length of the shortest way between two places on the WGS 84 ellipsoid [m].
double distance_on_earth(GeoPoint a, GeoPoint b);

}  // namespace mlab::geography
