#include "mlab/ros2/names.h"

#include <string>

#include <gtest/gtest.h>

namespace mlab::ros2 {
namespace {

TEST(Names, AreInTheNamespaceUnlessTheyAreInFull) {
  EXPECT_EQ(namespace_of("veh1"), "/veh1");
  EXPECT_EQ(namespace_of("/fleet/veh_1/"), "/fleet/veh_1");
  EXPECT_EQ(namespace_of("/"), "");
  EXPECT_EQ(namespace_of(""), "");
  EXPECT_EQ(full_name("/veh1", "scan"), "/veh1/scan");
  EXPECT_EQ(full_name("/veh1", "front/scan"), "/veh1/front/scan");
  EXPECT_EQ(full_name("/veh1", "/scan"), "/scan");
  EXPECT_EQ(full_name("", "scan"), "/scan");
}

TEST(Names, AreRefusedWhereRosWouldNotTakeThem) {
  EXPECT_EQ(namespace_of("veh-1").error(),
            "the namespace `veh-1` has `veh-1` in it: words of letters, digits and single `_`, with no digit "
            "before, and `/` between them");
  for (const char* const bad : {"1st", "a//b", "a__b", "a b", "a\nb"}) EXPECT_FALSE(namespace_of(bad)) << bad;
  EXPECT_FALSE(full_name("/veh1", ""));
  EXPECT_FALSE(full_name("/veh1", std::string(300, 'a')));
}

}  // namespace
}  // namespace mlab::ros2
