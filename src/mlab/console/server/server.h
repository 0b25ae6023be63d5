#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/console/server/connection_id.h"
#include "mlab/metrics/exposition.h"

namespace mlab::console {

/// Where a server listens, and what it serves.
struct ServerSettings {
  std::string address = "127.0.0.1";    ///< an IP address of this machine
  std::vector<std::uint16_t> ports{0};  ///< tried in this order; 0: any free one
  std::string certificate;              ///< PEM file with the chain; empty: no TLS
  std::string key;                      ///< PEM file
  std::string web_folder;               ///< index.html and what it loads
  std::string token;                    ///< empty: a new random one
  std::uint16_t token_port = 0;         ///< the only port that the token is good for; 0: any
};

/// Bytes to be sent, and what they are.
struct Content {
  std::string type;                          ///< MIME
  std::shared_ptr<const std::string> bytes;  ///< none: there is no such thing
};

/// What the server calls for one of its WebSockets.
struct SocketHandlers {
  /// Takes a message of a connection, in order of arrival. False: the bytes are none, and the connection
  /// ends.
  std::function<bool(ConnectionId, std::string_view bytes)> receive;
  /// Nothing comes from this connection any more.
  std::function<void(ConnectionId)> closed;
};

/// What the server calls. `picture`, `tile` and `report` come from a thread of their own, and may wait; the
/// others come from its network thread and must not block.
struct ServerHandlers {
  SocketHandlers session;
  SocketHandlers designer;  ///< of `/designer`; none: there is no designer
  std::function<void()> emergency_stop;
  std::function<Content(std::uint64_t revision)> picture;
  /// A square of the map of the Earth; none: there is no such map.
  std::function<Content(std::uint32_t zoom, std::uint32_t column, std::uint32_t row)> tile;
  std::function<std::string()> report;                ///< JSON
  std::function<void(metrics::Exposition&)> metrics;  ///< what is told beside what the server knows itself
};

/// HTTP and WebSocket for the operator console, on one thread. Knows browsers, tokens and files, and nothing
/// of missions or messages. Whatever a stranger sends, the worst that happens is that his own connection
/// ends.
class Server {
 public:
  /// Reads the web files and the certificate, and takes its port; nobody is answered before `start`.
  /// @return null where that can't be done; `error` is then a sentence for a person
  static std::unique_ptr<Server> open(const ServerSettings& settings, std::string& error);
  /// As `stop`.
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  void start(ServerHandlers handlers);
  /// Ends all connections and the thread. Afterwards no handler is called, and `send` does nothing.
  void stop();

  /// Hands a message to a connection; from any thread, at once. Who does not
  /// take what is sent is disconnected; for a connection that is gone nothing happens.
  void send(ConnectionId to, std::shared_ptr<const std::string> bytes);

  std::uint16_t port() const;
  const std::string& token() const;
  /// What to open in a browser, token included: first from this machine, then, where it listens to others,
  /// from elsewhere.
  /// @param page  `designer.html`; empty: the console's
  std::vector<std::string> urls(const std::string& page = "") const;
  bool is_encrypted() const;
  /// Only this machine reaches it.
  bool is_loopback() const;

 private:
  class Network;
  explicit Server(std::unique_ptr<Network> network);
  std::unique_ptr<Network> network_;
};

}  // namespace mlab::console
