#include "mlab/agents/ending_watchdog.h"

#include <unistd.h>

#include <chrono>

#include <gtest/gtest.h>

namespace mlab::agents {
namespace {

using std::chrono::hours;
using std::chrono::milliseconds;

[[noreturn]] void hang() {
  for (;;) ::pause();
}

class EndingWatchdogs : public ::testing::Test {
 protected:
  // They have threads: the child begins anew.
  void SetUp() override { ::testing::GTEST_FLAG(death_test_style) = "threadsafe"; }
};

TEST_F(EndingWatchdogs, EndWhatHangsWithItsStatusAndAWord) {
  const auto hanging = [] {
    EndingWatchdog watchdog("mlab agent", {}, milliseconds(100));
    watchdog.expect_end(3);
    hang();
  };
  EXPECT_EXIT(hanging(), ::testing::ExitedWithCode(3),
              "mlab agent: has not ended .* the network's library hangs");
}

TEST_F(EndingWatchdogs, EndWhatHangsOnceItIsWanted) {
  const auto hanging = [] {
    EndingWatchdog watchdog("mlab agent", [] { return 0; }, milliseconds(100));
    hang();
  };
  EXPECT_EXIT(hanging(), ::testing::ExitedWithCode(0), "has not ended");
}

TEST_F(EndingWatchdogs, SayBeforeThatIsToStandWhatMoves) {
  const auto hanging = [] {
    EndingWatchdog watchdog("mlab agent", {}, milliseconds(2000));
    if (watchdog.is_late()) ::_exit(1);
    watchdog.expect_end(1);
    while (!watchdog.is_late()) ::usleep(1000);
    ::_exit(7);
  };
  EXPECT_EXIT(hanging(), ::testing::ExitedWithCode(7), "");
}

TEST_F(EndingWatchdogs, EndNothingThatIsNotToEndOrHasEnded) {
  const auto going_on = [] {
    {
      EndingWatchdog watchdog("mlab run", {}, hours(1));
      watchdog.expect_end(3);
    }
    const EndingWatchdog other("mlab run", [] { return std::optional<int>(); }, milliseconds(1));
    ::usleep(200000);
    ::_exit(7);
  };
  EXPECT_EXIT(going_on(), ::testing::ExitedWithCode(7), "");
}

}  // namespace
}  // namespace mlab::agents
