#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

namespace mlab::agents {

/// Sees to it that a process that takes part in a fleet comes to its end, whatever the network's library
/// does: that can wait for itself for ever, or compute for ever. A process that is to end and has not within
/// the patience is ended at once, with a word on standard error. Robots that it carries end with it, as with
/// one that is killed. May be used by any thread.
class EndingWatchdog {
 public:
  static constexpr std::chrono::milliseconds kPatience{5000};

  /// The exit status of a process that is to end by now; nothing: it goes on. Asked twenty times a second, on
  /// a thread of the watchdog's; must not wait.
  using Wanted = std::function<std::optional<int>()>;

  /// @param command  in front of the word: `mlab agent`
  /// @param wanted   empty: it ends when `expect_end` is called
  explicit EndingWatchdog(std::string command, Wanted wanted = {},
                          std::chrono::milliseconds patience = kPatience);
  EndingWatchdog(const EndingWatchdog&) = delete;
  EndingWatchdog& operator=(const EndingWatchdog&) = delete;
  /// What could hang is over.
  ~EndingWatchdog();

  /// The process is to end from now on.
  /// @return  the status
  int expect_end(int status);

  /// Half of the patience is over: whatever is moved by this process is to stand now.
  bool is_late() const { return is_late_.load(); }

 private:
  void watch(const std::stop_token& over);

  std::string command_;
  Wanted wanted_;
  std::chrono::milliseconds patience_;
  std::atomic<bool> is_expected_ = false;
  std::atomic<int> status_ = 0;
  std::atomic<bool> is_late_ = false;
  std::jthread thread_;
};

}  // namespace mlab::agents
