#include "mlab/dds/loopback_only.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "mlab/dds/network.h"

namespace mlab::dds {
namespace {

/// Whether it is a socket that hears all addresses at a port of the domain.
bool hears_all(int descriptor, int domain) {
  sockaddr_in at{};
  socklen_t size = sizeof at;
  if (::getsockname(descriptor, reinterpret_cast<sockaddr*>(&at), &size) != 0) return false;
  const int first = 7400 + 250 * domain;
  const int port = ntohs(at.sin_port);
  return at.sin_family == AF_INET && at.sin_addr.s_addr == htonl(INADDR_ANY) && port >= first &&
         port < first + 250;
}

/// Linux makes it first in every network namespace, and calls it so.
constexpr std::string_view kLoopback = "lo";

}  // namespace

std::expected<void, std::string> hear_loopback_only(int domain) {
  std::error_code error;
  for (const auto& one : std::filesystem::directory_iterator("/proc/self/fd", error)) {
    const std::string name = one.path().filename();
    int descriptor = -1;
    std::from_chars(name.data(), name.data() + name.size(), descriptor);
    if (descriptor < 0 || !hears_all(descriptor, domain)) continue;
    if (::setsockopt(descriptor, SOL_SOCKET, SO_BINDTODEVICE, kLoopback.data(),
                     static_cast<socklen_t>(kLoopback.size())) != 0)
      return std::unexpected(fmt::format("strangers can't be kept out: no socket can be tied to `{}`: {}",
                                         kLoopback, std::generic_category().message(errno)));
  }
  if (error)
    return std::unexpected(fmt::format("strangers can't be kept out: /proc/self/fd: {}", error.message()));
  return {};
}

}  // namespace mlab::dds
