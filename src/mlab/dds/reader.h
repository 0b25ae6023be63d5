#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/dds/message.h"
#include "mlab/dds/waiter.h"

namespace mlab::dds {

/// One topic, read. Made by Participant::reader; it takes part until it is destroyed.
///
/// What arrives is fetched by Cyclone's receiving thread, as it arrives, into a queue of the reader's own, so
/// that a thread that takes nothing for a while holds up neither the network nor other readers. At most
/// kMaxWaiting arrivals and kMaxWaitingBytes of them wait there; what comes on top is counted and told
/// (Arrival::Kind::kLost), of reliable channels too. Messages of a writer come in its order as far as they
/// have the same key. May be used by any thread.
class Reader {
 public:
  static constexpr std::size_t kMaxWaiting = 65'536;
  static constexpr std::size_t kMaxWaitingBytes = 64UL * 1024 * 1024;

  Reader(Reader&&) noexcept;
  Reader& operator=(Reader&&) noexcept;
  ~Reader();

  /// All that has arrived since the last call; never waits.
  std::vector<Arrival> take();

  /// Messages of one sender under one key, for another thread: one that serves a conversation of many on this
  /// topic, and would otherwise have to be woken by the one that serves the topic.
  class Branch;
  /// From now on those messages go there, and nothing of them to `take`; what has arrived before does. All
  /// else that concerns their sender is told here.
  /// @param waiter  is signalled whenever there is something to take from the branch
  /// @return  it has to end before the reader
  Branch branch(const Guid& sender, std::string_view key, const Waiter& waiter);

  /// The participants that write this topic, as what it is read as, and are not silent.
  std::vector<Guid> senders() const;

  /// Who writes this topic as something else, or in a way that can't be read here: a sentence each, at most
  /// 20. Nothing that those write is taken. Empty is how it should be.
  std::vector<std::string> mismatches() const;

 private:
  friend class Participant;
  class State;
  explicit Reader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

class Reader::Branch {
 public:
  Branch(Branch&& other) noexcept;
  Branch& operator=(Branch&&) = delete;
  ~Branch();
  /// As Reader::take: messages, and Arrival::Kind::kLost.
  std::vector<Arrival> take();

 private:
  friend class Reader;
  struct Queue;
  Branch(State& reader, std::shared_ptr<Queue> queue);
  State* reader_;  // null: moved from
  std::shared_ptr<Queue> queue_;
};

}  // namespace mlab::dds
