#include "mlab/lang/cnl/user_code.h"

#include <algorithm>
#include <array>

#include <fmt/core.h>

namespace mlab::cnl {
namespace {

using Kind = CppToken::Kind;

bool is_cpp_word_start(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$' ||
         (static_cast<unsigned char>(c) & 0x80U) != 0;
}
bool is_cpp_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_word_part(char c) {
  return is_cpp_word_start(c) || is_cpp_digit(c);
}

template <std::size_t kCount>
bool is_one_of(std::string_view word, const std::array<std::string_view, kCount>& words) {
  return std::ranges::find(words, word) != words.end();
}

constexpr auto kKeywords = std::to_array<std::string_view>(
    {"alignas",     "alignof",   "and",        "and_eq",    "asm",      "auto",         "bitand",
     "bitor",       "bool",      "break",      "case",      "catch",    "char",         "char8_t",
     "char16_t",    "char32_t",  "class",      "compl",     "concept",  "const",        "consteval",
     "constexpr",   "constinit", "const_cast", "continue",  "co_await", "co_return",    "co_yield",
     "decltype",    "default",   "delete",     "do",        "double",   "dynamic_cast", "else",
     "enum",        "explicit",  "export",     "extern",    "false",    "float",        "for",
     "friend",      "goto",      "if",         "inline",    "int",      "long",         "mutable",
     "namespace",   "new",       "noexcept",   "not",       "not_eq",   "nullptr",      "operator",
     "or",          "or_eq",     "private",    "protected", "public",   "register",     "reinterpret_cast",
     "requires",    "return",    "short",      "signed",    "sizeof",   "static",       "static_assert",
     "static_cast", "struct",    "switch",     "template",  "this",     "thread_local", "throw",
     "true",        "try",       "typedef",    "typeid",    "typename", "union",        "unsigned",
     "using",       "virtual",   "void",       "volatile",  "wchar_t",  "while",        "xor",
     "xor_eq"});

constexpr auto kStatementWords = std::to_array<std::string_view>(
    {"if",     "for",  "while",    "switch",   "do",   "else",    "try",           "catch",
     "return", "goto", "break",    "continue", "case", "default", "static_assert", "delete",
     "throw",  "asm",  "operator", "new",      "this", "sizeof",  "co_return",     "friend"});
constexpr auto kBlockWords =
    std::to_array<std::string_view>({"if", "for", "while", "switch", "do", "else", "try", "catch", "{"});
constexpr auto kSpecifiers =
    std::to_array<std::string_view>({"const", "constexpr", "volatile", "inline", "static", "thread_local",
                                     "register", "constinit", "typename"});
constexpr auto kBuiltinTypes = std::to_array<std::string_view>(
    {"unsigned", "signed", "short", "long", "int", "char", "bool", "float", "double", "auto"});
constexpr auto kTypeWords =
    std::to_array<std::string_view>({"struct", "class", "enum", "union", "using", "typedef"});
/// Small types that copy well and still point at something.
constexpr auto kHiddenPointers =
    std::to_array<std::string_view>({"string_view", "span", "reference_wrapper"});

}  // namespace

bool is_cpp_keyword(std::string_view word) {
  return is_one_of(word, kKeywords);
}

UserCode::UserCode(const Code& code) : code_(code), text_(code.text()) {
  cut();
  // Brackets are matched once, so that skipping a group is one step whatever it holds.
  closes_.resize(tokens_.size());
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < tokens_.size(); ++i) {
    closes_[i] = i;
    if (tokens_[i].kind != Kind::kPunctuation) continue;
    const char c = tokens_[i].text[0];
    if (c == '(' || c == '[' || c == '{') {
      open.push_back(i);
    } else if ((c == ')' || c == ']' || c == '}') && !open.empty()) {
      closes_[open.back()] = i;
      open.pop_back();
    }
  }
  for (const std::size_t i : open) closes_[i] = tokens_.size() - 1;
  find_variables();
}

// One past the end of the string or character literal that starts at `at`.
std::uint32_t UserCode::skip_text(std::uint32_t at) const {
  const char quote = text_[at];
  for (++at; at < text_.size() && text_[at] != '\n'; ++at) {
    if (text_[at] == '\\') {
      ++at;
    } else if (text_[at] == quote) {
      return at + 1;
    }
  }
  return static_cast<std::uint32_t>(std::min<std::size_t>(at, text_.size()));
}

// The end of the line of a `#`, and of the lines that it goes on in.
std::uint32_t UserCode::directive_end(std::uint32_t at) const {
  for (;;) {
    const std::size_t end = text_.find('\n', at);
    if (end == std::string_view::npos) return static_cast<std::uint32_t>(text_.size());
    at = static_cast<std::uint32_t>(end);
    if (text_[end - 1] != '\\') return at;
    ++at;
  }
}

void UserCode::cut() {
  const std::uint32_t base = code_.place.span.begin;
  const auto size = static_cast<std::uint32_t>(text_.size());
  const auto starts_line = [&](std::uint32_t at) {
    const std::size_t last = at == 0 ? std::string_view::npos : text_.find_last_not_of(" \t", at - 1);
    return last == std::string_view::npos || text_[last] == '\n';
  };
  const auto add = [&](Kind kind, std::uint32_t begin, std::uint32_t end) {
    tokens_.push_back({kind, text_.substr(begin, end - begin), base + begin});
  };
  for (std::uint32_t i = 0; i < size;) {
    const char c = text_[i];
    if (c == '\n' || c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v') {
      ++i;
    } else if (text_.substr(i, 2) == "//") {
      i = static_cast<std::uint32_t>(std::min<std::size_t>(text_.find('\n', i), size));
    } else if (text_.substr(i, 2) == "/*") {
      const std::size_t close = text_.find("*/", i + 2);
      i = close == std::string_view::npos ? size : static_cast<std::uint32_t>(close) + 2;
    } else if (c == '#' && starts_line(i)) {
      has_directives_ = true;
      i = directive_end(i);
    } else if (c == 'R' && text_.substr(i, 2) == "R\"") {
      const std::size_t open = text_.find('(', i);
      const std::string close = open == std::string_view::npos || open - i > 18
                                    ? std::string()
                                    : fmt::format("){}\"", text_.substr(i + 2, open - i - 2));
      const std::size_t end = close.empty() ? std::string_view::npos : text_.find(close, open);
      const auto stop = end == std::string_view::npos ? size : static_cast<std::uint32_t>(end + close.size());
      add(Kind::kText, i, stop);
      i = stop;
    } else if (c == '"' || c == '\'') {
      const std::uint32_t end = skip_text(i);
      add(Kind::kText, i, end);
      i = end;
    } else if (is_cpp_digit(c) || (c == '.' && i + 1 < size && is_cpp_digit(text_[i + 1]))) {
      std::uint32_t end = i + 1;
      while (end < size && (is_word_part(text_[end]) || text_[end] == '.' ||
                            (text_[end] == '\'' && end + 1 < size && is_word_part(text_[end + 1])) ||
                            ((text_[end] == '+' || text_[end] == '-') &&
                             (text_[end - 1] == 'e' || text_[end - 1] == 'E')))) {
        ++end;
      }
      add(Kind::kNumber, i, end);
      i = end;
    } else if (is_cpp_word_start(c)) {
      std::uint32_t end = i + 1;
      while (end < size && is_word_part(text_[end])) ++end;
      add(Kind::kWord, i, end);
      i = end;
    } else {
      const std::string_view two = text_.substr(i, 2);
      const std::uint32_t length =
          two == "::" || two == "->" || two == "<<" || two == "&&" || two == "||" || two == "==" ? 2 : 1;
      add(Kind::kPunctuation, i, i + length);
      i += length;
    }
  }
}

bool UserCode::mentions(std::string_view word) const {
  for (std::size_t i = 0; i < tokens_.size(); ++i) {
    if (tokens_[i].kind != Kind::kWord || tokens_[i].text != word) continue;
    if (i == 0) return true;
    const std::string_view before = tokens_[i - 1].text;
    if (before != "." && before != "->" && before != "::") return true;
  }
  return false;
}

text::Place UserCode::place(const CppToken& token) const {
  return {code_.place.source, {token.offset, token.offset + static_cast<std::uint32_t>(token.text.size())}};
}

void UserCode::check(text::Diagnostics& diagnostics) const {
  check_balance(diagnostics);
  check_static(diagnostics);
}

// A bracket too many would close what the compiler of this language opened around the section.
void UserCode::check_balance(text::Diagnostics& diagnostics) const {
  if (has_directives_) return;  // both branches of an #if may open the same brace
  std::vector<const CppToken*> open;
  for (const CppToken& token : tokens_) {
    if (token.kind != Kind::kPunctuation) continue;
    const std::size_t closing = std::string_view(")]}").find(token.text[0]);
    if (token.text == "(" || token.text == "[" || token.text == "{") {
      open.push_back(&token);
    } else if (closing != std::string_view::npos) {
      const char wanted = "([{"[closing];
      if (open.empty()) {
        diagnostics.error("unbalanced-code", place(token),
                          fmt::format("`{}` closes nothing in this section", token.text));
        return;
      }
      if (open.back()->text[0] != wanted) {
        auto& diagnostic =
            diagnostics.error("unbalanced-code", place(token),
                              fmt::format("`{}` does not close `{}`", token.text, open.back()->text));
        diagnostic.notes.push_back({fmt::format("`{}` opened here", open.back()->text), place(*open.back())});
        return;
      }
      open.pop_back();
    }
  }
  if (!open.empty()) {
    diagnostics.error("unbalanced-code", place(*open.back()),
                      fmt::format("`{}` is not closed in this section", open.back()->text));
  }
}

void UserCode::check_static(text::Diagnostics& diagnostics) const {
  for (std::size_t i = 0; i < tokens_.size(); ++i) {
    const CppToken& token = tokens_[i];
    if (token.kind != Kind::kWord || (token.text != "static" && token.text != "thread_local")) continue;
    const bool constant = i + 1 < tokens_.size() && tokens_[i + 1].text == "constexpr";
    if (constant || (i > 0 && tokens_[i - 1].text == "constexpr")) continue;
    auto& diagnostic =
        diagnostics.error("static-variable", place(token),
                          fmt::format("a `{}` variable would be shared by all robots", token.text));
    diagnostic.hints.emplace_back(
        "declare it in `header` (starts anew when the node does) or in `once` (kept for the whole run)");
    if (token.text == "static")
      diagnostic.hints.emplace_back("a table that never changes may be `static constexpr`");
  }
}

std::size_t UserCode::close_of(std::size_t open) const {
  return closes_[open];
}

void UserCode::find_variables() {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < tokens_.size();) {
    const std::string_view text = tokens_[i].text;
    if (tokens_[i].kind == Kind::kPunctuation && text == ";") {
      read_statement(begin, i);
      begin = ++i;
    } else if (tokens_[i].kind == Kind::kPunctuation && (text == "{" || text == "(" || text == "[")) {
      i = close_of(i) + 1;
      // A block ends its statement; an initializer or the body of a type goes on to its `;`.
      if (text == "{" && is_one_of(tokens_[begin].text, kBlockWords)) begin = i;
    } else {
      ++i;
    }
  }
}

void UserCode::read_statement(std::size_t begin, std::size_t end) {
  Variable common;
  bool is_static = false;
  bool is_constexpr = false;
  std::size_t at = begin;
  while (at < end && tokens_[at].text == "[" && at + 1 < end && tokens_[at + 1].text == "[")
    at = close_of(at) + 1;
  while (at < end && is_one_of(tokens_[at].text, kSpecifiers)) {
    is_static = is_static || tokens_[at].text == "static";
    is_constexpr = is_constexpr || tokens_[at].text == "constexpr";
    ++at;
  }
  if (at >= end || (tokens_[at].kind != Kind::kWord && tokens_[at].text != "::") ||
      is_one_of(tokens_[at].text, kStatementWords))
    return;
  common.is_constant = is_static && is_constexpr;
  const std::string_view first = tokens_[at].text;
  if (is_one_of(first, kTypeWords)) {
    const bool is_name_for_other = first == "using" && at + 1 < end && tokens_[at + 1].text == "namespace";
    if (!is_name_for_other) local_types_.push_back({std::string(first), place(tokens_[at])});
    if (first == "using" || first == "typedef") return;
    // `struct P { ... } p;`: the names behind the braces.
    while (at < end && tokens_[at].text != "{" && tokens_[at].text != ";") ++at;
    if (at >= end) return;
    read_declarators(close_of(at) + 1, end, common);
    return;
  }
  bool is_pointer = false;
  const std::size_t behind = read_type(at, end, is_pointer);
  if (behind == at) return;
  common.is_pointer = is_pointer;
  read_declarators(behind, end, common);
}

// One past the type at `at`, or `at` where there is none that can be read.
std::size_t UserCode::read_type(std::size_t at, std::size_t end, bool& is_pointer) const {
  const std::size_t begin = at;
  if (is_one_of(tokens_[at].text, kBuiltinTypes)) {
    while (at < end && (is_one_of(tokens_[at].text, kBuiltinTypes) || tokens_[at].text == "const")) ++at;
    return at;
  }
  if (tokens_[at].text == "decltype" && at + 1 < end && tokens_[at + 1].text == "(")
    return close_of(at + 1) + 1;
  for (;;) {
    if (at < end && tokens_[at].text == "::") ++at;
    if (at >= end || tokens_[at].kind != Kind::kWord || is_cpp_keyword(tokens_[at].text)) return begin;
    is_pointer = is_pointer || is_one_of(tokens_[at].text, kHiddenPointers);
    ++at;
    if (at < end && tokens_[at].text == "<") {
      int depth = 0;
      for (; at < end; ++at) {
        const std::string_view text = tokens_[at].text;
        if (text == "<") ++depth;
        if (text == "<<") depth += 2;
        if (text == "*") is_pointer = true;
        if (text == ">" && --depth == 0) break;
        if (text == "(" || text == "{" || text == "[") at = close_of(at);
      }
      if (at >= end) return begin;
      ++at;
    }
    if (at >= end || tokens_[at].text != "::") break;
  }
  while (at < end && tokens_[at].text == "const") ++at;
  return at;
}

void UserCode::read_declarators(std::size_t at, std::size_t end, const Variable& common) {
  while (at < end) {
    Variable variable = common;
    while (at < end && (tokens_[at].text == "*" || tokens_[at].text == "&" || tokens_[at].text == "&&" ||
                        tokens_[at].text == "const")) {
      variable.is_pointer = variable.is_pointer || tokens_[at].text != "const";
      ++at;
    }
    if (at >= end) return;
    std::vector<std::size_t> names;
    if (tokens_[at].text == "[") {  // auto [a, b] = ...
      for (std::size_t i = at + 1; i < close_of(at); ++i) {
        if (tokens_[i].kind == Kind::kWord) names.push_back(i);
      }
      at = close_of(at) + 1;
    } else {
      if (tokens_[at].kind != Kind::kWord || is_cpp_keyword(tokens_[at].text)) return;
      names.push_back(at++);
      while (at < end && tokens_[at].text == "[") at = close_of(at) + 1;
    }
    const std::string_view next = at < end ? tokens_[at].text : std::string_view(";");
    if (next != ";" && next != "=" && next != "{" && next != "(" && next != ",") return;
    if (next == "=" && at + 1 < end && tokens_[at + 1].text == "&")
      variable.is_pointer = true;  // auto p = &x;
    while (at < end && tokens_[at].text != ",") {
      if (tokens_[at].text == "[" && at + 1 < end && tokens_[at + 1].text == "&")
        variable.holds_references = true;
      const bool opens = tokens_[at].text == "(" || tokens_[at].text == "[" || tokens_[at].text == "{";
      at = opens ? close_of(at) + 1 : at + 1;
    }
    ++at;
    for (const std::size_t name : names) {
      variable.name = std::string(tokens_[name].text);
      variable.place = place(tokens_[name]);
      variables_.push_back(variable);
    }
  }
}

}  // namespace mlab::cnl
