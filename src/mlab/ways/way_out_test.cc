#include "mlab/ways/way_out.h"

#include <gtest/gtest.h>

namespace mlab::ways {
namespace {

using geom::Point;

constexpr double kRadius = 0.2;
constexpr double kClearance = 0.3;
constexpr Bounds kBounds{-100, -100, 100, 100};

// Two rocks with a gap of 0.2 m between them, and a body of 0.4 m before the gap.
const Ground kNotch{{{{380.71, 89.1}, 5.96}, {{382.97, 80.83}, 2.43}}, {}, {0, 0, 400, 200}};

TEST(WayOut, DoesNotLeadThroughAGapThatIsTooNarrow) {
  const Point here{381.306, 82.919};
  const Clearing clearing(kNotch, kClearance);
  ASSERT_FALSE(clearing.is_free(here));
  EXPECT_FALSE(leads_straight(kNotch, {here, {384.0, 83.8}}, kRadius));
  const auto out = way_out(kNotch, clearing, here, kRadius);
  ASSERT_TRUE(out);
  EXPECT_TRUE(clearing.is_free(*out));
  EXPECT_TRUE(leads_straight(kNotch, {here, *out}, kRadius));
}

TEST(WayOut, DoesNotLeadThroughAWall) {
  const Ground ground{{}, {{{0, -10}, {0, 10}}}, kBounds};
  const Clearing clearing(ground, kClearance);
  const auto out = way_out(ground, clearing, {0.25, 0.0}, kRadius);
  ASSERT_TRUE(out);
  EXPECT_NEAR(out->x, kClearance, 1e-6);
  EXPECT_FALSE(leads_straight(ground, {{0.25, 0.0}, {-1.0, 0.0}}, kRadius));
}

TEST(WayOut, IsNoneOfAFreePlaceAndOfOneThatNoBodyCanStandAt) {
  const Clearing clearing(kNotch, kClearance);
  EXPECT_FALSE(way_out(kNotch, clearing, {360.0, 80.0}, kRadius));
  EXPECT_FALSE(way_out(kNotch, clearing, {380.0, 89.0}, kRadius));
}

}  // namespace
}  // namespace mlab::ways
