#include "mlab/lang/cdl/syntax/cursor.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/syntax/help.h"
#include "mlab/lang/cdl/types/units.h"
#include "mlab/text/shown.h"

namespace mlab::cdl {
namespace {

// Not a bracket or another mark.
bool is_word_of_language(std::string_view word) {
  return word[0] >= 'a' && word[0] <= 'z';
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

}  // namespace

Cursor::Cursor(text::SourcePtr source, text::Diagnostics& sink, PartialFile* written)
    : source_(std::move(source)), sink_(sink), written_(written) {
  Tokens lexed = lex(source_->text());
  comments_ = std::move(lexed.comments);
  for (const Token& token : lexed.tokens) {
    if (token.kind != Token::Kind::kUnknown) {
      tokens_.push_back(token);
      continue;
    }
    error("unknown-character", place(token.span),
          fmt::format("`{}` has no meaning here", text::shown(source_->text(token.span))));
  }
  for (const Comment& comment : comments_) {
    if (!comment.is_closed)
      error("unclosed-comment", place({comment.span.begin, comment.span.begin + 2}),
            "this comment is never closed by `*/`");
  }
}

bool Cursor::is(std::string_view word) const {
  return (is(Token::Kind::kName) || is(Token::Kind::kPunctuation)) && text() == word;
}

bool Cursor::is_any(std::initializer_list<std::string_view> words) const {
  return std::ranges::any_of(words, [&](std::string_view word) { return is(word); });
}

bool Cursor::could_be(std::initializer_list<std::string_view> words) {
  if (!at_end() || written_ == nullptr || needs_more_) return is_any(words);
  for (const std::string_view word : words) {
    if (is_word_of_language(word)) written_->next_words.emplace_back(word);
  }
  return false;
}

bool Cursor::is_before(std::string_view word) const {
  return !at_end() && source_->text(tokens_[at_ + 1].span) == word;
}

bool Cursor::is_before_name() const {
  if (at_end() || tokens_[at_ + 1].kind != Token::Kind::kName) return false;
  const std::string_view next = source_->text(tokens_[at_ + 1].span);
  constexpr std::string_view kWords[] = {"as", "active", "and", "or", "by"};
  if (std::ranges::find(kWords, next) != std::end(kWords)) return false;
  return source_->text({token().span.end, tokens_[at_ + 1].span.begin}).find('\n') == std::string_view::npos;
}

bool Cursor::is_before_path_and(std::string_view word) const {
  std::size_t at = at_ + 1;
  const auto is_name = [&] { return at < tokens_.size() && tokens_[at].kind == Token::Kind::kName; };
  const auto is_word = [&](std::string_view wanted) {
    return at < tokens_.size() && source_->text(tokens_[at].span) == wanted;
  };
  if (at_end() || !is_name()) return false;
  ++at;
  while (is_word(".")) {
    ++at;
    if (!is_name()) return false;
    ++at;
  }
  return is_word(word);
}

bool Cursor::starts_line() const {
  if (at_ == 0) return true;
  const std::uint32_t end = last_end();
  return source_->text({end, token().span.begin}).find('\n') != std::string_view::npos;
}

bool Cursor::at_declaration() const {
  if (!is(Token::Kind::kName) || !starts_line()) return false;
  if (std::ranges::find(kDeclarationWords, text()) == std::end(kDeclarationWords)) return false;
  const Token::Kind next = tokens_[at_ + 1].kind;
  // A robot has `use DEVICE for BINDING`.
  if (text() == "use" || text() == "test") return next == Token::Kind::kText;
  if (text() == "layout" && is_before("{")) return true;
  return next == Token::Kind::kName;
}

void Cursor::advance() {
  if (!at_end()) ++at_;
}

void Cursor::note_word(text::Span span) {
  if (written_ != nullptr) written_->words.push_back(span);
}

bool Cursor::take(std::string_view word) {
  if (!could_be({word})) return false;
  is_word_of_language(word) ? advance_word() : advance();
  return true;
}

bool Cursor::expect(std::string_view word, std::string_view why) {
  if (take(word)) return true;
  expected(fmt::format("`{}` {}", word, why));
  // A misspelt word before what it introduces.
  if (is_word_of_language(word) && is(Token::Kind::kName) && is_before_name()) advance();
  return !at_end() && !is(";") && !is(Token::Kind::kUnclosed);
}

bool Cursor::expect_semicolon(std::string_view why) {
  if (take(";")) return true;
  const bool is_next_line = starts_line() || is("}") || at_end();
  if (is_next_line) {
    const std::uint32_t end = last_end();
    if (text::Diagnostic* d =
            error("syntax", place({end == 0 ? 0 : end - 1, end}), fmt::format("expected `;` {}", why))) {
      d->label = "behind this";
    }
    return true;
  }
  expected(fmt::format("`;` {}", why));
  return false;
}

bool Cursor::read_name(Word& out, std::string_view what) {
  if (!is(Token::Kind::kName)) {
    out = {"", place({begin(), begin()})};
    expected(what);
    return false;
  }
  out = {std::string(text()), here()};
  advance();
  return true;
}

bool Cursor::divides_units(const Word& unit) const {
  if (at_end() || tokens_[at_ + 1].kind != Token::Kind::kName) return !at_end() && written_ != nullptr;
  const text::Span next = tokens_[at_ + 1].span;
  if (source_->text(tokens_[at_ + 2].span) == "(") return false;  // `2 m / min(a, b)`
  const bool is_glued = unit.place.span.end == token().span.begin && token().span.end == next.begin;
  return is_glued || unit_named(fmt::format("{}/{}", unit.text, source_->text(next))).has_value();
}

bool Cursor::at_unit() const {
  if (!is(Token::Kind::kName) || !is_before("/") || tokens_[at_ + 2].kind != Token::Kind::kName) return false;
  const text::Span whole{token().span.begin, tokens_[at_ + 2].span.end};
  const bool is_glued = token().span.end == tokens_[at_ + 1].span.begin &&
                        tokens_[at_ + 1].span.end == tokens_[at_ + 2].span.begin;
  return is_glued && unit_named(source_->text(whole)).has_value();
}

std::optional<double> Cursor::read_number() {
  if (!is(Token::Kind::kNumber)) {
    expected("a number");
    return std::nullopt;
  }
  std::string_view digits = text();
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double value = 0.0;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (failure != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) {
    error("number-out-of-range", here(),
          fmt::format("`{}` is not a number that a double can hold", text::shown(text())));
    value = 0.0;
  }
  advance();
  return value;
}

std::optional<std::string> Cursor::read_text(std::string_view what) {
  if (is(Token::Kind::kUnclosed)) {
    error("unclosed-text", here(), "this text has no closing `\"` on its line");
    advance();
    return std::nullopt;
  }
  if (!is(Token::Kind::kText)) {
    expected(what);
    return std::nullopt;
  }
  std::string value(text().substr(1, text().size() - 2));
  if (value.find('\\') != std::string::npos) {
    error("syntax", here(), "a text has no `\\` in it, since nothing is escaped");
  }
  advance();
  return value;
}

Word Cursor::take_unit() {
  if (!is("[")) return {};
  const std::uint32_t from = token().span.end;
  advance();
  while (!at_end() && !is_any({"]", ";", "{", "}", "=", ",", ")"}) && !starts_line()) advance();
  const std::uint32_t to = token().span.begin;
  const bool is_closed = take("]");
  if (!is_closed) expected("`]` behind the unit");
  if (!keeps(is_closed)) return {};
  const std::string_view unit = trimmed(source_->text({from, to}));
  const auto at = static_cast<std::uint32_t>(unit.empty() ? to : unit.data() - source_->text().data());
  return {std::string(unit), place({at, at + static_cast<std::uint32_t>(unit.size())})};
}

// With its line end. Looked for once a line: a line may be the whole file.
text::Span Cursor::line_around(std::uint32_t at) const {
  if (at >= line_.begin && at < line_.end) return line_;
  const std::string_view all = source_->text();
  const std::size_t before = at == 0 ? std::string_view::npos : all.rfind('\n', at - 1);
  const std::size_t behind = all.find('\n', at);
  line_ = {static_cast<std::uint32_t>(before == std::string_view::npos ? 0 : before + 1),
           static_cast<std::uint32_t>(behind == std::string_view::npos ? all.size() + 1 : behind + 1)};
  return line_;
}

std::uint32_t Cursor::indent_of(std::uint32_t offset) const {
  const std::string_view all = source_->text();
  const std::size_t start = line_around(offset).begin;
  const std::size_t first = all.find_first_not_of(" \t", start);
  return static_cast<std::uint32_t>(first == std::string_view::npos ? 0 : first - start);
}

bool Cursor::at_statement() const {
  if (at_ == 0) return true;
  const std::string_view last = source_->text(last_span());
  return last == ";" || last == "{" || last == "}" || starts_line();
}

// Where the text ends it is asked once what statement could begin there.
bool Cursor::at_close() {
  statement_ = at_;
  if (!at_end()) return is("}") || at_declaration();
  if (written_ == nullptr || needs_more_ || has_read_end_ || !at_statement()) return true;
  has_read_end_ = true;
  return false;
}

bool Cursor::at_next_statement() const {
  if (!keeps_parts() || !is(Token::Kind::kName) || !starts_line() || at_ == statement_) return false;
  constexpr std::string_view kGoOn[] = {";", "{", "}", "(", ",", "["};
  if (std::ranges::find(kGoOn, source_->text(last_span())) != std::end(kGoOn)) return false;
  if (is_before(":")) return true;
  return tokens_[at_ + 1].kind == Token::Kind::kName &&
         is_any({"let", "when", "start", "final", "case", "sensor", "actuator", "given", "expect"});
}

ExpressionPtr Cursor::hole() const {
  auto out = std::make_shared<Expression>();
  out->place = place({begin(), begin()});
  return out;
}

bool Cursor::skip_to(std::initializer_list<std::string_view> words) {
  if (!keeps_parts()) return false;
  while (!at_end() && !is_any(words) && !is_any({";", "{", "}"}) && !at_declaration()) advance();
  return is_any(words);
}

void Cursor::finish() {
  if (written_ == nullptr) return;
  std::ranges::sort(written_->words, {}, &text::Span::begin);
  written_->ends_inside = needs_more_ || !written_->next_words.empty();
  if (!written_->ends_inside)
    written_->next_words.assign(std::begin(kDeclarationWords), std::end(kDeclarationWords));
  written_->tokens = {std::move(tokens_), std::move(comments_)};
}

bool Cursor::open(const char* what) {
  const text::Span opener = token().span;
  const bool is_there = expect("{", fmt::format("before what belongs to {}", what));
  // What goes on in the same line with anything but a name belongs to something else that is missing.
  if (!is_there || (tokens_[at_].span.begin == opener.begin && !starts_line() && !is(Token::Kind::kName)))
    return false;
  blocks_.push_back({what, opener, indent_of(opener.begin), std::exchange(stops_at_brace, false)});
  return true;
}

void Cursor::report_unclosed(const Block& block) {
  need_here();
  // Indents tell which one was forgotten.
  const char* what = mismatch_ ? mismatch_->what : block.what;
  const text::Span opener = mismatch_ ? mismatch_->opener : block.opener;
  const text::Span where = mismatch_ ? mismatch_->before : last_span();
  if (text::Diagnostic* d =
          error("unclosed-block", place(where), fmt::format("expected `}}` behind this, to close {}", what)))
    d->notes.push_back({"it opens here", place(opener)});
  mismatch_.reset();
}

void Cursor::close() {
  const Block block = blocks_.back();
  blocks_.pop_back();
  stops_at_brace = block.stops_at_brace;
  if (!is("}")) {
    report_unclosed(block);
  } else {
    if (starts_line() && indent_of(begin()) < block.indent && !mismatch_)
      mismatch_ = Mismatch{block.what, block.opener, last_span()};
    advance();
  }
  if (blocks_.empty()) mismatch_.reset();
}

bool Cursor::enter() {
  if (++depth_ <= kMaxNesting) return true;
  if (depth_ == kMaxNesting + 1) {
    error_line_ = {};
    error("nested-too-deep", here(), fmt::format("this stands more than {} levels deep", kMaxNesting));
  }
  at_ = tokens_.size() - 1;
  gave_up_ = true;
  needs_more_ = true;
  return false;
}

text::Place Cursor::since(std::uint32_t begin) const {
  return place({begin, std::max(begin, last_end())});
}

text::Diagnostic* Cursor::error(std::string kind, const text::Place& where, std::string message) {
  const std::uint32_t at = where.span.begin;
  if (gave_up_ || (at >= error_line_.begin && at < error_line_.end)) return nullptr;
  error_line_ = line_around(at);
  return &sink_.error(std::move(kind), where, std::move(message));
}

std::string Cursor::found() const {
  if (at_end()) return "the end of the file";
  if (is(Token::Kind::kUnclosed)) return "a text without its closing `\"`";
  return fmt::format("`{}`", text::shown(text()));
}

text::Diagnostic* Cursor::expected(std::string_view what) {
  need_here();
  return error("syntax", here(), fmt::format("expected {}, found {}", what, found()));
}

void Cursor::skip_statement() {
  int depth = 0;
  while (!at_end() && !(at_declaration() && !blocks_.empty())) {
    if (depth == 0 && (is("}") || at_next_statement())) return;
    if (depth == 0 && take(";")) return;
    if (is_any({"{", "(", "["})) ++depth;
    if (is_any({"}", ")", "]"})) depth = std::max(0, depth - 1);
    advance();
  }
}

void Cursor::skip_declaration() {
  int depth = 0;
  bool is_first = true;
  while (!at_end()) {
    if (!is_first && at_declaration()) return;
    is_first = false;
    if (depth == 0 && take(";")) return;
    if (is("{")) ++depth;
    const bool closes = is("}");
    advance();
    if (closes && --depth <= 0) return;
  }
}

std::string Cursor::help_above() const {
  std::vector<std::string_view> lines;
  std::uint32_t below = begin();
  for (std::size_t i = token().comments; i-- > 0;) {
    const text::Span span = comments_[i].span;
    const std::string_view comment = source_->text(span);
    const std::string_view between = source_->text({span.end, below});
    const bool touches = trimmed(between).empty() && std::ranges::count(between, '\n') == 1;
    const std::string_view before = source_->text().substr(0, span.begin);
    const std::size_t last = before.find_last_not_of(" \t");
    const bool own_line = last == std::string_view::npos || before[last] == '\n';
    if (!comment.starts_with("///") || comment.starts_with("///<") || !touches || !own_line) break;
    lines.push_back(comment);
    below = span.begin;
  }
  std::ranges::reverse(lines);
  return help_of(lines);
}

std::string Cursor::help_behind() const {
  // Behind the comma where one follows.
  const Token& next = is(",") ? tokens_[at_ + 1] : token();
  std::uint32_t end = is(",") ? token().span.end : last_end();
  std::vector<std::string_view> lines;
  const std::uint32_t first = is(",") ? token().comments : (at_ == 0 ? 0 : tokens_[at_ - 1].comments);
  for (std::uint32_t i = first; i < next.comments; ++i) {
    const text::Span span = comments_[i].span;
    const std::string_view between = source_->text({end, span.begin});
    const std::string_view comment = source_->text(span);
    if (!comment.starts_with("///<") || std::ranges::count(between, '\n') > (i == first ? 0 : 1)) break;
    lines.push_back(comment);
    end = span.end;
  }
  return help_of(lines);
}

}  // namespace mlab::cdl
