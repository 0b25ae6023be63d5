#include "mlab/model_vehicles/sonar_ring.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "mlab/base/angle.h"

namespace mlab::model_vehicles {
namespace {

using base::radians;

SonarSpec silent_spec() {
  SonarSpec spec;
  spec.noise = 0.0;
  spec.dropout = 0.0;
  spec.beam_width = radians(10.0);
  spec.glancing = radians(25.0);
  return spec;
}

/// A long wall 2 m ahead of the origin, across.
constexpr std::array<binding::Wall, 1> kWall = {binding::Wall{{{2.0, -10.0}, {2.0, 10.0}}}};

/// Where a beam whose axis is `axis_deg` off hears a wall across at 2 m.
double distance_to_wall(double axis_deg) {
  return 2.0 / std::cos(radians(std::max(0.0, std::abs(axis_deg) - 5.0)));
}

TEST(SonarRing, HearsAWallFromStraightOn) {
  for (const double axis_deg : {0.0, 4.0, -4.0, 20.0, -29.0})
    EXPECT_FALSE(is_thrown_elsewhere(silent_spec(), {}, radians(axis_deg), distance_to_wall(axis_deg), kWall))
        << axis_deg;
}

TEST(SonarRing, DoesNotHearAWallThatItGlancesAt) {
  for (const double axis_deg : {31.0, -31.0, 60.0, -80.0})
    EXPECT_TRUE(is_thrown_elsewhere(silent_spec(), {}, radians(axis_deg), distance_to_wall(axis_deg), kWall))
        << axis_deg;
}

TEST(SonarRing, HearsTheEndOfAWall) {
  constexpr std::array<binding::Wall, 1> kShort = {binding::Wall{{{2.0, 2.0}, {2.0, 10.0}}}};
  EXPECT_FALSE(is_thrown_elsewhere(silent_spec(), {}, radians(45.0), std::sqrt(8.0), kShort));
}

TEST(SonarRing, HearsWhatIsNoWall) {
  EXPECT_FALSE(is_thrown_elsewhere(silent_spec(), {}, radians(45.0), 1.0, kWall));
}

TEST(SonarRing, LooksFromWhereTheVehicleIs) {
  const geom::Pose pose{{1.0, 3.0}, radians(-60.0)};
  EXPECT_FALSE(is_thrown_elsewhere(silent_spec(), pose, radians(60.0), 1.0, kWall));
  EXPECT_TRUE(is_thrown_elsewhere(silent_spec(), pose, radians(100.0), 1.0 / std::cos(radians(35.0)), kWall));
}

TEST(SonarRing, TellsWhatIsTooNearOrTooFarAsItCan) {
  const std::array<percept::RangeReading, 4> there = {
      percept::RangeReading{0.0F, 0.05F, true}, percept::RangeReading{0.0F, 7.5F, true},
      percept::RangeReading{0.0F, 3.0F, true}, percept::RangeReading{0.0F, 7.0F, false}};
  base::Random random(1);
  const auto told = heard(silent_spec(), {}, 0.4, there, {}, random);
  ASSERT_EQ(told.size(), 4U);
  EXPECT_FLOAT_EQ(told[0], 0.15F);
  EXPECT_TRUE(std::isinf(told[1]));
  EXPECT_FLOAT_EQ(told[2], 3.0F);
  EXPECT_TRUE(std::isinf(told[3]));
}

TEST(SonarRing, IsAsNoisyAndAsDeafAsItIsSaid) {
  SonarSpec spec = silent_spec();
  spec.noise = 0.05;
  spec.dropout = 0.2;
  const std::array<percept::RangeReading, 1> there = {percept::RangeReading{0.0F, 3.0F, true}};
  base::Random random(9);
  constexpr int kTimes = 20000;
  int lost = 0;
  double sum2 = 0.0;
  for (int i = 0; i < kTimes; ++i) {
    const float told = heard(spec, {}, 0.4, there, {}, random)[0];
    if (std::isinf(told)) {
      ++lost;
    } else {
      sum2 += (told - 3.0) * (told - 3.0);
    }
  }
  EXPECT_NEAR(static_cast<double>(lost) / kTimes, 0.2, 0.01);
  EXPECT_NEAR(std::sqrt(sum2 / (kTimes - lost)), 0.05, 0.002);
}

}  // namespace
}  // namespace mlab::model_vehicles
