#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/random.h"
#include "mlab/base/testing/processor_time.h"
#include "mlab/statistics/shares.h"

// What intervals promise, tried by simulation. Each test prints its seed.
namespace mlab::statistics {
namespace {

constexpr std::uint64_t kSeed = 20'260'301;

// The most that a share which is `alpha` is found to be in so many tries, but for one time in 30,000.
double most_by_chance(double alpha, int tries) {
  return alpha + 4.0 * std::sqrt(alpha * (1.0 - alpha) / tries);
}

// Whether a sequence of intervals, one after each trial, misses the true share at any time.
template <class Misses>
int wrong_sequences(int sequences, std::uint64_t trials, double share, std::uint64_t seed, Misses misses) {
  int wrong = 0;
  for (int i = 0; i < sequences; ++i) {
    base::Random random = base::Random::of(seed, static_cast<std::uint64_t>(i), 0, 0);
    Count count;
    while (count.trials < trials) {
      ++count.trials;
      if (random.uniform() < share) ++count.successes;
      if (!misses(count)) continue;
      ++wrong;
      break;
    }
  }
  return wrong;
}

// For each number of trials the counts with which Clopper and Pearson's interval has the share: looked up,
// where it is asked for millions of times.
class KeptCounts {
 public:
  KeptCounts(double share, std::uint64_t trials, double confidence) {
    std::uint64_t low = 0;
    std::uint64_t high = 0;
    for (std::uint64_t n = 0; n <= trials; ++n) {
      while (low < n && clopper_pearson({low, n}, confidence).high < share) ++low;
      while (high < n && clopper_pearson({high + 1, n}, confidence).low <= share) ++high;
      lows_.push_back(low);
      highs_.push_back(high);
    }
  }
  bool misses(Count count) const {
    return count.successes < lows_[count.trials] || count.successes > highs_[count.trials];
  }

 private:
  std::vector<std::uint64_t> lows_;
  std::vector<std::uint64_t> highs_;
};

TEST(Coverage, ClopperPearsonHoldsWhereItIsLookedAtOnce) {
  constexpr int kTries = 20'000;
  for (const double confidence : {0.9, 0.95, 0.99}) {
    for (const std::uint64_t trials : {10U, 35U, 200U}) {
      for (const double share : {0.02, 0.1, 0.5, 0.87, 0.99}) {
        const KeptCounts kept(share, trials, confidence);
        int wrong = 0;
        for (int i = 0; i < kTries; ++i) {
          base::Random random = base::Random::of(kSeed, static_cast<std::uint64_t>(i), trials, 1);
          Count count{0, trials};
          for (std::uint64_t k = 0; k < trials; ++k) count.successes += random.uniform() < share ? 1 : 0;
          wrong += kept.misses(count) ? 1 : 0;
        }
        EXPECT_LE(static_cast<double>(wrong) / kTries, most_by_chance(1.0 - confidence, kTries))
            << "seed " << kSeed << ", share " << share << ", " << trials << " trials";
      }
    }
  }
}

TEST(Coverage, ConfidenceSequenceHoldsHoweverOftenItIsLookedAt) {
  constexpr int kSequences = base::kIsSlowBuild ? 500 : 4000;
  constexpr std::uint64_t kTrials = 1000;
  for (const double confidence : {0.9, 0.95, 0.99}) {
    const double threshold = -std::log1p(-confidence);
    for (const double share : {0.05, 0.5, 0.95, 0.99}) {
      const int wrong = wrong_sequences(kSequences, kTrials, share, kSeed, [&](Count count) {
        return log_evidence_against(share, count) >= threshold;
      });
      const double found = static_cast<double>(wrong) / kSequences;
      EXPECT_LE(found, most_by_chance(1.0 - confidence, kSequences))
          << "seed " << kSeed << ", share " << share;
      // And it is none that promises nothing: 0.99 alone can be missed on one side only for long.
      if (share > 0.04 && share < 0.96) {
        EXPECT_GT(found, 0.05 * (1.0 - confidence)) << "share " << share;
      }
    }
  }
}

TEST(Coverage, ClopperPearsonDoesNotHoldWhereItIsLookedAtAgainAndAgain) {
  constexpr int kSequences = base::kIsSlowBuild ? 500 : 4000;
  constexpr std::uint64_t kTrials = 200;
  constexpr double kShare = 0.5;
  for (const double confidence : {0.95, 0.99}) {
    const KeptCounts kept(kShare, kTrials, confidence);
    const int wrong =
        wrong_sequences(kSequences, kTrials, kShare, kSeed, [&](Count count) { return kept.misses(count); });
    const double found = static_cast<double>(wrong) / kSequences;
    RecordProperty("wrong", std::to_string(found));
    EXPECT_GT(found, 2.5 * (1.0 - confidence)) << "seed " << kSeed;
    // Such a test finds it: it is the one that the confidence sequence passes.
    EXPECT_GT(found, most_by_chance(1.0 - confidence, kSequences));
  }
}

}  // namespace
}  // namespace mlab::statistics
