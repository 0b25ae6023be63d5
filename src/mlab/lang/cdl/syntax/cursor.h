#pragma once

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/lang/cdl/syntax/lexer.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/lang/cdl/syntax/tree.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cdl {

/// Blocks and parentheses may stand this deep in each other.
inline constexpr int kMaxNesting = 200;

/// The parser's place in one file: the token it looks at, what it takes, and what it says when something else
/// stands there. What is missing is said once and then taken as if it were there, so that one slip is one
/// message. The functions that read one construct each stand in `parse_*.cc`.
class Cursor {
 public:
  /// @param written  null: only what is whole is kept
  Cursor(text::SourcePtr source, text::Diagnostics& sink, PartialFile* written = nullptr);

  const Token& token() const { return tokens_[at_]; }
  std::string_view text() const { return source_->text(token().span); }
  bool at_end() const { return token().kind == Token::Kind::kEnd; }
  bool is(Token::Kind kind) const { return token().kind == kind; }
  bool is(std::string_view word) const;
  bool is_any(std::initializer_list<std::string_view> words) const;
  /// As `is_any`; where the text ends, these words could stand there.
  bool could_be(std::initializer_list<std::string_view> words);
  /// Whether the token after this one is this word.
  bool is_before(std::string_view word) const;
  bool is_before(Token::Kind kind) const { return !at_end() && tokens_[at_ + 1].kind == kind; }
  /// Whether a name follows on the same line that is no word of an expression.
  bool is_before_name() const;
  /// Whether a name follows, or names joined by dots, and this word behind them.
  bool is_before_path_and(std::string_view word) const;
  /// Whether this token stands on another line than the one before it.
  bool starts_line() const;
  /// Whether a declaration starts here: one of its words at the start of a line, and a name behind it.
  bool at_declaration() const;
  const text::SourcePtr& source() const { return source_; }

  void advance();
  /// What stands here is a word of the language.
  void note_word(text::Span span);
  void advance_word() {
    note_word(token().span);
    advance();
  }
  bool take(std::string_view word);
  /// Takes this word, or says that it is missing and goes on as if it were there. `why` follows "expected
  /// `word`". @return false where it is missing and what stands there makes no sense behind it
  bool expect(std::string_view word, std::string_view why);
  /// The `;` behind a statement. Where it is missing, the message points behind what it should follow.
  bool expect_semicolon(std::string_view why);
  bool read_name(Word& out, std::string_view what);
  std::optional<double> read_number();
  /// Whether the `/` here, behind the first unit of a quantity, belongs to its unit: a unit follows, or there
  /// is no blank on either side.
  bool divides_units(const Word& unit) const;
  /// Whether a unit of two stands here without blanks, `m/s`, and so no number before it.
  bool at_unit() const;
  std::optional<std::string> read_text(std::string_view what);
  /// The text up to `]` after a `[` that the cursor looks at. Without a `[` an empty word.
  Word take_unit();

  /// A `{`, and which construct it belongs to. @return false where nothing that follows can be its content
  bool open(const char* what);
  /// Whether the block that was opened last ends here (or can't go on).
  bool at_close();
  /// Whether a statement may begin here.
  bool at_statement() const;
  void close();
  /// Counts nesting; says so once and gives up the file where it is too deep.
  bool enter();
  void leave() { --depth_; }

  /// Whether what is incomplete is kept: a part that could not be read whole goes into the tree all the same.
  bool keeps_parts() const { return written_ != nullptr; }
  /// Whether the part that was just read goes into the tree.
  bool keeps(bool is_whole) const { return is_whole || keeps_parts(); }
  /// A value that is missing here.
  ExpressionPtr hole() const;
  /// Where parts are kept: whether the next line begins a statement of its own, so that what should stand
  /// here is still to be written. (Who checks a whole file says more of it by going on.)
  bool at_next_statement() const;
  /// Where parts are kept: skips what can't be read, up to one of these words, but not out of the statement.
  /// @return whether the cursor looks at one of them
  bool skip_to(std::initializer_list<std::string_view> words);
  /// Hands over what was read, and whether anything was left open where the text ends.
  void finish();

  /// A `{` ends the expression that is being read: `select by task {`.
  bool stops_at_brace = false;

  text::Place here() const { return {source_, token().span}; }
  text::Place place(text::Span span) const { return {source_, span}; }
  /// From `begin` to the last token that was taken.
  text::Place since(std::uint32_t begin) const;
  text::Span span_since(std::uint32_t begin) const { return {begin, std::max(begin, last_end())}; }
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
  /// Nothing but what is missing here could follow where the text ends.
  void need_here() { needs_more_ = needs_more_ || at_end(); }
  std::string found() const;

  text::SourcePtr source_;
  text::Diagnostics& sink_;
  std::vector<Token> tokens_;
  std::vector<Comment> comments_;
  std::size_t at_ = 0;
  std::size_t statement_ = 0;  ///< where the statement begins that is being read
  std::vector<Block> blocks_;
  std::optional<Mismatch> mismatch_;
  mutable text::Span line_;  ///< that was looked for last
  text::Span error_line_;    ///< the line that something was said about last
  int depth_ = 0;
  bool gave_up_ = false;  ///< nothing more is said of this file
  PartialFile* written_ = nullptr;
  bool needs_more_ = false;    ///< all that could follow the text is known
  bool has_read_end_ = false;  ///< the statement that could begin where the text ends was looked for
};

/// An expression. @return false after an error, which was said; then `into` is what was read of it, with
/// holes
bool parse_expression(Cursor& cursor, ExpressionPtr& into);
/// `callee(arguments)` where the cursor looks at the callee. @return as `parse_expression`
bool parse_call(Cursor& cursor, std::string_view what, Call& into);
/// `cooperate { ... }` and the other operators. The cursor looks at their word. @return nothing after an
/// error
bool parse_block(Cursor& cursor, Expression& into);
/// Whether an operator starts here.
bool at_block(const Cursor& cursor);
/// @return nothing where no number stands
std::optional<Number> parse_quantity(Cursor& cursor);
/// Puts a declaration into the tree, if it is kept. @return is_whole
template <class Declaration>
bool put(const Cursor& cursor, std::uint32_t begin, Declaration what, bool is_whole, Tree& tree) {
  what.whole = cursor.span_since(begin);
  if (cursor.keeps(is_whole)) tree.items.emplace_back(std::move(what));
  return is_whole;
}
/// One declaration of the file; false where it could not be read.
bool parse_item(Cursor& cursor, Tree& tree);
bool parse_parameters(Cursor& cursor, std::vector<Parameter>& into);
bool parse_let(Cursor& cursor, std::vector<Let>& into);
bool parse_class(Cursor& cursor, Tree& tree, const std::string& help);
bool parse_robot(Cursor& cursor, Tree& tree, const std::string& help);
bool parse_society(Cursor& cursor, Tree& tree, const std::string& help);
bool parse_society_operator(Cursor& cursor, Tree& tree, const std::string& help);
bool parse_test(Cursor& cursor, Tree& tree, const std::string& help);
/// `Searching.Noise`. @return  false where there is none, which was said
bool read_path(Cursor& cursor, Word& out, std::string_view what);

/// Words that start a declaration.
inline constexpr std::string_view kDeclarationWords[] = {"use",   "architecture", "assemblage", "binding",
                                                         "class", "robot",        "operator",   "society",
                                                         "test",  "layout"};

}  // namespace mlab::cdl
