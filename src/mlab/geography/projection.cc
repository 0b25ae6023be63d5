#include "mlab/geography/projection.h"

#include <GeographicLib/Constants.hpp>
#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/TransverseMercator.hpp>

namespace mlab::geography {
namespace {

constexpr double kClarkeSemiMajor = 6378206.4;
constexpr double kClarkeSemiMinor = 6356583.8;
constexpr double kUtmScale = 0.9996;
constexpr double kUtmFalseEasting = 500000.0;

geom::Offset forward(const Projection& on, GeoPoint place) {
  const GeographicLib::TransverseMercator mercator(on.semi_major, on.flattening, on.scale);
  geom::Offset out;
  mercator.Forward(on.central_meridian_deg, place.latitude_deg, place.longitude_deg, out.x, out.y);
  return out;
}

}  // namespace

Projection Projection::around(GeoPoint origin) {
  Projection out{GeographicLib::Constants::WGS84_a(),
                 GeographicLib::Constants::WGS84_f(),
                 1.0,
                 origin.longitude_deg,
                 {}};
  out.origin = forward(out, origin);
  return out;
}

Projection Projection::historic_grid(int zone, geom::Offset origin) {
  return {kClarkeSemiMajor, 1.0 - kClarkeSemiMinor / kClarkeSemiMajor, kUtmScale, zone * 6.0 - 183.0,
          origin - geom::Offset{kUtmFalseEasting, 0.0}};
}

geom::Point Projection::to_world(GeoPoint place) const {
  return geom::Point{} + (forward(*this, place) - origin);
}

GeoPoint Projection::to_earth(geom::Point point) const {
  const GeographicLib::TransverseMercator mercator(semi_major, flattening, scale);
  const geom::Point at = point + origin;
  GeoPoint out;
  mercator.Reverse(central_meridian_deg, at.x, at.y, out.latitude_deg, out.longitude_deg);
  return out;
}

double distance_on_earth(GeoPoint a, GeoPoint b) {
  double out = 0.0;
  GeographicLib::Geodesic::WGS84().Inverse(a.latitude_deg, a.longitude_deg, b.latitude_deg, b.longitude_deg,
                                           out);
  return out;
}

}  // namespace mlab::geography
