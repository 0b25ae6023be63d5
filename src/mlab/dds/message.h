#pragma once

#include <array>
#include <chrono>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>

namespace mlab::dds {

/// The longest key [bytes]. What is longer is refused on both sides.
inline constexpr std::size_t kMaxKey = 64;
/// The longest body [bytes]. What is larger has to be divided by who sends it.
inline constexpr std::size_t kMaxBody = 1'048'576;

/// A participant, anywhere on the network. Without DDS Security it can be forged.
struct Guid {
  std::array<std::uint8_t, 16> bytes{};

  /// 32 hexadecimal digits.
  std::string text() const;

  friend auto operator<=>(const Guid&, const Guid&) = default;
};

/// What a reader is told, in the order in which it was noticed.
struct Arrival {
  enum class Kind : std::uint8_t {
    kMessage,  ///< `key`, `body`, `sender`, `sent`
    kEnded,    ///< its writer has ended this key on purpose: `key`, `sender`, `sent`
    /// Nobody is left who writes this key: all that did have gone, or are silent. `key`, `sender`
    kOrphaned,
    kMatched,    ///< a writer of this topic is there: `sender`
    kUnmatched,  ///< it is no longer: it went in good order, or its participant has been silent for 5 s:
                 ///< `sender`
    /// The lease of the channel's kind has run out: its process has ended, is stopped, or can't be reached.
    kSilent,
    /// Who was silent has written again: `sender`. As long as it writes nothing it stays silent, so whoever
    /// is to be seen on a channel with a lease writes now and then.
    kAlive,
    /// Nobody took what arrived, so `lost` messages that came after all before were not kept.
    kLost,
  };

  Kind kind = Kind::kMessage;
  std::string key;   ///< at most kMaxKey bytes, none of them 0; need not be UTF-8
  std::string body;  ///< at most kMaxBody bytes
  Guid sender;       ///< the participant
  /// When it was written, by the wall clock of the sender's machine.
  std::chrono::sys_time<std::chrono::nanoseconds> sent;
  /// When it was noticed here: before it was taken.
  std::chrono::steady_clock::time_point noticed;
  std::uint64_t lost = 0;
};

}  // namespace mlab::dds
