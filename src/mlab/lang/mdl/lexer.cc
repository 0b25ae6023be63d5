#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/mdl/token.h"

namespace mlab::mdl {
namespace {

constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
constexpr bool is_alphanumeric(char c) {
  return is_digit(c) || is_letter(c);
}
// A carriage return counts as a blank: files that came through Windows are as good as others.
constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

// Every `..._length` says how many bytes from `at` on belong to that class of token; 0: none.
class Lexer {
 public:
  Lexer(const text::SourcePtr& source, text::Diagnostics& diagnostics)
      : source_(source), text_(source->text()), diagnostics_(diagnostics) {}

  Tokens run() {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;  // byte order mark
    while (at_ < text_.size()) step();
    add(TokenKind::kEnd, 0);
    return std::move(out_);
  }

 private:
  struct Match {
    TokenKind kind = TokenKind::kEnd;
    std::size_t length = 0;
  };

  char peek(std::size_t i) const { return i < text_.size() ? text_[i] : '\0'; }

  template <class Predicate>
  std::size_t run_length(std::size_t from, Predicate belongs) const {
    std::size_t i = from;
    while (i < text_.size() && belongs(text_[i])) ++i;
    return i - from;
  }

  void step() {
    const char c = text_[at_];
    if (c == '\n') {
      if (line_is_empty_) blank_line_ = true;
      line_is_empty_ = true;
      first_on_line_ = true;
      ++at_;
    } else if (is_blank(c)) {
      ++at_;
    } else if (c == '-' && peek(at_ + 1) == '-') {
      comment();
    } else {
      token();
    }
  }

  void comment() {
    std::size_t length = std::min(text_.find('\n', at_), text_.size()) - at_;
    while (is_blank(text_[at_ + length - 1])) --length;
    out_.comments.push_back({span(length), static_cast<std::uint32_t>(out_.tokens.size()), first_on_line_,
                             std::exchange(blank_line_, false)});
    at_ += length;
    line_is_empty_ = first_on_line_ = false;
  }

  void token() {
    Match best;
    // On equal length the class that comes first wins.
    for (const Match match :
         {header(), Match{TokenKind::kDate, date_length()}, Match{TokenKind::kTime, time_length()},
          Match{TokenKind::kLabel, label_length()}, Match{TokenKind::kNumber, number_length()},
          Match{TokenKind::kName, name_length()}, Match{TokenKind::kFile, file_length()}, string(),
          punctuation()}) {
      if (match.length > best.length) best = match;
    }
    if (best.length == 0) {
      skip_characters();
    } else {
      add(best.kind, best.length);
    }
  }

  Match header() const {
    if (!is_letter(text_[at_])) return {};
    const auto two_words = [&](std::string_view first, std::string_view second) -> std::size_t {
      if (!equal_without_case(text_.substr(at_, first.size()), first)) return 0;
      const std::size_t gap = run_length(at_ + first.size(), [](char c) { return c == ' ' || c == '\t'; });
      const std::size_t length = first.size() + gap + second.size();
      if (gap == 0 || !equal_without_case(text_.substr(at_ + first.size() + gap, second.size()), second))
        return 0;
      return length;
    };
    if (const std::size_t n = two_words("MISSION", "NAME"); n > 0 && !continues_name(at_ + n)) {
      return {TokenKind::kMissionName, n};
    }
    if (const std::size_t n = two_words("COMMAND", "LIST:"); n > 0) return {TokenKind::kCommandList, n};
    if (const std::size_t n = two_words("IMMEDIATE", "COMMAND:"); n > 0)
      return {TokenKind::kImmediateCommand, n};
    return {};
  }

  bool continues_name(std::size_t i) const {
    return is_alphanumeric(peek(i)) || peek(i) == '_' || peek(i) == '-';
  }

  std::size_t digits(std::size_t from, std::size_t at_most) const {
    std::size_t n = 0;
    while (n < at_most && is_digit(peek(from + n))) ++n;
    return n;
  }

  std::size_t date_length() const {
    const std::size_t month = digits(at_, 2);
    const std::size_t i = at_ + month;
    if (month == 0 || peek(i) != '-' || digits(i + 1, 2) < 2 || peek(i + 3) != '-' || digits(i + 4, 2) < 2)
      return 0;
    return month + 6;
  }

  std::size_t time_length() const {
    const std::size_t sign = text_[at_] == '+' ? 1 : 0;
    const std::size_t first = digits(at_ + sign, 2);
    if (first == 0) return 0;
    std::size_t n = sign + first;
    if (peek(at_ + n) != ':' || digits(at_ + n + 1, 2) < 2) {
      return sign == 1 ? 1 + run_length(at_ + 1, is_digit) : 0;
    }
    n += 3;
    if (peek(at_ + n) == ':' && digits(at_ + n + 1, 2) == 2) n += 3;
    return n;
  }

  std::size_t label_length() const {
    if (!is_digit(text_[at_])) return 0;
    const std::size_t n = run_length(at_, is_alphanumeric);
    return peek(at_ + n) == '.' ? n + 1 : 0;
  }

  std::size_t number_length() const {
    std::size_t n = text_[at_] == '-' ? 1 : 0;
    const std::size_t whole = run_length(at_ + n, is_digit);
    n += whole;
    if (peek(at_ + n) == '.') {
      const std::size_t fraction = run_length(at_ + n + 1, is_digit);
      if (whole + fraction == 0) return 0;
      n += 1 + fraction;
    } else if (whole == 0) {
      return 0;
    }
    if (peek(at_ + n) == 'e' || peek(at_ + n) == 'E') {
      const std::size_t sign = peek(at_ + n + 1) == '+' || peek(at_ + n + 1) == '-' ? 1 : 0;
      const std::size_t exponent = run_length(at_ + n + 1 + sign, is_digit);
      if (exponent > 0) n += 1 + sign + exponent;
    }
    return n;
  }

  std::size_t name_length() const {
    if (!is_letter(text_[at_])) return 0;
    const std::size_t n = run_length(at_, [](char c) { return is_alphanumeric(c) || c == '_' || c == '-'; });
    return peek(at_ + n) == '*' ? n + 1 : n;
  }

  std::size_t file_length() const {
    const char c = text_[at_];
    if (c != '/' && c != '.' && !is_alphanumeric(c)) return 0;
    const std::size_t n = 1 + run_length(at_ + 1, [](char d) {
                            return d == '/' || d == '-' || d == '.' || d == '_' || is_alphanumeric(d);
                          });
    return peek(at_ + n) == '~' ? n + 1 : n;
  }

  Match string() {
    if (text_[at_] != '"') return {};
    const std::size_t end = std::min(text_.find_first_of("\"\n", at_ + 1), text_.size());
    if (peek(end) == '"') return {TokenKind::kString, end - at_ + 1};
    diagnostics_
        .error("unterminated-string", {source_, span(end - at_)},
               "the string has no closing `\"` on its line")
        .hints.emplace_back(
            "a string ends on the line on which it begins; there is no way to put a `\"` into one");
    return {TokenKind::kString, end - at_};
  }

  Match punctuation() const {
    switch (text_[at_]) {
      case ':':
        return {TokenKind::kColon, 1};
      case '(':
        return {TokenKind::kOpen, 1};
      case ')':
        return {TokenKind::kClose, 1};
      case '<':
        return {TokenKind::kLess, 1};
      case '>':
        return {TokenKind::kGreater, 1};
      case '=':
        return {TokenKind::kEquals, 1};
      case ',':
        return {TokenKind::kComma, 1};
      case '%':
        return {TokenKind::kPercent, is_behind_share() ? std::size_t{1} : 0};
      default:
        return {};
    }
  }

  // Old missions have such signs behind numbers where none belongs; there they still say nothing.
  bool is_behind_share() const {
    const std::size_t n = out_.tokens.size();
    if (n < 2 || out_.tokens[n - 1].kind != TokenKind::kNumber) return false;
    return equal_without_case(source_->text(out_.tokens[n - 2].span), "BELOW");
  }

  // Signs are part of something only before a digit; `--` begins a comment.
  bool may_start_something(std::size_t i) const {
    const char c = text_[i];
    const char next = peek(i + 1);
    if (c == '+') return is_digit(next);
    if (c == '-') return is_digit(next) || next == '.' || next == '-';
    return c == '\n' || is_blank(c) || is_alphanumeric(c) || std::string_view("/.\":()<>=,").contains(c);
  }

  void skip_characters() {
    std::size_t length = 1;
    while (at_ + length < text_.size() && !may_start_something(at_ + length)) ++length;
    diagnostics_.warning(
        "skipped-characters", {source_, span(length)},
        length == 1
            ? "this character belongs to no word of the language and is skipped"
            : fmt::format("these {} bytes belong to no word of the language and are skipped", length));
    at_ += length;
    line_is_empty_ = first_on_line_ = false;
  }

  text::Span span(std::size_t length) const {
    return {static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(at_ + length)};
  }

  void add(TokenKind kind, std::size_t length) {
    Token token{kind, Word::kNone, 0, first_on_line_, std::exchange(blank_line_, false), span(length)};
    if (kind == TokenKind::kName) {
      if (const Keyword* keyword = find_keyword(text_.substr(at_, length))) {
        token.kind = keyword->kind;
        token.word = keyword->word;
        token.value = keyword->value;
      }
    }
    out_.tokens.push_back(token);
    at_ += length;
    line_is_empty_ = first_on_line_ = false;
  }

  text::SourcePtr source_;
  std::string_view text_;
  text::Diagnostics& diagnostics_;
  Tokens out_;
  std::size_t at_ = 0;
  bool first_on_line_ = true;
  bool line_is_empty_ = true;
  bool blank_line_ = false;
};

}  // namespace

Tokens lex(const text::SourcePtr& source, text::Diagnostics& diagnostics) {
  return Lexer(source, diagnostics).run();
}

}  // namespace mlab::mdl
