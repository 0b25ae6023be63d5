#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace mlab::network {

/// Host number k has 10.77.0.k, in a network of 254.
inline constexpr std::uint32_t kNetwork = 0x0a4d0000;
inline constexpr int kMaxHosts = 254;

inline constexpr const char* kInterface = "net0";

inline std::string address_of(int host) {
  return "10.77.0." + std::to_string(host);
}

/// 0: it is that of no host.
constexpr int host_with(std::uint32_t address) {
  return (address & 0xffffff00U) == kNetwork && (address & 0xffU) <= kMaxHosts
             ? static_cast<int>(address & 0xffU)
             : 0;
}

/// Multicasts, and the broadcasts of this network.
constexpr bool is_for_all(std::uint32_t address) {
  return address >> 28 == 0xe || address == 0xffffffffU || address == (kNetwork | 0xffU);
}

/// Administered locally.
constexpr std::array<std::uint8_t, 6> hardware_address(int host) {
  return {0x02, 0x00, 0x0a, 0x4d, 0x00, static_cast<std::uint8_t>(host)};
}

}  // namespace mlab::network
