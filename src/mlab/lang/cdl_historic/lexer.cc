#include "mlab/lang/cdl_historic/lexer.h"

#include <cstddef>
#include <string_view>

#include <fmt/core.h>

#include "mlab/text/shown.h"

namespace mlab::cdl_historic {
namespace {

using Kind = Token::Kind;

constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
// Wider than the historic rule, which let names start with letters only and inline names hold no dot.
constexpr bool starts_name(char c) {
  return is_letter(c) || c == '_' || c == '$';
}
constexpr bool is_name_character(char c) {
  return is_letter(c) || is_digit(c) || c == '_' || c == '-' || c == '.' || c == '*';
}
constexpr bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

class Lexer {
 public:
  Lexer(const text::SourcePtr& source, text::Diagnostics& sink)
      : source_(source), text_(source->text()), sink_(sink) {}

  std::vector<Token> run() {
    if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;
    while (true) {
      skip_blanks();
      if (at_ >= text_.size()) break;
      lex_token();
    }
    add(Kind::kEnd, 0, 0, 0);
    return std::move(tokens_);
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  std::string_view rest() const { return text_.substr(at_); }
  text::Place place(std::size_t length) const {
    return {source_, {static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(at_ + length)}};
  }

  // A token of `length` characters, of which `front` at its start and `back` at its end say nothing.
  void add(Kind kind, std::size_t length, std::size_t front, std::size_t back) {
    const text::Span span = place(length).span;
    tokens_.push_back(
        {kind,
         span,
         {static_cast<std::uint32_t>(span.begin + front), static_cast<std::uint32_t>(span.end - back)},
         spaced_});
    spaced_ = false;
    at_ += length;
  }

  void skip_blanks() {
    while (at_ < text_.size()) {
      if (is_space(text_[at_])) {
        ++at_;
      } else if (rest().starts_with("//")) {
        skip_line();
      } else if (rest().starts_with("/*")) {
        skip_comment();
      } else if (text_[at_] == '#' && (at_ == 0 || text_[at_ - 1] == '\n')) {
        skip_directive();
      } else {
        return;
      }
      spaced_ = true;
    }
  }

  void skip_line() { at_ = std::min(text_.find('\n', at_), text_.size()); }

  void skip_comment() {
    const std::size_t end = text_.find("*/", at_ + 2);
    if (end == std::string_view::npos) {
      sink_.error("unterminated-comment", place(2), "this comment has no `*/`");
      at_ = text_.size();
    } else {
      at_ = end + 2;
    }
  }

  void skip_directive() {
    std::string_view line = rest().substr(0, rest().find('\n'));
    if (line.ends_with('\r')) line.remove_suffix(1);
    const std::size_t word = line.find_first_not_of("# \t");
    const bool is_marker =
        word == std::string_view::npos || is_digit(line[word]) || line.substr(word).starts_with("line");
    if (!is_marker && line.find("pragma") == std::string_view::npos) {
      sink_
          .warning("unknown-directive", place(line.size()),
                   fmt::format("`{}` means nothing here and is left out", text::shown(line)))
          .hints = {"run the C preprocessor over the file first"};
    }
    skip_line();
  }

  void lex_token() {
    const char c = text_[at_];
    if (starts_name(c)) {
      lex_name();
    } else if (is_digit(c) || (c == '-' && is_digit(peek(1)))) {
      lex_number();
    } else if (c == '%' && (is_letter(peek(1)) || peek(1) == '_')) {
      add(Kind::kPushed, name_length(1), 1, 0);
    } else if (c == '|') {
      lex_description();
    } else if (c == '{') {
      lex_braces();
    } else if (std::string_view("()[]<>,;=^}").find(c) != std::string_view::npos) {
      add(Kind::kPunctuation, 1, 0, 0);
    } else {
      skip_strays();
    }
  }

  std::size_t name_length(std::size_t from) const {
    std::size_t n = from;
    while (is_name_character(peek(n))) ++n;
    return n;
  }

  void lex_name() {
    const std::size_t n = name_length(1);
    if (peek(n) == ':') {
      add(Kind::kInline, n + 1, 0, 1);
    } else {
      add(Kind::kName, n, 0, 0);
    }
  }

  void lex_number() {
    std::size_t n = 1;
    while (is_digit(peek(n))) ++n;
    if (peek(n) == '.') ++n;
    while (is_digit(peek(n))) ++n;
    add(Kind::kNumber, n, 0, 0);
  }

  void lex_description() {
    const std::size_t end = text_.find_first_of("|\n", at_ + 1);
    if (end != std::string_view::npos && text_[end] == '|') {
      add(Kind::kDescription, end + 1 - at_, 1, 1);
      return;
    }
    sink_.error("unterminated-description", place(1), "this description has no second `|` on its line");
    skip_line();
  }

  void lex_braces() {
    if (rest().starts_with("{^")) {
      add(Kind::kUp, 2, 0, 0);
    } else if (rest().starts_with("{@^")) {
      add(Kind::kAdvancedUp, 3, 0, 0);
    } else if (rest().starts_with("{&")) {
      add(Kind::kPair, 2, 0, 0);
    } else if (const std::size_t end = text_.find('}', at_); end != std::string_view::npos) {
      add(Kind::kInitializer, end + 1 - at_, 1, 1);
    } else {
      sink_.error("unterminated-initializer", place(1), "this `{` has no `}`");
      at_ = text_.size();
    }
  }

  void skip_strays() {
    std::size_t n = 1;
    while (at_ + n < text_.size() && is_stray(text_[at_ + n])) ++n;
    sink_.warning(
        "stray-character", place(n),
        fmt::format("`{}` starts no word of the language and is left out", text::shown(rest().substr(0, n))));
    at_ += n;
    spaced_ = true;
  }
  static bool is_stray(char c) {
    return !is_space(c) && !starts_name(c) && !is_digit(c) &&
           std::string_view("()[]<>,;=^}{|%-/#").find(c) == std::string_view::npos;
  }

  text::SourcePtr source_;
  std::string_view text_;
  text::Diagnostics& sink_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  bool spaced_ = false;
};

}  // namespace

std::vector<Token> lex(const text::SourcePtr& source, text::Diagnostics& sink) {
  return Lexer(source, sink).run();
}

}  // namespace mlab::cdl_historic
