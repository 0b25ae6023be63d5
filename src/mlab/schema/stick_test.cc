#include "mlab/schema/stick.h"

#include <numbers>

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

constexpr double kFacingNorth = std::numbers::pi / 2.0;

TEST(Stick, UpIsAheadInTheRobotFrame) {
  EXPECT_EQ(stick_direction(0.0, 0.3, true, 1.234), (geom::Vector{1.0, 0.0, 0.0}));
  EXPECT_EQ(stick_direction(0.3, 0.0, true, 1.234), (geom::Vector{0.0, -1.0, 0.0}));
}

TEST(Stick, UpIsNorthInTheWorldFrame) {
  const geom::Vector east = stick_direction(0.2, 0.0, false, kFacingNorth);
  EXPECT_NEAR(east.x, 0.0, 1e-12);
  EXPECT_NEAR(east.y, -1.0, 1e-12);
  const geom::Vector north = stick_direction(0.0, 1.0, false, kFacingNorth);
  EXPECT_NEAR(north.x, 1.0, 1e-12);
  EXPECT_NEAR(north.y, 0.0, 1e-12);
}

TEST(Stick, AtRestIsZero) {
  EXPECT_EQ(geom::length(stick_direction(0.0, 0.0, true, 1.0)), 0.0);
  EXPECT_EQ(geom::length(stick_direction(0.0, 0.0, false, 1.0)), 0.0);
}

}  // namespace
}  // namespace mlab::schema
