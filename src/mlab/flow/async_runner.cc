#include "mlab/flow/async_runner.h"

#include <utility>

namespace mlab::flow {

void Job::compute() {
  percept::Percepts percepts;  // an asynchronous behavior sees its inputs and the time, nothing else
  percepts.time = time;
  percepts.cycle_duration = cycle_duration;
  percept::Action action;
  const Cycle context{&percepts, &action, cycle, seed, robot};
  // Who fired before did so in the cycle before, whenever that was.
  Call call{{output, state, path_hash}, &context, frame.data(), inputs.data(), 2U, is_first ? 0U : 1U};
  behavior->fire(call);
}

AsyncRunner::AsyncRunner(unsigned threads) {
  for (unsigned i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
}

AsyncRunner::~AsyncRunner() {
  {
    const std::lock_guard lock(mutex_);
    stops_ = true;
  }
  wake_workers_.notify_all();
}

void AsyncRunner::start(const JobKey& key, Job job) {
  {
    const std::lock_guard lock(mutex_);
    entries_[key] = {std::move(job), false};
    waiting_.push_back(key);
  }
  wake_workers_.notify_one();
}

bool AsyncRunner::take(const JobKey& key, Job& out) {
  std::unique_lock lock(mutex_);
  const auto it = entries_.find(key);
  if (it == entries_.end()) return false;
  wake_takers_.wait(lock, [&] { return it->second.is_done; });
  out = std::move(it->second.job);
  entries_.erase(it);
  return true;
}

std::size_t AsyncRunner::size() const {
  const std::lock_guard lock(mutex_);
  return entries_.size();
}

void AsyncRunner::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_workers_.wait(lock, [this] { return stops_ || !waiting_.empty(); });
    if (stops_) return;
    const JobKey key = waiting_.front();
    waiting_.pop_front();
    Entry& entry = entries_.at(key);  // stays where it is: a map does not move its entries
    lock.unlock();
    entry.job.compute();
    lock.lock();
    entry.is_done = true;
    wake_takers_.notify_all();
  }
}

}  // namespace mlab::flow
