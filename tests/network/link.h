#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

namespace mlab::network {

using Clock = std::chrono::steady_clock;
using Time = Clock::time_point;
using Duration = std::chrono::nanoseconds;

/// What becomes of packets on their way from one host to another; nothing, as long as nothing is set.
struct Link {
  double loss = 0.0;        ///< share that is lost [0..1]
  Duration delay{0};        ///< of each
  Duration jitter{0};       ///< delay varies evenly by as much to both sides; order stays
  double reordering = 0.0;  ///< share that is held back, so that others overtake it [0..1]
  Duration held_back = std::chrono::milliseconds(10);  ///< by so much
  double duplication = 0.0;                            ///< share that arrives twice [0..1]
  double bits_per_second = 0.0;                        ///< of whole frames; 0: any number
  std::size_t queue_bytes =
      std::size_t{256} * 1024;  ///< that wait for such a link at most; the rest is dropped
};

/// Packets of one link, all since the beginning. Each that was sent is counted in exactly one of delivered,
/// lost, cut, overflowed, or is still under way.
struct Counters {
  std::uint64_t sent = 0;        ///< came into the relay for this link; of a multicast one for each receiver
  std::uint64_t delivered = 0;   ///< duplicates are not counted here
  std::uint64_t lost = 0;        ///< by Link::loss
  std::uint64_t cut = 0;         ///< the link was cut, or the receiver off, when it was sent or was to arrive
  std::uint64_t overflowed = 0;  ///< too many waited already, or the receiver's kernel took no more
  std::uint64_t delayed = 0;     ///< did not go on at once
  std::uint64_t reordered = 0;
  std::uint64_t duplicated = 0;
  std::uint64_t bytes = 0;  ///< of the delivered, with their Ethernet headers

  Counters& operator+=(const Counters& other);
  std::string words() const;
};

/// What is decided of a packet.
struct Fate {
  enum class End : std::uint8_t { kArrives, kLost, kOverflows };
  End end = End::kArrives;
  Time due{};  ///< where it arrives
  bool is_reordered = false;
  bool is_twice = false;
};

/// One direction between two hosts: decides of each packet by (seed, from, to, how many came before it) and
/// the settings at that moment, and by nothing else. So packet number n of a link with a loss of 20 % is lost
/// in every run with this seed, or in none.
class Wire {
 public:
  Wire(std::uint64_t seed, int from, int to);
  /// @param bytes  of the frame
  /// @param now    never before that of the last call
  Fate next(const Link& link, std::size_t bytes, Time now);

 private:
  std::uint64_t seed_;
  int from_;
  int to_;
  std::uint64_t count_ = 0;
  Time free_at_{};   ///< when all before it have gone into a link of limited rate
  Time last_due_{};  ///< of those that keep their order
};

}  // namespace mlab::network
