#include "mlab/vehicle/their_clock.h"

#include <gtest/gtest.h>

namespace mlab::vehicle {
namespace {

using namespace std::chrono_literals;

constexpr Clock::time_point kBegin{1h};

TEST(TheirClock, TakesTheFastestForAtOnce) {
  TheirClock clock;
  EXPECT_FALSE(clock.is_known());
  EXPECT_TRUE(clock.hear(1000, kBegin + 80ms));
  EXPECT_TRUE(clock.hear(1100, kBegin + 100ms));  // 80 ms less late
  EXPECT_TRUE(clock.hear(1200, kBegin + 290ms));
  EXPECT_NEAR(std::chrono::duration<double>(clock.ours(1100) - (kBegin + 100ms)).count(), 0.0, 0.0002);
  EXPECT_LT(clock.ours(1200), kBegin + 201ms);
  EXPECT_EQ(clock.theirs(clock.ours(1200) + 800ms), 2000U);
}

TEST(TheirClock, FollowsAClockThatIsSlower) {
  TheirClock clock;
  Clock::time_point now = kBegin;
  for (std::uint32_t theirs = 0; theirs < 3'600'000; theirs += 100, now += 100ms + 50us)
    clock.hear(theirs, now);
  EXPECT_NEAR(std::chrono::duration<double>(clock.ours(3'599'900) - (now - 100ms - 50us)).count(), 0.0,
              0.001);
}

TEST(TheirClock, LeavesOutWhatRunsBackwards) {
  TheirClock clock;
  clock.hear(5000, kBegin);
  EXPECT_FALSE(clock.hear(4999, kBegin + 10ms));
  EXPECT_EQ(clock.ours(5000), kBegin);
  clock.forget();
  EXPECT_TRUE(clock.hear(100, kBegin + 20ms));
}

TEST(TheirClock, GoesOnWhereTheirsBeginsWith0Again) {
  TheirClock clock;
  clock.hear(0xFFFF'FFF0, kBegin);
  EXPECT_TRUE(clock.hear(0x10, kBegin + 32ms));
  EXPECT_EQ(clock.ours(0x10), kBegin + 32ms);
}

TEST(TheirClock, IsSettledOnceNothingCatchesUp) {
  TheirClock clock;
  clock.hear(0, kBegin);
  EXPECT_FALSE(clock.is_settled(kBegin + 299ms));
  EXPECT_TRUE(clock.is_settled(kBegin + 300ms));
  // What was held back for two seconds comes ten times as fast as it was said.
  clock.forget();
  Clock::time_point now = kBegin + 2s;
  std::uint32_t theirs = 0;
  for (; theirs < 2000; theirs += 100, now += 10ms) {
    clock.hear(theirs, now);
    EXPECT_FALSE(clock.is_settled(now));
  }
  for (; theirs < 4000; theirs += 100, now += 100ms) clock.hear(theirs, now);
  EXPECT_TRUE(clock.is_settled(now));
}

}  // namespace
}  // namespace mlab::vehicle
