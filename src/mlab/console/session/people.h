#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "mlab/console/run/event_log.h"
#include "mlab/console/session.h"
#include "mlab/console/session/request.h"

namespace mlab::console {

/// Everybody who is connected: who they are, what is under way to them, and what each may ask for.
class People {
 public:
  /// @param welcome  what everybody is greeted with, but for the number of the client
  People(Welcome welcome, Session::Send send);

  // ---- who is here

  /// Takes in who says Hello. @errors  a sentence; nobody has come then
  Answered join(ConnectionId from, const Hello& hello);
  void leave(ConnectionId from);
  /// Forgets who has been away for too long.
  void forget();
  /// Nothing where no client has that connection.
  std::optional<Sender> find(ConnectionId from);
  const Roles& roles() const { return roles_; }
  /// As Roles::recall.
  void recall(std::vector<Roles::Client> clients, std::uint32_t operator_id) {
    roles_.recall(std::move(clients), operator_id, wall_time());
  }
  std::map<ConnectionId, Channel>& channels() { return channels_; }
  const std::map<ConnectionId, Channel>& channels() const { return channels_; }

  // ---- what they ask for

  /// Why somebody may not do what only the operator may.
  Answered why_no_operator(const Roles::Client& client) const;
  void acknowledge(const Sender& sender, const Acknowledge& drawn);
  void beat(const Sender& sender, const Beat& beat);
  /// True: the client is the operator now; false: who is has been asked.
  bool take_operator(const Roles::Client& client) { return roles_.take(client.id); }
  /// As Roles::pass.
  Answered pass_operator(const Roles::Client& client, std::uint32_t to) { return roles_.pass(client.id, to); }

  // ---- what they are told

  void send(ConnectionId to, const ToBrowser& message) const;
  /// @param of_run  who looks at another moment of the run is left out
  void broadcast(const ToBrowser& message, bool of_run = false) const;
  void welcome(ConnectionId to) const;
  /// What each has not been told yet.
  void send_log(Channel& channel, const EventLog& log) const;
  /// So that everybody sees that the session's thread is alive.
  void send_beats();

 private:
  void send_beat(const Channel& channel) const;

  const Welcome welcome_;
  const Session::Send send_;
  Roles roles_;
  std::map<ConnectionId, Channel> channels_;
  double last_beats_ = -1e9;
};

}  // namespace mlab::console
