#include "mlab/text/utf8.h"

#include <cstddef>
#include <cstdint>

namespace mlab::text {
namespace {

bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;
}

// Bytes of the character at the start of the text; 0 where it is none.
std::size_t character_length(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  if (first < 0x80U) return 1;
  const std::size_t length = first >= 0xf0U ? 4 : first >= 0xe0U ? 3 : 2;
  if (first < 0xc2U || first > 0xf4U || text.size() < length) return 0;
  std::uint32_t value = first & (0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if (!is_continuation(text[i])) return 0;
    value = value << 6U | (static_cast<unsigned char>(text[i]) & 0x3fU);
  }
  const bool is_overlong = value < (length == 2 ? 0x80U : length == 3 ? 0x800U : 0x10000U);
  const bool is_surrogate = value >= 0xd800U && value <= 0xdfffU;
  return is_overlong || is_surrogate || value > 0x10ffffU ? 0 : length;
}

}  // namespace

bool is_utf8(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t length = character_length(bytes);
    if (length == 0) return false;
    bytes.remove_prefix(length);
  }
  return true;
}

std::string utf8_of_latin1(std::string_view bytes) {
  std::string out;
  for (const char c : bytes) {
    const auto value = static_cast<unsigned char>(c);
    if (value < 0x80U) {
      out += c;
    } else {
      out += static_cast<char>(0xc0U | value >> 6U);
      out += static_cast<char>(0x80U | (value & 0x3fU));
    }
  }
  return out;
}

std::string as_utf8(std::string_view bytes) {
  return is_utf8(bytes) ? std::string(bytes) : utf8_of_latin1(bytes);
}

bool is_character_boundary(std::string_view text, std::size_t at) {
  return at >= text.size() || !is_continuation(text[at]);
}

}  // namespace mlab::text
