#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace mlab::console {

/// A thread for what takes long (compiling, making a large run), so that the session goes on meanwhile. Jobs
/// are done one after the other; those that have not begun when it ends are dropped.
class Workshop {
 public:
  Workshop() : thread_([this] { work(); }) {}
  ~Workshop() {
    {
      const std::scoped_lock lock(mutex_);
      ends_ = true;
    }
    wakes_.notify_one();
    thread_.join();
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  void start(std::function<void()> job) {
    {
      const std::scoped_lock lock(mutex_);
      jobs_.push_back(std::move(job));
    }
    wakes_.notify_one();
  }

 private:
  void work() {
    std::unique_lock lock(mutex_);
    while (true) {
      wakes_.wait(lock, [&] { return ends_ || !jobs_.empty(); });
      if (ends_) return;
      const std::function<void()> job = std::move(jobs_.front());
      jobs_.pop_front();
      lock.unlock();
      job();
      lock.lock();
    }
  }

  std::mutex mutex_;
  std::condition_variable wakes_;
  std::deque<std::function<void()>> jobs_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace mlab::console
