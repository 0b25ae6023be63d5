#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "mlab/lang/cnl/parser.h"

namespace mlab::cnl {

/// The parser's place in one file: the token it looks at, what it takes, and what it says when something else
/// stands there. The functions that read one construct each stand in `*_parser.cc`.
class Cursor {
 public:
  Cursor(text::SourcePtr source, text::Diagnostics& diagnostics, Layout& layout);

  const Token& token() const { return token_; }
  std::string_view text() const { return source_->text(token_.span); }
  bool at_end() const { return token_.kind == Token::Kind::kEnd; }
  bool is(Token::Kind kind) const { return token_.kind == kind; }
  /// True at this name or punctuation.
  bool is(std::string_view word) const;
  bool is_any(std::initializer_list<std::string_view> words) const;
  /// True where the token after this one is this word.
  bool is_before(std::string_view word) const;
  /// Offset one past the last token that was taken.
  std::uint32_t last_end() const { return last_end_; }
  std::string_view source_text() const { return source_->text(); }

  void advance();
  /// Takes the token if it is this word.
  bool take(std::string_view word);
  /// Takes this word, or says that it is missing; `why` follows "expected `word`".
  bool expect(std::string_view word, std::string_view why);
  /// Takes a name; `what` says which: "the name of the node".
  std::optional<Word> expect_name(std::string_view what);
  /// The same where dots may stand in it: nodes that stand in others are called `outer.inner`.
  std::optional<Word> expect_node_name(std::string_view what);
  /// The same into a word that is there; false where there is no name.
  bool read_name(Word& out, std::string_view what);
  /// The text up to `]` after a `[` that the cursor looks at. Without a `[` an empty word.
  Word take_unit();
  /// A constant, or the name of a node or parameter.
  std::optional<flow::Source> expect_source(std::string_view what);
  std::optional<double> expect_number(std::string_view what);

  text::Place here() const { return {source_, token_.span}; }
  text::Place place(text::Span span) const { return {source_, span}; }
  text::Diagnostic& error(std::string kind, text::Place place, std::string message);
  text::Diagnostic& warning(std::string kind, text::Place place, std::string message);
  /// "expected WHAT, found `X`" at the token.
  text::Diagnostic& expected(std::string_view what);

  /// Skips to one of the words, or past the next `;`. @return false at the end of the file
  bool skip_past_semicolon_or_to(std::initializer_list<std::string_view> words);
  void skip_to(std::initializer_list<std::string_view> words);

  /// The `///` lines right above the token.
  struct Doc {
    std::string help;
    std::string source;
  };
  Doc doc_above() const;
  /// The `///<` help right after the last token that was taken, on the same line, and the lines that continue
  /// it.
  std::string doc_behind() const;

  /// The token starts a line of the canonical layout.
  void line(int indent, bool is_optional = false);
  Layout& layout() { return layout_; }

  /// The lines from `begin` on up to a line that holds nothing but one of the words.
  struct RawLines {
    Code code;
    std::string end_word;  ///< empty: the file ended first
    text::Span end_span;
  };
  RawLines raw_lines(std::uint32_t begin, std::initializer_list<std::string_view> end_words) const;
  /// Goes on behind user code.
  void resume(std::uint32_t offset);

  /// The user code that starts behind the token (or on the next line, where nothing follows on this one).
  std::uint32_t code_start() const;

 private:
  void lex(std::uint32_t offset);
  bool handle_odd_token();

  text::SourcePtr source_;
  text::Diagnostics& diagnostics_;
  Layout& layout_;
  Lexer lexer_;
  Token token_;
  std::uint32_t last_end_ = 0;
};

/// A number as CNL writes it: `007`, `(.5)`, `-2e3`. Canonical text without parentheses and leading zeros.
std::string canonical_number(std::string_view text);

void parse_procedure(Cursor& cursor, Tree& tree);
void parse_init(Cursor& cursor, Tree& tree);
void parse_type(Cursor& cursor, Tree& tree);
void parse_module(Cursor& cursor, Tree& tree);
void parse_parameter(Cursor& cursor, Tree& tree);
void parse_node(Cursor& cursor, Tree& tree);
void parse_operator(Cursor& cursor, Tree& tree);
/// `in LOW .. HIGH`, or nothing. @return false after an error
bool parse_range(Cursor& cursor, std::optional<double>& low, std::optional<double>& high, text::Place& place);

/// Words at which reading goes on after an error.
inline const std::initializer_list<std::string_view> kDeclarationWords = {
    "procedure", "nprocedure", "external", "init",      "type",     "module", "modulename",
    "node",      "public",     "remote",   "parameter", "sequence", "select", "delay"};

}  // namespace mlab::cnl
