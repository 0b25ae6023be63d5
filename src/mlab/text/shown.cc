#include "mlab/text/shown.h"

#include <fmt/core.h>

namespace mlab::text {
namespace {

// Bytes of the character at the start of `text`, which is not empty; 0 where it is not UTF-8 or is a control
// character.
std::size_t printable_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t length = first >= 0xc2 && first < 0xe0   ? 2
                             : first >= 0xe0 && first < 0xf0 ? 3
                             : first >= 0xf0 && first < 0xf5 ? 4
                                                             : 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0U) != 0x80U) return 0;
  }
  const bool is_overlong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
  const bool is_surrogate = first == 0xed && byte(1) >= 0xa0;
  const bool is_past_end = first == 0xf4 && byte(1) >= 0x90;
  const bool is_control = first == 0xc2 && byte(1) < 0xa0;
  return is_overlong || is_surrogate || is_past_end || is_control ? 0 : length;
}

}  // namespace

std::string shown(std::string_view piece, std::size_t most) {
  std::string out;
  for (std::size_t count = 0; !piece.empty(); ++count) {
    if (count == most) return out + "...";
    const std::size_t length = printable_length(piece);
    out += length > 0 ? std::string(piece.substr(0, length))
                      : fmt::format("\\x{:02x}", static_cast<unsigned char>(piece[0]));
    piece.remove_prefix(length > 0 ? length : 1);
  }
  return out;
}

}  // namespace mlab::text
