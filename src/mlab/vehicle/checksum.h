#pragma once

#include <cstdint>
#include <string_view>

namespace mlab::vehicle {

/// CRC-16/CCITT: polynomial 1021, begun with FFFF, nothing reflected; of "123456789" it is 29B1.
/// @source ITU-T V.41; the variant that is also called CCITT-FALSE
constexpr std::uint16_t checksum_of(std::string_view bytes) {
  std::uint32_t sum = 0xFFFF;
  for (const char c : bytes) {
    sum ^= static_cast<std::uint32_t>(static_cast<std::uint8_t>(c)) << 8U;
    for (int bit = 0; bit < 8; ++bit) sum = (sum & 0x8000U) != 0 ? (sum << 1U) ^ 0x1021U : sum << 1U;
  }
  return static_cast<std::uint16_t>(sum);
}
static_assert(checksum_of("123456789") == 0x29B1);

}  // namespace mlab::vehicle
