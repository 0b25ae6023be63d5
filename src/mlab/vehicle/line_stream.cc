#include <fcntl.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <vector>

#include "mlab/vehicle/socket.h"

namespace mlab::vehicle {
namespace {

using namespace std::chrono_literals;

// A host that does not answer at all is asked anew after this.
constexpr auto kConnectingFor = 3s;
constexpr std::size_t kMostWaiting = 16384;

/// The system's word for a speed; B0 where there is none.
speed_t speed_of(std::uint32_t bits) {
  constexpr std::array<speed_t, std::size(kLineSpeeds)> kSpeeds = {
      B1200, B2400, B4800, B9600, B19200, B38400, B57600, B115200, B230400, B460800, B921600, B1500000};
  for (std::size_t i = 0; i < kSpeeds.size(); ++i) {
    if (kLineSpeeds[i] == bits) return kSpeeds[i];
  }
  return B0;
}

/// Opens, keeps what waits, and notices that the other end has gone; how it is opened is the kind's business.
class LineStream : public Stream {
 public:
  explicit LineStream(const Address& address) : name_(print(address)), why_("is not opened yet") {}

  const std::string& name() const override { return name_; }
  bool is_open() const override { return is_open_; }
  const std::string& why() const override { return why_; }
  std::uint64_t openings() const override { return openings_; }

  std::span<const std::byte> read(Clock::time_point now) override {
    if (!open(now)) return {};
    flush(now);
    if (!is_open_) return {};
    const ssize_t size = ::read(line_.number(), buffer_.data(), buffer_.size());
    if (size > 0) return std::span(buffer_).first(static_cast<std::size_t>(size));
    if (size == 0) lose(now, "was closed by the other end");
    if (size < 0 && !is_passing(errno)) lose(now, "was lost: " + std::generic_category().message(errno));
    return {};
  }

  bool write(std::span<const std::byte> bytes, Clock::time_point now) override {
    if (!open(now) || bytes.empty() || waiting_.size() + bytes.size() > kMostWaiting) return false;
    waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
    flush(now);
    return is_open_;
  }

  void begin_anew(Clock::time_point now) override { lose(now, "was given up: nothing was heard"); }

 protected:
  /// A line that is open, or on its way; not open: `why` was set.
  virtual Descriptor begin(std::string& why) = 0;
  /// Whether what was begun is open by now. Sets `why` where it never will be.
  virtual bool is_done(const Descriptor& line, std::string& why) = 0;
  /// As the system's `write`; but no signal comes of it.
  virtual ssize_t put(const Descriptor& line, std::span<const std::byte> bytes) = 0;

 private:
  static bool is_passing(int error) { return error == EAGAIN || error == EWOULDBLOCK || error == EINTR; }

  bool open(Clock::time_point now) {
    if (is_open_) return true;
    if (!line_.is_open()) {
      if (tried_ && now - tried_at_ < kBetweenOpenings) return false;
      tried_ = true;
      tried_at_ = now;
      line_ = begin(why_);
      if (!line_.is_open()) return false;
      why_ = "is being opened";
    }
    std::string failure;
    is_open_ = is_done(line_, failure);
    if (is_open_) {
      why_.clear();
      ++openings_;
    } else if (!failure.empty()) {
      lose(now, failure);
    } else if (now - tried_at_ > kConnectingFor) {
      lose(now, "can't be opened: nobody answers");
    }
    return is_open_;
  }

  void flush(Clock::time_point now) {
    while (!waiting_.empty()) {
      const ssize_t size = put(line_, waiting_);
      if (size < 0 && errno == EINTR) continue;
      if (size < 0 && !is_passing(errno)) lose(now, "was lost: " + std::generic_category().message(errno));
      if (size <= 0) return;
      waiting_.erase(waiting_.begin(), waiting_.begin() + size);
    }
  }

  void lose(Clock::time_point now, std::string_view why) {
    line_.close();
    is_open_ = false;
    waiting_.clear();
    why_ = why;
    tried_ = true;
    tried_at_ = now;
  }

  std::string name_;
  std::string why_;
  Descriptor line_;
  bool is_open_ = false;
  std::uint64_t openings_ = 0;
  bool tried_ = false;
  Clock::time_point tried_at_;
  std::vector<std::byte> waiting_;
  std::array<std::byte, 4096> buffer_{};
};

class SerialStream final : public LineStream {
 public:
  explicit SerialStream(const Address& address)
      : LineStream(address), file_(address.place), speed_(speed_of(address.number)) {}

 private:
  Descriptor begin(std::string& why) override {
    Descriptor line(::open(file_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    termios settings{};
    if (!line.is_open() || ::tcgetattr(line.number(), &settings) != 0) {
      why = not_opened(errno);
      return {};
    }
    ::cfmakeraw(&settings);
    settings.c_cflag |= CLOCAL | CREAD;
    settings.c_cflag &= ~static_cast<tcflag_t>(CRTSCTS | CSTOPB | PARENB);
    settings.c_cc[VMIN] = 1;
    settings.c_cc[VTIME] = 0;
    // Two programs that talk to one vehicle on one line each get half of what it says.
    if (::cfsetspeed(&settings, speed_) != 0 || ::tcsetattr(line.number(), TCSANOW, &settings) != 0 ||
        ::ioctl(line.number(), TIOCEXCL) != 0) {
      why = not_opened(errno);
      return {};
    }
    ::tcflush(line.number(), TCIOFLUSH);
    return line;
  }

  bool is_done(const Descriptor& /*line*/, std::string& /*why*/) override { return true; }
  ssize_t put(const Descriptor& line, std::span<const std::byte> bytes) override {
    return ::write(line.number(), bytes.data(), bytes.size());
  }

  std::string file_;
  speed_t speed_;
};

class TcpStream final : public LineStream {
 public:
  explicit TcpStream(const Address& address) : LineStream(address), address_(address) {}

 private:
  Descriptor begin(std::string& why) override {
    Descriptor line(::socket(address_.storage.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (!line.is_open()) {
      why = not_opened(errno);
      return {};
    }
    // Commands are small, and late ones are of no use.
    const int yes = 1;
    ::setsockopt(line.number(), IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    if (::connect(line.number(), address_.get(), address_.length) != 0 && errno != EINPROGRESS) {
      why = not_opened(errno);
      return {};
    }
    return line;
  }

  bool is_done(const Descriptor& line, std::string& why) override {
    pollfd one{line.number(), POLLOUT, 0};
    if (::poll(&one, 1, 0) <= 0) return false;
    int error = 0;
    socklen_t length = sizeof error;
    if (::getsockopt(line.number(), SOL_SOCKET, SO_ERROR, &error, &length) != 0) error = errno;
    if (error != 0) why = not_opened(error);
    return error == 0;
  }

  ssize_t put(const Descriptor& line, std::span<const std::byte> bytes) override {
    return ::send(line.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }

  SocketAddress address_;
};

}  // namespace

std::unique_ptr<Stream> make_line_stream(const Address& address) {
  if (address.kind == Address::Kind::kSerial) return std::make_unique<SerialStream>(address);
  return std::make_unique<TcpStream>(address);
}

}  // namespace mlab::vehicle
