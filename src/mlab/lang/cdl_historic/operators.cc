// Coordination operators and logic.

#include <fmt/core.h>

#include "mlab/lang/cdl_historic/constants.h"
#include "mlab/lang/cdl_historic/converter.h"
#include "mlab/text/shown.h"

namespace mlab::cdl_historic {
namespace {

bool is_list_element(const Setting& setting, std::string_view name) {
  return !setting.is_pushed && setting.name.text == name && setting.value.kind != Value::Kind::kNone;
}

const Setting* setting_of(const Expr& expr, std::string_view name) {
  for (const Setting& setting : expr.settings) {
    if (is_list_element(setting, name)) return &setting;
  }
  return nullptr;
}

}  // namespace

// Members and weights belong together by their positions; the names between the brackets mean nothing.
TypedDraft Converter::make_cooperation(const Expr& expr, const Level* own) {
  cdl::Cooperate cooperate;
  Port port;
  port.type = "Vector";
  for (const Setting& setting : expr.settings) {
    if (!is_list_element(setting, "members")) continue;
    const TypedDraft member = make_value(setting, own, port, "");
    if (member.expr != nullptr) cooperate.members.push_back({nullptr, member.expr, {}});
  }
  port.type = "double";
  std::size_t weights = 0;
  for (const Setting& setting : expr.settings) {
    if (!is_list_element(setting, "weight")) continue;
    if (weights < cooperate.members.size()) {
      TypedDraft weight = make_value(setting, own, port, "");
      if (weight.expr == nullptr) weight.expr = number(1.0, "", setting.name.place);
      cooperate.members[weights].weight = weight.expr;
    }
    ++weights;
  }
  if (weights != cooperate.members.size()) {
    sink_.warning("list-lengths", expr.name.place,
                  fmt::format("{} members and {} weights; members without one count once",
                              cooperate.members.size(), weights));
  }
  if (cooperate.members.empty()) return nothing("Vector", expr.place);
  return {draft(std::move(cooperate), expr.place), "Vector"};
}

TypedDraft Converter::make_logic(const Expr& expr, const Level* own) {
  cdl::Logic logic;
  const std::string& name = expr.name.text;
  logic.connective = name == "NOT"   ? cdl::Connective::kNot
                     : name == "AND" ? cdl::Connective::kAnd
                                     : cdl::Connective::kOr;
  Port port;
  port.type = "bool";
  for (const std::string_view operand : {"a", "b"}) {
    if (operand == "b" && name == "NOT") continue;
    const Setting* setting = setting_of(expr, operand);
    TypedDraft value = setting == nullptr ? TypedDraft{} : make_value(*setting, own, port, "");
    if (value.expr == nullptr) value = nothing("bool", expr.name.place);
    logic.operands.push_back(value.expr);
  }
  return {draft(std::move(logic), expr.place), "bool"};
}

// The blackboard is gone: what a node read from it is what it was at the start.
TypedDraft Converter::make_blackboard(const Expr& expr, const Level* own) {
  const std::string& name = expr.name.text;
  Port port;
  port.type = name == "DATABASE_BOOLEAN" ? "bool"
              : name == "DATABASE_INT"   ? "int"
              : name == "DATABASE_VEC"   ? "Vector"
                                         : "double";
  const Setting* key = setting_of(expr, "key");
  const std::string said = key == nullptr || key->value.kind != Value::Kind::kConstant
                               ? std::string("?")
                               : key->value.constant.text;
  warn_once("blackboard", said, expr.name.place,
            fmt::format("the blackboard's {} is what it was at the start; nothing here changes it",
                        text::shown(said)));
  const Setting* initial = setting_of(expr, port.type == "Vector" ? "new_vector" : "initial");
  TypedDraft value = initial == nullptr ? TypedDraft{} : make_value(*initial, own, port, "");
  return value.expr == nullptr ? nothing(port.type, expr.name.place) : value;
}

// What the console's current command asks for. That a task is done the mission executive finds out by itself.
TypedDraft Converter::make_console_operator(const Expr& expr, const Level* own) {
  struct Task {
    std::string_view input;
    std::string_view task;
  };
  static constexpr Task kTasks[] = {{"moveto", "MoveTo"}, {"teleop", "Teleoperate"}, {"occupy", "Occupy"}};
  const Signature* task = vocabulary_.find("GetActiveTask");
  Port port;
  port.type = "Vector";
  cdl::Select select;
  for (const Task& known : kTasks) {
    const Setting* setting = setting_of(expr, known.input);
    const TypedDraft member = setting == nullptr ? TypedDraft{} : make_value(*setting, own, port, "");
    if (member.expr == nullptr) continue;
    select.cases.push_back({{{std::string(known.task), expr.name.place}}, member.expr, expr.place});
  }
  if (task == nullptr || select.cases.empty()) return make_instance_hole(expr, own, "Vector");
  select.by = call(task->name, expr.name.place);
  select.cases.push_back({{}, nothing("Vector", expr.place).expr, expr.place});
  return {draft(std::move(select), expr.place), "Vector"};
}

}  // namespace mlab::cdl_historic
