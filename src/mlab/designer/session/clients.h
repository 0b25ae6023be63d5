#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/console/server/connection_id.h"
#include "mlab/designer.pb.h"
#include "mlab/designer/designer.h"

namespace mlab::designer {

struct Sender;

/// A browser, and what it has open.
struct Client {
  bool has_greeted = false;
  std::uint64_t beat = 0;  ///< number of its last one
  /// By path; each with a number of its own for every time that it was opened.
  std::map<std::string, std::uint64_t, std::less<>> documents;
  std::vector<Page> pages;  ///< that it looks at

  /// 0: it has not opened it.
  std::uint64_t opening_of(std::string_view document) const {
    const auto found = documents.find(document);
    return found == documents.end() ? 0 : found->second;
  }
};

/// Everybody who is connected, and what each has open.
class Clients {
 public:
  explicit Clients(Designer::Send send) : send_(std::move(send)) {}

  // ---- who is here

  /// Who has that connection; whoever is new is taken in.
  Client& of(console::ConnectionId connection) { return all_[connection]; }
  /// Null: nobody.
  Client* find(console::ConnectionId connection);
  void leave(console::ConnectionId connection) { all_.erase(connection); }
  const std::map<console::ConnectionId, Client>& all() const { return all_; }

  // ---- what they have open

  void open(Client& client, const std::string& document);
  /// With its pages.
  void close(Client& client, const std::string& document);
  bool is_open(std::string_view document) const;
  /// Whether somebody else has it open as well.
  bool is_open_beside(const Client& client, std::string_view document) const;
  /// The document has another name from now on: whoever has it open is told, and has it open anew.
  void rename(const std::string& from, const std::string& to);
  void look(const Sender& sender, const Look& look);

  // ---- what they are told

  void send(console::ConnectionId to, const FromDesigner& message) const;
  void send_bytes(console::ConnectionId to, std::string bytes) const;
  /// Says to all, a few times a second, that the designer's thread goes on.
  void send_beats();
  void beat(const Sender& sender, const console::Beat& beat);

 private:
  void send_beat(console::ConnectionId to, const Client& client) const;

  const Designer::Send send_;
  std::map<console::ConnectionId, Client> all_;
  std::uint64_t openings_ = 0;
  double last_beats_ = 0.0;
};

}  // namespace mlab::designer
