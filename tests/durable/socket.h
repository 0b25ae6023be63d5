#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mlab::durable {

/// A WebSocket to a server on this machine, as little of it as a test needs: whole binary messages, one
/// thread.
class Socket {
 public:
  /// @param target  `/session?token=T`
  /// @errors  not `is_open()`: nobody answers there, or not as a WebSocket
  Socket(int port, const std::string& target);
  ~Socket();
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  bool is_open() const { return fd_ >= 0; }
  /// What can't be sent is lost: the server has gone.
  void send(std::string_view message);
  /// The next message; nothing: none came in this time [s], or the connection has ended.
  std::optional<std::string> receive(double seconds);

 private:
  /// A message of `incoming_`, once all of it is there. Answers pings on the way.
  std::optional<std::string> take();
  void send_frame(unsigned char opcode, std::string_view payload);
  void close();

  int fd_ = -1;
  std::string incoming_;
  std::string begun_;  ///< of a message that comes in pieces
};

}  // namespace mlab::durable
