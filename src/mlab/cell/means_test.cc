#include "mlab/cell/means.h"

#include <gtest/gtest.h>

namespace mlab::cell {
namespace {

TEST(Means, LandlockComesBeforeBubblewrap) {
  EXPECT_EQ(choose_wall({3, "/usr/bin/bwrap"}), Wall::kLandlock);
  EXPECT_EQ(choose_wall({0, "/usr/bin/bwrap"}), Wall::kBubblewrap);
}

TEST(Means, AMachineWithoutEitherIsToldWhatHelps) {
  const auto wall = choose_wall({0, ""});
  ASSERT_FALSE(wall);
  EXPECT_NE(wall.error().find("install bubblewrap"), std::string::npos);
  EXPECT_NE(wall.error().find("--no-cell"), std::string::npos);
}

TEST(Means, OnlyWhoSaysSoGoesWithoutWalls) {
  EXPECT_EQ(choose_wall({0, ""}, true), Wall::kNone);
  EXPECT_EQ(choose_wall({3, ""}, true), Wall::kNone);
}

}  // namespace
}  // namespace mlab::cell
