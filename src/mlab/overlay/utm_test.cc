#include "mlab/overlay/utm.h"

#include <gtest/gtest.h>

namespace mlab::overlay {
namespace {

TEST(UtmProject, AgreesWithThePublishedExample) {
  // Snyder, page 269: 40 30' N, 73 30' W, Clarke 1866, central meridian 75 W: x = 127,106.5 m, y =
  // 4,484,124.4 m.
  const GeoPoint place{40.5, -73.5};
  EXPECT_EQ(utm_zone(place.longitude_deg), 18);
  const geom::Offset at = utm_project(place, 18);
  EXPECT_NEAR(at.x, 500000.0 + 127106.5, 0.06);
  EXPECT_NEAR(at.y, 4484124.4, 0.06);
}

TEST(UtmProject, IsMirroredInTheEquatorAndInTheCentralMeridian) {
  const geom::Offset north_east = utm_project({30.0, 4.0}, 31);
  const geom::Offset south_west = utm_project({-30.0, 2.0}, 31);
  EXPECT_NEAR(north_east.y, -south_west.y, 1e-6);
  EXPECT_NEAR(north_east.x - 500000.0, 500000.0 - south_west.x, 1e-6);
}

TEST(UtmProject, PutsTheCentralMeridianAtTheFalseEasting) {
  EXPECT_DOUBLE_EQ(utm_project({33.8, -87.0}, 16).x, 500000.0);
  EXPECT_DOUBLE_EQ(utm_project({0.0, -87.0}, 16).y, 0.0);
}

TEST(UtmZone, IsRightForWestLongitudes) {
  EXPECT_EQ(utm_zone(-84.4), 16);  // Atlanta
  EXPECT_EQ(central_meridian_deg(16), -87.0);
  EXPECT_EQ(utm_zone(-180.0), 1);
  EXPECT_EQ(utm_zone(-0.1), 30);
  EXPECT_EQ(utm_zone(0.0), 31);
  EXPECT_EQ(utm_zone(179.9), 60);
}

TEST(UtmZone, CountsLongitudesPastAHalfTurn) {
  EXPECT_EQ(utm_zone(275.6), 16);
}

TEST(DegreesFromCenter, GoesTheShortWayAcrossTheDateLine) {
  EXPECT_NEAR(degrees_from_center({0.0, -179.5}, 60), 3.5, 1e-9);
}

}  // namespace
}  // namespace mlab::overlay
