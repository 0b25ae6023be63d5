#include "mlab/vehicle/stream.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <thread>

#include <gtest/gtest.h>

#include "mlab/vehicle/socket.h"

namespace mlab::vehicle {
namespace {

using namespace std::chrono_literals;

std::unique_ptr<Stream> stream_at(const std::string& text) {
  const auto address = parse_address(text);
  EXPECT_TRUE(address) << text;
  return make_stream(*address);
}

std::string refusal(std::string_view text) {
  const auto address = parse_address(text);
  return address ? "" : address.error().message;
}

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text));
}

/// Reads for as long as it takes, at most five seconds.
std::string awaited(Stream& stream, std::size_t size, Clock::time_point now = Clock::now()) {
  std::string out;
  for (int i = 0; i < 5000 && out.size() < size; ++i) {
    const auto bytes = stream.read(now);
    out.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (bytes.empty()) std::this_thread::sleep_for(1ms);
  }
  return out;
}

/// A socket of the test's own, on this machine.
struct Peer {
  Descriptor socket;
  std::uint16_t port = 0;

  explicit Peer(int type) : socket(::socket(AF_INET, type | SOCK_CLOEXEC, 0)) {
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::bind(socket.number(), reinterpret_cast<sockaddr*>(&at), sizeof at), 0);
    socklen_t length = sizeof at;
    ::getsockname(socket.number(), reinterpret_cast<sockaddr*>(&at), &length);
    port = ntohs(at.sin_port);
  }
  void send_to(std::uint16_t to, std::string_view text) const {
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    at.sin_port = htons(to);
    ::sendto(socket.number(), text.data(), text.size(), 0, reinterpret_cast<sockaddr*>(&at), sizeof at);
  }
  std::string received() const {
    char buffer[100];
    pollfd one{socket.number(), POLLIN, 0};
    if (::poll(&one, 1, 5000) <= 0) return "nothing";
    const ssize_t size = ::recv(socket.number(), buffer, sizeof buffer, 0);
    return {buffer, static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
  }
};

/// A port that is free, as far as one can know.
std::uint16_t free_udp_port() {
  return Peer(SOCK_DGRAM).port;
}

TEST(VehicleAddress, IsReadAndWrittenTheSameWay) {
  for (const std::string text :
       {"serial:/dev/ttyUSB0:57600", "serial:/dev/serial/by-id/usb-A:B:115200", "tcp:192.168.1.7:5760",
        "udp:192.168.1.7:14555", "udp:14550", "udp:0.0.0.0:14550", "udp-listen:192.168.1.2:14550",
        "tcp:[fd00::7]:5760", "udp:[::]:14550"}) {
    const auto address = parse_address(text);
    ASSERT_TRUE(address) << text << ": " << address.error().message;
    EXPECT_EQ(print(*address), text);
  }
  EXPECT_EQ(print(*parse_address("tcp:localhost:5760")), "tcp:127.0.0.1:5760");
}

TEST(VehicleAddress, ListensToThisMachineOnlyUnlessToldOtherwise) {
  EXPECT_EQ(*parse_address("udp:14550"), (Address{Address::Kind::kUdpListening, "127.0.0.1", 14550}));
  EXPECT_EQ(parse_address("udp:0.0.0.0:14550")->kind, Address::Kind::kUdpListening);
  EXPECT_EQ(parse_address("udp:10.0.0.1:14550")->kind, Address::Kind::kUdp);
}

TEST(VehicleAddress, SaysWhatWasSeenAndWhatIsExpected) {
  EXPECT_EQ(refusal("serial:/dev/ttyS0"),
            "`serial:/dev/ttyS0`: expected a file and a speed: `serial:/dev/ttyUSB0:57600`");
  EXPECT_TRUE(
      refusal("serial:/dev/ttyS0:57601").starts_with("`57601` as speed of a serial line; expected one"));
  EXPECT_EQ(refusal("udp:65536"), "`65536` as port; expected a number from 1 to 65535");
  EXPECT_EQ(refusal("tcp:1.2.3.4:"), "`` as port; expected a number from 1 to 65535");
  EXPECT_EQ(refusal("tcp:5760"), "`5760` without a port; expected HOST:PORT, as `192.168.1.7:5760`");
  EXPECT_EQ(refusal("tcp:rover.local:5760"),
            "`rover.local` as host; expected its address in numbers, as `192.168.1.7` or `[fd00::7]`, or "
            "`localhost`");
  EXPECT_EQ(refusal("tcp:0.0.0.0:5760"),
            "`0.0.0.0` as host of a vehicle; expected the vehicle's own address");
  EXPECT_TRUE(refusal("can0").starts_with("`can0` as address of a vehicle; expected `serial:FILE:SPEED`"));
  EXPECT_TRUE(refusal("").starts_with("`` as address of a vehicle"));
  EXPECT_NE(refusal(std::string(400, 'x')), "");
}

TEST(VehicleStream, AnswersWhoSpokeFirstOnUdpAndNobodyElse) {
  const std::uint16_t port = free_udp_port();
  const auto stream = stream_at("udp:" + std::to_string(port));
  const auto now = Clock::now();
  EXPECT_TRUE(stream->read(now).empty());
  EXPECT_TRUE(stream->is_open());
  EXPECT_FALSE(stream->write(bytes_of("to nobody"), now));
  const Peer first(SOCK_DGRAM);
  const Peer second(SOCK_DGRAM);
  first.send_to(port, "hello");
  EXPECT_EQ(awaited(*stream, 5), "hello");
  second.send_to(port, "stranger");
  first.send_to(port, "again");
  EXPECT_EQ(awaited(*stream, 5), "again");
  EXPECT_TRUE(stream->write(bytes_of("answer"), now));
  EXPECT_EQ(first.received(), "answer");

  const std::uint64_t before = stream->openings();
  stream->begin_anew(now);
  second.send_to(port, "newcomer");
  EXPECT_EQ(awaited(*stream, 8), "newcomer");
  EXPECT_GT(stream->openings(), before);
}

TEST(VehicleStream, HearsOnlyWhomItSpeaksToOnUdp) {
  const Peer vehicle(SOCK_DGRAM);
  const auto stream = stream_at("udp:127.0.0.1:" + std::to_string(vehicle.port));
  EXPECT_TRUE(stream->write(bytes_of("hello"), Clock::now()));
  sockaddr_in from{};
  socklen_t length = sizeof from;
  char buffer[10];
  ASSERT_EQ(::recvfrom(vehicle.socket.number(), buffer, sizeof buffer, 0, reinterpret_cast<sockaddr*>(&from),
                       &length),
            5);
  Peer(SOCK_DGRAM).send_to(ntohs(from.sin_port), "stranger");
  vehicle.send_to(ntohs(from.sin_port), "vehicle");
  EXPECT_EQ(awaited(*stream, 7), "vehicle");
}

TEST(VehicleStream, SaysWhyAPortOfUdpIsNotOpen) {
  const Peer holder(SOCK_DGRAM);
  const auto stream = stream_at("udp:" + std::to_string(holder.port));
  EXPECT_TRUE(stream->read(Clock::now()).empty());
  EXPECT_FALSE(stream->is_open());
  EXPECT_EQ(stream->why(), "can't be opened: Address already in use");
}

TEST(VehicleStream, ConnectsAgainAfterTcpWasLost) {
  const Peer listener(SOCK_STREAM);
  const auto stream = stream_at("tcp:127.0.0.1:" + std::to_string(listener.port));
  auto now = Clock::now();
  // The system refuses at once, or when it is looked at.
  for (int i = 0; i < 1000 && !stream->why().starts_with("can't"); ++i) stream->read(now);
  EXPECT_EQ(stream->why(), "can't be opened: Connection refused");
  ASSERT_EQ(::listen(listener.socket.number(), 1), 0);
  now += 400ms;
  stream->read(now);
  EXPECT_EQ(stream->why(), "can't be opened: Connection refused") << "it is not tried so soon again";
  for (std::uint64_t opening = 1; opening <= 2; ++opening) {
    now += 600ms;
    for (int i = 0; i < 1000 && !stream->is_open(); ++i) stream->read(now);
    ASSERT_TRUE(stream->is_open()) << stream->why();
    EXPECT_EQ(stream->openings(), opening);
    const Descriptor accepted(::accept4(listener.socket.number(), nullptr, nullptr, SOCK_CLOEXEC));
    ASSERT_EQ(::send(accepted.number(), "hi", 2, 0), 2);
    EXPECT_EQ(awaited(*stream, 2, now), "hi");
    ::shutdown(accepted.number(), SHUT_RDWR);
    for (int i = 0; i < 1000 && stream->is_open(); ++i) stream->read(now);
    EXPECT_FALSE(stream->is_open());
  }
}

TEST(VehicleStream, KeepsABoundedNumberOfBytesForALineThatIsFull) {
  const Peer listener(SOCK_STREAM);
  ASSERT_EQ(::listen(listener.socket.number(), 1), 0);
  const auto stream = stream_at("tcp:127.0.0.1:" + std::to_string(listener.port));
  const auto now = Clock::now();
  for (int i = 0; i < 1000 && !stream->is_open(); ++i) stream->read(now);
  const std::string much(4096, 'x');
  bool is_refused = false;
  for (int i = 0; i < 10000 && !is_refused; ++i) is_refused = !stream->write(bytes_of(much), now);
  EXPECT_TRUE(is_refused);
  EXPECT_TRUE(stream->is_open());
}

TEST(VehicleStream, SpeaksOverASerialLineAndOpensItAgain) {
  std::string name;
  const auto open_pair = [&name] {
    Descriptor other(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
    ::grantpt(other.number());
    ::unlockpt(other.number());
    name = ::ptsname(other.number());
    return other;
  };
  Descriptor other = open_pair();
  const std::string link = testing::TempDir() + "mlab_line_" + std::to_string(::getpid());
  ASSERT_EQ(::symlink(name.c_str(), link.c_str()), 0);
  const auto stream = stream_at("serial:" + link + ":57600");
  auto now = Clock::now();
  stream->read(now);
  ASSERT_TRUE(stream->is_open()) << stream->why();
  // All values pass as they are.
  ASSERT_EQ(::write(other.number(), "\x03\x0d\x11\xff", 4), 4);
  EXPECT_EQ(awaited(*stream, 4, now), "\x03\x0d\x11\xff");
  ASSERT_TRUE(stream->write(bytes_of("\n\r\x04"), now));
  char buffer[8];
  EXPECT_EQ(::read(other.number(), buffer, sizeof buffer), 3);
  EXPECT_EQ(std::string_view(buffer, 3), "\n\r\x04");

  other.close();
  for (int i = 0; i < 1000 && stream->is_open(); ++i) stream->read(now);
  EXPECT_TRUE(stream->why().starts_with("was ")) << stream->why();
  ::unlink(link.c_str());
  now += 600ms;
  stream->read(now);
  EXPECT_EQ(stream->why(), "can't be opened: No such file or directory");
  other = open_pair();
  ASSERT_EQ(::symlink(name.c_str(), link.c_str()), 0);
  now += 600ms;
  stream->read(now);
  EXPECT_TRUE(stream->is_open()) << stream->why();
  EXPECT_EQ(stream->openings(), 2U);
  ::unlink(link.c_str());
}

TEST(VehicleStream, RefusesAFileThatIsNoSerialLine) {
  const auto stream = stream_at("serial:/dev/null:57600");
  stream->read(Clock::now());
  EXPECT_EQ(stream->why(), "can't be opened: Inappropriate ioctl for device");
}

}  // namespace
}  // namespace mlab::vehicle
