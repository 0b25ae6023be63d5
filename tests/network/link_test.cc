// What becomes of packets, without any: a Wire decides by seed and number.

#include "network/link.h"

#include <vector>

#include <gtest/gtest.h>

namespace mlab::network {
namespace {

using std::chrono::milliseconds;

constexpr Time kBegin{std::chrono::seconds(100)};

int lost_of(int packets, std::uint64_t seed, const Link& link) {
  Wire wire(seed, 1, 2);
  int lost = 0;
  for (int i = 0; i < packets; ++i) lost += wire.next(link, 100, kBegin).end == Fate::End::kLost ? 1 : 0;
  return lost;
}

TEST(Wire, LetsEverythingThroughAtOnceWhereNothingIsSet) {
  Wire wire(1, 1, 2);
  for (int i = 0; i < 1000; ++i) {
    const Fate fate = wire.next({}, 1500, kBegin);
    ASSERT_EQ(fate.end, Fate::End::kArrives);
    ASSERT_EQ(fate.due, kBegin);
    ASSERT_FALSE(fate.is_twice || fate.is_reordered);
  }
}

TEST(Wire, LosesItsShareWithAnySeed) {
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    EXPECT_NEAR(lost_of(10'000, seed, {.loss = 0.2}), 2000, 200);  // 5 sigma
  EXPECT_EQ(lost_of(1000, 1, {.loss = 1.0}), 1000);
}

TEST(Wire, DoesTheSameWithTheSameSeedWhateverElseIsSet) {
  Wire one(7, 1, 2);
  Wire other(7, 1, 2);
  Wire back(7, 2, 1);
  int differs_back = 0;
  for (int i = 0; i < 1000; ++i) {
    const Fate a = one.next({.loss = 0.3}, 100, kBegin);
    const Fate b = other.next(
        {.loss = 0.3, .delay = milliseconds(5), .jitter = milliseconds(2), .duplication = 0.5}, 900, kBegin);
    ASSERT_EQ(a.end, b.end) << i;
    differs_back += back.next({.loss = 0.3}, 100, kBegin).end != a.end ? 1 : 0;
  }
  EXPECT_NEAR(differs_back, 420, 80);  // 2 * 0.3 * 0.7: independent
}

TEST(Wire, VariesDelaysWithinTheJitterAndKeepsTheOrder) {
  Wire wire(3, 1, 2);
  Time last{};
  Duration shortest = std::chrono::seconds(1);
  Duration longest{0};
  for (int i = 0; i < 1000; ++i) {
    const Time now = kBegin + milliseconds(100) * i;
    const Fate fate = wire.next({.delay = milliseconds(50), .jitter = milliseconds(20)}, 100, now);
    shortest = std::min<Duration>(shortest, fate.due - now);
    longest = std::max<Duration>(longest, fate.due - now);
    ASSERT_GE(fate.due, last);
    last = fate.due;
  }
  EXPECT_GE(shortest, milliseconds(30));
  EXPECT_LT(shortest, milliseconds(31));
  EXPECT_LE(longest, milliseconds(70));
  EXPECT_GT(longest, milliseconds(69));
}

TEST(Wire, HoldsBackThoseThatAreOvertaken) {
  Wire wire(3, 1, 2);
  int late = 0;
  Time highest{};
  for (int i = 0; i < 1000; ++i) {
    const Fate fate =
        wire.next({.reordering = 0.1, .held_back = milliseconds(10)}, 100, kBegin + milliseconds(i));
    EXPECT_EQ(fate.due - (kBegin + milliseconds(i)), fate.is_reordered ? milliseconds(10) : milliseconds(0));
    late += fate.due < highest ? 1 : 0;
    highest = std::max(highest, fate.due);
  }
  EXPECT_NEAR(late, 600, 150);  // whoever comes within 10 ms after one that was held back overtakes it
}

TEST(Wire, SendsNoMoreThanItsRateAndDropsWhatItCantKeep) {
  Wire wire(3, 1, 2);
  const Link link{.bits_per_second = 8e6, .queue_bytes = 10'000};  // a byte each microsecond
  int overflowed = 0;
  for (int i = 1; i <= 20; ++i) {
    const Fate fate = wire.next(link, 1000, kBegin);
    if (fate.end == Fate::End::kOverflows)
      ++overflowed;
    else
      EXPECT_EQ(fate.due - kBegin, milliseconds(i));
  }
  EXPECT_EQ(overflowed, 10);
  EXPECT_EQ(wire.next(link, 1000, kBegin + std::chrono::seconds(1)).due, kBegin + milliseconds(1001));
}

}  // namespace
}  // namespace mlab::network
