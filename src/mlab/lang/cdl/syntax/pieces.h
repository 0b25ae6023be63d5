#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "mlab/lang/cdl/syntax/lexer.h"
#include "mlab/text/source.h"

namespace mlab::cdl {

/// A text as what stands in it one after the other: tokens and comments, both counted as pieces, and which
/// comment belongs to which token. The text must outlive it.
class Pieces {
 public:
  explicit Pieces(std::string_view text) : text_(text), lexed_(lex(text)) {}

  std::string_view text() const { return text_; }
  std::string_view text(text::Span span) const { return text_.substr(span.begin, span.end - span.begin); }
  std::size_t size() const { return lexed_.tokens.size() - 1 + lexed_.comments.size(); }

  /// The token behind the last one: the end of the text.
  std::size_t end() const { return lexed_.tokens.size() - 1; }
  text::Span token(std::size_t at) const { return lexed_.tokens[at].span; }
  std::string_view word(std::size_t at) const { return text(token(at)); }
  text::Span comment(std::size_t at) const { return lexed_.comments[at].span; }
  /// The first token that begins at or behind a byte.
  std::size_t token_at(std::uint32_t byte) const;

  std::size_t piece_of_token(std::size_t at) const { return at + lexed_.tokens[at].comments; }
  std::size_t piece_of_comment(std::size_t at) const;

  /// The comments behind a token on its line, or on the line of its comma.
  std::vector<std::size_t> comments_behind(std::size_t token) const;
  /// The comments before a token that stand behind no other.
  std::vector<std::size_t> comments_before(std::size_t token) const;
  /// The last of them, where they are the help of what begins there.
  std::vector<std::size_t> help_before(std::size_t token) const;
  /// Comments at the start of the text that an empty line parts from what is below them.
  std::vector<std::size_t> header() const;

  /// Where the comments before a token begin that stand behind no other; where those behind one end.
  std::uint32_t begin_with_comments(std::size_t at) const;
  std::uint32_t end_with_comments(std::size_t at) const;

  /// How many lines end before, or behind, a piece.
  int lines_before(text::Span piece) const;
  int lines_behind(text::Span piece) const;

 private:
  /// The first comment behind a token that does not stand on its line.
  std::size_t end_of_line(std::size_t token) const;

  std::string_view text_;
  Tokens lexed_;
};

}  // namespace mlab::cdl
