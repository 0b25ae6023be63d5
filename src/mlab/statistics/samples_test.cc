#include "mlab/statistics/samples.h"

#include <cmath>
#include <limits>
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

// 400 values from 300 to 350, more of them in the middle.
Sample bell() {
  std::vector<double> values;
  for (int i = 0; i < 400; ++i) {
    const double share = (i + 0.5) / 400.0;
    values.push_back(325.0 + 25.0 * std::pow(2.0 * share - 1.0, 3.0));
  }
  return sample_of(values);
}

TEST(BinWidth, IsRoundAndGetsNarrowerWithTheNumber) {
  EXPECT_DOUBLE_EQ(bin_width(bell(), 60.0, 40), 2.0) << "twice 6.25 over the third root of 400";
  const Sample few = sample_of(std::vector{300.0, 310.0, 330.0, 350.0});
  EXPECT_DOUBLE_EQ(bin_width(few, 60.0, 40), 20.0) << "three bins for four values";
}

TEST(BinWidth, OfEqualValuesOrASingleOneIsTheNarrowest) {
  EXPECT_DOUBLE_EQ(bin_width(sample_of(std::vector{7.0, 7.0, 7.0}), 40.0, 40), 1.0);
  EXPECT_DOUBLE_EQ(bin_width(sample_of(std::vector{7.0}), 40.0, 40), 1.0);
}

TEST(BinWidth, OfWhatIsMostlyOneValueGoesByTheDeviation) {
  std::vector<double> values(100, 10.0);
  for (int i = 0; i < 10; ++i) values[static_cast<std::size_t>(i)] = 10.0 * i;
  const double width = bin_width(sample_of(values), 100.0, 40);
  EXPECT_GE(width, 5.0);
  EXPECT_LE(width, 10.0);
  EXPECT_GE(bin_width(sample_of(std::vector{0.0, 1e-9, 2e-9, 1e9}), 1e9, 40), 1e9 / 40.0)
      << "never more bins";
}

TEST(Histogram, HoldsEveryValueTheUpperEdgeToo) {
  const Sample sample = sample_of(std::vector{0.0, 1.0, 4.9, 5.0, 10.0});
  EXPECT_EQ(histogram(sample, 0.0, 10.0, 5.0), (std::vector<std::uint64_t>{3, 2}));
  EXPECT_EQ(histogram(sample, 2.0, 7.0, 4.0), (std::vector<std::uint64_t>{4, 1})) << "what lies outside";
  EXPECT_EQ(histogram(sample_of(std::vector{0.1, 0.2, 0.3}), 0.0, 0.3, 0.1).size(), 3U)
      << "no bin for the last digit";
  EXPECT_EQ(histogram(Sample{}, 0.0, 1.0, 0.5), (std::vector<std::uint64_t>{0, 0}));
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
