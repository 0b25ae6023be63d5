#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>

#include "talk.h"

namespace mlab::network::talk {
namespace {

/// FNV-1a.
class Hash {
 public:
  void add(const char* data, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
      hash_ = (hash_ ^ static_cast<unsigned char>(data[i])) * 1099511628211ULL;
  }
  std::string words() const { return fmt::format("{:x}", hash_); }

 private:
  std::uint64_t hash_ = 14695981039346656037ULL;
};

}  // namespace

int take(const Words& words) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  const sockaddr_in here = address("0.0.0.0", words.at(0));
  if (socket < 0 || ::bind(socket, reinterpret_cast<const sockaddr*>(&here), sizeof here) != 0 ||
      ::listen(socket, 1) != 0)
    give_up("listening");
  tell("ready");
  const int peer = ::accept(socket, nullptr, nullptr);
  std::array<char, 65536> block{};
  std::size_t all = 0;
  Hash hash;
  for (ssize_t size = 0; (size = ::read(peer, block.data(), block.size())) > 0;) {
    all += static_cast<std::size_t>(size);
    hash.add(block.data(), static_cast<std::size_t>(size));
  }
  tell(fmt::format("{} {}", all, hash.words()));
  return 0;
}

int give(const Words& words) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  const sockaddr_in to = address(words.at(0), words.at(1));
  if (socket < 0 || ::connect(socket, reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0)
    give_up("connecting");
  std::string text(static_cast<std::size_t>(std::atol(words.at(2).c_str())), '\0');
  for (std::size_t i = 0; i < text.size(); ++i) text[i] = static_cast<char>(i * i >> 3);
  Hash hash;
  hash.add(text.data(), text.size());
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t size = ::write(socket, text.data() + sent, text.size() - sent);
    if (size <= 0) give_up("giving");
    sent += static_cast<std::size_t>(size);
  }
  tell(hash.words());
  return 0;
}

}  // namespace mlab::network::talk
