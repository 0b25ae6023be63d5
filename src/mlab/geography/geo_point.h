#pragma once

namespace mlab::geography {

/// Where a place lies on the Earth, in decimal degrees: north and east are positive.
struct GeoPoint {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;

  friend constexpr bool operator==(GeoPoint, GeoPoint) = default;
};

/// UTM and MGRS end at these latitudes, and so do maps: beyond them the grids are polar ones [degrees].
inline constexpr double kSouthernmost = -80.0;
inline constexpr double kNorthernmost = 84.0;
constexpr bool is_between_the_caps(GeoPoint place) {
  return place.latitude_deg >= kSouthernmost && place.latitude_deg <= kNorthernmost;
}

}  // namespace mlab::geography
