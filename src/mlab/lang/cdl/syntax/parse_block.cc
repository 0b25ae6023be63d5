// The operators that are written as blocks: cooperation, competition, coordination, fusion, sequencing,
// selection.

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/syntax/cursor.h"

namespace mlab::cdl {
namespace {

// `0.8: Noise(persistence = 10 s) as drift;`
bool parse_member(Cursor& cursor, std::vector<Member>& into) {
  Member member;
  member.help = cursor.help_above();
  bool is_read = parse_expression(cursor, member.value);
  if (is_read && cursor.take(":")) {
    member.weight = std::move(member.value);
    is_read = parse_expression(cursor, member.value);
  }
  const bool is_whole = is_read && cursor.expect_semicolon("behind the member");
  if (cursor.keeps(is_read)) into.push_back(std::move(member));
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
  cursor.advance_word();
  Compete& compete = into.what.emplace<Compete>();
  if (!cursor.expect("by", "and `priority` or `strength`")) return false;
  if (!cursor.could_be({"priority", "strength"})) {
    text::Diagnostic* d = cursor.expected("`priority` or `strength`");
    if (d != nullptr)
      d->hints.emplace_back("`coordinate by OPERATOR { ... }` takes any operator of the library");
    return false;
  }
  compete.rule = cursor.is("priority") ? CompetitionRule::kPriority : CompetitionRule::kStrength;
  compete.rule_word = {std::string(cursor.text()), cursor.here()};
  cursor.advance_word();
  return parse_members(cursor, "`compete`", compete.members);
}

// `coordinate by Op(...) { ... }`, `fuse by Op(...) { ... }`
template <class Operator>
bool parse_by(Cursor& cursor, const char* what, Expression& into) {
  cursor.advance_word();
  Operator& op = into.what.emplace<Operator>();
  if (!cursor.expect("by", "and the operator")) return false;
  op.by.has_parentheses = !cursor.is_before("{");  // without arguments they may be left out
  const bool is_read = op.by.has_parentheses ? parse_call(cursor, "the operator", op.by)
                                             : cursor.read_name(op.by.callee, "the operator");
  return is_read && parse_members(cursor, what, op.members);
}

bool read_target(Cursor& cursor, Word& into) {
  constexpr const char* kWhat = "the state to go to";
  if (!cursor.at_next_statement()) return cursor.read_name(into, kWhat);
  cursor.expected(kWhat);
  return false;
}

// `when TRIGGER goto STATE [restart];`
bool parse_transition(Cursor& cursor, State& state) {
  const std::uint32_t begin = cursor.begin();
  Transition transition;
  transition.help = cursor.help_above();
  cursor.advance_word();
  const bool is_read = parse_expression(cursor, transition.trigger) &&
                       cursor.expect("goto", "behind the trigger") && read_target(cursor, transition.target);
  transition.restarts = is_read && cursor.take("restart");
  transition.place = cursor.since(begin);
  const bool is_whole = is_read && cursor.expect_semicolon("behind the transition");
  if (cursor.keeps(is_read)) state.transitions.push_back(std::move(transition));
  return is_whole;
}

bool at_mark(Cursor& cursor, const State& state) {
  if (cursor.at_end() && state.is_start) return !state.is_final && cursor.could_be({"final"});
  if (cursor.at_end() && state.is_final) return false;
  return cursor.could_be({"start", "final"});
}

// `[start] [final] NAME: MEMBER;`
bool parse_state_head(Cursor& cursor, State& state) {
  state.help = cursor.help_above();
  while (at_mark(cursor, state) && !cursor.is_before("(")) {
    if (cursor.is_before(":") && (state.is_start || state.is_final)) break;  // a state of that name
    (cursor.is("start") ? state.is_start : state.is_final) = true;
    cursor.advance_word();
  }
  if (!cursor.read_name(state.name, "a state: its name, `:` and what it does")) return false;
  state.place = state.name.place;
  if (cursor.is("(")) {
    if (text::Diagnostic* d = cursor.expected("`:` behind the name of the state"))
      d->hints.emplace_back("a transition starts with `when`");
    return false;
  }
  if (!cursor.expect(":", "behind the name of the state")) return false;
  const bool is_read = parse_expression(cursor, state.member);
  if (!cursor.keeps(is_read)) state.member = nullptr;
  return is_read && cursor.expect_semicolon("behind what the state does");
}

void parse_state(Cursor& cursor, Sequence& sequence) {
  State state;
  const std::uint32_t begin = cursor.begin();
  if (!parse_state_head(cursor, state)) cursor.skip_statement();
  while (cursor.is("when") || (cursor.at_statement() && cursor.could_be({"when"}))) {
    if (!parse_transition(cursor, state)) cursor.skip_statement();
  }
  state.whole = cursor.span_since(begin);
  if (!state.name.text.empty()) sequence.states.push_back(std::move(state));
}

bool parse_sequence(Cursor& cursor, Expression& into) {
  cursor.advance_word();
  Sequence& sequence = into.what.emplace<Sequence>();
  if (!cursor.open("`sequence`")) return false;
  while (!cursor.at_close()) parse_state(cursor, sequence);
  cursor.close();
  return true;
}

bool parse_case_value(Cursor& cursor, Case& into) {
  Word value{std::string(cursor.text()), cursor.here()};
  const bool is_whole = cursor.is(Token::Kind::kNumber) || cursor.is(Token::Kind::kName);
  if (cursor.keeps(is_whole)) into.values.push_back(std::move(value));
  is_whole ? cursor.advance() : static_cast<void>(cursor.expected("a value of the selector"));
  return is_whole;
}

bool parse_case_head(Cursor& cursor, Case& into) {
  if (cursor.take("otherwise")) return true;
  if (!cursor.take("case")) {
    cursor.expected("`case` or `otherwise`");
    return false;
  }
  do {
    if (!parse_case_value(cursor, into)) return false;
  } while (cursor.take(","));
  return true;
}

// `case MoveTo, Follow: MEMBER;` or `otherwise: MEMBER;`
bool parse_case(Cursor& cursor, Select& select) {
  Case one;
  one.place = cursor.here();
  const bool is_read = parse_case_head(cursor, one) &&
                       cursor.expect(":", "before what is done in this case") &&
                       parse_expression(cursor, one.member);
  const bool is_whole = is_read && cursor.expect_semicolon("behind the case");
  if (cursor.keeps(is_read)) select.cases.push_back(std::move(one));
  return is_whole;
}

bool parse_select(Cursor& cursor, Expression& into) {
  cursor.advance_word();
  Select& select = into.what.emplace<Select>();
  if (!cursor.expect("by", "and the selector")) return false;
  const bool outer = std::exchange(cursor.stops_at_brace, true);
  const bool has_selector = parse_expression(cursor, select.by);
  cursor.stops_at_brace = outer;
  if (!has_selector || !cursor.open("`select`")) return false;
  while (!cursor.at_close()) {
    if (!parse_case(cursor, select)) cursor.skip_statement();
  }
  cursor.close();
  return true;
}

bool parse_cooperate(Cursor& cursor, Expression& into) {
  cursor.advance_word();
  return parse_members(cursor, "`cooperate`", into.what.emplace<Cooperate>().members);
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
