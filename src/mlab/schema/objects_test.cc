#include "mlab/schema/objects.h"

#include <array>

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

using percept::ObjectClass;

TEST(Objects, HaveTheColourOfTheirClass) {
  EXPECT_EQ(color_of(ObjectClass::kMine), "orange");
  EXPECT_EQ(color_of(ObjectClass::kFriendlyRobot), "blue");
  EXPECT_EQ(object_class_of_color("Dark Sea Green"), ObjectClass::kTree);
  EXPECT_EQ(object_class_of_color("pink"), std::nullopt);
  EXPECT_EQ(object_class_of_color(""), std::nullopt);
}

TEST(Objects, HaveOneColourForEachClass) {
  for (int i = 0; i < 11; ++i) {
    const auto object_class = static_cast<ObjectClass>(i);
    EXPECT_EQ(object_class_of_color(color_of(object_class)), object_class);
  }
}

TEST(Objects, AreAsFarAsTheirEdge) {
  EXPECT_DOUBLE_EQ(edge_distance({.id = {1}, .center = {3.0, 4.0}, .radius = 2.0}), 3.0);
  EXPECT_DOUBLE_EQ(edge_distance({.id = {1}, .center = {1.0, 0.0}, .radius = 2.0}), 0.0);
}

TEST(Objects, AreSeenByClassAndRange) {
  const std::array<percept::ObjectReading, 2> objects = {
      {{.id = {1}, .object_class = ObjectClass::kFlag, .center = {5.0, 0.0}, .radius = 1.0},
       {.id = {2}, .object_class = ObjectClass::kTree, .center = {9.0, 0.0}}}};
  percept::Percepts percepts;
  percepts.objects = objects;
  const flow::ObjectClasses flags{1U << 2U};
  EXPECT_TRUE(sees(percepts, flags, 4.0));
  EXPECT_FALSE(sees(percepts, flags, 3.9));
  EXPECT_FALSE(sees(percepts, flow::ObjectClasses{1U << 3U}, 100.0));
}

}  // namespace
}  // namespace mlab::schema
