#include "mlab/vehicle/stream.h"

#include <arpa/inet.h>
#include <unistd.h>

#include <cstring>
#include <system_error>

#include "mlab/vehicle/socket.h"

namespace mlab::vehicle {

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

SocketAddress::SocketAddress(const Address& address) {
  sockaddr_in four{};
  sockaddr_in6 six{};
  if (::inet_pton(AF_INET, address.place.c_str(), &four.sin_addr) == 1) {
    four.sin_family = AF_INET;
    four.sin_port = htons(static_cast<std::uint16_t>(address.number));
    std::memcpy(&storage, &four, sizeof four);
    length = sizeof four;
  } else {
    ::inet_pton(AF_INET6, address.place.c_str(), &six.sin6_addr);
    six.sin6_family = AF_INET6;
    six.sin6_port = htons(static_cast<std::uint16_t>(address.number));
    std::memcpy(&storage, &six, sizeof six);
    length = sizeof six;
  }
}

bool operator==(const SocketAddress& a, const SocketAddress& b) {
  if (a.storage.ss_family != b.storage.ss_family) return false;
  if (a.storage.ss_family == AF_INET) {
    sockaddr_in x{};
    sockaddr_in y{};
    std::memcpy(&x, &a.storage, sizeof x);
    std::memcpy(&y, &b.storage, sizeof y);
    return x.sin_port == y.sin_port && x.sin_addr.s_addr == y.sin_addr.s_addr;
  }
  sockaddr_in6 x{};
  sockaddr_in6 y{};
  std::memcpy(&x, &a.storage, sizeof x);
  std::memcpy(&y, &b.storage, sizeof y);
  return x.sin6_port == y.sin6_port && x.sin6_scope_id == y.sin6_scope_id &&
         std::memcmp(&x.sin6_addr, &y.sin6_addr, sizeof x.sin6_addr) == 0;
}

std::string not_opened(int error) {
  return "can't be opened: " + std::generic_category().message(error);
}

std::unique_ptr<Stream> make_stream(const Address& address) {
  switch (address.kind) {
    case Address::Kind::kSerial:
    case Address::Kind::kTcp:
      return make_line_stream(address);
    case Address::Kind::kUdp:
    case Address::Kind::kUdpListening:
      return make_udp_stream(address);
  }
  return nullptr;
}

}  // namespace mlab::vehicle
