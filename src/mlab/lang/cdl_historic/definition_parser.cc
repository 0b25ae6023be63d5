#include <optional>
#include <utility>

#include "mlab/lang/cdl_historic/cursor.h"

namespace mlab::cdl_historic {
namespace {

using Kind = Token::Kind;

// The second spelling of a keyword is all in small letters.
bool says(std::string_view word, std::string_view keyword) {
  if (word.size() != keyword.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const char small =
        keyword[i] >= 'A' && keyword[i] <= 'Z' ? static_cast<char>(keyword[i] + 32) : keyword[i];
    if (word[i] != keyword[i] && word[i] != small) return false;
  }
  return true;
}

Word take_architecture(Cursor& cursor) {
  if (!cursor.take("[")) return {};
  Word architecture = cursor.expect_name("the name of an architecture");
  cursor.expect("]", "behind the architecture");
  return architecture;
}

ParamDecl parse_typed(Cursor& cursor) {
  ParamDecl param;
  param.is_const = cursor.take("const");
  param.type = cursor.expect_name("the type of a parameter");
  param.name = cursor.expect_name("the name of a parameter");
  if (cursor.take("=")) {
    if (cursor.is(Kind::kInitializer)) {
      param.initial = cursor.take_word();
    } else {
      cursor.expected("a constant in braces");
    }
  }
  return param;
}

void parse_params(Cursor& cursor, std::vector<ParamDecl>& params) {
  if (!cursor.expect("(", "in front of the parameters")) return;
  while (!cursor.failed() && !cursor.take(")")) {
    const bool is_list = cursor.take("list");
    const bool is_related = is_list && cursor.take("[");
    do {
      params.push_back(parse_typed(cursor));
      params.back().is_list = is_list;
    } while (is_related && !cursor.failed() && cursor.take(","));
    if (is_related) cursor.expect("]", "behind related lists");
    if (!cursor.take(",") && !cursor.is(")")) cursor.expect(")", "behind the parameters, or `,`");
  }
}

void parse_slots(Cursor& cursor, std::vector<SlotDecl>& slots) {
  if (!cursor.expect("(", "in front of the robot's devices")) return;
  while (!cursor.failed() && !cursor.take(")")) {
    SlotDecl slot;
    slot.is_actuator = cursor.is("actuator");
    if (!slot.is_actuator && !cursor.is("sensor")) {
      cursor.expected("`sensor` or `actuator`");
      return;
    }
    cursor.advance();
    if (!cursor.is(Kind::kInline)) {
      cursor.expected("a name with a colon behind it");
      return;
    }
    slot.name = cursor.take_word();
    slot.device_class = cursor.expect_name("the class of a device");
    slots.push_back(std::move(slot));
    if (!cursor.take(",") && !cursor.is(")")) cursor.expect(")", "behind the devices, or `,`");
  }
}

// What an editor shows of a type means nothing here.
void parse_type(Cursor& cursor, Tree& tree) {
  take_architecture(cursor);
  Word name = cursor.expect_name("the name of a type");
  if (!name.text.empty()) tree.types.push_back(std::move(name));
  while (!cursor.is(";") && !cursor.at_end() && !starts_statement(cursor.text())) cursor.advance();
}

void parse_named_value(Cursor& cursor, Tree& tree) {
  NamedValue value;
  value.name = cursor.expect_name("the name of a value");
  cursor.expect("ForDataType", "behind the name");
  value.type = cursor.expect_name("a type");
  cursor.expect("=", "behind the type");
  if (!cursor.is(Kind::kInitializer)) {
    cursor.expected("a constant in braces");
    return;
  }
  value.value = cursor.take_word();
  tree.named_values.push_back(std::move(value));
}

std::optional<Definition::Kind> definition_kind(std::string_view keyword) {
  using enum Definition::Kind;
  if (says(keyword, "defAgent")) return kAgent;
  if (says(keyword, "defOp")) return kOperator;
  if (says(keyword, "defIBP")) return kInputPoint;
  if (says(keyword, "defOBP")) return kOutputPoint;
  if (says(keyword, "defRBP")) return kRobotPoint;
  if (says(keyword, "defSensor")) return kSensor;
  if (says(keyword, "defActuator")) return kActuator;
  if (says(keyword, "defRobot")) return kRobot;
  return std::nullopt;
}

bool is_style(std::string_view word) {
  return word == "FSAstyle" || word == "SELECTstyle" || word == "MDLstyle" || word == "RLstyle";
}

}  // namespace

void parse_definition(Cursor& cursor, std::string_view keyword, Tree& tree) {
  if (says(keyword, "defType")) {
    parse_type(cursor, tree);
    return;
  }
  if (keyword == "defNamedValue") {
    parse_named_value(cursor, tree);
    return;
  }
  if (says(keyword, "defArch")) {
    Word name = cursor.expect_name("the name of an architecture");
    if (!name.text.empty()) tree.own_architectures.push_back(std::move(name));
    return;
  }
  const std::optional<Definition::Kind> kind = definition_kind(keyword);
  if (!kind) {
    cursor.expected("a statement");
    return;
  }
  Definition definition;
  definition.kind = *kind;
  definition.architecture = take_architecture(cursor);
  if (cursor.take("binds")) definition.binds = cursor.expect_name("what it binds");
  const bool is_untyped = *kind == Definition::Kind::kRobotPoint || *kind == Definition::Kind::kRobot;
  if (!is_untyped) definition.type = cursor.expect_name("a type");
  definition.name = cursor.expect_name("the name of a class");
  if (cursor.is(Kind::kName) && is_style(cursor.text())) definition.style = cursor.take_word();
  if (cursor.is(Kind::kDescription)) definition.label = cursor.take_word();
  if (*kind == Definition::Kind::kRobot) {
    parse_slots(cursor, definition.slots);
  } else {
    parse_params(cursor, definition.params);
  }
  if (!cursor.failed()) tree.definitions.push_back(std::move(definition));
}

}  // namespace mlab::cdl_historic
