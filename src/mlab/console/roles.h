#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mlab/console/server/connection_id.h"

namespace mlab::console {

class Clients;

/// Who looks at the session, and who of them is the operator: the first who comes, then whoever the place is
/// handed over to. A client outlives its connection for kKept, and is the same one when it comes back with
/// its key.
///
/// Times are seconds of any clock that does not go back.
class Roles {
 public:
  static constexpr double kKept = 60.0;

  struct Client {
    std::uint32_t id = 0;  ///< from 1, never used again
    std::string name;
    std::string key;
    ConnectionId connection;  ///< 0: it has none now
    double left = 0.0;        ///< when it lost its connection
  };
  struct Joined {
    std::uint32_t client = 0;
    /// A connection that had the same key and is somebody else from now on (a duplicated browser tab); 0:
    /// none.
    ConnectionId displaced;
  };

  Joined join(ConnectionId connection, const std::string& name, const std::string& key, double now);
  /// False where nobody had that connection.
  bool leave(ConnectionId connection, double now);
  /// Forgets who has been away for too long. True where somebody was.
  bool forget(double now);
  /// When somebody is to be forgotten; nothing: nobody is away.
  std::optional<double> next_to_forget() const;

  /// Null where nobody has that connection.
  const Client* of(ConnectionId connection) const;
  const Client* find(std::uint32_t client) const;
  bool is_operator(std::uint32_t client) const { return client != 0 && client == operator_; }
  std::uint32_t operator_id() const { return operator_; }
  /// Who wants to be the operator; 0: nobody.
  std::uint32_t asks() const { return asks_; }

  /// @return true: the client is the operator now; false: the holder has been asked
  bool take(std::uint32_t client);
  /// The operator gives the place away, or declines (client 0).
  /// @errors  a sentence: not the operator, nobody of that number is here
  std::optional<std::string> pass(std::uint32_t from, std::uint32_t to);

  /// In the order in which they came, those who are away for a while too.
  const std::vector<Client>& clients() const { return clients_; }
  /// Those of an earlier session, who are away until they come back with their keys. Only where nobody has
  /// come yet.
  void recall(std::vector<Client> clients, std::uint32_t operator_id, double now);

  void encode(Clients& out) const;

 private:
  std::uint32_t add(ConnectionId connection, const std::string& name, const std::string& key);

  std::vector<Client> clients_;  // in the order in which they came
  std::uint32_t last_ = 0;
  std::uint32_t operator_ = 0;
  std::uint32_t asks_ = 0;
};

}  // namespace mlab::console
