#include "mlab/robot/wire/shared_number.h"

#include <linux/futex.h>
#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <chrono>

namespace mlab::robot_wire {

static_assert(std::atomic<std::uint32_t>::is_always_lock_free);
namespace {

// Offers them this processor. Where nobody wants it that takes a fraction of a microsecond.
bool is_taken_by_others() {
  constexpr std::chrono::microseconds kMost(3);
  const auto before = std::chrono::steady_clock::now();
  sched_yield();
  return std::chrono::steady_clock::now() - before > kMost;
}

}  // namespace

void Looks::learn(int looks) {
  if ((looks < count_ && looks <= kCheap) || ++in_vain_ % kTryAgainAfter == 0)
    count_ = kMost;
  else
    count_ /= 2;
}

void SharedNumber::set(std::uint32_t number) {
  number_.store(number);
  if (is_awaited_.load() != 0) syscall(SYS_futex, &number_, FUTEX_WAKE, 1, nullptr, nullptr, 0);
}

bool SharedNumber::pause(int look) {
  constexpr int kYieldEvery = 400;  // the other side may need this processor
  if (look % kYieldEvery == 0 && is_taken_by_others()) return true;
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("isb" ::: "memory");  // `yield` takes no time on most of these processors
#endif
  return false;
}

void SharedNumber::sleep(std::uint32_t before, const timespec& patience) {
  syscall(SYS_futex, &number_, FUTEX_WAIT, before, &patience, nullptr, 0);
}

}  // namespace mlab::robot_wire
