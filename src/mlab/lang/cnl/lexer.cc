#include "mlab/lang/cnl/lexer.h"

#include <algorithm>

namespace mlab::cnl {
namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_name_start(char c) {
  return is_letter(c) || c == '$' || c == '_';
}
bool is_name_part(char c) {
  return is_letter(c) || is_digit(c) || c == '_' || c == '-';
}
bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

}  // namespace

bool is_name(std::string_view text) {
  return !text.empty() && is_name_start(text[0]) && std::all_of(text.begin() + 1, text.end(), is_name_part);
}

std::uint32_t Lexer::line_end(std::uint32_t offset) const {
  const std::size_t end = text_.find('\n', offset);
  return static_cast<std::uint32_t>(end == std::string_view::npos ? text_.size() : end);
}

std::uint32_t Lexer::next_line(std::uint32_t offset) const {
  const std::uint32_t end = line_end(offset);
  return end < text_.size() ? end + 1 : end;
}

bool Lexer::starts_line(std::uint32_t offset) const {
  while (offset > 0 && (text_[offset - 1] == ' ' || text_[offset - 1] == '\t')) --offset;
  return offset == 0 || text_[offset - 1] == '\n';
}

std::uint32_t Lexer::skip_blank(std::uint32_t i, std::vector<Comment>* comments) const {
  if (i == 0 && text_.starts_with("\xef\xbb\xbf")) i = 3;  // a byte order mark
  for (;;) {
    while (i < text_.size() && is_blank(text_[i])) ++i;
    if (at(i) != '/' || (at(i + 1) != '/' && at(i + 1) != '*')) return i;
    std::uint32_t end = 0;
    bool closed = true;
    if (at(i + 1) == '/') {
      end = line_end(i);
      if (text_[end - 1] == '\r') --end;
    } else {
      const std::size_t close = text_.find("*/", i + 2);
      closed = close != std::string_view::npos;
      end = static_cast<std::uint32_t>(closed ? close + 2 : text_.size());
    }
    if (comments) comments->push_back({{i, end}, closed});
    i = end;
  }
}

// One past the last character of the number at i, or i where there is none. `1..5` is `1`, `..`, `5`.
std::uint32_t Lexer::number_end(std::uint32_t i) const {
  const std::uint32_t begin = i;
  if (at(i) == '-' || at(i) == '+') ++i;
  std::uint32_t digits = 0;
  for (; is_digit(at(i)); ++i) ++digits;
  if (at(i) == '.' && at(i + 1) != '.') {
    for (++i; is_digit(at(i)); ++i) ++digits;
  }
  if (digits == 0) return begin;
  if (at(i) == 'e' || at(i) == 'E') {
    std::uint32_t exponent = i + 1;
    if (at(exponent) == '-' || at(exponent) == '+') ++exponent;
    if (is_digit(at(exponent))) {
      while (is_digit(at(exponent))) ++exponent;
      i = exponent;
    }
  }
  return i;
}

Token Lexer::parenthesis(std::uint32_t begin) const {
  std::uint32_t i = begin + 1;
  while (at(i) == ' ' || at(i) == '\t') ++i;
  std::uint32_t end = number_end(i);
  if (end == i) return make(Token::Kind::kPunctuation, begin, begin + 1);
  while (at(end) == ' ' || at(end) == '\t') ++end;
  return at(end) == ')' ? make(Token::Kind::kNumber, begin, end + 1)
                        : make(Token::Kind::kPunctuation, begin, begin + 1);
}

Token Lexer::initializer(std::uint32_t begin) const {
  int depth = 0;
  for (std::uint32_t i = begin; i < text_.size() && text_[i] != '\n'; ++i) {
    const char c = text_[i];
    if (c == '"' || c == '\'') {
      const Token inner = quoted(i);
      if (inner.kind == Token::Kind::kUnclosed) break;
      i = inner.span.end - 1;
    } else if (c == '{') {
      ++depth;
    } else if (c == '}' && --depth == 0) {
      return make(Token::Kind::kInitializer, begin, i + 1);
    }
  }
  return make(Token::Kind::kUnclosed, begin, line_end(begin));
}

// Looks no farther than it has to: a line may hold a million of them.
Token Lexer::quoted(std::uint32_t begin) const {
  const char quote = text_[begin];
  std::uint32_t i = begin + 1;
  for (; i < text_.size() && text_[i] != '\n'; ++i) {
    if (text_[i] == '\\' && at(i + 1) != '\n' && i + 1 < text_.size()) {
      ++i;
    } else if (text_[i] == quote) {
      return make(quote == '"' ? Token::Kind::kString : Token::Kind::kCharacter, begin, i + 1);
    }
  }
  return make(Token::Kind::kUnclosed, begin, i);
}

Token Lexer::next(std::uint32_t offset, std::vector<Comment>* comments) const {
  const std::uint32_t i = skip_blank(offset, comments);
  if (i >= text_.size()) return make(Token::Kind::kEnd, i, i);
  const char c = text_[i];
  if (is_name_start(c)) {
    std::uint32_t end = i + 1;
    // A dot inside of a name belongs to it: a node may stand in others.
    while (is_name_part(at(end)) || (at(end) == '.' && (is_name_start(at(end + 1)) || is_digit(at(end + 1)))))
      ++end;
    return make(Token::Kind::kName, i, end);
  }
  if (const std::uint32_t end = number_end(i); end > i) return make(Token::Kind::kNumber, i, end);
  switch (c) {
    case '(':
      return parenthesis(i);
    case '{':
      return initializer(i);
    case '"':
    case '\'':
      return quoted(i);
    case '<':
    case '>':
    case ',':
    case '=':
    case ';':
    case ':':
    case '[':
    case ']':
    case ')':
      return make(Token::Kind::kPunctuation, i, i + 1);
    case '.':
      if (at(i + 1) == '.') return make(Token::Kind::kPunctuation, i, i + 2);
      break;
    case '|': {
      const std::size_t close = text_.find_first_of("|\n", i + 1);
      if (close != std::string_view::npos && text_[close] == '|') {
        return make(Token::Kind::kDescription, i, static_cast<std::uint32_t>(close) + 1);
      }
      return make(Token::Kind::kUnclosed, i, line_end(i));
    }
    case '#':
      if (starts_line(i)) return make(Token::Kind::kDirective, i, line_end(i));
      break;
    default:
      break;
  }
  std::uint32_t end = i + 1;
  while (end < text_.size() && !is_blank(text_[end]) && !is_name_part(text_[end]) &&
         std::string_view("$+.({\"'<>,=;:[])|/#").find(text_[end]) == std::string_view::npos) {
    ++end;
  }
  return make(Token::Kind::kUnknown, i, end);
}

}  // namespace mlab::cnl
