#pragma once

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
  using Time = std::chrono::steady_clock::time_point;

  void post(Task task) {
    {
      const std::scoped_lock lock(mutex_);
      tasks_.push_back(std::move(task));
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
    return std::exchange(tasks_, {});
  }

 private:
  std::mutex mutex_;
  std::condition_variable wakes_;
  std::vector<Task> tasks_;
  bool is_woken_ = false;
};

}  // namespace mlab::console
