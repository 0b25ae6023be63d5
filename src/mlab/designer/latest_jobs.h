#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

namespace mlab::designer {

/// A thread for what takes long, where only the newest job of each name matters: one that waits is replaced,
/// and one that is being done is told that it may give up. Jobs that have not begun when it ends are dropped.
class LatestJobs {
 public:
  /// Whether what the job finds is of no use any more.
  using IsStale = std::function<bool()>;
  using Job = std::function<void(const IsStale& is_stale)>;

  LatestJobs() : thread_([this] { work(); }) {}
  ~LatestJobs() {
    {
      const std::scoped_lock lock(mutex_);
      ends_ = true;
    }
    wakes_.notify_one();
    thread_.join();
  }
  LatestJobs(const LatestJobs&) = delete;
  LatestJobs& operator=(const LatestJobs&) = delete;

  void start(const std::string& name, Job job) {
    {
      const std::scoped_lock lock(mutex_);
      if (!jobs_.contains(name)) order_.push_back(name);
      jobs_[name] = std::move(job);
    }
    wakes_.notify_one();
  }

 private:
  void work() {
    std::unique_lock lock(mutex_);
    while (true) {
      wakes_.wait(lock, [&] { return ends_ || !order_.empty(); });
      if (ends_) return;
      const std::string name = std::move(order_.front());
      order_.pop_front();
      const Job job = std::move(jobs_.extract(name).mapped());
      lock.unlock();
      job([&] {
        const std::scoped_lock asking(mutex_);
        return ends_ || jobs_.contains(name);
      });
      lock.lock();
    }
  }

  std::mutex mutex_;
  std::condition_variable wakes_;
  std::map<std::string, Job> jobs_;
  std::deque<std::string> order_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace mlab::designer
