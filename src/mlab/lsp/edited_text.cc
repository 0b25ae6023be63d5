#include "mlab/lsp/edited_text.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace mlab::lsp {
namespace {

constexpr std::size_t kPiece = 4096;  // bytes, where lines are not longer

// `\r` alone ends a line, too.
std::uint32_t line_ends_in(std::string_view text) {
  std::uint32_t out = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_pair = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    out += text[i] == '\n' || (text[i] == '\r' && !is_pair) ? 1 : 0;
  }
  return out;
}

}  // namespace

EditedText::EditedText(std::string_view text) : pieces_(pieces_of(text)), size_(text.size()) {}

std::vector<EditedText::Piece> EditedText::pieces_of(std::string_view text) {
  std::vector<Piece> out;
  for (;;) {
    const std::size_t end = text.size() <= 2 * kPiece ? std::string_view::npos : text.find('\n', kPiece);
    const std::string_view piece = end == std::string_view::npos ? text : text.substr(0, end + 1);
    text.remove_prefix(piece.size());
    out.push_back({std::string(piece), line_ends_in(piece)});
    if (end == std::string_view::npos) return out;
  }
}

EditedText::At EditedText::at(Position position) const {
  std::size_t piece = 0;
  std::uint32_t line = position.line;
  while (piece + 1 < pieces_.size() && line >= pieces_[piece].line_ends) line -= pieces_[piece++].line_ends;
  return {piece, LineIndex(pieces_[piece].text).offset({line, position.character})};
}

void EditedText::replace(Position begin, Position end, std::string_view with) {
  const At first = at(begin);
  At last = at(end);
  if (std::tie(last.piece, last.offset) < std::tie(first.piece, first.offset)) last = first;
  std::string now = pieces_[first.piece].text.substr(0, first.offset);
  now += with;
  now += std::string_view(pieces_[last.piece].text).substr(last.offset);
  const auto from = pieces_.begin() + static_cast<std::ptrdiff_t>(first.piece);
  const auto to = pieces_.begin() + static_cast<std::ptrdiff_t>(last.piece) + 1;
  for (auto piece = from; piece != to; ++piece) size_ -= piece->text.size();
  size_ += now.size();
  std::vector<Piece> in_place = pieces_of(now);
  const auto kept = std::min<std::ptrdiff_t>(std::ssize(in_place), to - from);
  std::move(in_place.begin(), in_place.begin() + kept, from);
  if (kept < to - from)
    pieces_.erase(from + kept, to);
  else
    pieces_.insert(to, std::make_move_iterator(in_place.begin() + kept),
                   std::make_move_iterator(in_place.end()));
}

std::string EditedText::text() const {
  std::string out;
  out.reserve(size_);
  for (const Piece& piece : pieces_) out += piece.text;
  return out;
}

}  // namespace mlab::lsp
