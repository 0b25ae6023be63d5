#include "mlab/lang/cdl/syntax/lexer.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace mlab::cdl {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_name_start(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_name_part(char c) {
  return is_name_start(c) || is_digit(c);
}
bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

class Cutter {
 public:
  explicit Cutter(std::string_view text) : text_(text) {}

  Tokens run() {
    if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;  // a byte order mark
    do {
      skip_blank();
      Token token = next();
      token.comments = static_cast<std::uint32_t>(out_.comments.size());
      token.is_before_value = token.kind == Token::Kind::kName && is_word_before_value(word(token));
      find_layout(token);
      at_ = token.span.end;
      out_.tokens.push_back(token);
    } while (out_.tokens.back().kind != Token::Kind::kEnd);
    return std::move(out_);
  }

 private:
  char peek(std::uint32_t i) const { return i < text_.size() ? text_[i] : '\0'; }

  std::uint32_t line_end(std::uint32_t i) const {
    const std::size_t end = text_.find('\n', i);
    return static_cast<std::uint32_t>(end == std::string_view::npos ? text_.size() : end);
  }

  void skip_blank() {
    for (;;) {
      while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
      if (peek(at_) != '/' || (peek(at_ + 1) != '/' && peek(at_ + 1) != '*')) return;
      Comment comment{{at_, line_end(at_)}, true};
      if (peek(at_ + 1) == '*') {
        const std::size_t close = text_.find("*/", at_ + 2);
        comment.is_closed = close != std::string_view::npos;
        comment.span.end = static_cast<std::uint32_t>(comment.is_closed ? close + 2 : text_.size());
      } else if (text_[comment.span.end - 1] == '\r') {
        --comment.span.end;
      }
      out_.comments.push_back(comment);
      at_ = comment.span.end;
    }
  }

  std::string_view word(const Token& token) const {
    return text_.substr(token.span.begin, token.span.end - token.span.begin);
  }

  // Whether a token begins a line or a statement.
  bool begins_line(const Token& token) const {
    if (out_.tokens.empty()) return true;
    const Token& last = out_.tokens.back();
    const std::string_view between = text_.substr(last.span.end, token.span.begin - last.span.end);
    return word(last) == "}" || word(last) == ";" || between.find('\n') != std::string_view::npos;
  }

  // Whether the next token stands between the braces of `layout A { x 40 -40; }`.
  void find_layout(const Token& token) {
    const std::string_view here = word(token);
    if (here == "{" || here == "}") {
      layout_ = here == "{" && layout_ == Layout::kNamed ? Layout::kInside : Layout::kOutside;
    } else if (here == "layout" && layout_ != Layout::kInside && begins_line(token)) {
      layout_ = Layout::kNamed;
    } else if (layout_ == Layout::kNamed && token.kind != Token::Kind::kName && here != ".") {
      layout_ = Layout::kOutside;
    }
  }

  // Whether the last token may be the end of a value.
  bool is_behind_value() const {
    if (out_.tokens.empty()) return false;
    const Token& last = out_.tokens.back();
    if (last.kind == Token::Kind::kName) return !last.is_before_value;
    return last.kind == Token::Kind::kNumber || last.kind == Token::Kind::kText || word(last) == ")" ||
           word(last) == "]" || word(last) == "}";
  }

  // Whether what follows the last token is a value, so that a sign belongs to its number.
  bool may_begin_value() const { return layout_ == Layout::kInside || !is_behind_value(); }

  // Where a value may stand such a word is somebody's name, but for `not`, with which one may begin.
  bool is_word_before_value(std::string_view name) const {
    constexpr std::string_view kBehindValues[] = {"and", "or", "by", "active", "in"};
    constexpr std::string_view kInStatements[] = {"when", "case"};
    if (name == "not") return true;
    if (std::ranges::find(kBehindValues, name) != std::end(kBehindValues)) return is_behind_value();
    if (std::ranges::find(kInStatements, name) == std::end(kInStatements)) return false;
    const bool begins_statement =
        out_.tokens.empty() || word(out_.tokens.back()) == ";" || word(out_.tokens.back()) == "{";
    return begins_statement || is_behind_value();
  }

  // One past the last character of the number at i, or i where there is none. `1..5` is `1`, `..`, `5`.
  std::uint32_t number_end(std::uint32_t i) const {
    const std::uint32_t begin = i;
    if ((peek(i) == '-' || peek(i) == '+') && may_begin_value()) ++i;
    const std::uint32_t digits = i;
    while (is_digit(peek(i))) ++i;
    const bool is_whole = i > digits;
    if (peek(i) == '.' && is_digit(peek(i + 1))) {
      for (++i; is_digit(peek(i));) ++i;
    } else if (!is_whole) {
      return begin;
    }
    if (peek(i) == 'e' || peek(i) == 'E') {
      std::uint32_t exponent = i + 1;
      if (peek(exponent) == '-' || peek(exponent) == '+') ++exponent;
      if (is_digit(peek(exponent))) {
        for (i = exponent; is_digit(peek(i));) ++i;
      }
    }
    return i;
  }

  Token make(Token::Kind kind, std::uint32_t end) const { return {kind, {at_, end}, 0}; }

  Token quoted() const {
    const std::size_t close = text_.find_first_of("\"\n", at_ + 1);
    if (close != std::string_view::npos && text_[close] == '"')
      return make(Token::Kind::kText, static_cast<std::uint32_t>(close) + 1);
    return make(Token::Kind::kUnclosed, line_end(at_));
  }

  Token next() const {
    if (at_ >= text_.size()) return make(Token::Kind::kEnd, at_);
    const char c = text_[at_];
    if (is_name_start(c)) {
      std::uint32_t end = at_ + 1;
      while (is_name_part(peek(end))) ++end;
      return make(Token::Kind::kName, end);
    }
    if (const std::uint32_t end = number_end(at_); end > at_) return make(Token::Kind::kNumber, end);
    if (c == '"') return quoted();
    if ((c == '-' && peek(at_ + 1) == '>') || (c == '.' && peek(at_ + 1) == '.') ||
        (peek(at_ + 1) == '=' && std::string_view("<>=!").find(c) != std::string_view::npos))
      return make(Token::Kind::kPunctuation, at_ + 2);
    if (std::string_view("{}()[],;:=./+-*<>").find(c) != std::string_view::npos)
      return make(Token::Kind::kPunctuation, at_ + 1);
    std::uint32_t end = at_ + 1;
    while (end < text_.size() && !is_blank(text_[end]) && !is_name_part(text_[end]) &&
           std::string_view("{}()[],;:=./\"-+*<>").find(text_[end]) == std::string_view::npos) {
      ++end;
    }
    return make(Token::Kind::kUnknown, end);
  }

  std::string_view text_;
  std::uint32_t at_ = 0;
  enum class Layout : std::uint8_t { kOutside, kNamed, kInside };
  Layout layout_ = Layout::kOutside;
  Tokens out_;
};

}  // namespace

bool is_name(std::string_view text) {
  return !text.empty() && is_name_start(text[0]) && std::all_of(text.begin() + 1, text.end(), is_name_part);
}

Tokens lex(std::string_view text) {
  return Cutter(text).run();
}

}  // namespace mlab::cdl
