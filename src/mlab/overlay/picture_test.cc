#include "mlab/overlay/picture.h"

#include <string>

#include <gtest/gtest.h>

namespace mlab::overlay {
namespace {

using namespace std::string_literals;

// Blue, green, red of a pixel of a BMP of this width.
std::string pixel(const ShownPicture& picture, std::size_t width, std::size_t row, std::size_t column) {
  const std::size_t row_bytes = (width * 3 + 3) / 4 * 4;
  return picture.bytes.substr(54 + row * row_bytes + column * 3, 3);
}

TEST(Picture, WhatBrowsersKnowIsHandedOnAsItIs) {
  const std::string png = "\x89PNG\r\n\x1a\nrest"s;
  EXPECT_EQ(shown_picture(png).content_type, "image/png");
  EXPECT_EQ(shown_picture(png).bytes, png);
  EXPECT_EQ(shown_picture("\xff\xd8\xff\xe0"s).content_type, "image/jpeg");
  EXPECT_EQ(shown_picture("GIF89a..."s).content_type, "image/gif");
  EXPECT_EQ(why_not_shown(png), "");
}

TEST(Picture, APgmOfBytesBecomesABmp) {
  const ShownPicture shown = shown_picture("P5\n# a comment\n2 2 255\n\x00\x40\x80\xff"s);
  EXPECT_EQ(shown.content_type, "image/bmp");
  ASSERT_EQ(shown.bytes.size(), 54U + 2U * 8U);
  EXPECT_EQ(pixel(shown, 2, 0, 0), "\x00\x00\x00"s);
  EXPECT_EQ(pixel(shown, 2, 0, 1), "\x40\x40\x40"s);
  EXPECT_EQ(pixel(shown, 2, 1, 1), "\xff\xff\xff"s);
}

TEST(Picture, APpmKeepsItsColoursInBytesAndInNumbers) {
  const ShownPicture bytes = shown_picture("P6 1 1 255\n\x01\x02\x03"s);
  EXPECT_EQ(pixel(bytes, 1, 0, 0), "\x03\x02\x01"s) << "BMP begins with blue";
  const ShownPicture numbers = shown_picture("P3\n2 1\n15\n15 0 0  0 15 0\n"s);
  EXPECT_EQ(pixel(numbers, 2, 0, 0), "\x00\x00\xff"s);
  EXPECT_EQ(pixel(numbers, 2, 0, 1), "\x00\xff\x00"s);
}

TEST(Picture, ValuesOfTwoBytesAreScaledToOne) {
  const ShownPicture shown = shown_picture("P5 2 1 65535\n\xff\xff\x80\x00"s);
  EXPECT_EQ(pixel(shown, 2, 0, 0), "\xff\xff\xff"s);
  EXPECT_EQ(pixel(shown, 2, 0, 1), "\x7f\x7f\x7f"s);
}

TEST(Picture, WhatIsMissingAtTheEndIsBlack) {
  const ShownPicture shown = shown_picture("P5 2 1 255\n\xff"s);
  EXPECT_EQ(pixel(shown, 2, 0, 0), "\xff\xff\xff"s);
  EXPECT_EQ(pixel(shown, 2, 0, 1), "\x00\x00\x00"s);
}

TEST(Picture, WhatCantBeShownSaysWhyAndIsNot) {
  for (const std::string& bytes :
       {"II*\0tif"s, ""s, "P"s, "P4 1 1\n\x80"s, "P5 0 1 255\n"s, "P5 1 1 70000\n"s,
        "P5 99999999 99999999 255\n"s, "P5"s, "P5 # no end"s, "P5 -1 2 255\n"s}) {
    EXPECT_EQ(shown_picture(bytes).content_type, "") << bytes;
    EXPECT_NE(why_not_shown(bytes), "") << bytes;
  }
}

}  // namespace
}  // namespace mlab::overlay
