#include "mlab/lang/odl/lexer.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <system_error>

#include <fmt/core.h>

#include "mlab/text/shown.h"

namespace mlab::odl {
namespace {

constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
constexpr bool is_name_character(char c) {
  return is_letter(c) || is_digit(c) || c == '_' || c == '-';
}
constexpr bool is_file_character(char c) {
  return is_name_character(c) || c == '.';
}

// How many characters at the start of `text` belong to the class.
template <class Class>
std::size_t run(std::string_view text, Class belongs) {
  return static_cast<std::size_t>(std::ranges::find_if_not(text, belongs) - text.begin());
}

bool starts_with_word(std::string_view text, std::string_view word) {
  const auto same = [](char a, char b) { return a == b || (is_letter(a) && (a ^ 0x20) == b); };
  return text.size() >= word.size() && std::ranges::equal(text.substr(0, word.size()), word, same);
}

// Each of these gives the length of its class's longest match at the start of the text, 0 for none.

std::size_t number_length(std::string_view text) {
  std::size_t n = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  const std::size_t whole = run(text.substr(n), is_digit);
  n += whole;
  std::size_t fraction = 0;
  if (n < text.size() && text[n] == '.') {
    fraction = run(text.substr(n + 1), is_digit);
    if (whole + fraction == 0) return 0;
    n += 1 + fraction;
  }
  if (whole + fraction == 0) return 0;
  if (n < text.size() && (text[n] == 'e' || text[n] == 'E')) {
    const std::size_t sign = n + 1 < text.size() && (text[n + 1] == '+' || text[n + 1] == '-') ? 1 : 0;
    const std::size_t exponent = run(text.substr(n + 1 + sign), is_digit);
    if (exponent > 0) n += 1 + sign + exponent;
  }
  return n;
}

std::size_t word_length(std::string_view text) {
  if (text.empty() || !is_letter(text[0])) return 0;
  if (starts_with_word(text, "LD/LC")) return 5;
  const std::size_t n = run(text, is_name_character);
  return n < text.size() && text[n] == '*' ? n + 1 : n;
}

std::size_t header_length(std::string_view text) {
  constexpr std::string_view kFirst = "CONTROL";
  constexpr std::string_view kSecond = "MEASURES:";
  if (!starts_with_word(text, kFirst)) return 0;
  const std::size_t blanks = run(text.substr(kFirst.size()), [](char c) { return c == ' ' || c == '\t'; });
  if (blanks == 0 || !starts_with_word(text.substr(kFirst.size() + blanks), kSecond)) return 0;
  return kFirst.size() + blanks + kSecond.size();
}

class Lexer {
 public:
  Lexer(const text::SourcePtr& source, std::vector<Token>& tokens, std::vector<Comment>& comments,
        text::Diagnostics& sink)
      : source_(source), text_(source->text()), tokens_(tokens), comments_(comments), sink_(sink) {}

  void run_to_end() {
    if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;
    while (at_ < text_.size()) {
      if (!skip_white_space() && !lex_comment() && !lex_string() && !lex_word()) skip_strays();
    }
    add_token(TokenKind::kEnd, 0);
  }

 private:
  std::string_view rest() const { return text_.substr(at_); }
  text::Span next(std::size_t length) const {
    return {static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(at_ + length)};
  }

  bool skip_white_space() {
    const char c = text_[at_];
    if (c == '\n') {
      after_blank_line_ = after_blank_line_ || starts_line_;
      starts_line_ = true;
    } else if (c != ' ' && c != '\t' && !rest().starts_with("\r\n")) {
      return false;
    }
    ++at_;
    return true;
  }

  bool lex_comment() {
    if (!rest().starts_with("--")) return false;
    std::string_view comment = rest().substr(0, rest().find('\n'));
    const std::size_t length = comment.size();
    comment = comment.substr(0, comment.find_last_not_of(" \t\r\f\v") + 1);
    comments_.push_back({next(comment.size()), starts_line_, after_blank_line_});
    at_ += length;
    starts_line_ = after_blank_line_ = false;
    return true;
  }

  bool lex_string() {
    if (text_[at_] != '"') return false;
    const std::size_t end = text_.find_first_of("\"\n", at_ + 1);
    if (end != std::string_view::npos && text_[end] == '"') {
      add_token(TokenKind::kString, end + 1 - at_);
      return true;
    }
    std::string_view string = rest().substr(0, end == std::string_view::npos ? end : end - at_);
    if (string.ends_with('\r')) string.remove_suffix(1);
    sink_.error("unterminated-string", {source_, next(string.size())}, "a string without its closing quote")
        .label = "a string ends on the line on which it begins";
    add_token(TokenKind::kString, string.size());
    return true;
  }

  bool lex_word() {
    if (const std::size_t header = header_length(rest())) {
      add_token(TokenKind::kHeader, header, Keyword::kControlMeasures);
      return true;
    }
    const std::size_t number = number_length(rest());
    const std::size_t word = word_length(rest());
    const std::size_t file = run(rest(), is_file_character);
    if (number == 0 && word == 0 && file == 0) return false;
    if (number >= word && number >= file) {
      add_token(TokenKind::kNumber, number);
    } else if (word >= file) {
      add_token(TokenKind::kWord, word, find_keyword(rest().substr(0, word)));
    } else {
      add_token(TokenKind::kFile, file);
    }
    return true;
  }

  void skip_strays() {
    std::size_t end = at_ + 1;
    while (end < text_.size() && is_stray(end)) ++end;
    sink_.warning(
        "stray-character", {source_, next(end - at_)},
        fmt::format("`{}` means nothing here, and is skipped", text::shown(rest().substr(0, end - at_), 12)));
    at_ = end;
  }

  bool is_stray(std::size_t i) const {
    const char c = text_[i];
    if (is_file_character(c) || c == '"' || c == ' ' || c == '\t' || c == '\n') return false;
    if (c == '+') return number_length(text_.substr(i)) == 0;
    return c != '\r' || !text_.substr(i).starts_with("\r\n");
  }

  void add_token(TokenKind kind, std::size_t length, Keyword keyword = Keyword::kNone) {
    const auto comments_end = static_cast<std::uint32_t>(comments_.size());
    tokens_.push_back(
        {kind, keyword, starts_line_, after_blank_line_, next(length), comments_begin_, comments_end});
    comments_begin_ = comments_end;
    at_ += length;
    starts_line_ = after_blank_line_ = false;
  }

  const text::SourcePtr& source_;
  std::string_view text_;
  std::vector<Token>& tokens_;
  std::vector<Comment>& comments_;
  text::Diagnostics& sink_;
  std::size_t at_ = 0;
  std::uint32_t comments_begin_ = 0;
  bool starts_line_ = true;
  bool after_blank_line_ = false;
};

}  // namespace

void lex(const text::SourcePtr& source, std::vector<Token>& tokens, std::vector<Comment>& comments,
         text::Diagnostics& sink) {
  Lexer(source, tokens, comments, sink).run_to_end();
}

bool is_number(std::string_view text) {
  return !text.empty() && number_length(text) == text.size();
}

double number_value(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) return std::numeric_limits<double>::infinity();
  return value;
}

}  // namespace mlab::odl
