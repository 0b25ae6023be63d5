// Expressions without blocks: numbers, names, calls, lists, logic.

#include <string>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/cursor.h"
#include "mlab/text/shown.h"

namespace mlab::cdl {
namespace {

// Words that may follow a number and are no unit.
bool is_unit(const Cursor& cursor) {
  if (!cursor.is(Token::Kind::kName) || cursor.starts_line()) return false;
  return !cursor.is_any({"as", "active", "and", "or", "in", "goto", "by", "binds", "is"});
}

template <class What>
std::shared_ptr<Expression> made(const Cursor& cursor, std::uint32_t begin, What what) {
  auto out = std::make_shared<Expression>();
  out->what = std::move(what);
  out->place = cursor.since(begin);
  return out;
}

using Made = std::shared_ptr<Expression>;

Made parse_or(Cursor& cursor);

bool parse_arguments(Cursor& cursor, std::vector<Argument>& into) {
  if (cursor.take(")")) return true;
  do {
    Argument argument;
    if (cursor.is(Token::Kind::kName) && cursor.is_before("=")) {
      cursor.read_name(argument.name, "the name of an argument");
      cursor.advance();
    }
    argument.value = parse_expression(cursor);
    if (!argument.value) return false;
    into.push_back(std::move(argument));
  } while (cursor.take(","));
  return cursor.take(")") ||
         (cursor.expected("`,` or `)` behind the argument"), cursor.is_any({";", "{", "}"}));
}

Made parse_list(Cursor& cursor) {
  const std::uint32_t begin = cursor.begin();
  List list;
  cursor.advance();
  while (!cursor.take("]")) {
    const ExpressionPtr item = parse_expression(cursor);
    if (!item) return nullptr;
    list.items.push_back(item);
    if (!cursor.take(",") && !cursor.is("]")) {
      cursor.expected("`,` or `]` behind the member of the list");
      if (!cursor.is_any({";", ")", "}"})) return nullptr;
      break;
    }
  }
  return made(cursor, begin, std::move(list));
}

// `delay(value, initial = 0)`
Made parse_delay(Cursor& cursor) {
  const std::uint32_t begin = cursor.begin();
  const std::optional<Call> call = parse_call(cursor, "`delay`");
  if (!call) return nullptr;
  Delay delay;
  for (const Argument& argument : call->arguments) {
    const bool is_initial = argument.name.text == "initial" || (argument.name.text.empty() && delay.value);
    if (!is_initial && !argument.name.text.empty() && argument.name.text != "value") {
      cursor.error(
          "syntax", argument.name.place,
          fmt::format("a delay has `value` and `initial`, and no `{}`", text::shown(argument.name.text)));
      return nullptr;
    }
    ExpressionPtr& into = is_initial ? delay.initial : delay.value;
    if (into) {
      cursor.error("syntax", argument.value->place, "a delay has one `value` and one `initial`");
      return nullptr;
    }
    into = argument.value;
  }
  if (!delay.value) {
    cursor.error("syntax", call->callee.place, "a delay needs the value that it delays: `delay(value)`");
    return nullptr;
  }
  return made(cursor, begin, std::move(delay));
}

Made parse_parenthesis(Cursor& cursor) {
  cursor.advance();
  Made inner = parse_or(cursor);
  if (inner && !cursor.expect(")", "behind the expression") && !cursor.is(";")) return nullptr;
  return inner;
}

Made parse_named(Cursor& cursor) {
  const std::uint32_t begin = cursor.begin();
  if (cursor.is("delay") && cursor.is_before("(")) return parse_delay(cursor);
  if (at_block(cursor)) {
    auto out = std::make_shared<Expression>();
    if (!parse_block(cursor, *out)) return nullptr;
    out->place = cursor.since(begin);
    return out;
  }
  if (cursor.is_before("(")) {
    std::optional<Call> call = parse_call(cursor, "what to instantiate");
    return call ? made(cursor, begin, std::move(*call)) : nullptr;
  }
  Name name;
  cursor.read_name(name.name, "a name");
  return made(cursor, begin, std::move(name));
}

Made parse_primary(Cursor& cursor) {
  const std::uint32_t begin = cursor.begin();
  if (cursor.is(Token::Kind::kNumber)) {
    std::optional<Number> number = parse_quantity(cursor);
    return number ? made(cursor, begin, std::move(*number)) : nullptr;
  }
  if (cursor.is(Token::Kind::kText) || cursor.is(Token::Kind::kUnclosed)) {
    std::optional<std::string> value = cursor.read_text("a text");
    return value ? made(cursor, begin, Text{std::move(*value)}) : nullptr;
  }
  if (cursor.is("[")) return parse_list(cursor);
  if (cursor.is("(")) return parse_parenthesis(cursor);
  if (cursor.is(Token::Kind::kName)) return parse_named(cursor);
  cursor.expected("a value");
  return nullptr;
}

// `x as NAME active y`
Made parse_suffixed(Cursor& cursor) {
  if (!cursor.enter()) return nullptr;
  const std::uint32_t begin = cursor.begin();
  Made out = parse_primary(cursor);
  while (out && cursor.is_any({"as", "active"})) {
    if (cursor.is("as")) {
      if (!out->as.text.empty() || out->active) {
        cursor.error("syntax", cursor.here(), "this has a name already");
        out = nullptr;
        break;
      }
      cursor.advance();
      if (!cursor.read_name(out->as, "the name behind `as`")) out = nullptr;
    } else if (out->active) {
      cursor.error("syntax", cursor.here(), "this has an active part already");
      out = nullptr;
    } else {
      cursor.advance();
      const Made active = parse_suffixed(cursor);
      out->active = active;
      if (!active) out = nullptr;
    }
    if (out) out->place = cursor.since(begin);
  }
  cursor.leave();
  return out;
}

Made parse_not(Cursor& cursor) {
  if (!cursor.is("not") || cursor.is_before("=")) return parse_suffixed(cursor);
  if (!cursor.enter()) return nullptr;
  const std::uint32_t begin = cursor.begin();
  cursor.advance();
  const Made operand = parse_not(cursor);
  cursor.leave();
  return operand ? made(cursor, begin, Logic{Connective::kNot, {operand}}) : nullptr;
}

Made parse_chain(Cursor& cursor, Connective connective) {
  const char* word = connective == Connective::kAnd ? "and" : "or";
  const auto operand = [&] {
    return connective == Connective::kAnd ? parse_not(cursor) : parse_chain(cursor, Connective::kAnd);
  };
  const std::uint32_t begin = cursor.begin();
  Made first = operand();
  if (!first || !cursor.is(word)) return first;
  Logic logic{connective, {first}};
  while (cursor.take(word)) {
    const Made next = operand();
    if (!next) return nullptr;
    logic.operands.push_back(next);
  }
  return made(cursor, begin, std::move(logic));
}

Made parse_or(Cursor& cursor) {
  return parse_chain(cursor, Connective::kOr);
}

}  // namespace

std::optional<Number> parse_quantity(Cursor& cursor) {
  Number number;
  const std::optional<double> value = cursor.read_number();
  if (!value) return std::nullopt;
  number.value = *value;
  if (!is_unit(cursor)) return number;
  const std::uint32_t begin = cursor.begin();
  cursor.read_name(number.unit, "a unit");
  if (cursor.is("/")) {
    cursor.advance();
    Word per;
    if (!cursor.read_name(per, "the unit behind `/`")) return std::nullopt;
    number.unit.text += "/" + per.text;
    number.unit.place = cursor.since(begin);
  }
  return number;
}

std::optional<Call> parse_call(Cursor& cursor, std::string_view what) {
  Call call;
  if (!cursor.read_name(call.callee, what)) return std::nullopt;
  if (!cursor.expect("(", "behind the name of what is instantiated")) return std::nullopt;
  if (!parse_arguments(cursor, call.arguments)) return std::nullopt;
  return call;
}

ExpressionPtr parse_expression(Cursor& cursor) {
  if (!cursor.enter()) return nullptr;
  Made out = parse_or(cursor);
  cursor.leave();
  return out;
}

}  // namespace mlab::cdl
