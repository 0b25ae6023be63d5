#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>

#include "mlab/dds/waiter.h"

namespace mlab::dds {

/// What is left of a waiter for those who signal it, on whatever thread.
class WaiterState {
 public:
  WaiterState() = default;
  WaiterState(const WaiterState&) = delete;
  WaiterState& operator=(const WaiterState&) = delete;
  ~WaiterState();

  void signal() { set(false); }
  void wake() { set(true); }
  /// @param deadline  null: none
  Waiter::Outcome wait(const std::chrono::steady_clock::time_point* deadline);
  Waiter::Outcome acknowledge();
  /// -1: none is left.
  int descriptor();

 private:
  void set(bool is_woken);
  void make_readable() const;

  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_signalled_ = false;
  bool is_woken_ = false;
  // Only once somebody has asked for it: to write and read one costs more than all else here.
  std::atomic<int> descriptor_ = -1;
};

}  // namespace mlab::dds
