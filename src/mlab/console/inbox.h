#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

namespace mlab::console {

/// What other threads want done on the session's thread, in their order.
class Inbox {
 public:
  using Task = std::function<void()>;
  using Clock = std::chrono::steady_clock;
  using Time = Clock::time_point;

  /// What a task has to do with a cycle that is waited for, because some robot's own process computes it.
  enum class Kind {
    kAfterCycle,   ///< changes the run: when the cycle is over
    kDuringCycle,  ///< leaves the run alone: at once, unless something that was posted before it waits
    kAtOnce,    ///< the same, and nothing that was posted before it makes a difference: an answer to a beat
    kEndsWait,  ///< a person has had enough: when the cycle is over, which is not waited for any longer
  };

  void post(Task task, Kind kind = Kind::kAfterCycle) {
    {
      const std::scoped_lock lock(mutex_);
      tasks_.push_back({std::move(task), kind, Clock::now()});
    }
    wakes_.notify_one();
  }
  /// The session looks around at once, though there is no task.
  void wake() {
    {
      const std::scoped_lock lock(mutex_);
      is_woken_ = true;
    }
    wakes_.notify_one();
  }
  /// Sleeps until there is a task, somebody wakes it, or the time has come; then hands over all tasks.
  std::vector<Task> wait_until(Time time) {
    std::unique_lock lock(mutex_);
    wakes_.wait_until(lock, time, [&] { return is_woken_ || !tasks_.empty(); });
    is_woken_ = false;
    std::vector<Task> out;
    for (Posted& one : std::exchange(tasks_, {})) out.push_back(std::move(one.task));
    return out;
  }
  /// The tasks that may be done during a cycle, without waiting. The others stay, in their order.
  std::vector<Task> take_for_cycle() {
    const std::scoped_lock lock(mutex_);
    std::vector<Task> out;
    bool has_waiting = false;
    std::erase_if(tasks_, [&](Posted& one) {
      const bool goes = one.kind == Kind::kAtOnce || (one.kind == Kind::kDuringCycle && !has_waiting);
      has_waiting = has_waiting || !goes;
      if (!goes) return false;
      out.push_back(std::move(one.task));
      return true;
    });
    return out;
  }
  /// Somebody wants the cycle over: with a task that says so, or with one that has waited for so long [s].
  bool wants_cycle_over(double patience) const {
    const std::scoped_lock lock(mutex_);
    const auto since =
        Clock::now() - std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(patience));
    return std::ranges::any_of(tasks_, [&](const Posted& one) {
      return one.kind == Kind::kEndsWait || (one.kind == Kind::kAfterCycle && one.posted < since);
    });
  }

 private:
  struct Posted {
    Task task;
    Kind kind;
    Time posted;
  };
  mutable std::mutex mutex_;
  std::condition_variable wakes_;
  std::vector<Posted> tasks_;
  bool is_woken_ = false;
};

}  // namespace mlab::console
