#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/text/source.h"

namespace mlab::cnl {

/// A piece of a declaration. Words of the language are names: only their place makes them words.
struct Token {
  enum class Kind : std::uint8_t {
    kEnd,
    kName,         ///< `$?L(L|D|_|-)*`, several of them joined by dots
    kNumber,       ///< also in parentheses: `(.5)`
    kCharacter,    ///< `'c'`
    kString,       ///< `"text"`
    kInitializer,  ///< `{1, 2}`, braces balanced, on one line
    kDescription,  ///< `|text|`
    kDirective,    ///< a whole line that starts with `#`
    kPunctuation,  ///< one of `< > , = ; : [ ] ( )`, or `..`
    kUnknown,      ///< bytes that start no token; several in a row are one token
    kUnclosed,     ///< a string, character, initializer or description that its line does not close
  };
  Kind kind = Kind::kEnd;
  text::Span span;
};

/// A comment outside of user code, with its `//` or `/* */`.
struct Comment {
  text::Span span;
  bool is_closed = true;
};

/// Cuts a source into tokens, one at a time and from any place, because user code in between is not cut at
/// all.
class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) {}

  /// The first token at or after `offset`; comments on the way are added to `comments` where it is not null.
  Token next(std::uint32_t offset, std::vector<Comment>* comments = nullptr) const;

  /// End of the line that holds `offset`, without its line end.
  std::uint32_t line_end(std::uint32_t offset) const;
  /// Start of the line after the one that holds `offset`, or the end of the text.
  std::uint32_t next_line(std::uint32_t offset) const;
  /// True where only blanks and tabs stand between the start of the line and `offset`.
  bool starts_line(std::uint32_t offset) const;

 private:
  std::uint32_t skip_blank(std::uint32_t i, std::vector<Comment>* comments) const;
  Token make(Token::Kind kind, std::uint32_t begin, std::uint32_t end) const { return {kind, {begin, end}}; }
  Token number(std::uint32_t begin) const;
  Token parenthesis(std::uint32_t begin) const;
  Token initializer(std::uint32_t begin) const;
  Token quoted(std::uint32_t begin) const;
  std::uint32_t number_end(std::uint32_t i) const;
  char at(std::uint32_t i) const { return i < text_.size() ? text_[i] : '\0'; }

  std::string_view text_;
};

/// True where `text` is a name from its first to its last character.
bool is_name(std::string_view text);

}  // namespace mlab::cnl
