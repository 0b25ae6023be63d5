#include "talk.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <system_error>

namespace mlab::network::talk {

void give_up(const std::string& what) {
  fmt::print(stderr, "{}: {}\n", what, std::generic_category().message(errno));
  std::exit(1);  // NOLINT(concurrency-mt-unsafe): one thread
}

void tell(const std::string& text) {
  fmt::print("{}\n", text);
  std::fflush(stdout);
}

sockaddr_in address(const std::string& host, const std::string& port) {
  addrinfo hints{};
  hints.ai_family = AF_INET;
  addrinfo* found = nullptr;
  if (::getaddrinfo(host.c_str(), port.c_str(), &hints, &found) != 0 || found == nullptr)
    give_up("no host " + host);
  const sockaddr_in out = *reinterpret_cast<const sockaddr_in*>(found->ai_addr);
  ::freeaddrinfo(found);
  return out;
}

int udp_socket(const std::string& port) {
  const int out = ::socket(AF_INET, SOCK_DGRAM, 0);
  if (out < 0) give_up("making a socket");
  constexpr int kRoom = 4 * 1024 * 1024;
  if (::setsockopt(out, SOL_SOCKET, SO_RCVBUFFORCE, &kRoom, sizeof kRoom) != 0)
    ::setsockopt(out, SOL_SOCKET, SO_RCVBUF, &kRoom, sizeof kRoom);
  const int yes = 1;
  ::setsockopt(out, SOL_SOCKET, SO_BROADCAST, &yes, sizeof yes);
  sockaddr_in here{};
  here.sin_family = AF_INET;
  here.sin_port = htons(static_cast<std::uint16_t>(std::atoi(port.c_str())));
  if (::bind(out, reinterpret_cast<const sockaddr*>(&here), sizeof here) != 0) give_up("binding");
  return out;
}

}  // namespace mlab::network::talk

int main(int count, char** arguments) {
  using namespace mlab::network::talk;
  const std::map<std::string, int (*)(const Words&)> modes = {
      {"echo", echo},     {"ask", ask},        {"flood", flood},   {"count", mlab::network::talk::count},
      {"hear", hear},     {"say", say},        {"take", take},     {"give", give},
      {"fill", fill},     {"spawn", spawn},    {"litter", litter}, {"wait", mlab::network::talk::wait},
      {"clocks", clocks}, {"chatter", chatter}};
  const auto found = count > 1 ? modes.find(arguments[1]) : modes.end();
  if (found == modes.end()) return 2;
  return found->second(Words(arguments + 2, arguments + count));
}
