#include "mlab/geography/place_text.h"

#include <string>

#include <gtest/gtest.h>

#include "mlab/geography/notation.h"
#include "mlab/geography/projection.h"

namespace mlab::geography {
namespace {

constexpr GeoPoint kVienna{48.0 + 12.0 / 60.0 + 29.52 / 3600.0, 16.0 + 22.0 / 60.0 + 25.68 / 3600.0};

double metres_from_vienna(std::string_view text) {
  const text::Result<GeoPoint> place = read_place(text);
  return place ? distance_on_earth(*place, kVienna) : 1e9;
}

std::string what_is_wrong(std::string_view text) {
  const text::Result<GeoPoint> place = read_place(text);
  return place ? "" : place.error().kind + ": " + place.error().message + ": " + place.error().label;
}

TEST(ReadPlace, TakesDegrees) {
  for (const char* text :
       {"48.2082 16.3738", "48.2082, 16.3738", "48.2082 N 16.3738 E", "48.2082N16.3738E",
        "n 48.2082 e 16.3738", "16.3738 E 48.2082 N", "+48.2082 +16.3738", "48.2082° N, 16.3738° E"})
    EXPECT_LT(metres_from_vienna(text), 0.001) << text;
}

TEST(ReadPlace, TakesMinutesAndSeconds) {
  for (const char* text :
       {"48°12'29.52'' N 16°22'25.68'' E", "48°12′29.52″N 16°22′25.68″E", "48 12 29.52 16 22 25.68",
        "N 48 12 29.52 E 16 22 25.68", "48d12'29.52\" N, 16d22'25.68\" E", "48 12.492 N 16 22.428 E"})
    EXPECT_LT(metres_from_vienna(text), 0.001) << text;
}

TEST(ReadPlace, TakesUtmAndMgrs) {
  for (const char* text :
       {"33N 602065.21 5340353.59", "33 n 602065.21 5340353.59", "33N 602065.21, 5340353.59"})
    EXPECT_LT(metres_from_vienna(text), 0.01) << text;
  for (const char* text : {"33UXP0206540353", "33 U XP 02065 40353", "33uxp 02065 40353"})
    EXPECT_LT(metres_from_vienna(text), 1.0) << text;
}

TEST(ReadPlace, TakesSouthAndWestAsMinus) {
  EXPECT_EQ(*read_place("33.5 S 70.25 W"), (GeoPoint{-33.5, -70.25}));
  EXPECT_EQ(*read_place("-33.5 -70.25"), (GeoPoint{-33.5, -70.25}));
  EXPECT_EQ(*read_place("-0 30 0 -0 15 0"), (GeoPoint{-0.5, -0.25}));
}

TEST(ReadPlace, SaysWhatItSawAndWhatItExpects) {
  EXPECT_EQ(
      what_is_wrong("somewhere"),
      "place-not-understood: `somewhere` is no place on the Earth: expected degrees (`48.2 N 16.4 E`), UTM "
      "(`33N 602065 5340353`) or MGRS (`33UXP0206540353`)");
  EXPECT_EQ(what_is_wrong("91 16"),
            "place-out-of-range: `91` is out of range: a latitude is at most 90 degrees from 0");
  EXPECT_EQ(what_is_wrong("48 N 181 E"),
            "place-out-of-range: `181` is out of range: a longitude is at most 180 degrees from 0");
  EXPECT_EQ(what_is_wrong("48 60 N 16 0 E"),
            "place-out-of-range: `60` is out of range: minutes and seconds are 0 or more and less than 60");
  EXPECT_EQ(what_is_wrong("48.5 30 N 16 0 E"),
            "place-not-understood: `48.5` is no place on the Earth: only the last number of an angle has a "
            "fraction");
  EXPECT_EQ(
      what_is_wrong("-48 N 16 E"),
      "place-not-understood: `-48` is no place on the Earth: an angle has a sign or one of `N`, `S`, `E`, "
      "`W`, not both");
  EXPECT_EQ(what_is_wrong("48 N 16 S"),
            "place-not-understood: `48 N 16 S` is no place on the Earth: a place is one latitude, `N` or "
            "`S`, and one "
            "longitude, `E` or `W`");
  EXPECT_EQ(
      what_is_wrong("85 N 16 E"),
      "place-polar: `85 N 16 E` is too near to a pole: places lie between 80 degrees south and 84 degrees "
      "north");
}

TEST(ReadPlace, SaysWhatIsWrongWithAGrid) {
  EXPECT_EQ(what_is_wrong("61N 448251 5411932"),
            "place-out-of-range: `61` is out of range: a zone of UTM is 1 to 60");
  EXPECT_EQ(what_is_wrong("33U 448251 5411932"),
            "place-not-understood: `U` is no place on the Earth: behind the zone of UTM stands the "
            "hemisphere, `N` or "
            "`S`, not the latitude band");
  EXPECT_EQ(what_is_wrong("33N 4482510 5411932"),
            "place-out-of-range: `4482510` is out of range: an easting of UTM is 0 to 1000000 m");
  EXPECT_EQ(what_is_wrong("33N 448251 54119320"),
            "place-out-of-range: `54119320` is out of range: a northing of UTM is 0 to 10000000 m");
  EXPECT_TRUE(
      what_is_wrong("33UVQ482511193").starts_with("place-not-understood: `33UVQ482511193` is no place"));
  EXPECT_TRUE(
      what_is_wrong("33UZZ4825111932").starts_with("place-not-understood: `33UZZ4825111932` is no place"));
}

TEST(ReadPlace, RefusesWhatNobodyMeans) {
  for (const char* text :
       {"", " ", "48", "48 N", "48 16 3", "1 2 3 4 5 6 7 8", "N E", "48 N 16 E 5", "48 @ 16", "1e3 4", "N N",
        "48''16", "- 48 16", "33N", "48 N 12 N 16 E", "\xff\xfe", "nan nan", "inf inf"})
    EXPECT_NE(what_is_wrong(text), "") << text;
  EXPECT_NE(what_is_wrong(std::string(10000, '1')), "");
}

}  // namespace
}  // namespace mlab::geography
