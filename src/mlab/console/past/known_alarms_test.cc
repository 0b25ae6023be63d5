#include "mlab/console/past/known_alarms.h"

#include <cstdint>

#include <gtest/gtest.h>

namespace mlab::console {
namespace {

TEST(AlarmsOverTime, KnowTheLastMomentUpToACycle) {
  AlarmsOverTime known;
  const Alarms alarms;
  EXPECT_EQ(known.before(1000).cycle, 0U);
  for (std::uint64_t cycle = 1; cycle <= 180; ++cycle) known.note(cycle, alarms);
  EXPECT_EQ(known.before(49).cycle, 0U) << "nothing was known before the first one";
  EXPECT_EQ(known.before(50).cycle, 50U);
  EXPECT_EQ(known.before(149).cycle, 100U);
  EXPECT_EQ(known.before(10'000).cycle, 150U);
}

TEST(AlarmsOverTime, AreFartherApartTheLongerARunIs) {
  AlarmsOverTime known;
  const Alarms alarms;
  constexpr std::uint64_t kHour = 36'000;
  for (std::uint64_t cycle = 1; cycle <= kHour; ++cycle) known.note(cycle, alarms);
  std::size_t moments = 0;
  std::uint64_t last = 0;
  for (std::uint64_t cycle = 1; cycle <= kHour; ++cycle) {
    const std::uint64_t at = known.before(cycle).cycle;
    ASSERT_LE(at, cycle);
    ASSERT_LT(cycle - at, 800U);
    if (at != last) ++moments;
    last = at;
  }
  EXPECT_GT(moments, AlarmsOverTime::kMost / 4);
  EXPECT_LE(moments, AlarmsOverTime::kMost);
}

}  // namespace
}  // namespace mlab::console
