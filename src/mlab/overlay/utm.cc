#include "mlab/overlay/utm.h"

#include <algorithm>
#include <cmath>

#include "mlab/base/angle.h"

namespace mlab::overlay {
namespace {

constexpr double kSemiMajor = 6378206.4;
constexpr double kSemiMinor = 6356583.8;
constexpr double kScale = 0.9996;
constexpr double kFalseEasting = 500000.0;
constexpr double kE2 = 1.0 - (kSemiMinor * kSemiMinor) / (kSemiMajor * kSemiMajor);  // eccentricity, squared

// Length of the meridian from the equator to the latitude [m], equation 3-21.
double meridian_length(double latitude) {
  constexpr double kE4 = kE2 * kE2;
  constexpr double kE6 = kE4 * kE2;
  return kSemiMajor * ((1.0 - kE2 / 4.0 - 3.0 * kE4 / 64.0 - 5.0 * kE6 / 256.0) * latitude -
                       (3.0 * kE2 / 8.0 + 3.0 * kE4 / 32.0 + 45.0 * kE6 / 1024.0) * std::sin(2.0 * latitude) +
                       (15.0 * kE4 / 256.0 + 45.0 * kE6 / 1024.0) * std::sin(4.0 * latitude) -
                       (35.0 * kE6 / 3072.0) * std::sin(6.0 * latitude));
}

}  // namespace

int utm_zone(double longitude_deg) {
  const double west = std::remainder(longitude_deg, 360.0) + 180.0;
  return std::clamp(static_cast<int>(std::floor(west / 6.0)) + 1, 1, 60);
}

double degrees_from_center(GeoPoint place, int zone) {
  return std::remainder(place.longitude_deg - central_meridian_deg(zone), 360.0);
}

geom::Offset utm_project(GeoPoint place, int zone) {
  constexpr double kEp2 = kE2 / (1.0 - kE2);
  const double latitude = base::radians(place.latitude_deg);
  const double sine = std::sin(latitude);
  const double cosine = std::cos(latitude);
  const double tangent = std::tan(latitude);
  // The letters are Snyder's: N radius of curvature, T, C and A powers of the angles.
  const double n = kSemiMajor / std::sqrt(1.0 - kE2 * sine * sine);
  const double t = tangent * tangent;
  const double c = kEp2 * cosine * cosine;
  const double a = base::radians(degrees_from_center(place, zone)) * cosine;
  const double a2 = a * a;
  const double x =
      kScale * n * a *
      (1.0 + (1.0 - t + c) * a2 / 6.0 + (5.0 - 18.0 * t + t * t + 72.0 * c - 58.0 * kEp2) * a2 * a2 / 120.0);
  const double y =
      kScale * (meridian_length(latitude) +
                n * tangent *
                    (a2 / 2.0 + (5.0 - t + 9.0 * c + 4.0 * c * c) * a2 * a2 / 24.0 +
                     (61.0 - 58.0 * t + t * t + 600.0 * c - 330.0 * kEp2) * a2 * a2 * a2 / 720.0));
  return {kFalseEasting + x, y};
}

}  // namespace mlab::overlay
