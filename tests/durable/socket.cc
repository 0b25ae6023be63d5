#include "socket.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <fmt/core.h>

namespace mlab::durable {
namespace {

constexpr unsigned char kContinued = 0x0;
constexpr unsigned char kBinary = 0x2;
constexpr unsigned char kClose = 0x8;
constexpr unsigned char kPing = 0x9;
constexpr unsigned char kPong = 0xa;

bool send_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::send(fd, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (n <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

// False where the connection has ended.
bool read_more(int fd, std::string& into) {
  char block[1 << 16];
  const ssize_t n = ::recv(fd, block, sizeof block, 0);
  if (n <= 0) return false;
  into.append(block, static_cast<std::size_t>(n));
  return true;
}

std::uint64_t number(std::string_view bytes) {
  std::uint64_t out = 0;
  for (const char byte : bytes) out = out << 8U | static_cast<unsigned char>(byte);
  return out;
}

}  // namespace

Socket::Socket(int port, const std::string& target) {
  fd_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const std::string hello = fmt::format(
      "GET {} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
      "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n",
      target, port);
  if (::connect(fd_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      !send_all(fd_, hello)) {
    close();
    return;
  }
  while (incoming_.find("\r\n\r\n") == std::string::npos) {
    if (read_more(fd_, incoming_)) continue;
    close();
    return;
  }
  if (!incoming_.starts_with("HTTP/1.1 101")) close();
  incoming_.erase(0, incoming_.find("\r\n\r\n") + 4);
}

Socket::~Socket() {
  close();
}

void Socket::close() {
  if (fd_ >= 0) ::close(fd_);
  fd_ = -1;
}

// Clients mask what they send; a mask of zeros is one.
void Socket::send_frame(unsigned char opcode, std::string_view payload) {
  std::string frame;
  frame += static_cast<char>(0x80U | opcode);
  if (payload.size() < 126) {
    frame += static_cast<char>(0x80U | payload.size());
  } else {
    const bool is_short = payload.size() < 65536;
    frame += static_cast<char>(0x80U | (is_short ? 126U : 127U));
    for (int shift = is_short ? 8 : 56; shift >= 0; shift -= 8)
      frame += static_cast<char>(payload.size() >> shift & 0xffU);
  }
  frame.append(4, '\0');
  frame += payload;
  if (fd_ >= 0) send_all(fd_, frame);
}

void Socket::send(std::string_view message) {
  send_frame(kBinary, message);
}

std::optional<std::string> Socket::take() {
  while (incoming_.size() >= 2) {
    const auto first = static_cast<unsigned char>(incoming_[0]);
    std::uint64_t size = static_cast<unsigned char>(incoming_[1]) & 0x7fU;
    const std::size_t more = size == 126 ? 2 : size == 127 ? 8 : 0;
    if (incoming_.size() < 2 + more) return std::nullopt;
    if (more > 0) size = number(std::string_view(incoming_).substr(2, more));
    if (incoming_.size() < 2 + more + size) return std::nullopt;
    std::string payload = incoming_.substr(2 + more, size);
    incoming_.erase(0, 2 + more + size);
    const unsigned char opcode = first & 0x0fU;
    if (opcode == kPing) send_frame(kPong, payload);
    if (opcode == kClose) close();
    if (opcode != kBinary && opcode != kContinued) continue;
    begun_ += payload;
    if ((first & 0x80U) != 0) return std::exchange(begun_, {});
  }
  return std::nullopt;
}

std::optional<std::string> Socket::receive(double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto end =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  while (true) {
    if (auto message = take()) return message;
    if (fd_ < 0) return std::nullopt;
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    pollfd wanted{fd_, POLLIN, 0};
    if (::poll(&wanted, 1, static_cast<int>(std::max<long>(left, 0))) <= 0) return std::nullopt;
    if (!read_more(fd_, incoming_)) close();
  }
}

}  // namespace mlab::durable
