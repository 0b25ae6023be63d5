#pragma once

#include <sys/types.h>

#include <mutex>
#include <string>
#include <vector>

#include "descriptor.h"
#include "keeper/setup.h"
#include "message.h"
#include "victim.h"

namespace mlab::network {

/// A keeper, the process that makes a host and holds it, as the test sees it. With this object it ends, and
/// all that is on the host; also when this process is killed.
class Connection {
 public:
  /// @errors  std::runtime_error: why such a host can't be made here
  explicit Connection(const KeeperSetup& setup);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// @return  the keeper's answer; words `failed` and why where there is none. Safe from all threads.
  Message ask(const std::vector<std::string>& words, const std::vector<int>& files = {});
  /// All on the host are killed at once, as if its power went. Comes back when they have ended.
  void end();
  bool is_open() const { return keeper_ > 0; }

  /// The first process of the host, from which all others descend.
  const Victim& first() const { return first_; }
  /// Once.
  Descriptor take_wire() { return std::move(wire_); }

 private:
  std::mutex mutex_;  ///< a question and its answer
  Descriptor socket_;
  Descriptor wire_;
  pid_t keeper_ = -1;
  Victim first_;
};

}  // namespace mlab::network
