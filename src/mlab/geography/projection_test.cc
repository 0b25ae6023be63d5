#include "mlab/geography/projection.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/base/angle.h"

namespace mlab::geography {
namespace {

constexpr GeoPoint kOrigins[] = {{48.2082, 16.3738}, {-33.8568, 151.2153}, {0.0, 0.0},
                                 {69.6492, 18.9553}, {-54.8019, -68.3030}, {52.0, 179.999},
                                 {-17.7134, -180.0}, {33.7774, -84.3973}};

struct Cartesian {
  double x, y, z;
};

// On WGS 84, by the textbook's formula: nothing of it is GeographicLib's.
Cartesian geocentric(GeoPoint place, double height = 0.0) {
  constexpr double kA = 6378137.0;
  constexpr double kF = 1.0 / 298.257223563;
  constexpr double kE2 = kF * (2.0 - kF);
  const double lat = base::radians(place.latitude_deg);
  const double lon = base::radians(place.longitude_deg);
  const double n = kA / std::sqrt(1.0 - kE2 * std::sin(lat) * std::sin(lat));
  return {(n + height) * std::cos(lat) * std::cos(lon), (n + height) * std::cos(lat) * std::sin(lon),
          (n * (1.0 - kE2) + height) * std::sin(lat)};
}

// East and north of a place in the plane that touches the Earth at the origin.
geom::Point in_tangent_plane(GeoPoint origin, GeoPoint place) {
  const Cartesian a = geocentric(origin);
  const Cartesian b = geocentric(place);
  const Cartesian d{b.x - a.x, b.y - a.y, b.z - a.z};
  const double lat = base::radians(origin.latitude_deg);
  const double lon = base::radians(origin.longitude_deg);
  return {-std::sin(lon) * d.x + std::cos(lon) * d.y,
          -std::sin(lat) * std::cos(lon) * d.x - std::sin(lat) * std::sin(lon) * d.y + std::cos(lat) * d.z};
}

geom::Point around(double distance, int sixteenths) {
  const double angle = sixteenths * std::numbers::pi / 8.0;
  return {distance * std::cos(angle), distance * std::sin(angle)};
}

TEST(Projection, PutsItsOriginAtZero) {
  for (const GeoPoint origin : kOrigins) {
    const geom::Point at = Projection::around(origin).to_world(origin);
    EXPECT_NEAR(at.x, 0.0, 1e-9);
    EXPECT_NEAR(at.y, 0.0, 1e-8);
  }
}

TEST(Projection, IsRightToACentimetreAtTenKilometresInTheTangentPlane) {
  for (const GeoPoint origin : kOrigins) {
    const Projection projection = Projection::around(origin);
    for (int direction = 0; direction < 16; ++direction) {
      const geom::Point at = around(10e3, direction);
      EXPECT_LT(distance(in_tangent_plane(origin, projection.to_earth(at)), at), 0.01)
          << origin.latitude_deg << " " << direction;
    }
  }
}

TEST(Projection, KeepsDistancesToACentimetreAtTenKilometres) {
  for (const GeoPoint origin : kOrigins) {
    const Projection projection = Projection::around(origin);
    for (int direction = 0; direction < 16; ++direction)
      EXPECT_NEAR(distance_on_earth(origin, projection.to_earth(around(10e3, direction))), 10e3, 0.01);
  }
}

TEST(Projection, LengthensByWhatItsHeaderSays) {
  const GeoPoint origin{48.0, 16.0};
  const Projection projection = Projection::around(origin);
  // A metre, 100 km east of the meridian: (100 / 6371)^2 / 2 = 1.23e-4.
  const double metre =
      distance_on_earth(projection.to_earth({kReach, 0.0}), projection.to_earth({kReach + 1.0, 0.0}));
  EXPECT_NEAR(1.0 - metre, 1.23e-4, 0.02e-4);
}

RC_GTEST_PROP(Projection, GoesThereAndBackToAMicrometre, ()) {
  const auto between = [](int low, int high) { return *rc::gen::inRange(low * 1000, high * 1000) / 1000.0; };
  const Projection projection = Projection::around({between(-80, 84), between(-180, 180)});
  const geom::Point at{between(-100000, 100000), between(-100000, 100000)};
  RC_ASSERT(distance(projection.to_world(projection.to_earth(at)), at) < 1e-6);
}

TEST(Projection, GoesAcrossTheDateLine) {
  const Projection projection = Projection::around({0.0, 179.999});
  const geom::Point beyond = projection.to_world({0.0, -179.999});
  EXPECT_NEAR(beyond.x, 0.002 * 6378137.0 * std::numbers::pi / 180.0, 1e-4);
  EXPECT_NEAR(projection.to_earth({1000.0, 0.0}).longitude_deg, 179.999 - 360.0 + 0.008983, 1e-6);
}

TEST(Projection, IsTheHistoricGridWhereThatIsAskedFor) {
  // Snyder, page 269: 40 30' N, 73 30' W, Clarke 1866, zone 18: x = 627,106.5 m, y = 4,484,124.4 m.
  const Projection grid = Projection::historic_grid(18, {600000.0, 4484000.0});
  const geom::Point at = grid.to_world({40.5, -73.5});
  EXPECT_NEAR(at.x, 27106.5, 0.06);
  EXPECT_NEAR(at.y, 124.4, 0.06);
}

}  // namespace
}  // namespace mlab::geography
