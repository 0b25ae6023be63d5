#include "mlab/statistics/pairs.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/random.h"

namespace mlab::statistics {
namespace {

TEST(McNemar, IsTheBinomialTestOfPairsThatDiffer) {
  EXPECT_EQ(mcnemar({0, 0}), 1.0);
  EXPECT_EQ(mcnemar({5, 5}), 1.0);
  EXPECT_NEAR(mcnemar({1, 9}), 2.0 * 11.0 / 1024.0, 1e-15);
  EXPECT_NEAR(mcnemar({9, 1}), 2.0 * 11.0 / 1024.0, 1e-15);
  EXPECT_NEAR(mcnemar({0, 20}), 2.0 * std::pow(0.5, 20), 1e-18);
  // A. Agresti, "Categorical Data Analysis" (1990), p. 350: approval of the president's performance, 150 and
  // 86 changed their minds; the exact p as R's package exact2x2 has it.
  EXPECT_NEAR(mcnemar({150, 86}), 3.716e-05, 5e-9);
}

TEST(SignedRanks, AreThoseOfPublishedData) {
  // M. Hollander, D. A. Wolfe, "Nonparametric Statistical Methods" (1973), p. 29: depression scale before and
  // after a therapy; R's wilcox.test gives V = 40, p = 0.03906 (two-sided).
  const double before[] = {1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30};
  const double after[] = {0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29};
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < std::size(before); ++i) pairs.push_back({before[i], after[i]});
  const SignedRanks found = signed_ranks(pairs);
  EXPECT_EQ(found.pairs, 9U);
  EXPECT_EQ(found.positive, 40.0);
  EXPECT_EQ(found.negative, 5.0);
  EXPECT_TRUE(found.is_exact);
  EXPECT_NEAR(found.p, 20.0 / 512.0, 1e-12);
}

TEST(SignedRanks, TakeDifferencesThatAreEqualButForRoundingForTies) {
  // 2.8, 2.8, -2.8, 0.1, -0.1, 5.6 and nothing. Among equal ones none has the same bits.
  const Pair pairs[] = {{175.3, 172.5}, {100.0, 97.2},  {170.2, 173.0},  {0.3, 0.2},
                        {0.7, 0.8},     {176.1, 170.5}, {0.1 + 0.2, 0.3}};
  ASSERT_NE(175.3 - 172.5, 100.0 - 97.2);
  ASSERT_NE(0.1 + 0.2, 0.3);
  const SignedRanks found = signed_ranks(pairs);
  EXPECT_EQ(found.pairs, 6U);
  // Ranks: 0.1 and -0.1 have 1.5, the three of 2.8 have 4, 5.6 has 6.
  EXPECT_EQ(found.positive, 1.5 + 4.0 + 4.0 + 6.0);
  EXPECT_EQ(found.negative, 1.5 + 4.0);
  // Of 64 ways to give signs, those with negative ranks that sum to 5.5 or less: none; 1.5 (2), 3, 4 (3), 5.5
  // (2 times 3).
  EXPECT_NEAR(found.p, 2.0 * 13.0 / 64.0, 1e-15);
}

// The differences by themselves.
SignedRanks ranks_of(const std::vector<double>& differences) {
  std::vector<Pair> pairs;
  for (const double one : differences) pairs.push_back({one, 0.0});
  return signed_ranks(pairs);
}

TEST(SignedRanks, CountSmallSamplesByHand) {
  // All positive: the only one of 2^5 on each side.
  EXPECT_NEAR(ranks_of(std::vector{1.0, 2.0, 3.0, 4.0, 5.0}).p, 2.0 / 32.0, 1e-15);
  // Ranks 1.5, 1.5 and 3: sums of positive ones 0, 1.5, 1.5, 3, 3, 4.5, 4.5, 6; here it is 1.5 below.
  const SignedRanks tied = ranks_of(std::vector{-1.0, 1.0, 2.0});
  EXPECT_EQ(tied.negative, 1.5);
  EXPECT_NEAR(tied.p, 2.0 * 3.0 / 8.0, 1e-15);
}

TEST(SignedRanks, LeaveOutWhatDoesNotDiffer) {
  const SignedRanks found = ranks_of(std::vector{0.0, 0.0, 1.0, std::nan("")});
  EXPECT_EQ(found.pairs, 1U);
  EXPECT_EQ(found.p, 1.0);
  EXPECT_EQ(ranks_of(std::vector<double>{}).p, 1.0);
  EXPECT_EQ(ranks_of(std::vector<double>(100, 0.0)).p, 1.0);
}

TEST(SignedRanks, AreTheSameWithTheSidesExchanged) {
  const SignedRanks one = ranks_of(std::vector{3.0, -1.0, 2.0, 2.0, -5.0, 8.0});
  const SignedRanks other = ranks_of(std::vector{-3.0, 1.0, -2.0, -2.0, 5.0, -8.0});
  EXPECT_EQ(one.positive, other.negative);
  EXPECT_EQ(one.p, other.p);
}

// Differences in whole numbers, so that many are equal, around a shift.
std::vector<double> whole_differences(std::uint64_t seed, std::size_t count, double shift) {
  base::Random random(seed);
  std::vector<double> out;
  while (out.size() < count) out.push_back(std::round(3.0 * random.normal() + shift));
  return out;
}

TEST(SignedRanks, AreNearlyNormalWhereCountingEnds) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::vector<double> differences = whole_differences(seed, 80, 0.5);
    std::erase(differences, 0.0);
    ASSERT_GT(differences.size(), kMostExactPairs);
    const SignedRanks many = ranks_of(differences);
    EXPECT_FALSE(many.is_exact);
    differences.resize(kMostExactPairs);
    const SignedRanks few = ranks_of(differences);
    EXPECT_TRUE(few.is_exact);
    // The normal one of the few, as it is worked out for the many.
    const double n = 50.0;
    const double away =
        std::abs(few.positive - n * (n + 1.0) / 4.0) / std::sqrt(n * (n + 1.0) * (2.0 * n + 1.0) / 24.0);
    EXPECT_NEAR(few.p, std::erfc(away / std::sqrt(2.0)), 0.03) << "seed " << seed;
  }
}

TEST(SignedRanks, AreRarelyWrongWhereNothingDiffers) {
  constexpr int kTries = 4000;
  for (const std::size_t pairs : {12U, 200U}) {
    int wrong = 0;
    for (int i = 0; i < kTries; ++i)
      wrong += ranks_of(whole_differences(1000 + static_cast<std::uint64_t>(i), pairs, 0.0)).p < 0.05 ? 1 : 0;
    EXPECT_LE(wrong, static_cast<int>(kTries * 0.05 + 4.0 * std::sqrt(kTries * 0.05 * 0.95)))
        << pairs << " pairs";
    EXPECT_GT(wrong, kTries / 100);
  }
}

}  // namespace
}  // namespace mlab::statistics
