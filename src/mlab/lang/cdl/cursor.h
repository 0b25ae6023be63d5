#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/lang/cdl/lexer.h"
#include "mlab/lang/cdl/tree.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cdl {

/// Blocks and parentheses may stand this deep in each other.
inline constexpr int kMaxNesting = 200;

/// The parser's place in one file: the token it looks at, what it takes, and what it says when something else
/// stands there. What is missing is said once and then taken as if it were there, so that one slip is one
/// message. The functions that read one construct each stand in `parse_*.cc`.
class Cursor {
 public:
  Cursor(text::SourcePtr source, text::Diagnostics& sink);

  const Token& token() const { return tokens_[at_]; }
  std::string_view text() const { return source_->text(token().span); }
  bool at_end() const { return token().kind == Token::Kind::kEnd; }
  bool is(Token::Kind kind) const { return token().kind == kind; }
  bool is(std::string_view word) const;
  bool is_any(std::initializer_list<std::string_view> words) const;
  /// Whether the token after this one is this word.
  bool is_before(std::string_view word) const;
  /// Whether a name follows on the same line that is no word of an expression.
  bool is_before_name() const;
  /// Whether this token stands on another line than the one before it.
  bool starts_line() const;
  /// Whether a declaration starts here: one of its words at the start of a line, and a name behind it.
  bool at_declaration() const;
  const text::SourcePtr& source() const { return source_; }

  void advance();
  bool take(std::string_view word);
  /// Takes this word, or says that it is missing and goes on as if it were there. `why` follows "expected
  /// `word`". @return false where it is missing and what stands there makes no sense behind it
  bool expect(std::string_view word, std::string_view why);
  /// The `;` behind a statement. Where it is missing, the message points behind what it should follow.
  bool expect_semicolon(std::string_view why);
  bool read_name(Word& out, std::string_view what);
  std::optional<double> read_number();
  std::optional<std::string> read_text(std::string_view what);
  /// The text up to `]` after a `[` that the cursor looks at. Without a `[` an empty word.
  Word take_unit();

  /// A `{`, and which construct it belongs to. @return false where nothing that follows can be its content
  bool open(const char* what);
  /// Whether the block that was opened last ends here (or can't go on).
  bool at_close() const { return at_end() || is("}") || at_declaration(); }
  void close();
  /// Counts nesting; says so once and gives up the file where it is too deep.
  bool enter();
  void leave() { --depth_; }

  /// A `{` ends the expression that is being read: `select by task {`.
  bool stops_at_brace = false;

  text::Place here() const { return {source_, token().span}; }
  text::Place place(text::Span span) const { return {source_, span}; }
  /// From `begin` to the last token that was taken.
  text::Place since(std::uint32_t begin) const;
  std::uint32_t begin() const { return token().span.begin; }
  /// Says it, unless something was said about the same line.
  text::Diagnostic* error(std::string kind, const text::Place& place, std::string message);
  /// "expected WHAT, found `X`" at the token.
  text::Diagnostic* expected(std::string_view what);

  /// Skips past the next `;` of this block, or to its end.
  void skip_statement();
  /// Skips a declaration that could not be read.
  void skip_declaration();

  /// The `///` lines right above the token.
  std::string help_above() const;
  /// The `///<` help behind the token that was taken last, or behind the `,` that is next.
  std::string help_behind() const;

 private:
  struct Block {
    const char* what;
    text::Span opener;  ///< its `{`
    std::uint32_t indent;
    bool stops_at_brace;  ///< as it was outside
  };
  /// A `}` that stands farther left than the line of its `{`: some `}` before it is missing.
  struct Mismatch {
    const char* what;
    text::Span opener;
    text::Span before;  ///< what stands before the `}`
  };

  text::Span line_around(std::uint32_t at) const;
  std::uint32_t indent_of(std::uint32_t offset) const;
  text::Span last_span() const { return at_ == 0 ? text::Span{} : tokens_[at_ - 1].span; }
  std::uint32_t last_end() const { return at_ == 0 ? 0 : tokens_[at_ - 1].span.end; }
  void report_unclosed(const Block& block);
  std::string found() const;

  text::SourcePtr source_;
  text::Diagnostics& sink_;
  std::vector<Token> tokens_;
  std::vector<Comment> comments_;
  std::size_t at_ = 0;
  std::vector<Block> blocks_;
  std::optional<Mismatch> mismatch_;
  mutable text::Span line_;  ///< that was looked for last
  text::Span error_line_;    ///< the line that something was said about last
  int depth_ = 0;
  bool gave_up_ = false;  ///< nothing more is said of this file
};

/// An expression; null after an error, which was said.
ExpressionPtr parse_expression(Cursor& cursor);
/// `callee(arguments)` where the cursor looks at the callee.
std::optional<Call> parse_call(Cursor& cursor, std::string_view what);
/// `cooperate { ... }` and the other operators. The cursor looks at their word. @return nothing after an
/// error
bool parse_block(Cursor& cursor, Expression& into);
/// Whether an operator starts here.
bool at_block(const Cursor& cursor);
std::optional<Number> parse_quantity(Cursor& cursor);
/// One declaration of the file; false where it could not be read.
bool parse_item(Cursor& cursor, Tree& tree);
bool parse_parameters(Cursor& cursor, std::vector<Parameter>& into);
bool parse_let(Cursor& cursor, std::vector<Let>& into);
bool parse_class(Cursor& cursor, Tree& tree, const std::string& help);
bool parse_robot(Cursor& cursor, Tree& tree, const std::string& help);
bool parse_society(Cursor& cursor, Tree& tree, const std::string& help);
bool parse_society_operator(Cursor& cursor, Tree& tree, const std::string& help);

/// Words that start a declaration.
inline constexpr std::string_view kDeclarationWords[] = {
    "use", "architecture", "assemblage", "binding", "class", "robot", "operator", "society", "layout"};

}  // namespace mlab::cdl
