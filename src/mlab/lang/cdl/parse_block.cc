// The operators that are written as blocks: cooperation, competition, coordination, fusion, sequencing,
// selection.

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/cursor.h"

namespace mlab::cdl {
namespace {

// `0.8: Noise(persistence = 10 s) as drift;`
bool parse_member(Cursor& cursor, std::vector<Member>& into) {
  Member member;
  member.help = cursor.help_above();
  member.value = parse_expression(cursor);
  if (!member.value) return false;
  if (cursor.take(":")) {
    member.weight = std::move(member.value);
    member.value = parse_expression(cursor);
    if (!member.value) return false;
  }
  const bool is_whole = cursor.expect_semicolon("behind the member");
  into.push_back(std::move(member));
  return is_whole;
}

bool parse_members(Cursor& cursor, const char* what, std::vector<Member>& into) {
  if (!cursor.open(what)) return false;
  while (!cursor.at_close()) {
    if (!parse_member(cursor, into)) cursor.skip_statement();
  }
  cursor.close();
  return true;
}

bool parse_compete(Cursor& cursor, Expression& into) {
  cursor.advance();
  Compete compete;
  if (!cursor.expect("by", "and `priority` or `strength`")) return false;
  if (!cursor.is_any({"priority", "strength"})) {
    text::Diagnostic* d = cursor.expected("`priority` or `strength`");
    if (d != nullptr)
      d->hints.emplace_back("`coordinate by OPERATOR { ... }` takes any operator of the library");
    return false;
  }
  compete.rule = cursor.is("priority") ? CompetitionRule::kPriority : CompetitionRule::kStrength;
  cursor.read_name(compete.rule_word, "the rule");
  if (!parse_members(cursor, "`compete`", compete.members)) return false;
  into.what = std::move(compete);
  return true;
}

// `coordinate by Op(...) { ... }`, `fuse by Op(...) { ... }`
template <class Operator>
bool parse_by(Cursor& cursor, const char* what, Expression& into) {
  cursor.advance();
  Operator op;
  if (!cursor.expect("by", "and the operator")) return false;
  std::optional<Call> by;
  if (cursor.is_before("{")) {  // without arguments the parentheses may be left out
    by.emplace();
    if (!cursor.read_name(by->callee, "the operator")) return false;
  } else {
    by = parse_call(cursor, "the operator");
  }
  if (!by) return false;
  op.by = std::move(*by);
  if (!parse_members(cursor, what, op.members)) return false;
  into.what = std::move(op);
  return true;
}

// `when TRIGGER goto STATE [restart];`
bool parse_transition(Cursor& cursor, State& state) {
  const std::uint32_t begin = cursor.begin();
  Transition transition;
  transition.help = cursor.help_above();
  cursor.advance();
  transition.trigger = parse_expression(cursor);
  if (!transition.trigger || !cursor.expect("goto", "behind the trigger")) return false;
  if (!cursor.read_name(transition.target, "the state to go to")) return false;
  transition.restarts = cursor.take("restart");
  transition.place = cursor.since(begin);
  const bool is_whole = cursor.expect_semicolon("behind the transition");
  state.transitions.push_back(std::move(transition));
  return is_whole;
}

// `[start] [final] NAME: MEMBER;`
bool parse_state_head(Cursor& cursor, State& state) {
  state.help = cursor.help_above();
  while (cursor.is_any({"start", "final"}) && !cursor.is_before("(")) {
    if (cursor.is_before(":") && (state.is_start || state.is_final)) break;  // a state of that name
    (cursor.is("start") ? state.is_start : state.is_final) = true;
    cursor.advance();
  }
  if (!cursor.read_name(state.name, "a state: its name, `:` and what it does")) return false;
  state.place = state.name.place;
  if (cursor.is("(")) {
    if (text::Diagnostic* d = cursor.expected("`:` behind the name of the state"))
      d->hints.emplace_back("a transition starts with `when`");
    return false;
  }
  if (!cursor.expect(":", "behind the name of the state")) return false;
  state.member = parse_expression(cursor);
  return state.member && cursor.expect_semicolon("behind what the state does");
}

void parse_state(Cursor& cursor, Sequence& sequence) {
  State state;
  if (!parse_state_head(cursor, state)) cursor.skip_statement();
  while (cursor.is("when")) {
    if (!parse_transition(cursor, state)) cursor.skip_statement();
  }
  if (!state.name.text.empty()) sequence.states.push_back(std::move(state));
}

bool parse_sequence(Cursor& cursor, Expression& into) {
  cursor.advance();
  Sequence sequence;
  if (!cursor.open("`sequence`")) return false;
  while (!cursor.at_close()) parse_state(cursor, sequence);
  cursor.close();
  into.what = std::move(sequence);
  return true;
}

bool parse_case_value(Cursor& cursor, Case& into) {
  Word value{std::string(cursor.text()), cursor.here()};
  if (!cursor.is(Token::Kind::kNumber) && !cursor.is(Token::Kind::kName)) {
    cursor.expected("a value of the selector");
    return false;
  }
  cursor.advance();
  into.values.push_back(std::move(value));
  return true;
}

// `case MoveTo, Follow: MEMBER;` or `otherwise: MEMBER;`
bool parse_case(Cursor& cursor, Select& select) {
  Case one;
  one.place = cursor.here();
  if (!cursor.take("otherwise")) {
    if (!cursor.is("case")) {
      cursor.expected("`case` or `otherwise`");
      return false;
    }
    cursor.advance();
    do {
      if (!parse_case_value(cursor, one)) return false;
    } while (cursor.take(","));
  }
  if (!cursor.expect(":", "before what is done in this case")) return false;
  one.member = parse_expression(cursor);
  if (!one.member) return false;
  const bool is_whole = cursor.expect_semicolon("behind the case");
  select.cases.push_back(std::move(one));
  return is_whole;
}

bool parse_select(Cursor& cursor, Expression& into) {
  cursor.advance();
  Select select;
  if (!cursor.expect("by", "and the selector")) return false;
  const bool outer = std::exchange(cursor.stops_at_brace, true);
  select.by = parse_expression(cursor);
  cursor.stops_at_brace = outer;
  if (!select.by || !cursor.open("`select`")) return false;
  while (!cursor.at_close()) {
    if (!parse_case(cursor, select)) cursor.skip_statement();
  }
  cursor.close();
  into.what = std::move(select);
  return true;
}

bool parse_cooperate(Cursor& cursor, Expression& into) {
  cursor.advance();
  Cooperate cooperate;
  if (!parse_members(cursor, "`cooperate`", cooperate.members)) return false;
  into.what = std::move(cooperate);
  return true;
}

}  // namespace

// `cooperate` and the others are words only where something follows that makes them one. What is most likely
// a forgotten `{` or `by` counts as well.
bool at_block(const Cursor& cursor) {
  if (cursor.is_before("{")) return !cursor.stops_at_brace;
  if (!cursor.is_any({"cooperate", "compete", "coordinate", "fuse", "sequence", "select"})) return false;
  if (cursor.is_before("by")) return true;
  constexpr const char* kOthers[] = {"(", ")", ",", ";", ":", "=", "as", "and", "or", "]", "active", "goto"};
  return std::ranges::none_of(kOthers, [&](const char* other) { return cursor.is_before(other); });
}

bool parse_block(Cursor& cursor, Expression& into) {
  if (cursor.is("cooperate")) return parse_cooperate(cursor, into);
  if (cursor.is("compete")) return parse_compete(cursor, into);
  if (cursor.is("coordinate")) return parse_by<Coordinate>(cursor, "`coordinate`", into);
  if (cursor.is("fuse")) return parse_by<Fuse>(cursor, "`fuse`", into);
  if (cursor.is("sequence")) return parse_sequence(cursor, into);
  if (cursor.is("select")) return parse_select(cursor, into);
  static const std::string kWords[] = {"cooperate", "compete", "coordinate", "fuse", "sequence", "select"};
  const std::string nearest = text::nearest_name(cursor.text(), kWords);
  text::Diagnostic* d =
      cursor.error("unknown-operator", cursor.here(), fmt::format("unknown operator `{}`", cursor.text()));
  if (d != nullptr) {
    d->hints.push_back(nearest.empty() ? "there are cooperate, compete, coordinate, fuse, sequence, select"
                                       : fmt::format("did you mean `{}`?", nearest));
  }
  return false;
}

}  // namespace mlab::cdl
