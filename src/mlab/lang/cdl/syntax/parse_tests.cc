// Tests beside components: what is sensed, and what is expected.

#include <string>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/syntax/cursor.h"

namespace mlab::cdl {
namespace {

using Kind = TestStep::Kind;
using When = TestStep::When;
using About = TestStep::About;

// `10 cycles`, `2 s`
bool parse_test_span(Cursor& cursor, Number& into) {
  std::optional<Number> span = parse_quantity(cursor);
  if (span) into = std::move(*span);
  return span.has_value();
}

// `given obstacle(at = [2 m, 0 m]);`, `given no obstacle;`
bool parse_given(Cursor& cursor, TestStep& into) {
  cursor.advance_word();
  if (cursor.could_be({"no"}) && !cursor.is_before("(")) {
    into.kind = Kind::kGivenNo;
    into.percept.has_parentheses = false;
    cursor.advance_word();
    return cursor.read_name(into.percept.callee, "what is no longer sensed");
  }
  into.kind = Kind::kGiven;
  if (cursor.is(Token::Kind::kName)) return parse_call(cursor, "what is sensed", into.percept);
  return cursor.read_name(into.percept.callee, "what is sensed, such as `obstacle(at = [2 m, 0 m])`");
}

bool parse_test_wait(Cursor& cursor, TestStep& into) {
  into.kind = Kind::kAfter;
  cursor.advance_word();
  return parse_test_span(cursor, into.span);
}

// `state Searching`, `no action PickUp`. Where something else follows these are names of a condition.
bool at_fact(const Cursor& cursor) {
  const bool is_typed = cursor.keeps_parts() && cursor.is_before(Token::Kind::kEnd);
  return cursor.is_any({"state", "action"}) &&
         (cursor.is_before_name() || cursor.is_before_path_and(";") || is_typed);
}

bool parse_fact(Cursor& cursor, TestStep& into) {
  into.about = cursor.is("state") ? About::kState : About::kAction;
  cursor.advance_word();
  return into.about == About::kState ? read_path(cursor, into.fact, "the name of a state")
                                     : cursor.read_name(into.fact, "the name of an action");
}

bool parse_expectation(Cursor& cursor, TestStep& into) {
  into.kind = Kind::kExpect;
  cursor.advance_word();
  if (cursor.could_be({"within", "for"}) && cursor.is_before(Token::Kind::kNumber)) {
    into.when = cursor.is("within") ? When::kWithin : When::kFor;
    cursor.advance_word();
    const bool is_read =
        parse_test_span(cursor, into.span) && cursor.expect(":", "and what is expected meanwhile");
    if (!is_read) {
      into.condition = cursor.hole();
      return false;
    }
  }
  cursor.could_be({"state", "action"});
  if (at_fact(cursor)) return parse_fact(cursor, into);
  if (cursor.is("no") && (cursor.is_before("state") || cursor.is_before("action"))) {
    into.is_negated = true;
    cursor.advance_word();
    return parse_fact(cursor, into);
  }
  const bool is_read = parse_expression(cursor, into.condition);
  if (!into.condition) into.condition = cursor.hole();
  return is_read;
}

bool parse_step(Cursor& cursor, std::vector<TestStep>& into) {
  TestStep step;
  const std::uint32_t begin = cursor.begin();
  step.help = cursor.help_above();
  bool is_read = false;
  if (cursor.could_be({"given"})) {
    is_read = parse_given(cursor, step);
  } else if (cursor.could_be({"after"})) {
    is_read = parse_test_wait(cursor, step);
  } else if (cursor.could_be({"expect"})) {
    is_read = parse_expectation(cursor, step);
  } else {
    cursor.expected("`given`, `expect`, `after` or `let`");
    return false;
  }
  step.place = cursor.since(begin);
  const bool is_whole = is_read && cursor.expect_semicolon("behind this step of the test");
  step.whole = cursor.span_since(begin);
  if (cursor.keeps(is_read)) into.push_back(std::move(step));
  return is_whole;
}

// `"turns away" of AvoidStaticObstacles(...) on Scout`
bool parse_test_head(Cursor& cursor, Test& into) {
  into.name.place = cursor.here();
  std::optional<std::string> name = cursor.read_text("what the test shows, in quotes");
  if (!name) return false;
  into.name.text = std::move(*name);
  if (!cursor.expect("of", "and what is tested")) return false;
  const bool is_read = parse_expression(cursor, into.subject);
  if (!into.subject) into.subject = cursor.hole();
  if (!is_read && !cursor.skip_to({"on", "{"})) return false;
  if (cursor.take("on")) cursor.read_name(into.class_name, "the class of robots that it runs on");
  return true;
}

}  // namespace

bool parse_test(Cursor& cursor, Tree& tree, const std::string& help) {
  Test out;
  const std::uint32_t begin = cursor.begin();
  out.help = help;
  cursor.advance_word();
  const bool is_whole = parse_test_head(cursor, out) && cursor.open("the test");
  if (is_whole) {
    while (!cursor.at_close()) {
      const bool is_let = cursor.could_be({"let"});
      if (!(is_let ? parse_let(cursor, out.lets) : parse_step(cursor, out.steps))) cursor.skip_statement();
    }
    cursor.close();
  }
  return put(cursor, begin, std::move(out), is_whole, tree);
}

}  // namespace mlab::cdl
