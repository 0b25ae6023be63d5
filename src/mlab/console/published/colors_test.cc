#include "mlab/console/published/colors.h"

#include <gtest/gtest.h>

namespace mlab::console {
namespace {

TEST(Colors, NamesOfX11AreFoundWithoutRegardToSpacesAndCase) {
  EXPECT_EQ(rgb_of("red"), "#ff0000");
  EXPECT_EQ(rgb_of("Dark Sea Green"), "#8fbc8f");
  EXPECT_EQ(rgb_of("dark-sea-green"), "#8fbc8f");
  EXPECT_EQ(rgb_of("SteelBlue4"), "#36648b");
}

TEST(Colors, GraysAreCounted) {
  EXPECT_EQ(rgb_of("gray0"), "#000000");
  EXPECT_EQ(rgb_of("grey50"), "#808080");
  EXPECT_EQ(rgb_of("gray100"), "#ffffff");
  EXPECT_EQ(rgb_of("gray"), "#bebebe");
}

TEST(Colors, NumbersStandForThemselvesAndNonsenseIsBlue) {
  EXPECT_EQ(rgb_of("#1A2b3C"), "#1a2b3c");
  EXPECT_EQ(rgb_of("#f80"), "#ff8800");
  EXPECT_EQ(rgb_of("#12345"), "#0000ff");
  EXPECT_EQ(rgb_of("gray1000000000000"), "#0000ff");
  EXPECT_EQ(rgb_of(""), "#0000ff");
}

}  // namespace
}  // namespace mlab::console
