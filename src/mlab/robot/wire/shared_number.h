#pragma once

#include <atomic>
#include <cstdint>
#include <ctime>

namespace mlab::robot_wire {

/// A number that one process sets and another waits for, in memory that both see.
class SharedNumber {
 public:
  std::uint32_t get() const { return number_.load(std::memory_order_acquire); }
  /// Also wakes whoever waits.
  void set(std::uint32_t number);

  /// Looks whether the number is as wanted for some ten microseconds, which is faster than to sleep.
  template <class Wanted>
  bool is_soon(Wanted wanted) const {
    for (int look = 1; look <= kLooks; ++look) {
      if (wanted(get())) return true;
      pause(look);
    }
    return false;
  }

  /// Sleeps until it is as wanted, or is set to something else, or the time is up. @return  whether it is
  template <class Wanted>
  bool is_after_sleep(Wanted wanted, const timespec& patience) {
    is_awaited_.store(1);
    const std::uint32_t before = number_.load();
    if (!wanted(before)) sleep(before, patience);
    is_awaited_.store(0);
    return wanted(get());
  }

 private:
  static constexpr int kLooks = 4000;
  static void pause(int look);
  void sleep(std::uint32_t before, const timespec& patience);

  std::atomic<std::uint32_t> number_{0};
  std::atomic<std::uint32_t> is_awaited_{0};  // whoever sets it has somebody to wake
};

}  // namespace mlab::robot_wire
