#pragma once

#include <atomic>

#include "mlab/dds/waiter.h"

namespace mlab::dds {

/// What is left of a waiter for those who signal it, on whatever thread.
class WaiterState {
 public:
  explicit WaiterState(int descriptor) : descriptor_(descriptor) {}
  WaiterState(const WaiterState&) = delete;
  WaiterState& operator=(const WaiterState&) = delete;
  ~WaiterState();

  void signal();
  void wake();
  Waiter::Outcome acknowledge();
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
  // Spares the system call where the descriptor is readable already.
  std::atomic<bool> is_signalled_ = false;
  std::atomic<bool> is_woken_ = false;
};

}  // namespace mlab::dds
