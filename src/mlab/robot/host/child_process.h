#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <expected>
#include <span>
#include <string>
#include <string_view>

#include "mlab/cell/means.h"
#include "mlab/cell/policy.h"

namespace mlab::robot_host {

using Clock = std::chrono::steady_clock;

/// An executable that runs in a cell, without a shell, in a process group of its own. It ends with this
/// object: its standard input is closed, and where that does not move it, it is killed with all that it
/// started. Where this process ends before it, it is killed as well, whatever it is doing.
class ChildProcess {
 public:
  /// @param files  descriptors that it gets as 3, 4, ...; at most two
  /// @errors  why it can't be started, as the system says it
  static std::expected<ChildProcess, std::string> start(const std::string& executable,
                                                        const cell::Policy& policy, cell::Wall wall,
                                                        std::span<const int> files = {});

  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();

  enum class Io { kDone, kEnded, kTimedOut };
  /// Writes all of it. kEnded: nobody reads.
  Io write(std::string_view bytes, Clock::time_point deadline);
  /// Waits for some bytes and says how many came.
  Io read(std::span<char> room, std::size_t& count, Clock::time_point deadline);

  /// Processor time of all its threads so far [s]; 0 where that can't be told.
  double processor_time() const;
  /// It has ended by itself; `end` says how. Takes what it says to standard error meanwhile.
  bool has_ended();

  /// Ends it, kindly at first. @return how it ended, for a person: `exit status 3`, `signal 11 (Segmentation
  /// fault)`
  std::string end(double patience);
  /// By SIGKILL: somebody outside ended it. Of one that has ended.
  bool was_killed() const { return was_killed_; }
  /// The end of what it wrote to standard error, as it stands.
  const std::string& said() {
    take_errors();
    return errors_;
  }
  /// The last words of its standard error, one line; empty: it said nothing.
  std::string last_words();

 private:
  ChildProcess() = default;
  void take_errors();
  void close_all();

  cell::Wall wall_ = cell::Wall::kNone;
  pid_t pid_ = -1;  // -1: it is no more
  int in_ = -1;     // our end of its standard input
  int out_ = -1;
  int err_ = -1;
  std::string errors_;  // the end of what it said
  bool was_killed_ = false;
};

}  // namespace mlab::robot_host
