#include "mlab/cell/tied_fork.h"

#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <system_error>
#include <thread>

namespace mlab::cell {
namespace {

/// The thread that forks, and who waits for it.
class Forker {
 public:
  /// @errors  std::system_error: there can be no more threads
  Forker() : owner_(getpid()) {
    std::thread([this] { work(); }).detach();
  }

  pid_t owner() const { return owner_; }

  pid_t fork_one(const std::function<void()>& in_child) {
    const std::scoped_lock turn(turn_);
    std::unique_lock lock(mutex_);
    in_child_ = &in_child;
    changed_.notify_all();
    changed_.wait(lock, [this] { return in_child_ == nullptr; });
    errno = failure_;
    return child_;
  }

 private:
  [[noreturn]] void work() {
    // Signals are for the threads that know what to do with them.
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, nullptr);
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [this] { return in_child_ != nullptr; });
      child_ = fork();
      failure_ = errno;
      if (child_ == 0) become();
      in_child_ = nullptr;
      changed_.notify_all();
    }
  }

  [[noreturn]] void become() const {
    // This process may have ended before the kernel was told.
    if (prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 && getppid() == owner_) (*in_child_)();
    _exit(127);
  }

  const pid_t owner_;
  std::mutex turn_;  // of those who wait
  std::mutex mutex_;
  std::condition_variable changed_;
  const std::function<void()>* in_child_ = nullptr;  // not null: is to be forked
  pid_t child_ = -1;
  int failure_ = 0;
};

// Never taken away, as its thread goes on until the end. A process that was forked from this one has none of
// its threads.
Forker& forker_of_process() {
  static std::mutex mutex;
  static Forker* forker = nullptr;
  const std::scoped_lock lock(mutex);
  if (forker == nullptr || forker->owner() != getpid()) forker = new Forker;
  return *forker;
}

}  // namespace

pid_t tied_fork(const std::function<void()>& in_child) {
  try {
    return forker_of_process().fork_one(in_child);
  } catch (const std::system_error& failure) {
    errno = failure.code().value();
    return -1;
  }
}

}  // namespace mlab::cell
