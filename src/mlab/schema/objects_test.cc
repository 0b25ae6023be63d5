#include "mlab/schema/objects.h"

#include <array>

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

using percept::ObjectClass;

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
