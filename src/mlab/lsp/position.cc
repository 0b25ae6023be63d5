#include "mlab/lsp/position.h"

#include <algorithm>

namespace mlab::lsp {
namespace {

constexpr std::uint32_t kMarkEvery = 256;  // bytes

/// Bytes of the character at `at`; 1 where it is none.
std::uint32_t character_length(std::string_view text, std::uint32_t at) {
  const auto first = static_cast<unsigned char>(text[at]);
  const std::uint32_t length = first >= 0xf0U && first <= 0xf4U  ? 4
                               : first >= 0xe0U && first < 0xf0U ? 3
                               : first >= 0xc2U && first < 0xe0U ? 2
                                                                 : 1;
  if (at + length > text.size()) return 1;
  for (std::uint32_t i = 1; i < length; ++i) {
    if ((static_cast<unsigned char>(text[at + i]) & 0xc0U) != 0x80U) return 1;
  }
  return length;
}

// Characters outside of the first plane take two units.
std::uint32_t units(std::uint32_t length) {
  return length == 4 ? 2 : 1;
}

}  // namespace

LineIndex::LineIndex(std::string_view text) : text_(text) {
  starts_.push_back(0);
  Mark at;
  std::uint32_t marked = 0;
  while (at.offset < text.size()) {
    const char here = text[at.offset];
    const std::uint32_t length = character_length(text, at.offset);
    at.offset += length;
    at.units += units(length);
    // `\r` alone ends a line, too.
    const bool ends = here == '\n' || (here == '\r' && (at.offset == text.size() || text[at.offset] != '\n'));
    if (ends) {
      starts_.push_back(at.offset);
      at.units = 0;
      marked = at.offset;
    } else if (at.offset - marked >= kMarkEvery) {
      marks_.push_back(at);
      marked = at.offset;
    }
  }
}

LineIndex::Mark LineIndex::mark_before(std::uint32_t offset, std::uint32_t line_start) const {
  const auto after = std::ranges::upper_bound(marks_, offset, {}, &Mark::offset);
  if (after == marks_.begin() || (after - 1)->offset < line_start) return {line_start, 0};
  return *(after - 1);
}

text::Span LineIndex::line(std::uint32_t number) const {
  if (number >= starts_.size())
    return {static_cast<std::uint32_t>(text_.size()), static_cast<std::uint32_t>(text_.size())};
  std::uint32_t end =
      number + 1 < starts_.size() ? starts_[number + 1] : static_cast<std::uint32_t>(text_.size());
  while (end > starts_[number] && (text_[end - 1] == '\n' || text_[end - 1] == '\r')) --end;
  return {starts_[number], end};
}

Position LineIndex::position(std::uint32_t offset) const {
  offset = std::min(offset, static_cast<std::uint32_t>(text_.size()));
  const auto after = std::ranges::upper_bound(starts_, offset);
  Position out;
  out.line = static_cast<std::uint32_t>(after - starts_.begin()) - 1;
  const Mark from = mark_before(offset, starts_[out.line]);
  out.character = from.units;
  for (std::uint32_t at = from.offset; at < offset;) {
    const std::uint32_t length = character_length(text_, at);
    if (at + length > offset) break;
    out.character += units(length);
    at += length;
  }
  return out;
}

std::uint32_t LineIndex::offset(Position position) const {
  const text::Span in = line(position.line);
  const auto first = std::ranges::upper_bound(marks_, in.begin, {}, &Mark::offset);
  const auto last = std::ranges::lower_bound(first, marks_.end(), in.end, {}, &Mark::offset);
  const auto beyond = std::ranges::upper_bound(first, last, position.character, {}, &Mark::units);
  std::uint32_t at = beyond == first ? in.begin : (beyond - 1)->offset;
  std::uint32_t counted = beyond == first ? 0 : (beyond - 1)->units;
  while (at < in.end && counted < position.character) {
    const std::uint32_t length = character_length(text_, at);
    counted += units(length);
    if (counted > position.character) break;  // in the middle of a pair
    at += length;
  }
  return at;
}

}  // namespace mlab::lsp
