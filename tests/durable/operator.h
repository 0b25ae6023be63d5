#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "server.h"
#include "socket.h"

#include "mlab/console.pb.h"

namespace mlab::durable {

/// Somebody at a console, always in the same browser tab.
class Operator {
 public:
  /// Says Hello, and waits until all is told.
  explicit Operator(const Server& server);

  /// Asks, without waiting for the answer. @return  the request's number
  std::uint32_t send(console::ToServer message);
  /// Asks, and waits. Nothing: the server has gone.
  std::optional<console::Reply> ask(console::ToServer message);
  std::optional<console::Reply> control(console::Control::Action action);
  std::optional<console::Reply> type(const std::string& line);
  /// Takes what comes until it is so; false where the server goes before, or for a minute nothing comes.
  bool wait(const std::function<bool()>& is_so);
  /// Takes what comes for so long [s].
  void listen(double seconds);

  const console::Status& status() const { return status_; }
  const console::Journal& journal() const { return journal_; }
  const console::Clients& clients() const { return clients_; }
  const console::Breakpoints& breakpoints() const { return breakpoints_; }
  std::uint32_t id() const { return id_; }
  bool has_log(const std::string& text) const;
  const std::vector<console::Log::Entry>& log() const { return log_; }
  /// Answers by request.
  const std::map<std::uint32_t, console::Reply>& replies() const { return replies_; }

 private:
  bool take(double seconds);

  Socket socket_;
  std::uint32_t request_ = 0;
  std::uint32_t id_ = 0;
  bool is_greeted_ = false;
  std::map<std::uint32_t, console::Reply> replies_;
  console::Status status_;
  console::Journal journal_;
  console::Clients clients_;
  console::Breakpoints breakpoints_;
  std::vector<console::Log::Entry> log_;
};

}  // namespace mlab::durable
