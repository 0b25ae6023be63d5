#include "mlab/console/server/session_socket.h"

#include <algorithm>
#include <exception>
#include <string_view>
#include <utility>

#include <boost/asio/bind_cancellation_slot.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/beast/websocket.hpp>

namespace mlab::console {

asio::awaitable<void> SessionSocket::run(const Request& request) {
  namespace websocket = beast::websocket;
  socket_.next_layer().expires_never();
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
  desk_.sessions[id_] = shared_from_this();
  const auto self = shared_from_this();
  end_.expires_at(asio::steady_timer::time_point::max());
  asio::co_spawn(
      desk_.io, [self] { return self->write(); },
      asio::bind_cancellation_slot(stop_writing_.slot(), asio::detached));
  asio::co_spawn(
      desk_.io, [self] { return self->read(); },
      asio::bind_cancellation_slot(stop_reading_.slot(), [self](const std::exception_ptr&) { self->end(); }));
  while (!is_over_) co_await end_.async_wait(kReturned);
  desk_.sessions.erase(id_);
  handlers_.closed(id_);
}

asio::awaitable<void> SessionSocket::read() {
  for (;;) {
    const auto [error, size] = co_await socket_.async_read(incoming_, kReturned);
    if (error) co_return;
    // Who is leaving is heard no more; what he still sends only has to be read.
    if (!is_leaving_) {
      const std::string_view bytes(static_cast<const char*>(incoming_.cdata().data()), size);
      if (!socket_.got_binary()) {
        leave(Goodbye::kUnknownData, "messages are binary");
      } else if (!handlers_.receive(id_, bytes)) {
        leave(Goodbye::kBadMessage, "this is no message of the console's protocol");
      }
    }
    incoming_.consume(incoming_.size());
  }
}

asio::awaitable<void> SessionSocket::write() {
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
      socket_.next_layer().socket().close(ignored);
      co_return;
    }
    last_taken_ = Clock::now();
    desk_.traffic.sent_bytes += size;
    ++desk_.traffic.messages;
    // Nothing where all that waited was thrown away meanwhile.
    waiting_bytes_ -= std::min(waiting_bytes_, next->size());
  }
}

void SessionSocket::send(std::shared_ptr<const std::string> bytes) {
  if (is_leaving_ || is_over_) return;
  if (waiting_bytes_ == 0) last_taken_ = Clock::now();
  waiting_bytes_ += bytes->size();
  waiting_.push_back(std::move(bytes));
  if (is_stuck()) leave(Goodbye::kPolicy, "too slow: it did not take what it was sent");
  wake_.cancel();
}

void SessionSocket::leave(Goodbye why, std::string reason) {
  if (std::exchange(is_leaving_, true)) return;
  ++desk_.traffic.ended_sessions;
  goodbye_ = {static_cast<beast::websocket::close_code>(why), reason};
  waiting_.clear();
  waiting_bytes_ = 0;
  wake_.cancel();
  deadline_.expires_after(limits::kGoodbye);
  deadline_.async_wait([self = shared_from_this()](beast::error_code error) {
    if (!error) self->hang_up();
  });
}

}  // namespace mlab::console
