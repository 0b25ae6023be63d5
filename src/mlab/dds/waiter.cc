#include "mlab/dds/waiter.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <system_error>

#include <fmt/format.h>

#include "mlab/dds/waiter_state.h"

namespace mlab::dds {

WaiterState::~WaiterState() {
  ::close(descriptor_);
}

void WaiterState::signal() {
  if (is_signalled_.exchange(true)) return;
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written = ::write(descriptor_, &one, sizeof one);
}

void WaiterState::wake() {
  is_woken_ = true;
  signal();
}

Waiter::Outcome WaiterState::acknowledge() {
  std::uint64_t count = 0;
  [[maybe_unused]] const auto got = ::read(descriptor_, &count, sizeof count);
  // In this order: who signals in between finds the flag up, and what he has to tell is taken after this.
  is_signalled_ = false;
  return is_woken_.exchange(false) ? Waiter::Outcome::kWoken : Waiter::Outcome::kNews;
}

std::expected<Waiter, std::string> Waiter::make() {
  const int descriptor = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  if (descriptor < 0)
    return std::unexpected(
        fmt::format("no descriptor to wait with: {}", std::generic_category().message(errno)));
  Waiter waiter;
  waiter.state_ = std::make_shared<WaiterState>(descriptor);
  return waiter;
}

Waiter::Outcome Waiter::wait(std::chrono::milliseconds limit) {
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  while (true) {
    const auto left = limit - std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - began);
    const auto longest = std::chrono::milliseconds(std::numeric_limits<int>::max());
    const int timeout =
        limit.count() < 0 ? -1
                          : static_cast<int>(std::clamp(left, std::chrono::milliseconds(0), longest).count());
    pollfd asked{.fd = state_->descriptor(), .events = POLLIN, .revents = 0};
    const int ready = ::poll(&asked, 1, timeout);
    if (ready > 0) return state_->acknowledge();
    if (ready == 0 && left <= longest) return Outcome::kTimeout;
    if (ready < 0 && errno != EINTR) return Outcome::kTimeout;
  }
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
