#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "mlab/text/source.h"

namespace mlab::cdl {

/// A piece of a configuration. Words of the language are names: only their place makes them words.
struct Token {
  enum class Kind : std::uint8_t {
    kEnd,
    kName,         ///< a letter or `_`, then letters, digits, `_`
    kNumber,       ///< `2`, `-0.5`, `.5`, `1e6`; `a -1` is `a`, `-`, `1`
    kText,         ///< `"text"`, on one line
    kPunctuation,  ///< one of `{ } ( ) [ ] , ; : = . + - * / < >`, or
                   ///< `..`, `->`, `<=`, `>=`, `==`, `!=`
    kUnknown,      ///< bytes that start no token; several in a row are one token
    kUnclosed,     ///< a text that its line does not close
  };
  Kind kind = Kind::kEnd;
  text::Span span;
  std::uint32_t comments = 0;  ///< how many comments stand before it in the file
  /// A word of the language behind which a value begins, `not`, `by`, where it stands as that word: what is
  /// called so by somebody is a value.
  bool is_before_value = false;
};

/// A comment with its `//`, `///` or `/* */`.
struct Comment {
  text::Span span;
  bool is_closed = true;
};

/// A file cut into tokens, the last one of kind kEnd, and the comments between them.
struct Tokens {
  std::vector<Token> tokens;
  std::vector<Comment> comments;
};

/// A sign right before a number belongs to it where a value begins: not behind another value (`a -1`,
/// `f(x)-1`), but always in a `layout`, where numbers stand one behind the other.
Tokens lex(std::string_view text);

/// True where `text` is a name from its first to its last character.
bool is_name(std::string_view text);

}  // namespace mlab::cdl
