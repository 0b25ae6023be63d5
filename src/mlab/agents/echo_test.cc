#include "mlab/agents/echo.h"

#include <gtest/gtest.h>

namespace mlab::agents {
namespace {

TEST(LinkHistory, KnowsNothingBeforeTheFirstAnswer) {
  LinkHistory link;
  EXPECT_FALSE(link.quality());
  link.asked(1);
  EXPECT_FALSE(link.quality());
}

TEST(LinkHistory, TakesTheOffsetOfTheFastestAnswer) {
  LinkHistory link;
  for (std::uint64_t i = 1; i <= 3; ++i) link.asked(i);
  link.answered(1, 0.020, 0.5);
  link.answered(2, 0.004, 0.25);
  link.answered(3, 0.100, 0.9);
  ASSERT_TRUE(link.quality());
  EXPECT_EQ(link.quality()->round_trip, 0.004);
  EXPECT_EQ(link.quality()->clock_offset, 0.25);
  EXPECT_EQ(link.quality()->lost, 0.0);
}

TEST(LinkHistory, CountsWhatWasNotAnsweredButForTheNewest) {
  LinkHistory link;
  for (std::uint64_t i = 1; i <= 4; ++i) link.asked(i);
  link.answered(1, 0.01, 0.0);
  link.answered(3, 0.01, 0.0);
  EXPECT_NEAR(link.quality()->lost, 1.0 / 3.0, 1e-12);
  link.asked(5);
  EXPECT_NEAR(link.quality()->lost, 0.5, 1e-12);
}

TEST(LinkHistory, CountsNothingOfWhatWasAskedBeforeBothHadFoundEachOther) {
  LinkHistory link;
  for (std::uint64_t i = 1; i <= 5; ++i) link.asked(i);
  link.answered(4, 0.01, 0.0);
  link.answered(5, 0.01, 0.0);
  EXPECT_EQ(link.quality()->lost, 0.0);
  for (std::uint64_t i = 6; i <= 7; ++i) link.asked(i);
  link.answered(7, 0.01, 0.0);
  EXPECT_NEAR(link.quality()->lost, 0.25, 1e-12) << "from then on all count";
}

TEST(LinkHistory, ForgetsWhatIsLongAgo) {
  LinkHistory link;
  link.asked(1);
  link.answered(1, 0.001, 7.0);
  for (std::uint64_t i = 2; i < 2 + LinkHistory::kKept; ++i) {
    link.asked(i);
    link.answered(i, 0.01, 1.0);
  }
  EXPECT_EQ(link.quality()->clock_offset, 1.0);
}

TEST(LinkHistory, TakesNoNonsense) {
  LinkHistory link;
  link.asked(1);
  for (const double nonsense : {-1.0, 1e9, std::numeric_limits<double>::quiet_NaN()})
    link.answered(1, nonsense, 0.0);
  link.answered(2, 0.1, 0.0);
  EXPECT_FALSE(link.quality());
  link.answered(1, 0.1, 2.0);
  link.answered(1, 0.01, 3.0);
  EXPECT_EQ(link.quality()->clock_offset, 2.0) << "an answer that comes twice";
}

}  // namespace
}  // namespace mlab::agents
