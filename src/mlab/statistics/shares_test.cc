#include "mlab/statistics/shares.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace mlab::statistics {
namespace {

void expect_near(Interval found, double low, double high) {
  EXPECT_NEAR(found.low, low, 5e-8);
  EXPECT_NEAR(found.high, high, 5e-8);
}

TEST(ClopperPearson, IsTheIntervalOfPublishedExamples) {
  // W. J. Conover, "Practical Nonparametric Statistics" (1971), as the help of R's binom.test has it: 682
  // giants of 925 plants.
  expect_near(clopper_pearson({682, 925}, 0.95), 0.7076683, 0.7654066);
  // Where nothing or everything succeeded it is known in closed form: 1 - (alpha / 2)^(1 / n).
  expect_near(clopper_pearson({0, 10}, 0.95), 0.0, 1.0 - std::pow(0.025, 0.1));
  expect_near(clopper_pearson({200, 200}, 0.99), std::pow(0.005, 1.0 / 200.0), 1.0);
}

TEST(ClopperPearson, KnowsNothingWithoutTrials) {
  EXPECT_EQ(clopper_pearson({0, 0}, 0.95), (Interval{0.0, 1.0}));
}

TEST(ClopperPearson, IsTheSameFromBothSides) {
  for (const std::uint64_t successes : {0U, 1U, 17U, 50U}) {
    const Interval one = clopper_pearson({successes, 50}, 0.9);
    const Interval other = clopper_pearson({50 - successes, 50}, 0.9);
    EXPECT_NEAR(one.low, 1.0 - other.high, 1e-12);
    EXPECT_NEAR(one.high, 1.0 - other.low, 1e-12);
  }
}

TEST(ClopperPearson, CountsToTenThousandsOfMillions) {
  const Interval found = clopper_pearson({9'999'999'999, 10'000'000'000}, 0.99);
  EXPECT_GT(found.low, 0.999999998);
  EXPECT_LT(found.low, 1.0 - 1e-10);
  EXPECT_LT(found.high, 1.0);
}

TEST(ConfidenceSequence, HoldsTheSharesThatAreNotRefuted) {
  for (const Count count :
       {Count{0, 1}, Count{1, 1}, Count{3, 10}, Count{200, 200}, Count{0, 5000}, Count{4711, 5000}}) {
    const Interval found = confidence_sequence(count, 0.99);
    const double threshold = std::log(100.0);
    EXPECT_TRUE(found.contains(count.share()));
    if (found.low > 0.0) {
      EXPECT_NEAR(log_evidence_against(found.low, count), threshold, 1e-6);
    }
    if (found.high < 1.0) {
      EXPECT_NEAR(log_evidence_against(found.high, count), threshold, 1e-6);
    }
    if (count.successes == 0) {
      EXPECT_EQ(found.low, 0.0);
    }
    if (count.successes == count.trials) {
      EXPECT_EQ(found.high, 1.0);
    }
  }
  EXPECT_EQ(confidence_sequence({0, 0}, 0.95), (Interval{0.0, 1.0}));
}

TEST(ConfidenceSequence, IsWiderThanAnIntervalThatIsLookedAtOnce) {
  for (const Count count : {Count{5, 10}, Count{95, 100}, Count{200, 200}, Count{900, 1000}}) {
    const Interval once = clopper_pearson(count, 0.95);
    const Interval always = confidence_sequence(count, 0.95);
    EXPECT_LT(always.low, once.low);
    EXPECT_GE(always.high, once.high);
    EXPECT_LT(always.width(), 2.2 * once.width());
  }
}

TEST(Evidence, IsABetThatIsFairIfTheShareIsTrue) {
  // After two trials with share 0.3, over all that can be counted.
  double mean = 0.0;
  for (const std::uint64_t successes : {0U, 1U, 2U}) {
    const double ways = successes == 1 ? 2.0 : 1.0;
    mean += ways * std::pow(0.3, successes) * std::pow(0.7, 2.0 - static_cast<double>(successes)) *
            std::exp(log_evidence_against(0.3, {successes, 2}));
  }
  EXPECT_NEAR(mean, 1.0, 1e-12);
  EXPECT_EQ(log_evidence_against(0.0, {1, 2}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(log_evidence_against(1.0, {1, 2}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace mlab::statistics
