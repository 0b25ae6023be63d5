#include "mlab/statistics/samples.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace mlab::statistics {
namespace {

TEST(Sample, HasMeanAndDeviation) {
  const Sample found = sample_of(std::vector{2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0});
  EXPECT_EQ(found.mean, 5.0);
  EXPECT_NEAR(found.deviation, std::sqrt(32.0 / 7.0), 1e-15);
  EXPECT_EQ(sample_of(std::vector{3.0}).deviation, 0.0);
}

TEST(Sample, LeavesOutWhatIsNoNumber) {
  const Sample found =
      sample_of(std::vector{std::nan(""), 1.0, std::numeric_limits<double>::infinity(), 3.0});
  EXPECT_EQ(found.size(), 2U);
  EXPECT_EQ(found.mean, 2.0);
  EXPECT_TRUE(sample_of(std::vector<double>{}).empty());
}

TEST(Quantile, IsThatOfTypeSeven) {
  const Sample ten = sample_of(std::vector{10.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0});
  // As R has it: quantile(1:10, c(0, .05, .25, .5, .9, 1)).
  EXPECT_EQ(quantile(ten, 0.0), 1.0);
  EXPECT_NEAR(quantile(ten, 0.05), 1.45, 1e-12);
  EXPECT_NEAR(quantile(ten, 0.25), 3.25, 1e-12);
  EXPECT_NEAR(quantile(ten, 0.5), 5.5, 1e-12);
  EXPECT_NEAR(quantile(ten, 0.9), 9.1, 1e-12);
  EXPECT_EQ(quantile(ten, 1.0), 10.0);
  EXPECT_EQ(quantile(sample_of(std::vector{7.0}), 0.3), 7.0);
}

TEST(Histogram, HasRoundBinsThatHoldEverything) {
  const std::vector<double> values{327.7, 331.2, 340.0, 329.9, std::nan(""), 349.99};
  const Histogram found = histogram(values, 327.7, 349.99, 20);
  EXPECT_EQ(found.width, 2.0);
  EXPECT_EQ(found.low, 326.0);
  EXPECT_GT(found.high(), 349.99);
  EXPECT_LE(found.counts.size(), 20U);
  EXPECT_EQ(std::accumulate(found.counts.begin(), found.counts.end(), std::uint64_t{0}), 5U);
  EXPECT_EQ(found.counts[0], 1U);
  EXPECT_EQ(found.counts[7], 1U);
}

TEST(Histogram, TakesEqualValuesAndFarOnes) {
  const Histogram equal = histogram(std::vector{0.0, 0.0, 0.0}, 0.0, 0.0, 20);
  EXPECT_EQ(equal.counts, std::vector<std::uint64_t>{3});
  const Histogram far = histogram(std::vector{-1e300, 1e300}, 0.0, 1.0, 20);
  EXPECT_LE(far.counts.size(), 22U);
  EXPECT_EQ(far.counts.front() + far.counts.back(), 2U);
}

TEST(RoundStep, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_EQ(round_step(10.0, 10), 1.0);
  EXPECT_EQ(round_step(11.0, 10), 2.0);
  EXPECT_EQ(round_step(45.0, 10), 5.0);
  EXPECT_EQ(round_step(60.0, 10), 10.0);
  EXPECT_EQ(round_step(0.0, 10), 1.0);
}

}  // namespace
}  // namespace mlab::statistics
