// Strangers who send anything to the ports of a participant.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>

#include <gtest/gtest.h>

#include "mlab/base/random.h"
#include "mlab/dds/participant.h"
#include "mlab/dds/testing/fleet.h"

namespace mlab::dds {
namespace {

using Kind = Arrival::Kind;

class Stranger {
 public:
  Stranger() : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {}
  Stranger(const Stranger&) = delete;
  Stranger& operator=(const Stranger&) = delete;
  ~Stranger() { ::close(socket_); }

  void send(int port, const std::string& bytes) const {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<std::uint16_t>(port));
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ::sendto(socket_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
  }

 private:
  int socket_;
};

/// A counter, mixed: the same in every run.
std::string noise(std::uint64_t seed, std::size_t size) {
  std::string bytes;
  for (std::uint64_t i = 0; bytes.size() < size; ++i)
    bytes += static_cast<char>(base::mix_bits(seed * 65'537 + i));
  return bytes;
}

/// As far as their head, packets of the protocol; behind it anything, and the more parts that look like some
/// the more of it is read.
std::string almost_a_packet(std::uint64_t seed) {
  std::string packet = std::string("RTPS\x02\x01\x01\x10", 8) + noise(seed, 12);
  for (std::uint64_t part = 0; part < 1 + seed % 4; ++part) {
    const std::string body = noise(seed * 31 + part, base::mix_bits(seed + part) % 120);
    constexpr std::string_view kParts("\x01\x06\x07\x08\x09\x0c\x0d\x0e\x0f\x12\x13\x15\x16", 13);
    packet += kParts[base::mix_bits(seed * 7 + part) % kParts.size()];
    packet += static_cast<char>(base::mix_bits(seed + 3 * part) % 8);
    packet += static_cast<char>(seed % 5 == 0 ? 200 : body.size() & ~3U);
    packet += '\0';
    packet += body;
  }
  return packet;
}

TEST(DdsGarbage, ChangesNothing) {
  Participant here = participant();
  Participant there = participant();
  Waiter waits = waiter();
  Writer events = writer(there, "events", ChannelKind::kEvents, &waits);
  Reader reads = reader(here, "events", ChannelKind::kEvents, waits);
  ASSERT_TRUE(comes_true(waits, [&] { return !events.readers().empty() && !reads.senders().empty(); }));
  reads.take();
  const Stranger stranger;
  constexpr int kPorts = 12;  // of the last places of a machine, which participants take first
  const int first_port = 7400 + 250 * domain_of(fleet_of_this_process()) + 10 + 2 * kMaxParticipants - kPorts;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    // Those of the first participants of the domain: ours are among them unless other tests have the same.
    const int port = first_port + static_cast<int>(i % kPorts);
    stranger.send(port, i % 3 == 0 ? noise(i, i % 1400) : almost_a_packet(i));
    if (i % 100 == 0) write_surely(events, "", std::to_string(i));
  }
  stranger.send(first_port + kPorts - 2, "");
  stranger.send(first_port + kPorts - 2, std::string(60'000, '\xff'));
  const auto all = arrivals(waits, reads, Kind::kMessage, 30);
  const auto got = bodies(all);
  ASSERT_EQ(got.size(), 30U);
  for (std::size_t i = 0; i < got.size(); ++i) EXPECT_EQ(got[i], std::to_string(100 * i));
  EXPECT_EQ(all.size(), 30U) << "nothing else was told";
  EXPECT_EQ(reads.senders().size(), 1U);
  EXPECT_LE(here.complaints().size(), 50U);
}

}  // namespace
}  // namespace mlab::dds
