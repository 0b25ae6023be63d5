#include <algorithm>
#include <array>
#include <cerrno>

#include "mlab/vehicle/socket.h"

namespace mlab::vehicle {
namespace {

// Of strangers' datagrams, in a row: their sender has not all of our time.
constexpr int kMostStrangers = 64;

class UdpStream final : public Stream {
 public:
  explicit UdpStream(const Address& address)
      : name_(print(address)),
        listens_(address.kind == Address::Kind::kUdpListening),
        address_(address),
        why_("is not opened yet") {
    if (!listens_) peer_ = address_;
  }

  const std::string& name() const override { return name_; }
  bool is_open() const override { return socket_.is_open(); }
  const std::string& why() const override { return why_; }
  std::uint64_t openings() const override { return openings_; }

  std::span<const std::byte> read(Clock::time_point now) override {
    if (!socket_.is_open() && !open(now)) return {};
    for (int i = 0; i < kMostStrangers; ++i) {
      SocketAddress from;
      from.length = sizeof from.storage;
      const ssize_t size =
          ::recvfrom(socket_.number(), buffer_.data(), buffer_.size(), 0, from.get(), &from.length);
      // That nobody is there now does not mean that nobody will be: such answers are told as errors.
      if (size < 0 && (errno == ECONNREFUSED || errno == EINTR)) continue;
      if (size < 0) return {};
      if (size == 0 || !is_ours(from)) continue;
      return std::span(buffer_).first(static_cast<std::size_t>(size));
    }
    return {};
  }

  bool write(std::span<const std::byte> bytes, Clock::time_point now) override {
    if (!socket_.is_open() && !open(now)) return false;
    if (peer_.length == 0 || bytes.empty()) return false;
    const ssize_t size =
        ::sendto(socket_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL, peer_.get(), peer_.length);
    return size == static_cast<ssize_t>(bytes.size());
  }

  void begin_anew(Clock::time_point /*now*/) override {
    if (listens_) peer_ = {};
  }

 private:
  bool is_ours(const SocketAddress& from) {
    if (peer_.length == 0) {
      peer_ = from;
      ++openings_;
    }
    return from == peer_;
  }

  bool open(Clock::time_point now) {
    if (tried_ && now - tried_at_ < kBetweenOpenings) return false;
    tried_ = true;
    tried_at_ = now;
    Descriptor socket(::socket(address_.storage.ss_family, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (!socket.is_open() || (listens_ && ::bind(socket.number(), address_.get(), address_.length) != 0)) {
      why_ = not_opened(errno);
      return false;
    }
    socket_ = std::move(socket);
    why_.clear();
    ++openings_;
    return true;
  }

  std::string name_;
  bool listens_;
  SocketAddress address_;
  SocketAddress peer_;  // of no length: nobody has spoken yet
  Descriptor socket_;
  std::string why_;
  std::uint64_t openings_ = 0;
  bool tried_ = false;
  Clock::time_point tried_at_;
  std::array<std::byte, 4096> buffer_{};
};

}  // namespace

std::unique_ptr<Stream> make_udp_stream(const Address& address) {
  return std::make_unique<UdpStream>(address);
}

}  // namespace mlab::vehicle
