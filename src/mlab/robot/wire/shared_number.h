#pragma once

#include <atomic>
#include <cstdint>
#include <ctime>

namespace mlab::robot_wire {

/// For how long one side looks before it sleeps: as long as that has paid lately. Where cycles follow each
/// other fast it is faster than to sleep; else it would only take the processor from others. Of one thread.
class Looks {
 public:
  int count() const { return count_; }
  /// It was as wanted after so many looks; after all of them it may not have been. To sleep would have been
  /// cheaper where many were needed.
  void learn(int looks);

 private:
  static constexpr int kMost = 4000;  // some ten microseconds to a tenth of a millisecond
  static constexpr int kCheap = kMost / 2;
  static constexpr int kTryAgainAfter = 256;
  int count_ = kMost;
  int in_vain_ = 0;
};

/// A number that one process sets and another waits for, in memory that both see.
class SharedNumber {
 public:
  std::uint32_t get() const { return number_.load(std::memory_order_acquire); }
  /// Also wakes whoever waits.
  void set(std::uint32_t number);

  /// Looks whether the number is as wanted, which may be faster than to sleep.
  template <class Wanted>
  bool is_soon(Wanted wanted, Looks& looks) const {
    for (int look = 1; look <= looks.count(); ++look) {
      if (wanted(get())) {
        looks.learn(look);
        return true;
      }
      if (pause(look)) break;
    }
    looks.learn(looks.count());
    return wanted(get());
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
  /// @return  whether somebody else had this processor meanwhile: to look takes it from those who have work
  static bool pause(int look);
  void sleep(std::uint32_t before, const timespec& patience);

  std::atomic<std::uint32_t> number_{0};
  std::atomic<std::uint32_t> is_awaited_{0};  // whoever sets it has somebody to wake
};

}  // namespace mlab::robot_wire
