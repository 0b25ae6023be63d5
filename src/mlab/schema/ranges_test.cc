#include "mlab/schema/ranges.h"

#include <array>
#include <numbers>

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

using percept::RangeReading;

constexpr float kLeft = static_cast<float>(std::numbers::pi / 2.0);

TEST(Ranges, AreNearerTheShorterTheBeam) {
  EXPECT_DOUBLE_EQ(proximity({.angle = 0.0F, .distance = 0.25F, .hit = true}, 1.0), 0.75);
  EXPECT_DOUBLE_EQ(proximity({.angle = 0.0F, .distance = 0.0F, .hit = true}, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(proximity({.angle = 0.0F, .distance = 1.0F, .hit = false}, 1.0), 0.0);
  EXPECT_DOUBLE_EQ(proximity({.angle = 0.0F, .distance = 2.0F, .hit = true}, 1.0), 0.0);
  EXPECT_DOUBLE_EQ(proximity({.angle = 0.0F, .distance = 0.0F, .hit = true}, 0.0), 0.0);
}

TEST(Ranges, PressFromWhereTheyHit) {
  const std::array<RangeReading, 4> ring = {
      {{0.0F, 0.5F, true}, {kLeft, 1.0F, false}, {2.0F * kLeft, 1.0F, false}, {-kLeft, 0.5F, true}}};
  const geom::Vector pressure = crowding(ring, 1.0);
  EXPECT_NEAR(pressure.x, 0.125, 1e-6);
  EXPECT_NEAR(pressure.y, -0.125, 1e-6);
  EXPECT_EQ(crowding({}, 1.0), geom::Vector{});
}

TEST(Ranges, LookAheadWithinAnAngle) {
  const std::array<RangeReading, 2> ring = {{{0.5F, 0.7F, true}, {3.0F, 0.1F, true}}};
  EXPECT_NEAR(proximity_ahead(ring, 1.0, kLeft), 0.3, 1e-6);
  EXPECT_NEAR(proximity_ahead(ring, 1.0, 3.1), 0.9, 1e-6);
  EXPECT_DOUBLE_EQ(proximity_ahead(ring, 1.0, 0.1), 0.0);
}

}  // namespace
}  // namespace mlab::schema
