#include <memory>
#include <utility>

#include "mlab/lang/cdl_historic/cursor.h"

namespace mlab::cdl_historic {
namespace {

using Kind = Token::Kind;

// `Type %name}` or `Type {& %a %b}}` or `}` behind `{^`.
Value parse_pushed_up(Cursor& cursor, const text::Place& start) {
  Value value;
  value.kind = Value::Kind::kPushedUp;
  if (!cursor.is("}")) {
    value.up.type = cursor.expect_name("the type of a pushed-up parameter, or `}`");
    if (cursor.is(Kind::kPair)) {
      cursor.advance();
      value.up.name = cursor.expect_pushed_name();
      value.up.second = cursor.expect_pushed_name();
      cursor.expect("}", "behind the two names");
    } else {
      value.up.name = cursor.expect_pushed_name();
    }
  }
  cursor.expect("}", "at the end of a pushed-up parameter");
  value.place = cursor.since(start);
  return value;
}

// `[ trigger ] goto Target` behind `if`. The trigger may have an inline name, and may be a reference.
Value parse_rule(Cursor& cursor, const text::Place& start) {
  auto rule = std::make_shared<Rule>();
  while (cursor.is(Kind::kInline)) cursor.advance();
  if (cursor.is("[")) {
    rule->members = parse_members(cursor);
    rule->spot = cursor.take_spot();
  } else if (!cursor.is("goto")) {
    Setting trigger;
    trigger.value.kind = Value::Kind::kExpr;
    trigger.value.expr = parse_expression(cursor);
    if (trigger.value.expr != nullptr) rule->spot = trigger.value.expr->spot;
    rule->members.push_back(std::move(trigger));
  }
  if (cursor.expect("goto", "behind the trigger of a rule")) {
    rule->target = cursor.expect_name("the name of a state");
  }
  Value value;
  value.kind = Value::Kind::kRule;
  value.rule = std::move(rule);
  value.place = cursor.since(start);
  return value;
}

std::vector<Setting> parse_settings(Cursor& cursor, std::string_view closing, std::string_view why);

Value parse_value(Cursor& cursor) {
  Value value;
  value.place = cursor.here();
  if (cursor.is(",") || cursor.is(")") || cursor.is("]")) return value;
  if (cursor.is(Kind::kInitializer)) {
    value.kind = Value::Kind::kConstant;
    value.constant = cursor.take_word();
  } else if (cursor.is(Kind::kUp) || cursor.is(Kind::kAdvancedUp)) {
    cursor.advance();
    return parse_pushed_up(cursor, value.place);
  } else if (cursor.take("^")) {
    value.kind = Value::Kind::kBare;
  } else if (cursor.is("if")) {
    cursor.advance();
    return parse_rule(cursor, value.place);
  } else if (cursor.take("(")) {
    value.kind = Value::Kind::kList;
    if (cursor.enter()) {
      value.list = parse_settings(cursor, ")", "at the end of the list");
      cursor.leave();
    }
  } else {
    value.kind = Value::Kind::kExpr;
    value.expr = parse_expression(cursor);
  }
  value.place = cursor.since(value.place);
  return value;
}

// True at `name =`, `name[`, `name<1,2> =`, `name<1,2>|text| =`: an assignment, and no expression.
bool is_assignment(const Cursor& cursor) {
  if (cursor.is(Kind::kPushed)) return true;
  if (!cursor.is(Kind::kName)) return false;
  std::size_t n = 1;
  if (cursor.is("[", n)) return true;
  if (cursor.is("<", n)) n += 5;
  if (cursor.token(n).kind == Kind::kDescription) ++n;
  return cursor.is("=", n);
}

Setting parse_setting(Cursor& cursor) {
  Setting setting;
  if (!is_assignment(cursor)) {
    setting.value.kind = Value::Kind::kExpr;
    setting.value.place = cursor.here();
    setting.value.expr = parse_expression(cursor);
    return setting;
  }
  setting.is_pushed = cursor.is(Kind::kPushed);
  setting.name = cursor.take_word();
  if (cursor.take("[")) {
    // An index is only a label; files written by hand number their elements.
    if (cursor.is(Kind::kNumber)) {
      setting.index = cursor.take_word();
    } else {
      setting.index = cursor.expect_name("a name between the brackets");
    }
    cursor.expect("]", "behind the name of the element");
  }
  setting.spot = cursor.take_spot();
  if (cursor.expect("=", "behind the name of a parameter")) setting.value = parse_value(cursor);
  return setting;
}

std::vector<Setting> parse_settings(Cursor& cursor, std::string_view closing, std::string_view why) {
  std::vector<Setting> settings;
  while (!cursor.failed() && !cursor.take(closing)) {
    settings.push_back(parse_setting(cursor));
    if (cursor.failed()) break;
    if (!cursor.take(",") && !cursor.is(closing)) {
      cursor.expect(closing, std::string(why) + ", or `,`");
      break;
    }
  }
  return settings;
}

ExprPtr parse_bare_expression(Cursor& cursor) {
  auto expr = std::make_shared<Expr>();
  const text::Place start = cursor.here();
  while (cursor.is(Kind::kInline)) expr->inline_names.push_back(cursor.take_word());
  if (cursor.is("[")) {
    expr->kind = Expr::Kind::kGroup;
    expr->settings = parse_members(cursor);
  } else {
    expr->name = cursor.expect_name("a name, a constant in braces or a group in brackets");
    if (cursor.failed()) return nullptr;
    expr->spot = cursor.take_spot();
    if (cursor.is("(")) {
      expr->kind = Expr::Kind::kInstance;
      expr->settings = parse_arguments(cursor);
    }
  }
  if (cursor.failed()) return nullptr;
  const Spot spot = cursor.take_spot();
  if (spot.has_position || !spot.label.text.empty()) expr->spot = spot;
  expr->place = cursor.since(start);
  return expr;
}

}  // namespace

std::vector<Setting> parse_arguments(Cursor& cursor) {
  if (!cursor.expect("(", "behind the name of a class")) return {};
  return parse_settings(cursor, ")", "at the end of the arguments");
}

std::vector<Setting> parse_members(Cursor& cursor) {
  if (!cursor.expect("[", "at the start of a group")) return {};
  if (!cursor.enter()) return {};
  std::vector<Setting> members = parse_settings(cursor, "]", "at the end of the group");
  cursor.leave();
  return members;
}

ExprPtr parse_expression(Cursor& cursor) {
  if (!cursor.enter()) return nullptr;
  ExprPtr expr = parse_bare_expression(cursor);
  cursor.leave();
  return expr;
}

}  // namespace mlab::cdl_historic
