#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

#include "descriptor.h"

namespace mlab::network {

/// A thread that sleeps until one of some descriptors can be read. All calls are safe from all threads.
class EventLoop {
 public:
  EventLoop();
  ~EventLoop();
  EventLoop(const EventLoop&) = delete;
  EventLoop& operator=(const EventLoop&) = delete;

  /// @param descriptor   stays the caller's, open until it is removed
  /// @param on_readable  called by the thread, one at a time, as long as there is something to be read (or
  /// the
  ///                     other side has gone)
  void add(int descriptor, std::function<void()> on_readable);
  /// Afterwards it is not called any more, and no call goes on. A callback may remove itself. Who waits here
  /// holds no lock that a callback takes.
  void remove(int descriptor);

 private:
  void work();

  using Callback = std::shared_ptr<const std::function<void()>>;

  Descriptor poll_;
  Descriptor end_;              ///< can be read once the thread shall end
  std::recursive_mutex mutex_;  ///< of `callbacks_`; held while one is called
  std::map<int, Callback> callbacks_;
  std::thread thread_;
};

}  // namespace mlab::network
