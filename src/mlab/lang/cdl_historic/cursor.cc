#include "mlab/lang/cdl_historic/cursor.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <utility>

#include <fmt/core.h>

#include "mlab/text/shown.h"

namespace mlab::cdl_historic {
namespace {

using Kind = Token::Kind;

double parsed_number(std::string_view text) {
  double value = 0.0;
  if (text.ends_with('.')) text.remove_suffix(1);
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

bool starts_statement(std::string_view word) {
  static constexpr std::string_view kWords[] = {
      "defIBP",       "defibp",       "defOBP",     "defobp",      "defRBP",      "defrbp",    "defSensor",
      "defsensor",    "defRobot",     "defrobot",   "defActuator", "defactuator", "defArch",   "defarch",
      "bindArch",     "bindarch",     "defType",    "deftype",     "defOp",       "defop",     "defAgent",
      "defagent",     "instAgent",    "instagent",  "instGroup",   "instgroup",   "instRobot", "instrobot",
      "instBP",       "instbp",       "instSensor", "instsensor",  "instOp",      "instop",    "instActuator",
      "instactuator", "defNamedValue"};
  return std::ranges::find(kWords, word) != std::end(kWords);
}

const Token& Cursor::token(std::size_t ahead) const {
  return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
}

bool Cursor::is(std::string_view word, std::size_t ahead) const {
  const Kind kind = token(ahead).kind;
  return (kind == Kind::kPunctuation || kind == Kind::kName) && text(ahead) == word;
}

void Cursor::advance() {
  last_end_ = token().span.end;
  if (at_ + 1 < tokens_.size()) ++at_;
}

bool Cursor::take(std::string_view word) {
  if (!is(word)) return false;
  advance();
  return true;
}

bool Cursor::expect(std::string_view word, std::string_view why) {
  if (take(word)) return true;
  expected(fmt::format("`{}` {}", word, why));
  return false;
}

Word Cursor::take_word() {
  Word word{std::string(source_->text(token().inner)), {source_, token().inner}};
  advance();
  return word;
}

Word Cursor::expect_name(std::string_view what) {
  if (is(Kind::kName)) return take_word();
  expected(what);
  return {};
}

Word Cursor::expect_pushed_name() {
  if (is(Kind::kPushed)) return take_word();
  expected("the `%name` of a pushed-up parameter");
  return {};
}

Spot Cursor::take_spot() {
  Spot spot;
  if (take("<")) {
    if (!is(Kind::kNumber)) return expected("the x of a position"), spot;
    spot.x = parsed_number(text());
    advance();
    expect(",", "between x and y");
    if (!is(Kind::kNumber)) return expected("the y of a position"), spot;
    spot.y = parsed_number(text());
    advance();
    expect(">", "at the end of a position");
    spot.has_position = true;
  }
  if (is(Kind::kDescription)) spot.label = take_word();
  return spot;
}

void Cursor::expected(std::string_view what) {
  if (failed_) return;
  failed_ = true;
  const std::string found = at_end() ? "the end of the file" : fmt::format("`{}`", text::shown(text()));
  std::string kind = "expected-";
  kind += is(Kind::kEnd) ? "more" : "other";
  sink_.error(std::move(kind), here(), fmt::format("expected {}, found {}", what, found));
}

void Cursor::skip_statement() {
  while (!at_end()) {
    if (is(Kind::kName) && starts_statement(text())) return;
    const bool ends = is(";");
    advance();
    if (ends) return;
  }
}

bool Cursor::enter() {
  if (depth_ < kMaxNesting) {
    ++depth_;
    return true;
  }
  if (!failed_) {
    sink_.error("nested-too-deeply", here(),
                fmt::format("this is nested more than {} instances deep", kMaxNesting));
  }
  failed_ = true;
  return false;
}

}  // namespace mlab::cdl_historic
