#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string_view>

#include "mlab/text/diagnostic.h"

namespace mlab::mavlink {

/// The secret that a vehicle and we have in common.
using Key = std::array<std::byte, 32>;

/// @param text  64 hexadecimal digits, or `passphrase:` and what ground stations make a key of by SHA-256
/// @errors `mavlink-key`; never shows what was read
[[nodiscard]] text::Result<Key> parse_key(std::string_view text);

/// Tens of microseconds since 2015 began.
using SigningTime = std::uint64_t;
/// By the machine's clock.
SigningTime signing_time_now();

/// Behind a frame: which link of the sender's, when, and the begin of a SHA-256 over key, frame, link and
/// time.
struct Signature {
  std::uint8_t link = 0;
  SigningTime time = 0;  ///< of which 48 bits are sent
  std::array<std::byte, 6> digest{};

  static constexpr std::size_t kSize = 13;
  std::array<std::byte, kSize> bytes() const;
  /// @param bytes  `kSize` of them
  static Signature read(std::span<const std::byte> bytes);
};

/// @param frame  from its first byte to its checksum
Signature sign(const Key& key, std::span<const std::byte> frame, std::uint8_t link, SigningTime time);

/// Refuses what was not signed with the key, and what was heard before: each link of each sender has to sign
/// with times that grow.
class Signatures {
 public:
  enum class Verdict : std::uint8_t { kGood, kWrong, kReplayed };

  explicit Signatures(const Key& key) : key_(key) {}

  /// @param now  ours; a sender that was not heard before may be a minute behind it
  Verdict judge(std::span<const std::byte> frame, std::uint8_t system, std::uint8_t component,
                const Signature& signature, SigningTime now);
  /// To be signed with next: later than all before, and than what was heard and was good.
  SigningTime next_time(SigningTime now);
  const Key& key() const { return key_; }

 private:
  struct Sender {
    std::uint8_t system = 0;
    std::uint8_t component = 0;
    std::uint8_t link = 0;
    friend auto operator<=>(const Sender&, const Sender&) = default;
  };

  Key key_;
  // Only who has the key adds to it; of more senders than this nothing new is accepted.
  static constexpr std::size_t kMostSenders = 256;
  std::map<Sender, SigningTime> last_;
  SigningTime latest_ = 0;
};

}  // namespace mlab::mavlink
