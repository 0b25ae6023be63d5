#include "mlab/console/session/work_share.h"

#include <gtest/gtest.h>

namespace mlab::console {
namespace {

using std::chrono::milliseconds;

constexpr WorkShare::Clock::time_point kBegin(std::chrono::hours(1));

TEST(WorkShare, LetsLittleBeDoneAtOnceAndThenLeavesTheTimeToOthers) {
  WorkShare share(0.2, milliseconds(20));
  WorkShare::Clock::time_point now = kBegin;
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(share.may_begin(now));
    share.note(now, now + milliseconds(15));
    now += milliseconds(15);
  }
  EXPECT_FALSE(share.may_begin(now)) << "30 ms are done, of which 6 are earned since";
  EXPECT_TRUE(share.may_begin(now + milliseconds(41)));
}

TEST(WorkShare, IsKeptHoweverOftenSomebodyAsks) {
  WorkShare share(0.25, milliseconds(100));
  WorkShare::Clock::duration worked{};
  WorkShare::Clock::time_point now = kBegin;
  while (now < kBegin + std::chrono::seconds(10)) {
    if (share.may_begin(now)) {
      share.note(now, now + milliseconds(40));
      worked += milliseconds(40);
      now += milliseconds(40);
    }
    now += milliseconds(1);
  }
  EXPECT_LE(worked, milliseconds(2500 + 100 + 40));
  EXPECT_GE(worked, milliseconds(2300));
}

}  // namespace
}  // namespace mlab::console
