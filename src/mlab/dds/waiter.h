#pragma once

#include <chrono>
#include <cstdint>
#include <expected>
#include <memory>
#include <string>

namespace mlab::dds {

class WaiterState;

/// What a thread waits with for any number of readers and writers, which signal it whenever something
/// arrives, comes or goes. One thread waits; all else may be called by any thread.
///
/// It has a descriptor (eventfd) for who asks for one: a loop polls it, and Boost.Asio watches it as any
/// other
/// (`asio::posix::stream_descriptor`, then `acknowledge()`). So no code of a caller ever runs on a thread of
/// Cyclone's, where a slow one would hold up the network.
class Waiter {
 public:
  enum class Outcome : std::uint8_t { kNews, kWoken, kTimeout };

  /// @errors  a sentence: none at present
  static std::expected<Waiter, std::string> make();

  /// Until there is something to take from one of the readers, somebody calls `wake`, or `limit` is over.
  /// What happened between two calls is not missed: the next one comes back at once. It may come back with
  /// kNews though everything was taken already. What happened before a call came back is not told again: all
  /// readers are asked after each, also where the wait was for something else.
  ///
  /// @param limit  [ms], 0: only looks; less: no limit
  Outcome wait(std::chrono::milliseconds limit);

  /// Ends the wait under way, or else the next one, with kWoken.
  void wake();

  /// Readable while there is something; -1 for one that was moved from, and where none is
  /// left. It belongs to the waiter.
  int descriptor() const;

  /// For who watches the descriptor by other means: makes it unreadable, until something happens. To be
  /// called before the readers are asked.
  Outcome acknowledge();

 private:
  friend class Participant;
  friend class Reader;
  std::shared_ptr<WaiterState> state_;
};

}  // namespace mlab::dds
