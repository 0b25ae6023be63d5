// What has a value: numbers, names, calls, lists, operators.

#include <algorithm>
#include <array>

#include "mlab/lang/cdl/cursor.h"
#include "mlab/language/cdl_reader.h"

namespace mlab::language {
namespace {

CdlGuess of_type(std::string type) {
  return {CdlGuess::Kind::kType, std::move(type), ""};
}

}  // namespace

CdlGuess CdlReader::expression(const CdlWanted& wanted) {
  CdlGuess out = conjunction(wanted);
  while (take_word("or")) {
    conjunction({.type = {"bool", ""}});
    out = of_type("bool");
  }
  return out;
}

CdlGuess CdlReader::conjunction(const CdlWanted& wanted) {
  CdlGuess out = negation(wanted);
  while (take_word("and")) {
    negation({.type = {"bool", ""}});
    out = of_type("bool");
  }
  return out;
}

CdlGuess CdlReader::negation(const CdlWanted& wanted) {
  bool is_negated = false;
  while (is("not") && !is_next("=")) {
    note_word();
    advance();
    is_negated = true;
  }
  const CdlGuess out = suffixed(is_negated ? CdlWanted{.type = {"bool", ""}} : wanted);
  return is_negated ? of_type("bool") : out;
}

CdlGuess CdlReader::suffixed(const CdlWanted& wanted) {
  if (++depth_ > cdl::kMaxNesting) {
    at_ = tokens_.size() - 1;
    --depth_;
    return {};
  }
  const CdlGuess out = primary(wanted);
  bool has_name = false;
  for (;;) {
    if (at_end()) {
      if (!has_name) want_words({"as"});
      want_words({"active", "and", "or"});
    }
    if (take_word("as")) {
      has_name = true;
      const auto [name, span] = declared(NameKind::kNode);
      if (!name.empty() && !out_.declarations.empty()) current().nodes.push_back({name, span, out});
    } else if (take_word("active")) {
      suffixed({});
    } else {
      break;
    }
  }
  --depth_;
  return out;
}

CdlGuess CdlReader::primary(const CdlWanted& wanted) {
  if (at_end()) {
    need({.kind = Kind::kValue, .wanted = wanted});
    return {};
  }
  if (at_next_statement()) return {};
  if (token().kind == TokenKind::kNumber) return number(wanted);
  if (token().kind == TokenKind::kText || token().kind == TokenKind::kUnclosed) {
    advance();
    return of_type("Text");
  }
  if (is("[")) return list(wanted);
  if (is("(")) {
    advance();
    CdlGuess out = expression(wanted);
    close(")");
    return out;
  }
  return is_name() ? named(wanted) : CdlGuess{};
}

// What is still to be written ends where the next line begins a statement of its own.
bool CdlReader::at_next_statement() const {
  if (!is_name() || !starts_line() || last_end() == 0) return false;
  const std::string_view last = out_.source->text(tokens_[at_ - 1].span);
  if (last == ";" || last == "{" || last == "}" || last == "(" || last == "," || last == "[") return false;
  if (is_next(":")) return true;
  const bool is_followed = token(1).kind == TokenKind::kName;
  return is_followed && is_any({"let", "when", "start", "final", "case", "sensor", "actuator"});
}

CdlGuess CdlReader::number(const CdlWanted& wanted) {
  CdlGuess out = of_type("double");
  advance();
  if (at_end()) want({.kind = Kind::kUnit, .wanted = wanted});
  if (!is_name() || starts_line() || is_any({"as", "active", "and", "or", "in", "goto", "by", "binds", "is"}))
    return out;
  CdlName unit{.span = token().span, .kind = NameKind::kUnit, .wanted = wanted};
  advance();
  if (is("/") && tokens_[at_ + 1].kind == TokenKind::kName) {
    advance();
    unit.span.end = token().span.end;
    advance();
  } else if (is("/") && tokens_[at_ + 1].kind == TokenKind::kEnd) {
    advance();
    need({.kind = Kind::kUnit, .wanted = wanted});
  }
  unit.text = out_.source->text(unit.span);
  unit.declaration = static_cast<int>(out_.declarations.size()) - 1;
  out.unit = unit.text;
  out_.names.push_back(std::move(unit));
  return out;
}

CdlGuess CdlReader::named(const CdlWanted& wanted) {
  if (is("delay") && is_next("(")) return delay(wanted);
  if (at_block()) return block(wanted);
  if (is_next("(")) return call(wanted);
  CdlGuess out{CdlGuess::Kind::kName, std::string(text()), ""};
  const auto i = static_cast<std::size_t>(add_name(NameKind::kWord));
  out_.names[i].is_value = true;
  out_.names[i].wanted = wanted;
  return out;
}

CdlGuess CdlReader::call(const CdlWanted& wanted) {
  CdlGuess out{CdlGuess::Kind::kCall, std::string(text()), ""};
  const int callee = add_name(NameKind::kProcedure);
  out_.names[static_cast<std::size_t>(callee)].wanted = wanted;
  if (is("(")) arguments(callee);
  return out;
}

void CdlReader::arguments(int callee) {
  take("(");
  CdlWant next{.kind = Kind::kArgument, .wanted = {.call = callee}};
  out_.open_calls.push_back({callee, 0, ""});
  int position = 0;
  while (!is(")")) {
    next.wanted.position = position;
    next.positional = position;
    if (out_.open_calls.size() <= cdl::kMaxNesting) {
      out_.open_calls.back().position = position;
      out_.open_calls.back().argument.clear();
    }
    if (at_end()) {
      need(next);
      return;
    }
    CdlWanted wanted{.call = callee, .position = position};
    if (is_name() && is_next("=")) {
      wanted.argument = text();
      next.given.insert(wanted.argument);
      const auto i = static_cast<std::size_t>(add_name(NameKind::kArgument));
      out_.names[i].wanted = wanted;
      out_.open_calls.back().argument = wanted.argument;
      advance();
    } else if (next.given.empty()) {
      ++position;
    }
    const std::size_t before = at_;
    expression(wanted);
    if (at_end()) {
      is_done_ = true;
      return;
    }
    if (take(",")) continue;
    if (is(")") || is_any({";", "{", "}"}) || at_declaration()) break;
    if (at_ == before) advance();
  }
  take(")");
  if (!out_.open_calls.empty()) out_.open_calls.pop_back();
}

CdlGuess CdlReader::list(const CdlWanted& wanted) {
  advance();
  CdlWanted inner = wanted;
  inner.in_list = true;
  if (inner.call < 0 && (inner.type.type == "Vector" || inner.type.type == "Point"))
    inner.type = {"double", inner.type.unit};
  bool is_open = true;  // something has to follow
  while (!at_end() && !is("]")) {
    const std::size_t before = at_;
    expression(inner);
    is_open = take(",");
    if (is_open) continue;
    if (is_any({";", ")", "}"}) || at_declaration()) break;
    if (!is("]") && at_ == before) advance();
  }
  if (at_end() && is_open) need({.kind = Kind::kValue, .wanted = inner});
  close("]");
  return {};
}

CdlGuess CdlReader::delay(const CdlWanted& wanted) {
  note_word();
  advance();
  take("(");
  CdlGuess out;
  bool is_first = true;
  while (!at_end() && !is(")")) {
    if (is_any({"initial", "value"}) && is_next("=")) {
      note_word();
      advance();
      advance();
    }
    const std::size_t before = at_;
    const CdlGuess guess = expression(wanted);
    if (is_first) out = guess;
    is_first = false;
    if (take(",")) {
      if (at_end()) need_words({"initial = "});
      continue;
    }
    if (is_any({";", "{", "}"}) || at_declaration()) break;
    if (!is(")") && at_ == before) advance();
  }
  if (at_end() && is_first) need({.kind = Kind::kValue, .wanted = wanted});
  close(")");
  return out;
}

bool CdlReader::at_block() const {
  if (!is_any({"cooperate", "compete", "coordinate", "fuse", "sequence", "select"})) return false;
  if (is_next("{")) return !stops_at_brace_;
  if (is_next("by")) return true;
  constexpr std::array kOthers = {"(", ")", ",", ";", ":", "=", "as", "and", "or", "]", "active", "goto"};
  return std::ranges::none_of(kOthers, [this](const char* other) { return is_next(other); });
}

bool CdlReader::open_block() {
  stops_at_brace_ = false;
  if (at_end()) need({});
  return take("{");
}

CdlGuess CdlReader::block(const CdlWanted& wanted) {
  const bool outer = stops_at_brace_;
  CdlGuess out;
  note_word();
  if (is("cooperate")) {
    advance();
    members({"Vector", ""});
    out = of_type("Vector");
  } else if (is("compete")) {
    advance();
    if (at_end()) need_words({"by"});
    take_word("by");
    if (at_end()) need_words({"priority", "strength"});
    if (is_any({"priority", "strength"})) {
      note_word();
      advance();
    }
    members({"Vector", ""});
    out = of_type("Vector");
  } else if (is("sequence")) {
    advance();
    out = sequence(wanted);
  } else if (is("select")) {
    out = select(wanted);
  } else {
    out = by_operator(wanted);
  }
  stops_at_brace_ = outer;
  return out;
}

CdlGuess CdlReader::by_operator(const CdlWanted& wanted) {
  const bool is_movement = is("coordinate");
  advance();
  if (at_end()) need_words({"by"});
  take_word("by");
  if (at_end()) need_kind(Kind::kOperator);
  CdlGuess out;
  if (is_name()) {
    out = {CdlGuess::Kind::kCall, std::string(text()), ""};
    const int callee = add_name(NameKind::kProcedure);
    out_.names[static_cast<std::size_t>(callee)].wanted = wanted;
    if (is("(")) arguments(callee);
  }
  members(is_movement ? ValueType{"Vector", ""} : ValueType{});
  return out;
}

void CdlReader::members(const ValueType& type) {
  if (!open_block()) return;
  while (!at_close()) {
    const std::size_t before = at_;
    member(type);
    if (at_ == before) skip_statement();
    if (at_ == before) advance();
  }
  if (at_end() && at_statement()) want({.kind = Kind::kValue, .wanted = {.type = type}});
  close("}");
}

void CdlReader::member(const ValueType& type) {
  expression({.type = type});
  if (take(":")) expression({.type = type});
  if (!take(";") && !at_close() && !starts_line()) skip_statement();
}

CdlGuess CdlReader::sequence(const CdlWanted& wanted) {
  CdlGuess out;
  if (!open_block()) return out;
  const int number = sequences_++;
  bool has_state = false;
  while (!at_close()) {
    const std::size_t before = at_;
    if (is("when")) {
      transition(number);
    } else {
      state(number, out, wanted);
      has_state = true;
    }
    if (at_ == before) skip_statement();
    if (at_ == before) advance();
    if (has_state && !out_.declarations.empty() && !current().states.empty())
      current().states.back().whole.end = std::max(current().states.back().whole.end, last_end());
  }
  if (at_end() && at_statement()) {
    want_words({"start", "final"});
    if (has_state) want_words({"when"});
  }
  close("}");
  return out;
}

void CdlReader::state(int sequence, CdlGuess& first, const CdlWanted& wanted) {
  CdlState state;
  state.help = help_above();
  state.sequence = sequence;
  state.whole.begin = token().span.begin;
  while (is_any({"start", "final"}) && !is_next("(") && !is_next(":")) {
    (is("start") ? state.is_start : state.is_final) = true;
    note_word();
    advance();
    if (at_end()) {
      if (state.is_start) want_words({"final"});
      need({});
      return;
    }
  }
  if (!is_name()) return;
  state.name = text();
  state.span = token().span;
  const auto i = static_cast<std::size_t>(add_name(NameKind::kState, true));
  out_.names[i].sequence = sequence;
  if (take(":")) {
    const CdlGuess guess = expression(wanted);
    if (first.kind == CdlGuess::Kind::kUnknown) first = guess;
  }
  state.whole.end = last_end();
  if (!out_.declarations.empty()) current().states.push_back(std::move(state));
  if (!take(";") && !at_close() && !starts_line()) skip_statement();
}

void CdlReader::transition(int sequence) {
  note_word();
  advance();
  expression({.type = {"bool", ""}});
  if (at_end()) want_words({"goto"});
  if (take_word("goto")) {
    if (at_end()) need({.kind = Kind::kState, .sequence = sequence});
    if (is_name() && !at_next_statement()) {
      const auto i = static_cast<std::size_t>(add_name(NameKind::kState));
      out_.names[i].sequence = sequence;
    }
    if (at_end()) want_words({"restart"});
    take_word("restart");
  }
  if (!take(";") && !at_close() && !starts_line()) skip_statement();
}

CdlGuess CdlReader::select(const CdlWanted& wanted) {
  advance();
  if (at_end()) need_words({"by"});
  take_word("by");
  stops_at_brace_ = true;
  const CdlGuess selector = expression({});
  CdlGuess out;
  if (!open_block()) return out;
  while (!at_close()) {
    const std::size_t before = at_;
    const CdlGuess guess = one_case(selector, wanted);
    if (out.kind == CdlGuess::Kind::kUnknown) out = guess;
    if (at_ == before) skip_statement();
    if (at_ == before) advance();
  }
  if (at_end() && at_statement()) want_words({"case", "otherwise: "});
  close("}");
  return out;
}

CdlGuess CdlReader::one_case(const CdlGuess& selector, const CdlWanted& wanted) {
  CdlGuess out;
  if (take_word("case")) {
    do {
      if (at_end()) need({.kind = Kind::kCaseValue, .guess = selector});
      if (is_name()) {
        add_name(NameKind::kWord);
      } else if (token().kind == TokenKind::kNumber) {
        advance();
      }
    } while (take(","));
  } else if (!take_word("otherwise")) {
    return out;
  }
  if (take(":")) out = expression(wanted);
  if (!take(";") && !at_close() && !starts_line()) skip_statement();
  return out;
}

}  // namespace mlab::language
