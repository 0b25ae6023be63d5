#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "mlab/dds/participant.h"

namespace mlab::dds {

/// A name that no other process uses: tests run side by side.
std::string fleet_of_this_process();

Participant participant(int lost_of_thousand = 0, const std::string& fleet = fleet_of_this_process());
/// One that does not meet others of this machine that are so.
Participant avoiding_participant(const std::string& fleet = fleet_of_this_process());
Waiter waiter();
Writer writer(Participant& participant, const std::string& topic, ChannelKind kind,
              const Waiter* waiter = nullptr);
Reader reader(Participant& participant, const std::string& topic, ChannelKind kind, const Waiter& waiter);

/// Waits until `condition` holds, and asks again whenever the waiter is signalled, and now and then.
/// @return  whether it came to hold within the limit, which machines under load don't need to reach
bool comes_true(Waiter& waiter, const std::function<bool()>& condition,
                std::chrono::milliseconds limit = std::chrono::seconds(30));

/// All that the reader is told until `count` of the kind are among it, or the limit is over.
std::vector<Arrival> arrivals(Waiter& waiter, Reader& reader, Arrival::Kind kind, std::size_t count = 1,
                              std::chrono::milliseconds limit = std::chrono::seconds(30));
/// The bodies of messages among them.
std::vector<std::string> bodies(const std::vector<Arrival>& arrivals);
/// The first of a kind; a default one with no sender where there is none.
Arrival first_of(const std::vector<Arrival>& arrivals, Arrival::Kind kind);

/// Writes it as often as it takes.
void write_surely(Writer& writer, const std::string& key, const std::string& body);

/// The program `dds_peer` (testing/peer.cc) as a child, in the fleet of this process. It is killed in the
/// end.
class Peer {
 public:
  explicit Peer(std::vector<std::string> words, int lost_of_thousand = 0);
  Peer(Peer&& other) noexcept : child_(other.child_) { other.child_ = -1; }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  Peer& operator=(Peer&&) = delete;
  ~Peer();

  void signal(int number) const;

 private:
  pid_t child_ = -1;
};

}  // namespace mlab::dds
