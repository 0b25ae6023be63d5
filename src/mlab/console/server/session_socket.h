#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <memory>
#include <string>

#include <boost/asio/as_tuple.hpp>
#include <boost/asio/cancellation_signal.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <boost/beast/websocket/stream.hpp>

#include "mlab/console/server/desk.h"
#include "mlab/console/server/stream.h"

namespace mlab::console {

inline constexpr auto kReturned = asio::as_tuple(asio::use_awaitable);
using Request = beast::http::request<beast::http::string_body>;

/// A browser's WebSocket: hands on what comes, and sends what waits, one message after the other.
class SessionSocket final : public Recipient, public std::enable_shared_from_this<SessionSocket> {
 public:
  /// @param handlers  the desk's for this socket
  SessionSocket(Stream stream, Desk& desk, const SocketHandlers& handlers)
      : desk_(desk),
        handlers_(handlers),
        socket_(std::move(stream)),
        wake_(desk.io),
        deadline_(desk.io),
        end_(desk.io) {}

  /// From the handshake to the end.
  asio::awaitable<void> run(const Request& request);

  void send(std::shared_ptr<const std::string> bytes) override;
  void leave(Goodbye why, std::string reason) override;

 private:
  using Clock = std::chrono::steady_clock;

  asio::awaitable<void> read();
  asio::awaitable<void> write();
  bool is_stuck() const {
    return waiting_bytes_ > limits::kWaitingBytes ||
           (waiting_bytes_ > limits::kStuckBytes && Clock::now() - last_taken_ > limits::kStuck);
  }
  // Nothing is sent or read any more.
  void end() {
    is_over_ = true;
    wake_.cancel();
    deadline_.cancel();
    end_.cancel();
  }
  // At once, whatever the other side does. Closing the socket is not enough: where Beast closes and finds
  // broken frames at the same time, its two operations wait for each other, not for the socket.
  void hang_up() {
    beast::error_code ignored;
    socket_.next_layer().socket().close(ignored);
    stop_reading_.emit(asio::cancellation_type::terminal);
    stop_writing_.emit(asio::cancellation_type::terminal);
    end();
  }

  Desk& desk_;
  const SocketHandlers& handlers_;
  beast::websocket::stream<Stream> socket_;
  beast::flat_buffer incoming_;
  std::deque<std::shared_ptr<const std::string>> waiting_;
  std::size_t waiting_bytes_ = 0;
  Clock::time_point last_taken_ = Clock::now();
  asio::steady_timer wake_;      // the writer sleeps on it
  asio::steady_timer deadline_;  // for the goodbye
  asio::steady_timer end_;       // cancelled when it is over
  asio::cancellation_signal stop_reading_;
  asio::cancellation_signal stop_writing_;
  ConnectionId id_;
  bool is_leaving_ = false;
  bool is_over_ = false;
  beast::websocket::close_reason goodbye_;
};

}  // namespace mlab::console
