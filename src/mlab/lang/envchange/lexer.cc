#include "mlab/lang/envchange/lexer.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/core.h>

#include "mlab/text/shown.h"

namespace mlab::envchange {
namespace {

constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
constexpr bool is_white(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}
constexpr char upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

struct Keyword {
  std::string_view spelling;
  TokenKind kind;
};
constexpr std::array kKeywords = {
    Keyword{"STEP_COUNT", TokenKind::kStepCount}, Keyword{"ADD", TokenKind::kAdd},
    Keyword{"REMOVE", TokenKind::kRemove},        Keyword{"REGION", TokenKind::kRegion},
    Keyword{"OBSTACLE", TokenKind::kObstacle},
};

TokenKind kind_of_word(std::string_view word) {
  const auto is = [&](const Keyword& k) { return std::ranges::equal(k.spelling, word, {}, {}, upper); };
  const auto* found = std::ranges::find_if(kKeywords, is);
  return found == kKeywords.end() ? TokenKind::kWord : found->kind;
}

template <class Class>
std::size_t run(std::string_view text, Class belongs) {
  return static_cast<std::size_t>(std::ranges::find_if_not(text, belongs) - text.begin());
}

// `[-]digits[.digits]`, 0 where there is none.
std::size_t number_length(std::string_view text) {
  const std::size_t sign = text.starts_with('-') ? 1 : 0;
  const std::size_t whole = run(text.substr(sign), is_digit);
  if (whole == 0) return 0;
  const std::size_t n = sign + whole;
  if (n == text.size() || text[n] != '.') return n;
  const std::size_t fraction = run(text.substr(n + 1), is_digit);
  return fraction > 0 ? n + 1 + fraction : n;
}

class Lexer {
 public:
  Lexer(const text::SourcePtr& source, text::Diagnostics& sink)
      : source_(source), text_(source->text()), sink_(sink) {}

  std::vector<Token> run_to_end() && {
    while (at_ < text_.size()) {
      if (!skip_white_space() && !skip_comment() && !lex_token()) report_strays();
    }
    add(TokenKind::kEnd, 0);
    return std::move(tokens_);
  }

 private:
  std::string_view rest() const { return text_.substr(at_); }
  text::Span next(std::size_t length) const {
    return {static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(at_ + length)};
  }

  bool skip_white_space() {
    if (!is_white(text_[at_])) return false;
    starts_line_ = starts_line_ || text_[at_] == '\n';
    ++at_;
    return true;
  }

  bool skip_comment() {
    if (rest().starts_with("//")) {
      at_ = std::min(text_.find('\n', at_), text_.size());
      return true;
    }
    if (!rest().starts_with("/*")) return false;
    const std::size_t end = text_.find("*/", at_ + 2);
    if (end == std::string_view::npos) {
      sink_.error("unterminated-comment", {source_, next(2)}, "a comment without its closing `*/`");
      at_ = text_.size();
    } else {
      starts_line_ = starts_line_ || text_.substr(at_, end - at_).contains('\n');
      at_ = end + 2;
    }
    return true;
  }

  bool lex_token() {
    if (text_[at_] == ',') return add(TokenKind::kComma, 1);
    if (const std::size_t word = run(rest(), is_letter))
      return add(kind_of_word(rest().substr(0, word)), word);
    const std::size_t number = number_length(rest());
    return number > 0 && add(TokenKind::kNumber, number);
  }

  void report_strays() {
    std::size_t end = at_ + 1;
    const auto is_stray = [&](std::size_t i) {
      const char c = text_[i];
      return !is_white(c) && !is_letter(c) && !is_digit(c) && c != ',' && c != '-' && c != '/';
    };
    while (end < text_.size() && is_stray(end)) ++end;
    sink_
        .error("stray-character", {source_, next(end - at_)},
               fmt::format("`{}` means nothing here", text::shown(rest().substr(0, end - at_), 12)))
        .hints = {"numbers are written `12`, `-12` or `12.5`"};
    at_ = end;
  }

  bool add(TokenKind kind, std::size_t length) {
    tokens_.push_back({kind, starts_line_, next(length)});
    at_ += length;
    starts_line_ = false;
    return true;
  }

  const text::SourcePtr& source_;
  std::string_view text_;
  text::Diagnostics& sink_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  bool starts_line_ = true;
};

}  // namespace

std::vector<Token> lex(const text::SourcePtr& source, text::Diagnostics& sink) {
  return Lexer(source, sink).run_to_end();
}

}  // namespace mlab::envchange
