#include "mlab/dds/waiter.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <utility>

#include "mlab/dds/waiter_state.h"

namespace mlab::dds {

WaiterState::~WaiterState() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void WaiterState::make_readable() const {
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written = ::write(descriptor_, &one, sizeof one);
}

void WaiterState::set(bool is_woken) {
  {
    const std::lock_guard lock(mutex_);
    is_woken_ |= is_woken;
    if (std::exchange(is_signalled_, true)) return;
    if (descriptor_ >= 0) make_readable();
  }
  changed_.notify_one();
}

Waiter::Outcome WaiterState::acknowledge() {
  if (const int descriptor = descriptor_; descriptor >= 0) {
    std::uint64_t count = 0;
    [[maybe_unused]] const auto got = ::read(descriptor, &count, sizeof count);
  }
  // In this order: who signals in between finds the flag up, and what he has to tell is taken after this.
  const std::lock_guard lock(mutex_);
  is_signalled_ = false;
  return std::exchange(is_woken_, false) ? Waiter::Outcome::kWoken : Waiter::Outcome::kNews;
}

Waiter::Outcome WaiterState::wait(const std::chrono::steady_clock::time_point* deadline) {
  {
    std::unique_lock lock(mutex_);
    const auto is_signalled = [this] { return is_signalled_; };
    if (deadline == nullptr)
      changed_.wait(lock, is_signalled);
    else if (!changed_.wait_until(lock, *deadline, is_signalled))
      return Waiter::Outcome::kTimeout;
  }
  return acknowledge();
}

int WaiterState::descriptor() {
  const std::lock_guard lock(mutex_);
  if (descriptor_ >= 0) return descriptor_;
  descriptor_ = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  if (descriptor_ >= 0 && is_signalled_) make_readable();
  return descriptor_;
}

std::expected<Waiter, std::string> Waiter::make() {
  Waiter waiter;
  waiter.state_ = std::make_shared<WaiterState>();
  return waiter;
}

Waiter::Outcome Waiter::wait(std::chrono::milliseconds limit) {
  // What is further away than this is never.
  constexpr std::chrono::hours kLongest(24 * 365);
  if (limit.count() < 0 || limit > kLongest) return state_->wait(nullptr);
  const auto deadline = std::chrono::steady_clock::now() + limit;
  return state_->wait(&deadline);
}

void Waiter::wake() {
  state_->wake();
}

int Waiter::descriptor() const {
  return state_ ? state_->descriptor() : -1;
}

Waiter::Outcome Waiter::acknowledge() {
  return state_->acknowledge();
}

}  // namespace mlab::dds
