#pragma once

#include <deque>
#include <exception>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include <boost/asio/as_tuple.hpp>
#include <boost/asio/bind_cancellation_slot.hpp>
#include <boost/asio/cancellation_signal.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "mlab/console.pb.h"
#include "mlab/console/server/desk.h"
#include "mlab/designer.pb.h"

namespace mlab::console {

namespace beast = boost::beast;
inline constexpr auto kReturned = asio::as_tuple(asio::use_awaitable);

/// Whose messages a socket carries.
enum class Party : std::uint8_t { kSession, kDesigner };

/// A browser's WebSocket: hands on what comes, and sends what waits, one message after the other.
/// @tparam Stream  beast::tcp_stream, with TLS around it or without
template <class Stream>
class SessionSocket final : public Recipient, public std::enable_shared_from_this<SessionSocket<Stream>> {
 public:
  SessionSocket(Stream stream, Desk& desk, Party party)
      : desk_(desk),
        party_(party),
        socket_(std::move(stream)),
        wake_(desk.io),
        deadline_(desk.io),
        end_(desk.io) {}

  /// From the handshake to the end.
  template <class Request>
  asio::awaitable<void> run(const Request& request);

  void send(std::shared_ptr<const std::string> bytes) override;
  void leave(Goodbye why, std::string reason) override;

 private:
  using Clock = std::chrono::steady_clock;

  asio::awaitable<void> read();
  asio::awaitable<void> write();
  // Hands on one message. False where it is none.
  bool take(ConnectionId id);
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
    beast::get_lowest_layer(socket_).socket().close(ignored);
    stop_reading_.emit(asio::cancellation_type::terminal);
    stop_writing_.emit(asio::cancellation_type::terminal);
    end();
  }

  Desk& desk_;
  Party party_;
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

template <class Stream>
template <class Request>
asio::awaitable<void> SessionSocket<Stream>::run(const Request& request) {
  namespace websocket = beast::websocket;
  beast::get_lowest_layer(socket_).expires_never();
  socket_.set_option(websocket::stream_base::timeout{limits::kHandshake, limits::kIdle, true});
  socket_.read_message_max(limits::kMessageBytes);
  socket_.binary(true);
  socket_.auto_fragment(false);
  const auto [error] = co_await socket_.async_accept(request, kReturned);
  if (error) co_return;
  if (desk_.sessions.size() >= limits::kSessions) {
    const websocket::close_reason full(static_cast<websocket::close_code>(Goodbye::kTryLater),
                                       "too many sessions");
    co_await socket_.async_close(full, kReturned);
    co_return;
  }
  id_ = ConnectionId{++desk_.last_session.value};
  desk_.sessions[id_] = this->shared_from_this();
  const auto self = this->shared_from_this();
  end_.expires_at(asio::steady_timer::time_point::max());
  asio::co_spawn(
      desk_.io, [self] { return self->write(); },
      asio::bind_cancellation_slot(stop_writing_.slot(), asio::detached));
  asio::co_spawn(
      desk_.io, [self] { return self->read(); },
      asio::bind_cancellation_slot(stop_reading_.slot(), [self](const std::exception_ptr&) { self->end(); }));
  while (!is_over_) co_await end_.async_wait(kReturned);
  desk_.sessions.erase(id_);
  (party_ == Party::kDesigner ? desk_.handlers.closed_design : desk_.handlers.closed)(id_);
}

template <class Stream>
asio::awaitable<void> SessionSocket<Stream>::read() {
  for (;;) {
    const auto [error, size] = co_await socket_.async_read(incoming_, kReturned);
    if (error) co_return;
    // Who is leaving is heard no more; what he still sends only has to be read.
    if (!is_leaving_) {
      if (!socket_.got_binary()) {
        leave(Goodbye::kUnknownData, "messages are binary");
      } else if (!take(id_)) {
        leave(Goodbye::kBadMessage, "this is no message of the console's protocol");
      }
    }
    incoming_.consume(incoming_.size());
  }
}

template <class Stream>
bool SessionSocket<Stream>::take(ConnectionId id) {
  const auto bytes = incoming_.cdata();
  if (party_ == Party::kDesigner) {
    auto design = std::make_unique<designer::ToDesigner>();
    if (!design->ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return false;
    desk_.handlers.receive_design(id, std::move(design));
    return true;
  }
  auto message = std::make_unique<ToServer>();
  if (!message->ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return false;
  desk_.handlers.receive(id, std::move(message));
  return true;
}

template <class Stream>
asio::awaitable<void> SessionSocket<Stream>::write() {
  while (!is_over_) {
    if (is_leaving_) {
      co_await socket_.async_close(goodbye_, kReturned);
      co_return;
    }
    if (waiting_.empty()) {
      wake_.expires_at(asio::steady_timer::time_point::max());
      co_await wake_.async_wait(kReturned);
      continue;
    }
    const std::shared_ptr<const std::string> next = std::move(waiting_.front());
    waiting_.pop_front();
    const auto [error, size] = co_await socket_.async_write(asio::buffer(*next), kReturned);
    if (error) {  // the reader sees it as well
      beast::error_code ignored;
      beast::get_lowest_layer(socket_).socket().close(ignored);
      co_return;
    }
    last_taken_ = Clock::now();
    // Nothing where all that waited was thrown away meanwhile.
    waiting_bytes_ -= std::min(waiting_bytes_, next->size());
  }
}

template <class Stream>
void SessionSocket<Stream>::send(std::shared_ptr<const std::string> bytes) {
  if (is_leaving_ || is_over_) return;
  if (waiting_bytes_ == 0) last_taken_ = Clock::now();
  waiting_bytes_ += bytes->size();
  waiting_.push_back(std::move(bytes));
  if (is_stuck()) leave(Goodbye::kPolicy, "too slow: it did not take what it was sent");
  wake_.cancel();
}

template <class Stream>
void SessionSocket<Stream>::leave(Goodbye why, std::string reason) {
  if (std::exchange(is_leaving_, true)) return;
  goodbye_ = {static_cast<beast::websocket::close_code>(why), reason};
  waiting_.clear();
  waiting_bytes_ = 0;
  wake_.cancel();
  deadline_.expires_after(limits::kGoodbye);
  deadline_.async_wait([self = this->shared_from_this()](beast::error_code error) {
    if (!error) self->hang_up();
  });
}

}  // namespace mlab::console
