// Expressions without blocks: numbers, names, calls, lists, logic.

#include <string>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/syntax/cursor.h"
#include "mlab/lang/cdl/syntax/signs.h"
#include "mlab/text/shown.h"

namespace mlab::cdl {
namespace {

// Words that may follow a number and are no unit.
bool is_unit(const Cursor& cursor) {
  if (!cursor.is(Token::Kind::kName) || cursor.starts_line()) return false;
  return !cursor.is_any({"as", "active", "and", "or", "in", "goto", "by", "binds", "is"});
}

// The expression that was read from `begin` on.
void settle(const Cursor& cursor, std::uint32_t begin, Expression& out) {
  out.place = cursor.since(begin);
  out.whole = out.place.span;
}

template <class What>
std::shared_ptr<Expression> made(const Cursor& cursor, std::uint32_t begin, What what) {
  auto out = std::make_shared<Expression>();
  out->what = std::move(what);
  settle(cursor, begin, *out);
  return out;
}

using MutableExpression = std::shared_ptr<Expression>;

/// What was read, with holes where it is not whole. Never null.
struct Read {
  MutableExpression value;
  bool is_whole = true;
};

Read hole(Cursor& cursor) {
  return {std::make_shared<Expression>(*cursor.hole()), false};
}

Read parse_or(Cursor& cursor);

bool parse_argument(Cursor& cursor, std::vector<Argument>& into) {
  Argument argument;
  if (cursor.is(Token::Kind::kName) && cursor.is_before("=")) {
    cursor.read_name(argument.name, "the name of an argument");
    cursor.advance();
  }
  const bool is_whole = parse_expression(cursor, argument.value);
  if (cursor.keeps(is_whole)) into.push_back(std::move(argument));
  return is_whole;
}

bool parse_arguments(Cursor& cursor, Call& call) {
  if (cursor.take(")")) return true;
  bool is_whole = true;
  call.is_closed = false;
  do {
    const bool is_read = parse_argument(cursor, call.arguments);
    is_whole = is_whole && is_read;
    if (!is_read && !cursor.skip_to({",", ")"})) return false;
  } while (cursor.take(","));
  call.is_closed = cursor.take(")");
  if (call.is_closed) return is_whole;
  cursor.expected("`,` or `)` behind the argument");
  return is_whole && cursor.is_any({";", "{", "}"});
}

Read parse_list(Cursor& cursor) {
  const std::uint32_t begin = cursor.begin();
  List list;
  bool is_whole = true;
  cursor.advance();
  while (is_whole && !cursor.take("]")) {
    ExpressionPtr item;
    is_whole = parse_expression(cursor, item);
    list.items.push_back(std::move(item));
    if (!is_whole || cursor.take(",") || cursor.is("]")) continue;
    cursor.expected("`,` or `]` behind the member of the list");
    is_whole = cursor.is_any({";", ")", "}"});
    break;
  }
  return {made(cursor, begin, std::move(list)), is_whole};
}

// One argument of a delay: `value` or `initial`.
bool put_delayed(Cursor& cursor, const Argument& argument, Delay& into) {
  if (!argument.name.text.empty()) cursor.note_word(argument.name.place.span);
  const bool is_initial = argument.name.text == "initial" || (argument.name.text.empty() && into.value);
  if (!is_initial && !argument.name.text.empty() && argument.name.text != "value") {
    cursor.error(
        "syntax", argument.name.place,
        fmt::format("a delay has `value` and `initial`, and no `{}`", text::shown(argument.name.text)));
    return false;
  }
  ExpressionPtr& part = is_initial ? into.initial : into.value;
  if (part) {
    cursor.error("syntax", argument.value->place, "a delay has one `value` and one `initial`");
    return false;
  }
  part = argument.value;
  return true;
}

// `delay(value, initial = 0)`
Read parse_delay(Cursor& cursor) {
  const std::uint32_t begin = cursor.begin();
  cursor.note_word(cursor.token().span);
  Call call;
  bool is_whole = parse_call(cursor, "`delay`", call);
  Delay delay;
  for (const Argument& argument : call.arguments) {
    is_whole = is_whole && put_delayed(cursor, argument, delay);
  }
  if (is_whole && !delay.value) {
    cursor.error("syntax", call.callee.place, "a delay needs the value that it delays: `delay(value)`");
    is_whole = false;
  }
  if (!delay.value) delay.value = cursor.hole();
  return {made(cursor, begin, std::move(delay)), is_whole};
}

Read parse_parenthesis(Cursor& cursor) {
  const std::uint32_t begin = cursor.begin();
  cursor.advance();
  Read inner = parse_or(cursor);
  if (inner.is_whole && !cursor.expect(")", "behind the expression") && !cursor.is(";"))
    inner.is_whole = false;
  inner.value->whole = cursor.span_since(begin);
  return inner;
}

Read parse_named(Cursor& cursor) {
  const std::uint32_t begin = cursor.begin();
  if (cursor.is("delay") && cursor.is_before("(")) return parse_delay(cursor);
  if (at_block(cursor)) {
    auto out = std::make_shared<Expression>();
    const bool is_whole = parse_block(cursor, *out);
    out->place = cursor.since(begin);
    out->whole = out->place.span;
    return {std::move(out), is_whole};
  }
  if (cursor.is_before("(")) {
    Call call;
    const bool is_whole = parse_call(cursor, "what to instantiate", call);
    return {made(cursor, begin, std::move(call)), is_whole};
  }
  if (cursor.at_unit()) {
    cursor.expected("a number before the unit");
    cursor.advance();
    cursor.advance();
    cursor.advance();
    return hole(cursor);
  }
  Name name;
  cursor.read_name(name.name, "a name");
  return {made(cursor, begin, std::move(name))};
}

Read parse_primary(Cursor& cursor) {
  const std::uint32_t begin = cursor.begin();
  if (cursor.is(Token::Kind::kNumber)) {
    std::optional<Number> number = parse_quantity(cursor);
    return number ? Read{made(cursor, begin, std::move(*number))} : hole(cursor);
  }
  if (cursor.is(Token::Kind::kText) || cursor.is(Token::Kind::kUnclosed)) {
    std::optional<std::string> value = cursor.read_text("a text");
    const bool is_whole = value.has_value();
    return {made(cursor, begin, Text{std::move(value).value_or("")}), is_whole};
  }
  if (cursor.is("[")) return parse_list(cursor);
  if (cursor.is("(")) return parse_parenthesis(cursor);
  if (cursor.is(Token::Kind::kName) && !cursor.at_next_statement()) return parse_named(cursor);
  cursor.expected("a value");
  return hole(cursor);
}

// `as NAME`
bool parse_name_of_node(Cursor& cursor, Expression& into) {
  if (!into.as.text.empty() || into.active) {
    cursor.error("syntax", cursor.here(), "this has a name already");
    return false;
  }
  cursor.advance_word();
  return cursor.read_name(into.as, "the name behind `as`");
}

Read parse_suffixed(Cursor& cursor);

// `active PART`
bool parse_active(Cursor& cursor, Expression& into) {
  if (into.active) {
    cursor.error("syntax", cursor.here(), "this has an active part already");
    return false;
  }
  cursor.advance_word();
  const Read active = parse_suffixed(cursor);
  into.active = active.value;
  return active.is_whole;
}

// `x as NAME active y`
Read parse_suffixed(Cursor& cursor) {
  if (!cursor.enter()) return hole(cursor);
  const std::uint32_t begin = cursor.begin();
  Read out = parse_primary(cursor);
  while (out.is_whole && ((out.value->as.text.empty() && cursor.could_be({"as"})) ||
                          cursor.could_be({"active"}) || cursor.is("as"))) {
    out.is_whole =
        cursor.is("as") ? parse_name_of_node(cursor, *out.value) : parse_active(cursor, *out.value);
    settle(cursor, begin, *out.value);
  }
  cursor.leave();
  return out;
}

// `-x`
Read parse_signed(Cursor& cursor) {
  if (!cursor.is("-")) return parse_suffixed(cursor);
  if (!cursor.enter()) return hole(cursor);
  const std::uint32_t begin = cursor.begin();
  cursor.advance();
  const Read operand = parse_signed(cursor);
  cursor.leave();
  return {made(cursor, begin, Arithmetic{{Operation::kNegate}, {operand.value}}), operand.is_whole};
}

// The operation that stands here, of those between `first` and `last`.
std::optional<Operation> operation_at(const Cursor& cursor, Operation first, Operation last) {
  for (Operation one = first; one <= last; one = static_cast<Operation>(static_cast<int>(one) + 1)) {
    if (cursor.is(sign_of(one))) return one;
  }
  return std::nullopt;
}

// `x * y / z`, `x + y - z`
Read parse_terms(Cursor& cursor, Operation first, Operation last) {
  const auto operand = [&] {
    return first == Operation::kAdd ? parse_terms(cursor, Operation::kMultiply, Operation::kDivide)
                                    : parse_signed(cursor);
  };
  const std::uint32_t begin = cursor.begin();
  Read out = operand();
  std::optional<Operation> next = operation_at(cursor, first, last);
  if (!out.is_whole || !next) return out;
  Arithmetic arithmetic{{}, {out.value}};
  for (; out.is_whole && next; next = operation_at(cursor, first, last)) {
    arithmetic.operations.push_back(*next);
    cursor.advance();
    const Read right = operand();
    arithmetic.operands.push_back(right.value);
    out.is_whole = right.is_whole;
  }
  out.value = made(cursor, begin, std::move(arithmetic));
  return out;
}

Read parse_sum(Cursor& cursor) {
  return parse_terms(cursor, Operation::kAdd, Operation::kSubtract);
}

// `x < y`
Read parse_comparison(Cursor& cursor) {
  const std::uint32_t begin = cursor.begin();
  Read out = parse_sum(cursor);
  const auto operation = operation_at(cursor, Operation::kLess, Operation::kUnequal);
  if (!out.is_whole || !operation) return out;
  cursor.advance();
  const Read right = parse_sum(cursor);
  out = {made(cursor, begin, Arithmetic{{*operation}, {out.value, right.value}}), right.is_whole};
  if (!out.is_whole || !operation_at(cursor, Operation::kLess, Operation::kUnequal)) return out;
  if (text::Diagnostic* d = cursor.error("syntax", cursor.here(), "a comparison is of two"))
    d->hints.emplace_back("`a < b and b < c` compares three");
  return {std::move(out.value), false};
}

Read parse_not(Cursor& cursor) {
  if (!cursor.is("not") || cursor.is_before("=")) return parse_comparison(cursor);
  if (!cursor.enter()) return hole(cursor);
  const std::uint32_t begin = cursor.begin();
  cursor.advance_word();
  const Read operand = parse_not(cursor);
  cursor.leave();
  return {made(cursor, begin, Logic{Connective::kNot, {operand.value}}), operand.is_whole};
}

Read parse_chain(Cursor& cursor, Connective connective) {
  const char* word = connective == Connective::kAnd ? "and" : "or";
  const auto operand = [&] {
    return connective == Connective::kAnd ? parse_not(cursor) : parse_chain(cursor, Connective::kAnd);
  };
  const std::uint32_t begin = cursor.begin();
  Read out = operand();
  if (!out.is_whole || !cursor.could_be({word})) return out;
  Logic logic{connective, {out.value}};
  while (out.is_whole && cursor.take(word)) {
    const Read next = operand();
    logic.operands.push_back(next.value);
    out.is_whole = next.is_whole;
  }
  out.value = made(cursor, begin, std::move(logic));
  return out;
}

Read parse_or(Cursor& cursor) {
  return parse_chain(cursor, Connective::kOr);
}

}  // namespace

std::optional<Number> parse_quantity(Cursor& cursor) {
  Number number;
  const std::uint32_t start = cursor.begin();
  const std::optional<double> value = cursor.read_number();
  if (!value) return std::nullopt;
  number.value = *value;
  number.whole = cursor.span_since(start);
  if (!is_unit(cursor)) {
    if (cursor.keeps_parts() && cursor.at_end()) number.unit.place = cursor.here();
    return number;
  }
  const std::uint32_t begin = cursor.begin();
  cursor.read_name(number.unit, "a unit");
  number.whole = cursor.span_since(start);
  if (!cursor.is("/") || !cursor.divides_units(number.unit)) return number;
  cursor.advance();
  Word per;
  if (!cursor.read_name(per, "the unit behind `/`")) {
    number.unit = per;
    return cursor.keeps_parts() ? std::optional(number) : std::nullopt;
  }
  number.unit.text += "/" + per.text;
  number.unit.place = cursor.since(begin);
  number.whole = cursor.span_since(start);
  return number;
}

bool parse_call(Cursor& cursor, std::string_view what, Call& into) {
  into.is_closed = false;
  if (!cursor.read_name(into.callee, what)) return false;
  if (!cursor.expect("(", "behind the name of what is instantiated")) return false;
  into.is_closed = true;
  return parse_arguments(cursor, into);
}

bool parse_expression(Cursor& cursor, ExpressionPtr& into) {
  if (!cursor.enter()) {
    into = cursor.hole();
    return false;
  }
  Read out = parse_or(cursor);
  cursor.leave();
  into = std::move(out.value);
  return out.is_whole;
}

}  // namespace mlab::cdl
