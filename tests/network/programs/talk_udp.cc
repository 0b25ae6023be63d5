#include <arpa/inet.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "talk.h"

namespace mlab::network::talk {
namespace {

using Clock = std::chrono::steady_clock;

bool send_to(int socket, const sockaddr_in& to, const void* data, std::size_t size) {
  return ::sendto(socket, data, size, 0, reinterpret_cast<const sockaddr*>(&to), sizeof to) >= 0;
}

bool can_be_read(int socket, int milliseconds) {
  pollfd wanted{socket, POLLIN, 0};
  return ::poll(&wanted, 1, milliseconds) > 0;
}

}  // namespace

int echo(const Words& words) {
  const int socket = udp_socket(words.at(0));
  tell("ready");
  for (;;) {
    std::array<char, 65536> block{};
    sockaddr_in from{};
    socklen_t size = sizeof from;
    const ssize_t count =
        ::recvfrom(socket, block.data(), block.size(), 0, reinterpret_cast<sockaddr*>(&from), &size);
    if (count >= 0) send_to(socket, from, block.data(), static_cast<std::size_t>(count));
  }
}

int ask(const Words& words) {
  const int socket = udp_socket("0");
  const sockaddr_in to = address(words.at(0), words.at(1));
  const int count = std::atoi(words.at(2).c_str());
  const int patience = words.size() > 3 ? std::atoi(words[3].c_str()) : 5000;
  int answers = 0;
  double sum = 0.0;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
    const auto begin = Clock::now();
    send_to(socket, to, &i, sizeof i);
    std::uint32_t answer = ~0U;
    while (answer != i && can_be_read(socket, patience)) {
      if (::recv(socket, &answer, sizeof answer, 0) < 0) break;
    }
    if (answer != i) continue;
    ++answers;
    sum += std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
  }
  tell(fmt::format("{} {:.0f}", answers, answers == 0 ? 0.0 : sum / answers));
  return 0;
}

int flood(const Words& words) {
  const int socket = udp_socket("0");
  const sockaddr_in to = address(words.at(0), words.at(1));
  const int count = std::atoi(words.at(2).c_str());
  const double per_second = std::atof(words.at(3).c_str());
  const auto begin = Clock::now();
  int sent = 0;
  for (int i = 0; i < count; ++i) {
    const auto number = static_cast<std::uint32_t>(i);
    sent += send_to(socket, to, &number, sizeof number) ? 1 : 0;
    if (i % 16 == 15) std::this_thread::sleep_until(begin + std::chrono::duration<double>(i / per_second));
  }
  tell(fmt::format("{} in {:.3f}", sent, std::chrono::duration<double>(Clock::now() - begin).count()));
  return 0;
}

int count(const Words& words) {
  const int socket = udp_socket(words.at(0));
  const int quiet = std::atoi(words.at(1).c_str());
  tell("ready");
  std::vector<int> times;  // that each number came
  std::uint32_t highest = 0;
  int all = 0;
  int late = 0;
  bool is_closed = false;
  for (;;) {
    std::array<pollfd, 2> wanted = {pollfd{socket, POLLIN, 0},
                                    pollfd{is_closed ? -1 : STDIN_FILENO, POLLIN, 0}};
    if (::poll(wanted.data(), wanted.size(), is_closed ? quiet : -1) == 0) break;
    if (wanted[1].revents != 0) is_closed = true;
    if (wanted[0].revents == 0) continue;
    std::uint32_t number = 0;
    if (::recv(socket, &number, sizeof number, 0) != sizeof number || number > 10'000'000) continue;
    ++all;
    late += number < highest ? 1 : 0;
    highest = std::max(highest, number);
    times.resize(highest + 1);
    ++times[number];
  }
  int twice = 0;
  std::uint64_t hash = 14695981039346656037ULL;
  for (std::size_t i = 0; i < times.size(); ++i) {
    twice += times[i] > 1 ? 1 : 0;
    if (times[i] > 0) hash = (hash ^ i) * 1099511628211ULL;
  }
  tell(fmt::format("{} {} {} {:x}", all, late, twice, hash));
  return 0;
}

int hear(const Words& words) {
  const int socket = udp_socket(words.at(1));
  if (words.at(0) != "-") {
    ip_mreq group{address(words.at(0), "0").sin_addr, {}};
    if (::setsockopt(socket, IPPROTO_IP, IP_ADD_MEMBERSHIP, &group, sizeof group) != 0) give_up("joining");
  }
  tell("ready");
  std::array<char, 1500> block{};
  sockaddr_in from{};
  socklen_t size = sizeof from;
  const ssize_t count =
      ::recvfrom(socket, block.data(), block.size(), 0, reinterpret_cast<sockaddr*>(&from), &size);
  if (count < 0) give_up("hearing");
  tell(fmt::format("heard {} from {}", std::string(block.data(), static_cast<std::size_t>(count)),
                   ::inet_ntoa(from.sin_addr)));  // NOLINT(concurrency-mt-unsafe): one thread
  return 0;
}

int say(const Words& words) {
  const int socket = udp_socket("0");
  const sockaddr_in to = address(words.at(0), words.at(1));
  if (!send_to(socket, to, words.at(2).data(), words.at(2).size())) give_up("saying");
  return 0;
}

}  // namespace mlab::network::talk
