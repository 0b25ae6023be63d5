#include "mlab/dds/waiter.h"

#include <poll.h>

#include <atomic>
#include <thread>

#include <gtest/gtest.h>

namespace mlab::dds {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

bool is_readable(const Waiter& waiter) {
  pollfd asked{.fd = waiter.descriptor(), .events = POLLIN, .revents = 0};
  return ::poll(&asked, 1, 0) == 1;
}

TEST(DdsWaiter, GivesUpAfterTheLimit) {
  auto waiter = Waiter::make().value();
  const auto began = Clock::now();
  EXPECT_EQ(waiter.wait(milliseconds(50)), Waiter::Outcome::kTimeout);
  EXPECT_GE(Clock::now() - began, milliseconds(50));
  EXPECT_EQ(waiter.wait(milliseconds(0)), Waiter::Outcome::kTimeout);
}

TEST(DdsWaiter, IsWokenByAnotherThread) {
  auto waiter = Waiter::make().value();
  std::jthread other([&] {
    std::this_thread::sleep_for(milliseconds(20));
    waiter.wake();
  });
  EXPECT_EQ(waiter.wait(milliseconds(-1)), Waiter::Outcome::kWoken);
}

TEST(DdsWaiter, MissesNoWakeThatCameBefore) {
  auto waiter = Waiter::make().value();
  waiter.wake();
  waiter.wake();
  EXPECT_EQ(waiter.wait(milliseconds(1000)), Waiter::Outcome::kWoken);
  EXPECT_EQ(waiter.wait(milliseconds(0)), Waiter::Outcome::kTimeout);
}

TEST(DdsWaiter, MissesNoneOfManyWakes) {
  auto waiter = Waiter::make().value();
  std::atomic<int> woken = 0;
  std::jthread other([&] {
    for (int i = 1; i <= 2000; ++i) {
      waiter.wake();
      while (woken < i) std::this_thread::yield();
    }
  });
  while (woken < 2000) {
    ASSERT_EQ(waiter.wait(milliseconds(20'000)), Waiter::Outcome::kWoken);
    ++woken;
  }
}

TEST(DdsWaiter, CanBeWatchedAsADescriptor) {
  auto waiter = Waiter::make().value();
  EXPECT_FALSE(is_readable(waiter));
  waiter.wake();
  EXPECT_TRUE(is_readable(waiter));
  EXPECT_EQ(waiter.acknowledge(), Waiter::Outcome::kWoken);
  EXPECT_FALSE(is_readable(waiter));
}

}  // namespace
}  // namespace mlab::dds
