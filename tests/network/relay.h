#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "descriptor.h"
#include "event_loop.h"
#include "link.h"

namespace mlab::network {

/// Joins hosts: takes Ethernet frames with IPv4 packets from each, and hands them to those that they are for,
/// late, twice, or never, as is set for each ordered pair of hosts. One for all (10.77.0.255,
/// 255.255.255.255) and multicasts go to all others, whoever listens. What is no IPv4, for nobody here, or
/// IGMP is ignored and counted.
///
/// Hosts are numbers, from 1. All calls are safe from all threads; settings hold for packets that come later.
class Relay {
 public:
  explicit Relay(std::uint64_t seed);
  Relay(const Relay&) = delete;
  Relay& operator=(const Relay&) = delete;

  /// @param wire  gives one frame for each read(2) and takes one for each write(2), without blocking
  void attach(int host, Descriptor wire);
  /// What is under way to it is lost. Afterwards its descriptor is closed.
  void detach(int host);

  /// All links, those of hosts that are attached later, too.
  void set(const Link& link);
  void set(int from, int to, const Link& link);
  Link link(int from, int to) const;
  /// Whether anything gets from one to the other; what is under way does not arrive, either.
  void cut(int from, int to, bool is_cut);

  Counters counters(int from, int to) const;
  Counters total() const;
  std::uint64_t ignored() const;
  /// Frames that a wire dropped because nobody came to read them, where it is one that counts those itself.
  std::uint64_t overruns(int host);

 private:
  using Frame = std::vector<std::uint8_t>;

  /// From one host to another.
  struct Way {
    Way(std::uint64_t seed, int from, int to, const Link& settings) : link(settings), wire(seed, from, to) {}
    Link link;
    Wire wire;
    Counters counters;
    bool is_cut = false;
  };
  /// Under way.
  struct Waiting {
    Time due;
    std::uint64_t order = 0;  ///< of those that are due together
    int from = 0;
    int to = 0;
    bool is_twice = false;
    Frame frame;
  };
  /// Who has to wait longest is the least.
  struct IsLater {
    bool operator()(const Waiting& a, const Waiting& b) const {
      return a.due != b.due ? a.due > b.due : a.order > b.order;
    }
  };

  void read_from(int host);
  void route(int from, std::span<std::uint8_t> frame);
  void send(int from, int to, std::span<std::uint8_t> frame, Time now);
  void deliver(Way& way, int to, std::span<std::uint8_t> frame, bool is_twice);
  void deliver_due();
  void set_timer();
  Way& way(int from, int to);

  const std::uint64_t seed_;
  Descriptor timer_;
  mutable std::mutex mutex_;  ///< of all that follows
  Link all_;
  std::map<int, Descriptor> wires_;
  std::map<std::pair<int, int>, Way> ways_;
  std::priority_queue<Waiting, std::vector<Waiting>, IsLater> waiting_;
  std::uint64_t order_ = 0;
  std::uint64_t ignored_ = 0;
  std::map<int, std::uint64_t> overruns_;
  Time timer_is_set_for_{};
  EventLoop loop_;  ///< the last, so that its thread has ended before anything else goes
};

}  // namespace mlab::network
