#include "mlab/percept/object_colors.h"

#include <string>

#include <gtest/gtest.h>

namespace mlab::percept {
namespace {

TEST(ObjectColors, AreOneForEachClass) {
  std::string all;
  for (int i = 0; i <= static_cast<int>(kLastObjectClass); ++i) {
    const auto object_class = static_cast<ObjectClass>(i);
    EXPECT_EQ(object_class_of_color(color_of(object_class)), object_class);
    all += (all.empty() ? "" : ", ") + std::string(color_of(object_class));
  }
  EXPECT_EQ(colors_of_classes(), all);
}

TEST(ObjectColors, AreToldByTheirLetters) {
  for (const char* color : {"Dark Sea Green", "darkseagreen", "DARK-SEA_GREEN"})
    EXPECT_EQ(object_class_of_color(color), ObjectClass::kTree) << color;
  for (const char* color : {"pink", "", " ", "re d d", "blu"})
    EXPECT_EQ(object_class_of_color(color), std::nullopt) << color;
}

}  // namespace
}  // namespace mlab::percept
