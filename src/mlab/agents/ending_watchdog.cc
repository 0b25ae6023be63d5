#include "mlab/agents/ending_watchdog.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include <fmt/core.h>

namespace mlab::agents {
namespace {

using Clock = std::chrono::steady_clock;

// Where nobody reads what it says, it ends nevertheless.
void say_at_once(const std::string& words) {
  pollfd errors{STDERR_FILENO, POLLOUT, 0};
  if (::poll(&errors, 1, 0) != 1 || (errors.revents & POLLOUT) == 0) return;
  [[maybe_unused]] const ssize_t count = ::write(STDERR_FILENO, words.data(), words.size());
}

}  // namespace

EndingWatchdog::EndingWatchdog(std::string command, Wanted wanted, std::chrono::milliseconds patience)
    : command_(std::move(command)),
      wanted_(std::move(wanted)),
      patience_(patience),
      thread_([this](const std::stop_token& over) { watch(over); }) {}

EndingWatchdog::~EndingWatchdog() = default;

int EndingWatchdog::expect_end(int status) {
  std::fflush(stdout);  // or it would be lost
  status_ = status;
  is_expected_ = true;
  return status;
}

void EndingWatchdog::watch(const std::stop_token& over) {
  constexpr std::chrono::milliseconds kGlance(50);
  std::optional<Clock::time_point> since;
  for (; !over.stop_requested(); std::this_thread::sleep_for(std::min(kGlance, patience_ / 2))) {
    const std::optional<int> status = is_expected_ ? std::optional(status_.load())
                                      : wanted_    ? wanted_()
                                                   : std::nullopt;
    if (!status) {
      since.reset();
      is_late_ = false;
      continue;
    }
    if (!since) since = Clock::now();
    const Clock::duration age = Clock::now() - *since;
    is_late_ = age >= patience_ / 2;
    if (age < patience_) continue;
    say_at_once(fmt::format(
        "{}: has not ended {:.1f} s after it was to: the network's library hangs. It is ended by force\n",
        command_, std::chrono::duration<double>(age).count()));
    ::_exit(*status);
  }
}

}  // namespace mlab::agents
