#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "mlab/base/fields.h"
#include "mlab/mavlink/messages.h"

namespace mlab::mavlink {

// Little endian, fields without gaps; zeros at the end are not sent, and what was not sent is zero.

namespace wire {

template <std::size_t kSize>
using Bits =
    std::conditional_t<kSize == 1, std::uint8_t,
                       std::conditional_t<kSize == 2, std::uint16_t,
                                          std::conditional_t<kSize == 4, std::uint32_t, std::uint64_t>>>;

template <class T>
void put(std::vector<std::byte>& out, T value) {
  const auto bits = std::bit_cast<Bits<sizeof(T)>>(value);
  for (std::size_t i = 0; i < sizeof(T); ++i) out.push_back(static_cast<std::byte>(bits >> (8 * i)));
}
template <class T, std::size_t kSize>
void put(std::vector<std::byte>& out, const std::array<T, kSize>& values) {
  for (const T& one : values) put(out, one);
}

template <class T>
void take(std::span<const std::byte>& from, T& value) {
  Bits<sizeof(T)> bits = 0;
  for (std::size_t i = 0; i < sizeof(T) && !from.empty(); ++i) {
    bits = static_cast<Bits<sizeof(T)>>(bits | static_cast<Bits<sizeof(T)>>(from.front()) << (8 * i));
    from = from.subspan(1);
  }
  value = std::bit_cast<T>(bits);
}
template <class T, std::size_t kSize>
void take(std::span<const std::byte>& from, std::array<T, kSize>& values) {
  for (T& one : values) take(from, one);
}

}  // namespace wire

/// Appends the message's payload: at least one byte.
template <class Message>
void write_payload(const Message& message, std::vector<std::byte>& out) {
  const std::size_t begin = out.size();
  std::apply([&](const auto&... field) { (wire::put(out, field), ...); }, base::fields_of(message));
  while (out.size() > begin + 1 && out.back() == std::byte{0}) out.pop_back();
}

/// Whatever the bytes are, it is a message; what is longer than one has extensions that are newer than this.
template <class Message>
Message read_payload(std::span<const std::byte> payload) {
  Message out;
  std::apply([&](auto&... field) { (wire::take(payload, field), ...); }, base::fields_of(out));
  return out;
}

}  // namespace mlab::mavlink
