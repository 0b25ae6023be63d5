#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <span>
#include <thread>
#include <tuple>
#include <vector>

#include "mlab/flow/behavior.h"
#include "mlab/flow/frame.h"

namespace mlab::flow {

/// Which run of which asynchronous node: unique in a simulation.
struct JobKey {
  std::uint32_t robot = 0;
  std::uint64_t path_hash = 0;
  std::uint64_t cycle = 0;  ///< in which it was started

  friend auto operator<=>(const JobKey&, const JobKey&) = default;
};

/// One firing of an asynchronous behavior, with everything it may read copied: what it computes depends on
/// nothing else.
struct Job {
  const Behavior* behavior = nullptr;
  Frame frame;                        ///< a copy; inputs are read from it, output and state are written to it
  std::vector<std::uint32_t> inputs;  ///< as Call::inputs
  std::uint32_t output = 0;
  std::uint32_t state = 0;
  bool is_first = false;
  std::uint64_t path_hash = 0;
  double time = 0.0;
  double cycle_duration = 0.0;
  std::uint64_t seed = 0;
  std::uint32_t robot = 0;
  std::uint64_t cycle = 0;

  /// Computes it, on the calling thread.
  void compute();
};

/// Runs asynchronous behaviors on threads of its own. Whether a job ran here or was computed in place makes
/// no difference to its value.
class AsyncRunner {
 public:
  explicit AsyncRunner(unsigned threads);
  /// Finishes the running jobs, drops the waiting ones.
  ~AsyncRunner();
  AsyncRunner(const AsyncRunner&) = delete;
  AsyncRunner& operator=(const AsyncRunner&) = delete;

  void start(const JobKey& key, Job job);
  /// Waits until the job is done and hands it over. False where no such job was started (after a checkpoint
  /// was restored, say): the caller then computes it itself.
  bool take(const JobKey& key, Job& out);
  /// Jobs that are waiting, running, or not yet taken.
  std::size_t size() const;

 private:
  struct Entry {
    Job job;
    bool is_done = false;
  };
  void work();

  mutable std::mutex mutex_;
  std::condition_variable wake_workers_;
  std::condition_variable wake_takers_;
  std::map<JobKey, Entry> entries_;
  std::deque<JobKey> waiting_;
  bool stops_ = false;
  std::vector<std::jthread> threads_;
};

}  // namespace mlab::flow
