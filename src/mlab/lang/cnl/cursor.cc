#include "mlab/lang/cnl/cursor.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <ranges>
#include <utility>

#include <fmt/core.h>

#include "mlab/text/shown.h"

namespace mlab::cnl {
namespace {

constexpr std::size_t kShownText = 40;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

void append_words(std::string& out, std::string_view line) {
  if (line.empty()) return;
  if (!out.empty()) out += ' ';
  out += line;
}

// What a constant means: no quotes, no parentheses; `{"text"}`, as historic networks write texts, is the
// text.
std::string constant_text(Token::Kind kind, std::string_view text) {
  if (kind == Token::Kind::kNumber) return canonical_number(text);
  if (kind == Token::Kind::kString) return std::string(text.substr(1, text.size() - 2));
  if (kind == Token::Kind::kCharacter) {
    return text.size() == 3 ? fmt::format("{}", static_cast<int>(static_cast<unsigned char>(text[1])))
                            : std::string(text);
  }
  if (kind == Token::Kind::kInitializer) {
    const std::string_view inner = trimmed(text.substr(1, text.size() - 2));
    const bool is_text = inner.size() >= 2 && inner.front() == '"' && inner.find('"', 1) == inner.size() - 1;
    if (is_text) return std::string(inner.substr(1, inner.size() - 2));
  }
  return std::string(text);
}

}  // namespace

std::string canonical_number(std::string_view text) {
  if (text.starts_with('(')) text = trimmed(text.substr(1, text.size() - 2));
  std::string sign;
  if (text.starts_with('-') || text.starts_with('+')) {
    if (text[0] == '-') sign = "-";
    text.remove_prefix(1);
  }
  while (text.size() > 1 && text[0] == '0' && text[1] >= '0' && text[1] <= '9') text.remove_prefix(1);
  if (text.starts_with('.')) sign += '0';
  std::string out = sign + std::string(text);
  if (out.ends_with('.')) out.pop_back();
  return out;
}

Cursor::Cursor(text::SourcePtr source, text::Diagnostics& diagnostics, Layout& layout)
    : source_(std::move(source)), diagnostics_(diagnostics), layout_(layout), lexer_(source_->text()) {
  lex(0);
}

bool Cursor::is(std::string_view word) const {
  return (token_.kind == Token::Kind::kName || token_.kind == Token::Kind::kPunctuation) && text() == word;
}

bool Cursor::is_any(std::initializer_list<std::string_view> words) const {
  return std::ranges::any_of(words, [&](std::string_view word) { return is(word); });
}

bool Cursor::is_before(std::string_view word) const {
  return source_->text(lexer_.next(token_.span.end).span) == word;
}

void Cursor::lex(std::uint32_t offset) {
  token_ = lexer_.next(offset, &layout_.comments);
  while (handle_odd_token()) token_ = lexer_.next(token_.span.end, &layout_.comments);
}

// Tokens that no construct wants are spoken of once, here. True: read on behind it.
bool Cursor::handle_odd_token() {
  if (token_.kind == Token::Kind::kUnknown) {
    error("unknown-character", here(),
          fmt::format("`{}` starts nothing in CNL", text::shown(text(), kShownText)));
    return true;
  }
  if (token_.kind != Token::Kind::kDirective) return false;
  const std::string_view word = trimmed(text().substr(1));
  if (word.starts_with("include")) return false;
  layout_.lines.push_back({token_.span.begin, 0, false});
  if (!word.empty() && !(word[0] >= '0' && word[0] <= '9') && !word.starts_with("line")) {
    warning("ignored-directive", here(), "a `#` line outside of user code means nothing here")
        .hints.emplace_back("what it guards is read all the same; C++ that needs it belongs into `init`");
  }
  return true;
}

void Cursor::advance() {
  last_end_ = token_.span.end;
  lex(last_end_);
}

bool Cursor::take(std::string_view word) {
  if (!is(word)) return false;
  advance();
  return true;
}

bool Cursor::expect(std::string_view word, std::string_view why) {
  if (take(word)) return true;
  if (is(Token::Kind::kUnclosed)) {
    expected(fmt::format("`{}` {}", word, why));
    advance();
    return false;
  }
  // A missing `;` belongs behind what should have had it, not at the next line.
  const bool behind = word == ";" && last_end_ > 0;
  const text::Place at = behind ? place({last_end_ - 1, last_end_}) : here();
  const std::string found =
      at_end() ? "the end of the file" : fmt::format("`{}`", text::shown(text(), kShownText));
  error("syntax", at,
        behind ? fmt::format("expected `{}` {}", word, why)
               : fmt::format("expected `{}` {}, found {}", word, why, found))
      .label = behind ? "behind this" : "";
  return false;
}

text::Diagnostic& Cursor::expected(std::string_view what) {
  if (is(Token::Kind::kUnclosed)) {
    return error("unclosed-text", here(),
                 fmt::format("expected {}, and `{}` is not closed on its line", what, text()[0]));
  }
  if (is(Token::Kind::kDirective)) {
    return error("misplaced-include", here(), "`#include` stands between declarations, not within one");
  }
  if (at_end()) return error("syntax", here(), fmt::format("expected {}, found the end of the file", what));
  return error("syntax", here(),
               fmt::format("expected {}, found `{}`", what, text::shown(text(), kShownText)));
}

std::optional<Word> Cursor::expect_name(std::string_view what) {
  const std::optional<Word> word = expect_node_name(what);
  if (word && word->text.find('.') != std::string::npos) {
    error("dotted-name", word->place,
          fmt::format("only nodes have dots in their names, and this is {}", what));
  }
  return word;
}

std::optional<Word> Cursor::expect_node_name(std::string_view what) {
  if (!is(Token::Kind::kName)) {
    expected(what);
    return std::nullopt;
  }
  Word word{std::string(text()), here()};
  advance();
  return word;
}

bool Cursor::read_name(Word& out, std::string_view what) {
  const std::optional<Word> name = expect_name(what);
  if (name) out = *name;
  return name.has_value();
}

Word Cursor::take_unit() {
  if (!is("[")) return {};
  const std::uint32_t begin = token_.span.end;
  const std::uint32_t end = lexer_.line_end(begin);
  const std::size_t close = source_text().substr(0, end).find(']', begin);
  if (close == std::string_view::npos) {
    error("unclosed-text", here(), "the unit is not closed with `]` on its line");
    // The word behind the bracket was meant to be the unit.
    const std::size_t first = source_text().find_first_not_of(" \t", begin);
    resume(
        static_cast<std::uint32_t>(std::min<std::size_t>(source_text().find_first_of(" \t\n", first), end)));
    return {};
  }
  const auto stop = static_cast<std::uint32_t>(close);
  Word unit{std::string(trimmed(source_text().substr(begin, stop - begin))), place({begin, stop})};
  resume(stop);
  advance();
  return unit;
}

std::optional<flow::Source> Cursor::expect_source(std::string_view what) {
  flow::Source source;
  source.place = here();
  switch (token_.kind) {
    case Token::Kind::kName:
      source.kind = flow::Source::Kind::kName;
      break;
    case Token::Kind::kNumber:
    case Token::Kind::kCharacter:
    case Token::Kind::kString:
    case Token::Kind::kInitializer:
      source.kind = flow::Source::Kind::kConstant;
      break;
    default:
      expected(what);
      return std::nullopt;
  }
  source.text = constant_text(token_.kind, text());
  advance();
  return source;
}

std::optional<double> Cursor::expect_number(std::string_view what) {
  if (!is(Token::Kind::kNumber)) {
    expected(what);
    return std::nullopt;
  }
  const std::string number = canonical_number(text());
  double value = 0.0;
  const auto [end, failure] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (failure != std::errc() || !std::isfinite(value)) {
    error("number-out-of-range", here(),
          fmt::format("`{}` is not a number that a double can hold", text::shown(number, kShownText)));
    value = 0.0;
  }
  advance();
  return value;
}

text::Diagnostic& Cursor::error(std::string kind, text::Place place, std::string message) {
  return diagnostics_.error(std::move(kind), std::move(place), std::move(message));
}

text::Diagnostic& Cursor::warning(std::string kind, text::Place place, std::string message) {
  return diagnostics_.warning(std::move(kind), std::move(place), std::move(message));
}

bool Cursor::skip_past_semicolon_or_to(std::initializer_list<std::string_view> words) {
  while (!at_end() && !is_any(words) && !is(";")) advance();
  if (is(";")) advance();
  return !at_end();
}

void Cursor::skip_to(std::initializer_list<std::string_view> words) {
  while (!at_end() && !is_any(words)) advance();
}

Cursor::Doc Cursor::doc_above() const {
  std::vector<std::string_view> lines;
  std::uint32_t below = token_.span.begin;
  for (const Comment& above : std::views::reverse(layout_.comments)) {
    if (above.span.begin >= below) continue;
    const std::string_view comment = source_->text(above.span);
    const std::string_view between = source_text().substr(above.span.end, below - above.span.end);
    const bool touches = std::count(between.begin(), between.end(), '\n') == 1 && trimmed(between).empty();
    if (!comment.starts_with("///") || comment.starts_with("///<") || !touches ||
        !lexer_.starts_line(above.span.begin)) {
      break;
    }
    lines.push_back(trimmed(comment.substr(3)));
    below = above.span.begin;
  }
  Doc doc;
  std::string* into = &doc.help;
  for (const std::string_view line : std::views::reverse(lines)) {
    if (line.starts_with("@source")) {
      into = &doc.source;
      append_words(*into, trimmed(line.substr(7)));
    } else {
      if (line.empty()) into = &doc.help;
      append_words(*into, line);
    }
  }
  return doc;
}

std::string Cursor::doc_behind() const {
  std::string help;
  std::uint32_t end = last_end_;
  const auto first = std::ranges::partition_point(layout_.comments,
                                                  [&](const Comment& c) { return c.span.begin < last_end_; });
  for (auto it = first; it != layout_.comments.end(); ++it) {
    const std::string_view between = source_text().substr(end, it->span.begin - end);
    const auto newlines = std::count(between.begin(), between.end(), '\n');
    const std::string_view comment = source_->text(it->span);
    if (!comment.starts_with("///<") || newlines > (it == first ? 0 : 1) || !trimmed(between).empty()) break;
    append_words(help, trimmed(comment.substr(4)));
    end = it->span.end;
  }
  return help;
}

void Cursor::line(int indent, bool is_optional) {
  if (!at_end()) layout_.lines.push_back({token_.span.begin, indent, is_optional});
}

std::uint32_t Cursor::code_start() const {
  const std::uint32_t end = lexer_.line_end(token_.span.end);
  const std::string_view rest = source_text().substr(token_.span.end, end - token_.span.end);
  return trimmed(rest).empty() ? lexer_.next_line(token_.span.end) : token_.span.end;
}

Cursor::RawLines Cursor::raw_lines(std::uint32_t begin,
                                   std::initializer_list<std::string_view> end_words) const {
  const std::string_view all = source_text();
  std::uint32_t at = begin;
  while (at < all.size()) {
    const std::uint32_t end = lexer_.line_end(at);
    const std::string_view word = trimmed(all.substr(at, end - at));
    if (std::ranges::find(end_words, word) != end_words.end()) {
      const auto from = static_cast<std::uint32_t>(word.data() - all.data());
      return {
          {place({begin, at})}, std::string(word), {from, from + static_cast<std::uint32_t>(word.size())}};
    }
    at = lexer_.next_line(at);
  }
  return {{place({begin, at})}, "", {at, at}};
}

void Cursor::resume(std::uint32_t offset) {
  last_end_ = offset;
  lex(offset);
}

}  // namespace mlab::cnl
