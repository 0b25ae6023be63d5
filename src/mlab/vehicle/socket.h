#pragma once

#include <netinet/in.h>
#include <sys/socket.h>

#include <cstddef>
#include <string>
#include <utility>

#include "mlab/vehicle/stream.h"

namespace mlab::vehicle {

/// What can't be opened is not tried again before.
inline constexpr std::chrono::milliseconds kBetweenOpenings{500};

/// A file of the kernel's, closed with the object.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor();

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  void close() { *this = Descriptor(); }

 private:
  int number_ = -1;
};

/// A host and a port, as sockets want them.
struct SocketAddress {
  sockaddr_storage storage{};
  socklen_t length = 0;

  explicit SocketAddress(const Address& address);
  SocketAddress() = default;

  const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&storage); }
  sockaddr* get() { return reinterpret_cast<sockaddr*>(&storage); }
  /// Whether it is the same host and port.
  friend bool operator==(const SocketAddress& a, const SocketAddress& b);
};

/// What the system says of `error`: `can't be opened: No such file or directory`.
std::string not_opened(int error);

/// Serial lines and TCP; UDP.
std::unique_ptr<Stream> make_line_stream(const Address& address);
std::unique_ptr<Stream> make_udp_stream(const Address& address);

}  // namespace mlab::vehicle
