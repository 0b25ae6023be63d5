#include "mlab/vehicle/earth.h"

#include <cmath>

namespace mlab::vehicle {
namespace {

// So short that its direction is that of the meridian to 1e-9 rad, so long that its ends are told apart as
// well: some hundred metres [degrees].
constexpr double kHalf = 5e-4;

}  // namespace

double north_at(const geography::Projection& map, geography::GeoPoint place) {
  const geom::Point south = map.to_world({place.latitude_deg - kHalf, place.longitude_deg});
  const geom::Point north = map.to_world({place.latitude_deg + kHalf, place.longitude_deg});
  const geom::Offset way = north - south;
  return std::atan2(way.y, way.x);
}

}  // namespace mlab::vehicle
