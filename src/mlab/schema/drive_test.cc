#include "mlab/schema/drive.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

using geom::Vector;

constexpr SpeedLimits kStandard{.base = 5.0, .max = 7.0, .cautious = 0.5, .is_cautious = false};
constexpr SpeedLimits kCautious{.base = 5.0, .max = 7.0, .cautious = 0.5, .is_cautious = true};

TEST(Velocity, IsTheVectorTimesTheBaseVelocity) {
  EXPECT_EQ(velocity({0.6, 0.8, 9.0}, kStandard), (Vector{3.0, 4.0, 0.0}));
}

TEST(Velocity, IsCutToTheMaximumInTheSameDirection) {
  EXPECT_NEAR(velocity({3.0, 4.0}, kStandard).x, 4.2, 1e-12);
  EXPECT_NEAR(velocity({3.0, 4.0}, kStandard).y, 5.6, 1e-12);
  EXPECT_EQ(velocity({0.0, -kInfinity}, kStandard), (Vector{0.0, -7.0, 0.0}));
}

TEST(Velocity, IsCautiousOnlyUnderAnAbsoluteDemand) {
  EXPECT_EQ(velocity({4.0, 0.0}, kCautious), (Vector{7.0, 0.0, 0.0}));
  EXPECT_EQ(velocity({kInfinity, 0.0}, kCautious), (Vector{0.5, 0.0, 0.0}));
  EXPECT_EQ(velocity({kInfinity * 0.03, 0.0}, kCautious), (Vector{0.5, 0.0, 0.0}));
}

TEST(Velocity, NeverExceedsTheMaximumForCaution) {
  EXPECT_EQ(velocity({kInfinity, 0.0}, {.base = 1.0, .max = 0.2, .cautious = 0.5, .is_cautious = true}),
            (Vector{0.2, 0.0, 0.0}));
}

TEST(Velocity, IsZeroForZeroAndNoNumberForWhatIsNone) {
  EXPECT_EQ(velocity({}, kStandard), Vector{});
  EXPECT_TRUE(std::isnan(velocity({std::numeric_limits<double>::quiet_NaN(), 0.0}, kStandard).x));
}

}  // namespace
}  // namespace mlab::schema
