#include "mlab/geography/notation.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/geography/place_text.h"
#include "mlab/geography/projection.h"

namespace mlab::geography {
namespace {

TEST(UtmOf, AgreesWithPublishedPlaces) {
  // The CN Tower: 43 38' 33.24" N, 79 23' 13.7" W is 630084 m east, 4833438 m north in zone 17.
  const std::optional<Utm> tower =
      utm_of({43.0 + 38.0 / 60.0 + 33.24 / 3600.0, -(79.0 + 23.0 / 60.0 + 13.7 / 3600.0)});
  ASSERT_TRUE(tower);
  EXPECT_EQ(tower->zone, 17);
  EXPECT_TRUE(tower->is_north);
  EXPECT_NEAR(tower->easting, 630084.0, 1.0);
  EXPECT_NEAR(tower->northing, 4833438.0, 1.0);
}

TEST(UtmOf, HasTheZonesOfNorwayAndSvalbard) {
  EXPECT_EQ(utm_of({60.39, 5.32})->zone, 32);   // Bergen; 31 by its longitude
  EXPECT_EQ(utm_of({78.22, 15.65})->zone, 33);  // Longyearbyen
}

TEST(UtmOf, CountsNorthingsInTheSouthFromTenThousandKilometres) {
  const std::optional<Utm> south = utm_of({-33.8568, 151.2153});
  ASSERT_TRUE(south);
  EXPECT_FALSE(south->is_north);
  EXPECT_NEAR(south->northing, 1e7 - 3.7475e6, 5e3);
}

TEST(UtmOf, EndsAtThePolarCaps) {
  EXPECT_TRUE(utm_of({84.0, 10.0}));
  EXPECT_FALSE(utm_of({84.001, 10.0}));
  EXPECT_FALSE(utm_of({-80.001, 10.0}));
  EXPECT_FALSE(utm_of({10.0, std::nan("")}));
}

TEST(PlaceOfUtm, RefusesWhatIsNowhere) {
  EXPECT_FALSE(place_of(Utm{0, true, 5e5, 5e6}));
  EXPECT_FALSE(place_of(Utm{61, true, 5e5, 5e6}));
  EXPECT_FALSE(place_of(Utm{33, true, -1.0, 5e6}));
  EXPECT_FALSE(place_of(Utm{33, true, 5e5, 1.1e7}));
  EXPECT_FALSE(place_of(Utm{33, true, std::nan(""), 5e6}));
}

TEST(PlaceOfMgrs, IsTheSouthWesternCorner) {
  const std::optional<GeoPoint> corner = place_of_mgrs("33UVQ4825111932");
  ASSERT_TRUE(corner);
  EXPECT_LT(distance_on_earth(*corner, *place_of(Utm{33, true, 448251.0, 5411932.0})), 1e-6);
  EXPECT_LT(distance_on_earth(*place_of_mgrs("33UVQ41"), *place_of(Utm{33, true, 440000.0, 5410000.0})),
            1e-6);
}

TEST(PlaceOfMgrs, RefusesWhatIsNoSquare) {
  for (const char* square : {"33UVQ", "33UVQ482", "33UIO1234", "33UAA1234", "61UVQ1234", "33", "", "UVQ1234",
                             "33UVQ1234567812345678", "YXL1234"})
    EXPECT_FALSE(place_of_mgrs(square)) << square;
}

TEST(Written, IsAsTheTablesExamplesSay) {
  for (const NotationInfo& row : kNotations)
    EXPECT_EQ(written({48.2082, 16.3738}, row.notation), row.example);
}

TEST(Written, CarriesSecondsThatRoundUp) {
  EXPECT_EQ(written({9.99999999999, -0.5}, Notation::kSeconds), "10°00'00.0000'' N 0°30'00.0000'' W");
}

TEST(Written, IsInDegreesWhereTheGridEnds) {
  EXPECT_EQ(written({85.0, 1.0}, Notation::kUtm), "85.0000000 N 1.0000000 E");
  EXPECT_EQ(written({-81.0, -1.0}, Notation::kMgrs), "81.0000000 S 1.0000000 W");
}

RC_GTEST_PROP(Written, IsReadAgainToACentimetre, ()) {
  const GeoPoint place{*rc::gen::inRange(-79999000, 83999000) / 1e6,
                       *rc::gen::inRange(-179999999, 179999999) / 1e6};
  for (const NotationInfo& row : kNotations) {
    const text::Result<GeoPoint> again = read_place(written(place, row.notation));
    RC_ASSERT(again.has_value());
    // A square of MGRS has a side of a metre.
    RC_ASSERT(distance_on_earth(place, *again) < (row.notation == Notation::kMgrs ? 1.5 : 0.01));
  }
}

}  // namespace
}  // namespace mlab::geography
