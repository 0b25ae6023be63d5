#include "mlab/dds/loopback_multicast.h"

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <string_view>

namespace mlab::dds {
namespace {

constexpr in_addr_t kGroup = 0xefff0001;  // 239.255.0.1, DDS's own
constexpr std::string_view kWord = "mlab";
constexpr int kPatience = 20;  // what is sent on the loopback is there at once [ms]

class Socket {
 public:
  Socket() : descriptor_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {}
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  ~Socket() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  int descriptor() const { return descriptor_; }
  template <class Value>
  bool set(int option, const Value& value) const {
    return ::setsockopt(descriptor_, IPPROTO_IP, option, &value, sizeof value) == 0;
  }

 private:
  int descriptor_;
};

sockaddr_in at(in_addr_t address, in_port_t port) {
  sockaddr_in out{};
  out.sin_family = AF_INET;
  out.sin_addr.s_addr = htonl(address);
  out.sin_port = port;
  return out;
}

/// Has the socket hear the group on the loopback, and send there.
/// @return  the port that it hears, as in the network; 0: it can't
in_port_t join(const Socket& socket) {
  sockaddr_in own = at(kGroup, 0);
  socklen_t size = sizeof own;
  const in_addr loopback{htonl(INADDR_LOOPBACK)};
  const ip_mreq membership{.imr_multiaddr = {htonl(kGroup)}, .imr_interface = loopback};
  if (::bind(socket.descriptor(), reinterpret_cast<const sockaddr*>(&own), size) != 0) return 0;
  if (!socket.set(IP_ADD_MEMBERSHIP, membership) || !socket.set(IP_MULTICAST_IF, loopback)) return 0;
  if (::getsockname(socket.descriptor(), reinterpret_cast<sockaddr*>(&own), &size) != 0) return 0;
  return own.sin_port;
}

}  // namespace

bool carries_loopback_multicast() {
  const Socket socket;
  const in_port_t port = socket.descriptor() >= 0 ? join(socket) : in_port_t{0};
  if (port == 0) return false;
  const sockaddr_in group = at(kGroup, port);
  if (::sendto(socket.descriptor(), kWord.data(), kWord.size(), 0, reinterpret_cast<const sockaddr*>(&group),
               sizeof group) < 0)
    return false;
  pollfd asked{.fd = socket.descriptor(), .events = POLLIN, .revents = 0};
  std::array<char, 16> word{};
  return ::poll(&asked, 1, kPatience) == 1 &&
         ::recv(socket.descriptor(), word.data(), word.size(), 0) == static_cast<ssize_t>(kWord.size());
}

}  // namespace mlab::dds
