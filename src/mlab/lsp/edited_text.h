#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/lsp/position.h"

namespace mlab::lsp {

/// A text that is changed many times before anybody reads it: a change costs what it changes, not what the
/// whole text has. Lines are counted as LineIndex does.
class EditedText {
 public:
  explicit EditedText(std::string_view text);

  /// Puts `with` in the place of what lies between two positions; before the first, where the second lies
  /// before it.
  void replace(Position begin, Position end, std::string_view with);
  std::size_t size() const { return size_; }
  std::string text() const;

 private:
  // Some lines; all pieces but the last end in `\n`.
  struct Piece {
    std::string text;
    std::uint32_t line_ends = 0;
  };
  struct At {
    std::size_t piece = 0;
    std::uint32_t offset = 0;
  };

  static std::vector<Piece> pieces_of(std::string_view text);
  At at(Position position) const;

  std::vector<Piece> pieces_;
  std::size_t size_ = 0;
};

}  // namespace mlab::lsp
