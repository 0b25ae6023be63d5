#include "mlab/binding/slide.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "mlab/base/random.h"

namespace mlab::binding {
namespace {

using geom::Offset;

TEST(Slide, AMotionThatNothingForbidsStaysAsItIs) {
  Blockers blockers;
  blockers.add({{1, 0}, 0.0, 0});
  EXPECT_EQ(slide({-1, 2}, blockers), (Offset{-1, 2}));
}

TEST(Slide, LosesOnlyWhatGoesAgainstTheThing) {
  Blockers blockers;
  blockers.add({{1, 0}, 0.0, 0});
  EXPECT_EQ(slide({3, 2}, blockers), (Offset{0, 2}));
}

TEST(Slide, UsesUpTheGapAndBacksOffWhereItIsNegative) {
  Blockers near;
  near.add({{1, 0}, 0.5, 0});
  EXPECT_EQ(slide({3, 2}, near), (Offset{0.5, 2}));
  Blockers inside;
  inside.add({{1, 0}, -0.25, 0});
  EXPECT_EQ(slide({3, 2}, inside), (Offset{-0.25, 2}));
}

TEST(Slide, StopsInACorner) {
  Blockers blockers;
  blockers.add({{1, 0}, 0.0, 0});
  blockers.add({{0, 1}, 0.0, 1});
  EXPECT_EQ(slide({3, 2}, blockers), (Offset{0, 0}));
  EXPECT_EQ(slide({3, -2}, blockers), (Offset{0, -2}));
}

TEST(Slide, SqueezedFromBothSidesItMovesAlong) {
  Blockers blockers;
  blockers.add({{1, 0}, -1e-6, 0});
  blockers.add({{-1, 0}, -1e-6, 1});
  const Offset slid = slide({3, 2}, blockers);
  EXPECT_NEAR(slid.x, 0.0, 1e-12);
  EXPECT_NEAR(slid.y, 2.0, 1e-12);
}

TEST(Slide, FindsTheNearestAllowedMotionAmongManyThings) {
  base::Random random(1);
  for (int round = 0; round < 2000; ++round) {
    Blockers blockers;
    for (std::uint32_t i = 0; i <= random.below(6); ++i) {
      const double angle = random.angle();
      blockers.add({{std::cos(angle), std::sin(angle)}, random.below(2) == 0 ? 0.0 : random.uniform(), i});
    }
    const Offset wanted{random.uniform(-2, 2), random.uniform(-2, 2)};
    const auto is_allowed = [&](Offset motion, double tolerance) {
      return std::all_of(blockers.begin(), blockers.end(),
                         [&](const Blocker& b) { return dot(motion, b.toward) <= b.gap + tolerance; });
    };
    const Offset slid = slide(wanted, blockers);
    ASSERT_TRUE(is_allowed(slid, 1e-9));
    ASSERT_LE(length(slid), length(wanted) + 1e-12);
    // No allowed motion of a fine grid is nearer to the wanted one.
    for (int column = -20; column <= 20; ++column) {
      for (int row = -20; row <= 20; ++row) {
        const Offset other{0.1 * column, 0.1 * row};
        if (is_allowed(other, 0.0)) {
          ASSERT_GE(length(other - wanted), length(slid - wanted) - 1e-9);
        }
      }
    }
  }
}

TEST(Slide, KeepsTheNearestThingsWhereThereAreTooMany) {
  Blockers blockers;
  for (std::uint32_t i = 0; i < 20; ++i) blockers.add({{1, 0}, 20.0 - i, i});
  EXPECT_EQ(blockers.end() - blockers.begin(), static_cast<std::ptrdiff_t>(Blockers::kMost));
  EXPECT_EQ(blockers.begin()->gap, 1.0);
}

}  // namespace
}  // namespace mlab::binding
