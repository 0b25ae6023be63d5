#pragma once

#include <cstdint>
#include <span>

namespace mlab::statistics {

/// Pairs of trials in which one succeeded and the other did not.
struct Discordant {
  std::uint64_t only_first = 0;
  std::uint64_t only_second = 0;
};

/// How likely pairs are at least as lopsided as these by chance alone: the exact, two-sided test of
/// Q. McNemar ("Note on the sampling error of the difference between correlated proportions or percentages",
/// Psychometrika 12, 1947), by the binomial distribution.
double mcnemar(Discordant pairs);

/// What the signed ranks of differences say.
struct SignedRanks {
  std::uint64_t pairs = 0;  ///< that differ; the others say nothing
  double positive = 0.0;    ///< sum of the ranks of positive differences
  double negative = 0.0;    ///< and of negative ones
  double p = 1.0;           ///< how likely sums at least as far apart are by chance alone, two-sided
  bool is_exact = true;     ///< p was counted; else it is by the normal distribution
};
/// Up to so many pairs p is counted over all ways to give the ranks their signs.
inline constexpr std::uint64_t kMostExactPairs = 50;

/// Two numbers that belong together; one that is not a number makes no pair.
struct Pair {
  double first = 0.0;
  double second = 0.0;
};
/// Differences are equal where they differ by no more than this share of the numbers that they are between:
/// 175.3 - 172.5 and 100.0 - 97.2, which are not the same bits.
inline constexpr double kRounding = 1e-9;

/// F. Wilcoxon's test ("Individual comparisons by ranking methods", Biometrics Bulletin 1, 1945). Equal
/// differences share the middle of their ranks, and p is that of the ranks as they are. For many pairs by the
/// normal distribution, corrected for ties and for continuity.
SignedRanks signed_ranks(std::span<const Pair> pairs);

}  // namespace mlab::statistics
