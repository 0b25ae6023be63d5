#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include <boost/asio/awaitable.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/thread_pool.hpp>

#include "mlab/console/server/routes.h"
#include "mlab/console/server/server.h"

// Inside the server: what its connections share. Includes Asio, so only the sources of the network include
// it.

namespace mlab::console {

namespace asio = boost::asio;
using Tcp = asio::ip::tcp;

/// What strangers are allowed before they are sent away.
namespace limits {
inline constexpr std::size_t kConnections = 192;  ///< the oldest that is no session makes room
inline constexpr std::size_t kSessions = 64;
inline constexpr std::uint32_t kHeaderBytes = 16U * 1024U;
inline constexpr std::uint64_t kBodyBytes = std::uint64_t{64} * 1024;
inline constexpr std::size_t kMessageBytes = std::size_t{4} << 20;
inline constexpr std::chrono::seconds kHandshake{10};  ///< for TLS, for a request, for the WebSocket
inline constexpr std::chrono::seconds kBetweenRequests{30};
inline constexpr std::chrono::seconds kAnswer{30};  ///< to take an answer
inline constexpr std::chrono::seconds kIdle{20};  ///< then a session is pinged; a second time, and it is gone
inline constexpr std::chrono::seconds kGoodbye{2};  ///< for the other side to agree to an end
/// What waits for a session that has taken nothing for kStuck, and what waits at most.
inline constexpr std::size_t kStuckBytes = std::size_t{8} << 20;
inline constexpr std::size_t kWaitingBytes = std::size_t{64} << 20;
inline constexpr std::chrono::seconds kStuck{2};
}  // namespace limits

/// Why a session ends, as codes of RFC 6455.
enum class Goodbye : std::uint16_t {
  kGoingAway = 1001,
  kUnknownData = 1003,
  kBadMessage = 1007,
  kPolicy = 1008,
  kTryLater = 1013
};

/// A session's socket. Lives on the network thread.
class Recipient {
 public:
  virtual ~Recipient() = default;
  virtual void send(std::shared_ptr<const std::string> bytes) = 0;
  virtual void leave(Goodbye why, std::string reason) = 0;
};

/// A connection.
struct Visitor {
  Tcp::socket* socket = nullptr;  ///< null: it is a session, which is ended in its own way
};

/// What went over the network, since the server started.
struct Traffic {
  std::uint64_t sent_bytes = 0;                ///< of answers and messages, without what TLS and TCP add
  std::uint64_t messages = 0;                  ///< to sessions
  std::map<unsigned, std::uint64_t> answered;  ///< requests, by status
  std::uint64_t ended_sessions = 0;            ///< that the server has ended: what they sent or did not take
};

/// What all connections of a server share. Everything but `waiting` and `routes` belongs to the network
/// thread.
struct Desk {
  Desk(asio::io_context& context, Routes table) : routes(std::move(table)), io(context) {}

  Routes routes;
  ServerHandlers handlers;
  std::list<Visitor> visitors;  ///< oldest first
  std::map<ConnectionId, std::shared_ptr<Recipient>> sessions;
  ConnectionId last_session;
  Traffic traffic;
  asio::thread_pool waiting{1};  ///< where answers are made that may have to wait
  asio::io_context& io;
};

/// Answers one connection until it ends. `tls`, which must outlive it, is null where it is not encrypted.
asio::awaitable<void> serve(Tcp::socket socket, asio::ssl::context* tls, Desk& desk);

}  // namespace mlab::console
