// What a configuration consists of: uses, assemblages, robots, societies. Layouts are in cdl_layout.cc.

#include "mlab/language/cdl_scan.h"

#include <algorithm>
#include <iterator>
#include <ranges>

#include "mlab/lang/cdl/cursor.h"
#include "mlab/language/cdl_reader.h"

namespace mlab::language {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

}  // namespace

CdlReader::CdlReader(const text::SourcePtr& source) {
  out_.source = source;
  out_.lexed = cdl::lex(source->text());
  for (const cdl::Token& token : out_.lexed.tokens) {
    if (token.kind != TokenKind::kUnknown) tokens_.push_back(token);
  }
}

bool CdlReader::is(std::string_view word) const {
  return (is_name() || token().kind == TokenKind::kPunctuation) && text() == word;
}

bool CdlReader::is_any(std::initializer_list<std::string_view> words) const {
  return std::ranges::any_of(words, [&](std::string_view word) { return is(word); });
}

bool CdlReader::starts_line(std::size_t ahead) const {
  if (at_ + ahead == 0) return true;
  const std::uint32_t end = tokens_[std::min(at_ + ahead, tokens_.size() - 1) - 1].span.end;
  return out_.source->text({end, token(ahead).span.begin}).find('\n') != std::string_view::npos;
}

bool CdlReader::at_declaration() const {
  if (!is_name() || !starts_line()) return false;
  if (std::ranges::find(cdl::kDeclarationWords, text()) == std::end(cdl::kDeclarationWords)) return false;
  return token(1).kind == (text() == "use" ? TokenKind::kText : TokenKind::kName);
}

void CdlReader::advance() {
  if (!at_end()) ++at_;
}

bool CdlReader::take(std::string_view punctuation) {
  if (!is(punctuation)) return false;
  advance();
  return true;
}

bool CdlReader::take_word(std::string_view word) {
  if (!is(word)) return false;
  note_word();
  advance();
  return true;
}

void CdlReader::skip_statement() {
  int depth = 0;
  while (!at_end() && !at_declaration()) {
    if (depth == 0 && is("}")) return;
    if (depth == 0 && take(";")) return;
    if (is_any({"{", "(", "["})) ++depth;
    if (is_any({"}", ")", "]"})) depth = std::max(0, depth - 1);
    advance();
  }
}

void CdlReader::want(CdlWant one) {
  if (!is_done_) out_.wants.push_back(std::move(one));
}

void CdlReader::want_words(std::initializer_list<std::string_view> words) {
  CdlWant one;
  for (const std::string_view word : words) one.words.emplace_back(word);
  want(std::move(one));
}

void CdlReader::need(CdlWant one) {
  want(std::move(one));
  is_done_ = true;
}

void CdlReader::need_words(std::initializer_list<std::string_view> words) {
  want_words(words);
  is_done_ = true;
}

bool CdlReader::at_statement() const {
  if (at_ == 0) return true;
  const std::string_view last = out_.source->text(tokens_[at_ - 1].span);
  return last == ";" || last == "{" || last == "}" || starts_line();
}

void CdlReader::close(std::string_view bracket) {
  if (!take(bracket) && at_end()) is_done_ = true;
}

int CdlReader::add_name(NameKind kind, bool is_declaration) {
  CdlName name;
  name.span = token().span;
  name.kind = kind;
  name.is_declaration = is_declaration;
  name.text = text();
  name.declaration = static_cast<int>(out_.declarations.size()) - 1;
  out_.names.push_back(std::move(name));
  advance();
  return static_cast<int>(out_.names.size()) - 1;
}

std::pair<std::string, text::Span> CdlReader::declared(NameKind kind) {
  if (!is_name()) return {};
  const CdlName& name = out_.names[static_cast<std::size_t>(add_name(kind, true))];
  return {name.text, name.span};
}

bool CdlReader::use(NameKind kind, Kind wanted) {
  if (at_end()) need_kind(wanted);
  if (!is_name()) return false;
  add_name(kind);
  return true;
}

// The `///` lines right above the token.
std::string CdlReader::help_above() const {
  std::vector<std::string_view> lines;
  std::uint32_t below = token().span.begin;
  for (std::size_t i = token().comments; i-- > 0;) {
    const text::Span span = out_.lexed.comments[i].span;
    const std::string_view comment = out_.source->text(span);
    const std::string_view between = out_.source->text({span.end, below});
    const bool touches = trimmed(between).empty() && std::ranges::count(between, '\n') == 1;
    if (!comment.starts_with("///") || comment.starts_with("///<") || !touches) break;
    lines.push_back(trimmed(comment.substr(3)));
    below = span.begin;
  }
  std::string help;
  for (const std::string_view line : std::views::reverse(lines)) {
    if (!help.empty()) help += line.empty() ? "\n\n" : help.ends_with('\n') ? "" : " ";
    help += line;
  }
  return help;
}

// The `///<` help behind what was taken last, or behind the `,` that is next.
std::string CdlReader::help_behind() const {
  const std::size_t comma = is(",") ? 1 : 0;
  const std::uint32_t first = token().comments;
  std::string help;
  for (std::size_t i = comma == 0 ? (at_ == 0 ? 0 : tokens_[at_ - 1].comments) : first;
       i < token(comma).comments; ++i) {
    const std::string_view comment = out_.source->text(out_.lexed.comments[i].span);
    if (!comment.starts_with("///<")) break;
    help += (help.empty() ? "" : " ") + std::string(trimmed(comment.substr(4)));
  }
  return help;
}

CdlScan CdlReader::run() {
  while (!at_end()) {
    const std::size_t before = at_;
    if (at_declaration() || is_any({"assemblage", "robot", "class", "society", "operator", "binding", "use",
                                    "architecture", "layout"})) {
      item();
    }
    if (at_ == before) advance();
  }
  const bool is_inside = is_done_ || !out_.wants.empty();
  if (!is_inside) {
    for (const std::string_view word : cdl::kDeclarationWords) want_words({word});
    out_.open_declaration = -1;
  }
  return std::move(out_);
}

void CdlReader::item() {
  struct Declared {
    const char* word;
    NameKind kind;
    void (CdlReader::*body)();
  };
  static constexpr Declared kDeclared[] = {
      {"assemblage", NameKind::kAssemblage, &CdlReader::assemblage},
      {"binding", NameKind::kBinding, &CdlReader::binding},
      {"class", NameKind::kClass, &CdlReader::robot_class},
      {"robot", NameKind::kRobot, &CdlReader::robot},
      {"operator", NameKind::kOperator, &CdlReader::society_operator},
      {"society", NameKind::kSociety, &CdlReader::society},
  };
  const auto* one = std::ranges::find_if(kDeclared, [this](const Declared& other) { return is(other.word); });
  if (one != std::end(kDeclared)) {
    declaration(one->kind, one->body);
  } else if (is("use")) {
    use_file();
  } else if (is("architecture")) {
    architecture();
  } else {
    layout();
  }
}

void CdlReader::declaration(NameKind kind, void (CdlReader::*body)()) {
  CdlDeclaration& one = out_.declarations.emplace_back();
  one.kind = kind;
  one.help = help_above();
  one.whole.begin = token().span.begin;
  note_word();
  advance();
  if (at_end()) need({});  // a new name
  std::tie(current().name, current().span) = declared(kind);
  (this->*body)();
  current().whole.end = last_end();
  const bool is_closed = at_ > 0 && (out_.source->text(tokens_[at_ - 1].span) == "}" ||
                                     out_.source->text(tokens_[at_ - 1].span) == ";");
  if (at_end() && (is_done_ || !out_.wants.empty() || !is_closed))
    out_.open_declaration = static_cast<int>(out_.declarations.size()) - 1;
}

void CdlReader::use_file() {
  note_word();
  advance();
  if (at_end()) need_kind(Kind::kFile);
  if (token().kind == TokenKind::kText) {
    const text::Span span{token().span.begin + 1, token().span.end - 1};
    out_.uses.push_back(
        {.span = span, .kind = NameKind::kFile, .text = std::string(out_.source->text(span))});
    advance();
  }
  if (is(";")) advance();
}

void CdlReader::architecture() {
  note_word();
  advance();
  if (at_end()) need_words({"AuRA", "UGV"});
  if (is_name()) add_name(NameKind::kArchitecture);
  take(";");
}

void CdlReader::assemblage() {
  parameters();
  if (take("->")) {
    if (at_end()) need_kind(Kind::kType);
    if (is_name()) {
      current().result_type = text();
      add_name(NameKind::kType);
    }
  }
  if (take(";")) return;
  if (take("{")) assemblage_body();
}

void CdlReader::binding() {
  parameters();
  if (take("->")) {
    if (at_end()) need_kind(Kind::kType);
    if (is_name()) {
      current().result_type = text();
      add_name(NameKind::kType);
    }
  }
  if (at_end()) need({});
  take(";");
}

void CdlReader::parameters() {
  if (!take("(")) {
    if (at_end()) need({});
    return;
  }
  while (!at_end() && !is(")") && !at_declaration()) {
    const std::size_t before = at_;
    parameter();
    if (!take(",") && (is_any({"{", ";", "->"}) || at_ == before)) break;
  }
  if (at_end() && std::string_view("(,").contains(out_.source->text()[last_end() - 1])) need({});
  close(")");
}

void CdlReader::parameter() {
  CdlParameter one;
  one.whole.begin = token().span.begin;
  one.input.help = help_above();
  std::tie(one.input.name, one.span) = declared(NameKind::kParameter);
  if (one.input.name.empty()) return;
  if (take(":")) {
    if (at_end()) need_kind(Kind::kType);
    if (is_name()) {
      one.input.type = text();
      add_name(NameKind::kType);
      one.input.unit = bracketed_unit();
    }
  }
  one.input.value = value_type(one.input.type, one.input.unit);
  const CdlWanted wanted{.type = one.input.value};
  if (take("=")) {
    const std::uint32_t begin = token().span.begin;
    expression(wanted);
    one.input.initial = value_text(begin);
  }
  if (at_end()) want_words({"in"});
  if (take_word("in")) {
    std::uint32_t begin = token().span.begin;
    if (token().kind == TokenKind::kNumber) number(wanted);
    one.input.low = value_text(begin);
    if (take("..")) {
      begin = token().span.begin;
      if (token().kind == TokenKind::kNumber) number(wanted);
      one.input.high = value_text(begin);
    }
  }
  if (const std::string behind = help_behind(); !behind.empty()) one.input.help = behind;
  one.whole.end = last_end();
  current().parameters.push_back(std::move(one));
}

std::string CdlReader::value_text(std::uint32_t begin) const {
  return begin < last_end() ? std::string(out_.source->text({begin, last_end()})) : std::string();
}

std::string CdlReader::bracketed_unit() {
  if (!take("[")) return "";
  if (at_end()) need_kind(Kind::kUnitName);
  const std::uint32_t begin = token().span.begin;
  while (!at_end() && !is_any({"]", ";", "{", "}", "=", ",", ")"}) && !starts_line()) advance();
  const std::string unit = value_text(begin);
  if (!unit.empty())
    out_.names.push_back({.span = {begin, last_end()},
                          .kind = NameKind::kUnit,
                          .text = unit,
                          .declaration = static_cast<int>(out_.declarations.size()) - 1});
  close("]");
  return unit;
}

void CdlReader::assemblage_body() {
  stops_at_brace_ = false;
  const ValueType result = value_type(current().result_type, "");
  bool has_body = false;
  while (!at_close()) {
    const std::size_t before = at_;
    if (is("let") && !is_next("(")) {
      let();
    } else if (is("alias") && token(1).kind == TokenKind::kText) {
      note_word();
      advance();
      advance();
      take(";");
    } else {
      const CdlGuess guess = expression({.type = result});
      if (!has_body) current().result = guess;
      has_body = true;
      if (!take(";") && !at_close() && !starts_line()) skip_statement();
    }
    if (at_ == before) skip_statement();
    if (at_ == before) advance();
  }
  if (at_end() && at_statement()) {
    want_words({"let"});
    if (!has_body) {
      want_words({"alias"});
      want({.kind = Kind::kValue, .wanted = {.type = result}});
    }
  }
  close("}");
}

void CdlReader::let() {
  CdlLet one;
  one.help = help_above();
  one.whole.begin = token().span.begin;
  note_word();
  advance();
  if (at_end()) need({});
  std::tie(one.name, one.span) = declared(NameKind::kLet);
  if (take("=")) one.guess = expression({});
  if (!take(";") && !at_close() && !starts_line()) skip_statement();
  one.whole.end = last_end();
  if (!one.name.empty()) current().lets.push_back(std::move(one));
}

void CdlReader::robot_class() {
  if (is("(")) parameters();
  if (!take("{")) return;
  while (!at_close()) {
    const std::size_t before = at_;
    if (take_word("body")) {
      body_settings();
    } else if (is_any({"sensor", "actuator"})) {
      device();
    } else {
      skip_statement();
    }
    if (at_ == before) advance();
  }
  if (at_end() && at_statement()) want_words({"body", "sensor", "actuator"});
  close("}");
}

void CdlReader::body_settings() {
  if (!take("{")) return;
  while (!at_close() && !is_any({"sensor", "actuator"})) {
    const std::size_t before = at_;
    if (is_name()) add_name(NameKind::kBodySetting);
    if (take("=")) expression({});
    if (!take(";") && !at_close() && !starts_line()) skip_statement();
    if (at_ == before) advance();
  }
  if (at_end() && at_statement()) need_kind(Kind::kBodySetting);
  close("}");
}

void CdlReader::device() {
  CdlDevice one;
  one.help = help_above();
  one.whole.begin = token().span.begin;
  one.is_actuator = is("actuator");
  note_word();
  advance();
  if (at_end()) need({});
  std::tie(one.name, one.span) = declared(NameKind::kDevice);
  if (take(":")) {
    if (is_name()) one.by = text();
    if (is_name() && is_next("(")) {
      call({});
    } else if (at_end()) {
      need({.kind = Kind::kValue});
    } else if (is_name()) {
      add_name(NameKind::kProcedure);
    }
  }
  if (at_end() && !one.by.empty()) want_words({"binds"});
  if (take_word("binds")) {
    if (at_end()) need_kind(Kind::kBinding);
    if (is_name()) {
      one.binds = text();
      add_name(NameKind::kBinding);
    }
  }
  if (!take(";") && !at_close() && !starts_line()) skip_statement();
  one.whole.end = last_end();
  if (!one.name.empty()) current().devices.push_back(std::move(one));
}

void CdlReader::robot() {
  if (is("(")) parameters();
  if (at_end()) want_words({"is"});
  if (take_word("is")) {
    if (at_end()) need_kind(Kind::kClass);
    if (is_name()) {
      current().class_name = text();
      add_name(NameKind::kClass);
    }
  }
  if (!take("{")) return;
  while (!at_close()) {
    const std::size_t before = at_;
    if (is("let") && !is_next("=")) {
      let();
    } else if (is("use") && !is_next("=")) {
      choice();
    } else {
      drive();
    }
    if (at_ == before) skip_statement();
    if (at_ == before) advance();
  }
  if (at_end() && at_statement()) {
    want_words({"let", "use"});
    need_kind(Kind::kActuator);
  }
  close("}");
}

void CdlReader::choice() {
  note_word();
  advance();
  std::string device(is_name() ? text() : "");
  use(NameKind::kDevice, Kind::kDevice);
  if (at_end() && !device.empty()) want_words({"for"});
  if (take_word("for")) {
    if (at_end()) need({.kind = Kind::kBinding, .device = device});
    if (is_name()) add_name(NameKind::kBinding);
  }
  if (!take(";") && !at_close() && !starts_line()) skip_statement();
}

void CdlReader::drive() {
  const bool is_movement = is("movement");
  if (is_name()) add_name(NameKind::kBinding);
  if (take("=")) expression({.type = is_movement ? ValueType{"Vector", ""} : ValueType{}});
  if (!take(";") && !at_close() && !starts_line()) skip_statement();
}

void CdlReader::society_operator() {
  if (!take("{")) return;
  while (!at_close()) {
    const std::size_t before = at_;
    if (is_name()) add_name(NameKind::kBinding);
    if (take("=")) {
      if (at_end()) need({.kind = Kind::kValue});
      if (is_name()) call({});
    }
    if (!take(";") && !at_close() && !starts_line()) skip_statement();
    if (at_ == before) advance();
  }
  if (at_end() && at_statement()) need_kind(Kind::kBinding);
  close("}");
}

void CdlReader::society() {
  if (take(":")) group();
  take(";");
}

void CdlReader::group() {
  if (++depth_ > cdl::kMaxNesting) {
    at_ = tokens_.size() - 1;
    --depth_;
    return;
  }
  if (at_end()) {
    want_words({"team of", "caste"});
    need_kind(Kind::kMember);
  }
  if (is("team") && !is_next(";")) {
    take_word("team");
    if (at_end()) need_words({"of"});
    take_word("of");
    if (token().kind == TokenKind::kNumber) {
      advance();
      use(NameKind::kRobot, Kind::kMember);
    }
  } else if (is("caste") && !is_next(";")) {
    take_word("caste");
    take("{");
    while (!at_close()) {
      const std::size_t before = at_;
      group();
      if (!take(";") && !at_close() && !starts_line()) skip_statement();
      if (at_ == before) advance();
    }
    if (at_end() && at_statement()) {
      want_words({"team of", "caste"});
      need_kind(Kind::kMember);
    }
    close("}");
  } else if (is_name()) {
    add_name(NameKind::kRobot);
  }
  if (at_end()) want_words({"by"});
  if (take_word("by")) use(NameKind::kOperator, Kind::kSocietyOperator);
  --depth_;
}

CdlScan scan_cdl(const text::SourcePtr& source) {
  return CdlReader(source).run();
}

}  // namespace mlab::language
