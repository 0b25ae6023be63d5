#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "mlab/text/source.h"

namespace mlab::lsp {

/// As the protocol counts: lines from 0, within the line UTF-16 code units from 0.
struct Position {
  std::uint32_t line = 0;
  std::uint32_t character = 0;

  friend bool operator==(const Position&, const Position&) = default;
};

/// Where lines of a text begin. The text has to outlive it. A byte that is no UTF-8 counts as one unit.
class LineIndex {
 public:
  explicit LineIndex(std::string_view text);

  /// An offset past the end counts as the end; one inside of a character as its start.
  Position position(std::uint32_t offset) const;
  /// A line past the end counts as the end, a character past its line as the line's end.
  std::uint32_t offset(Position position) const;
  std::uint32_t line_count() const { return static_cast<std::uint32_t>(starts_.size()); }
  /// Of a line without its line end.
  text::Span line(std::uint32_t number) const;

 private:
  /// Where counting can begin on a long line: units from the line's start.
  struct Mark {
    std::uint32_t offset = 0;
    std::uint32_t units = 0;
  };
  Mark mark_before(std::uint32_t offset, std::uint32_t line_start) const;

  std::string_view text_;
  std::vector<std::uint32_t> starts_;
  std::vector<Mark> marks_;  // ascending
};

}  // namespace mlab::lsp
