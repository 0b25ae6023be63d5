#pragma once

#include <string>
#include <string_view>

#include "mlab/designer/drawing/model.h"
#include "mlab/lang/cdl/syntax/lexer.h"
#include "mlab/text/source.h"

// Where things stand in a text: what the tree does not say. Positions are bytes.

namespace mlab::designer {

/// The tokens of a text, to be asked for what stands at a place.
class TokenMap {
 public:
  explicit TokenMap(std::string_view text) : text_(text), lexed_(cdl::lex(text)) {}

  const std::vector<cdl::Token>& tokens() const { return lexed_.tokens; }
  std::string_view word(std::size_t i) const {
    const text::Span span = lexed_.tokens[i].span;
    return text_.substr(span.begin, span.end - span.begin);
  }
  /// The first token that begins at or behind a byte; the end where there is none.
  std::size_t at(std::uint32_t byte) const;

  /// Where the `///` lines begin that stand right above a statement that begins at a byte; the byte itself
  /// where there are none.
  std::uint32_t help_begin(std::uint32_t statement) const;

 private:
  std::string_view text_;
  cdl::Tokens lexed_;
};

/// A declaration from its help to its `}` or `;`. Empty where there is none of that name.
text::Span declaration_span(const Model& model, std::string_view name);
std::string declaration_text(const Model& model, std::string_view name);

}  // namespace mlab::designer
