#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/lang/cdl_historic/parser.h"
#include "mlab/lang/cdl_historic/token.h"

namespace mlab::cdl_historic {

/// The parser's place in one file: the token it looks at, what it takes, and what it says when something else
/// stands there. Expressions are read in expression_parser.cc, definitions in definition_parser.cc.
class Cursor {
 public:
  Cursor(text::SourcePtr source, std::vector<Token> tokens, text::Diagnostics& sink)
      : source_(std::move(source)), tokens_(std::move(tokens)), sink_(sink) {}

  const Token& token(std::size_t ahead = 0) const;
  std::string_view text(std::size_t ahead = 0) const { return source_->text(token(ahead).span); }
  bool at_end() const { return is(Token::Kind::kEnd); }
  bool is(Token::Kind kind) const { return token().kind == kind; }
  /// True at this punctuation, or at a name that is exactly this word.
  bool is(std::string_view word, std::size_t ahead = 0) const;

  void advance();
  bool take(std::string_view word);
  /// Takes this word, or says that it is missing; `why` follows "expected `word`".
  bool expect(std::string_view word, std::string_view why);
  /// What the token says (without `%`, bars, braces), and takes it.
  Word take_word();
  /// Takes a name; `what` says which: "the name of the instance". Empty where there is none.
  Word expect_name(std::string_view what);
  Word expect_pushed_name();
  /// `<10, 20>` and `|text|`, in this order, or as far as they are there.
  Spot take_spot();

  text::Place here() const { return {source_, token().span}; }
  /// From the start of `from` to the end of the last token that was taken.
  text::Place since(const text::Place& from) const { return {source_, {from.span.begin, last_end_}}; }
  /// "expected WHAT, found `X`" at the token.
  void expected(std::string_view what);
  text::Diagnostics& sink() { return sink_; }

  /// An error was said of the statement that is being read: no more of it is.
  bool failed() const { return failed_; }
  void start_statement() { failed_ = false; }
  /// Goes on behind the next `;` at the top, or at a word that starts a statement.
  void skip_statement();

  /// False, with an error, where instances are nested more than kMaxNesting deep.
  bool enter();
  void leave() { --depth_; }

  /// Where the token stands in the file, to see whether anything was taken.
  std::size_t position() const { return at_; }

 private:
  text::SourcePtr source_;
  std::vector<Token> tokens_;
  text::Diagnostics& sink_;
  std::size_t at_ = 0;
  std::uint32_t last_end_ = 0;
  int depth_ = 0;
  bool failed_ = false;
};

/// The words that start a statement, in both historic spellings.
bool starts_statement(std::string_view word);

/// A reference, instance or group; null after an error.
ExprPtr parse_expression(Cursor& cursor);
/// `( ... )` behind a class.
std::vector<Setting> parse_arguments(Cursor& cursor);
/// `[ ... ]`
std::vector<Setting> parse_members(Cursor& cursor);
/// `defX ...;` behind its keyword.
void parse_definition(Cursor& cursor, std::string_view keyword, Tree& tree);

}  // namespace mlab::cdl_historic
