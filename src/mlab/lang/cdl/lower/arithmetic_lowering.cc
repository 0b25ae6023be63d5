#include "mlab/lang/cdl/lower/arithmetic_lowering.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "mlab/flow/port_types.h"
#include "mlab/flow/type_words.h"
#include "mlab/lang/cdl/syntax/signs.h"
#include "mlab/lang/cdl/types/units.h"

namespace mlab::cdl {
namespace {

flow::Node computing_node(std::string name, std::string_view behavior, const text::Place& place) {
  flow::Node node;
  node.name = std::move(name);
  node.behavior = behavior;
  node.place = node.behavior_place = place;
  return node;
}

text::Place from_to(const text::Place& first, const text::Place& last) {
  text::Place out = first;
  out.span.end = std::max(first.span.end, last.span.end);
  return out;
}

// All that have a unit have this one, as it is written: then it need not be converted.
std::optional<std::string> common_unit(const auto& operands, const PortType& result) {
  std::string out;
  for (const auto& one : operands) {
    if (one.value.unit.empty()) continue;
    if (!out.empty() && out != one.value.unit) return std::nullopt;
    out = one.value.unit;
  }
  const std::optional<Unit> unit = unit_named(out);
  const std::optional<Unit> wanted = unit_named(result.unit);
  const bool is_kept =
      unit && wanted && (unit->same_dimension(*wanted) || result.type->kind == flow::TypeKind::kBool);
  return is_kept ? std::optional(out) : std::nullopt;
}

}  // namespace

std::optional<ArithmeticLowering::Operand> ArithmeticLowering::operand(const Expression& expression,
                                                                       std::string_view of, std::string angle,
                                                                       Scope& scope) {
  const Value value = values_.value_of(expression, scope);
  Operand out{value, value.type, expression.place, std::move(angle)};
  switch (value.kind) {
    case Value::Kind::kNone:
      return std::nullopt;
    case Value::Kind::kNumber:
      out.type = {&flow::type_info<double>(), value.unit};
      return out;
    case Value::Kind::kWire:
    case Value::Kind::kList:
      return out;
    default:
      break;
  }
  if (value.kind != Value::Kind::kSink && value.type.type != nullptr) return out;
  if (value.kind == Value::Kind::kWord && (value.text == "true" || value.text == "false")) {
    findings_
        .error("wrong-type", expression.place,
               fmt::format("`{}` is of numbers; `{}` is a truth value", of, value.text))
        .hints = {"a truth value is a condition by itself: `on`, and `not on` where it is to be false"};
    return std::nullopt;
  }
  binder_.bind(value, {&flow::type_info<double>(), ""}, nullptr, std::string(of),
               expression.place);  // says what is wrong
  return std::nullopt;
}

void ArithmeticLowering::settle_lists(std::vector<Operand>& operands) {
  std::vector<PortType> types;
  std::vector<bool> is_list;
  for (const Operand& one : operands) {
    types.push_back(one.type);
    is_list.push_back(one.value.kind == Value::Kind::kList);
  }
  cdl::settle_lists(types, is_list);
  for (std::size_t i = 0; i < operands.size(); ++i) operands[i].type = types[i];
}

std::vector<PortType> ArithmeticLowering::types_of(const std::vector<Operand>& operands) {
  std::vector<PortType> out;
  for (const Operand& operand : operands) out.push_back(operand.type);
  return out;
}

void ArithmeticLowering::refuse(const Computation& how, const std::vector<Operand>& operands,
                                const text::Place& place) {
  const bool is_of_two = operands.size() == 2 && !how.refused;
  const text::Place& at = how.refused ? operands[*how.refused].place : is_of_two ? operands[1].place : place;
  text::Diagnostic& d = findings_.error(how.is_about_units ? "wrong-unit" : "wrong-type", at, how.refusal);
  const auto described = [](const PortType& type) {
    if (type.type == nullptr) return std::string("this can't be told");
    const bool is_number = type.type->kind == flow::TypeKind::kReal;
    return is_number ? fmt::format("this is {}", unit_in_words(type.unit))
                     : "this is " + flow::value_of(*type.type, type.unit);
  };
  if (is_of_two) {
    d.label = described(operands[1].type);
    d.notes.push_back({described(operands[0].type), operands[0].place});
  }
  if (!how.hint.empty()) d.hints.push_back(how.hint);
}

Value ArithmeticLowering::fold(const Computation& how, const std::vector<Operand>& operands,
                               const text::Place& place) {
  const std::optional<std::string> unit = common_unit(operands, how.type);
  std::vector<double> numbers;
  for (const std::size_t i : how.order) {
    const Value& value = operands[i].value;
    numbers.push_back(unit ? value.number : unit_named(value.unit).value_or(Unit{}).in_si(value.number));
  }
  Value out;
  const std::optional<double> number = folded(how.behavior, numbers);
  if (!number) return out;
  if (!std::isfinite(*number)) {
    if (how.behavior == "DivideNumbers" && numbers[1] == 0.0)
      findings_.error("division-by-zero", operands[1].place, "this is 0, and nothing can be divided by it");
    else
      findings_.error("number-out-of-range", place, "the result is no number that can be held here");
    return out;
  }
  out.place = place;
  if (how.type.type->kind == flow::TypeKind::kBool) {
    out.kind = Value::Kind::kWord;
    out.text = *number != 0.0 ? "true" : "false";
    out.type = how.type;
    return out;
  }
  out.kind = Value::Kind::kNumber;
  out.number = *number;
  out.unit = unit.value_or(how.type.unit);
  return out;
}

// Procedures of arithmetic say no unit. An angle gets it from a node that takes and gives radians, so that
// who counts in degrees converts it.
Value ArithmeticLowering::in_radians(Value value, const std::string& path, const std::string& angle,
                                     const text::Place& place) {
  flow::Node node = computing_node(path.empty() ? angle : path, "InRadians", place);
  node.links.push_back({"angle", {flow::Source::Kind::kName, value.text, place}, place});
  value.text = node.name;
  value.type.unit = value.counted_in = "rad";
  network_.nodes.push_back(std::move(node));
  return value;
}

void ArithmeticLowering::link_operand(const Operand& operand, const flow::Input& input, flow::Node& node) {
  PortType type = operand.type;
  if (const std::optional<Unit> unit = unit_named(type.unit)) type.unit = si_unit(*unit);
  Value value = operand.value;
  if (value.kind == Value::Kind::kWire &&
      !binder_.is_convertible(value, type, std::string(input.name), operand.place))
    return;
  if (value.kind == Value::Kind::kWire && value.counted_in == "deg")
    value = in_radians(std::move(value), "", operand.angle, operand.place);
  if (auto source = binder_.bind(value, type, nullptr, std::string(input.name), operand.place))
    node.links.push_back({std::string(input.name), std::move(*source), operand.place});
}

Value ArithmeticLowering::compute(const Computation& how, const std::vector<Operand>& operands,
                                  const std::string& path, const text::Place& place) {
  if (!how.refusal.empty()) {
    refuse(how, operands, place);
    return {};
  }
  const flow::Behavior* behavior = library_.find(how.behavior).behavior;
  if (how.type.type == nullptr || behavior == nullptr || behavior->inputs.size() < how.order.size())
    return {};
  const bool is_constant = std::ranges::all_of(
      operands, [](const Operand& one) { return one.value.kind == Value::Kind::kNumber; });
  if (is_constant) return fold(how, operands, place);
  flow::Node node = computing_node(path, how.behavior, place);
  const std::size_t errors_before = findings_.error_count();
  for (std::size_t i = 0; i < how.order.size(); ++i)
    link_operand(operands[how.order[i]], behavior->inputs[i], node);
  if (findings_.error_count() == errors_before) network_.nodes.push_back(std::move(node));
  return wire(path, how.type, place);
}

Value ArithmeticLowering::operations(const Expression& expression, const Arithmetic& arithmetic, Scope& scope,
                                     const std::string& path) {
  const text::Place& place = expression.place;
  std::vector<Operand> operands;
  for (std::size_t i = 0; i < arithmetic.operands.size(); ++i) {
    auto read =
        operand(*arithmetic.operands[i],
                sign_of(arithmetic.operations.empty() ? Operation::kAdd : arithmetic.operations.front()),
                scope.angle_of_operand(expression, i), scope);
    if (read) operands.push_back(std::move(*read));
  }
  if (operands.size() < arithmetic.operands.size() || arithmetic.operations.empty()) return {};
  settle_lists(operands);
  const bool is_signed = arithmetic.operations.front() == Operation::kNegate;
  Operand left = operands.front();
  for (std::size_t i = 0; i < arithmetic.operations.size(); ++i) {
    std::vector<Operand> both = {left};
    if (!is_signed) both.push_back(operands[i + 1]);
    const std::vector<PortType> types = types_of(both);
    const Computation how = computation(arithmetic.operations[i], types);
    const bool is_last = i + 1 == arithmetic.operations.size();
    const bool is_angle = is_last && how.type.unit == "rad";
    const text::Place at = is_last ? place : from_to(operands.front().place, both.back().place);
    Value value = compute(how, both,
                          is_angle  ? scope.angle_of(expression)
                          : is_last ? path
                                    : scope.path_behind(*arithmetic.operands[i + 1]),
                          at);
    if (value.kind == Value::Kind::kNone) return {};
    if (is_angle && value.kind == Value::Kind::kWire) value = in_radians(std::move(value), path, "", place);
    left = {
        value,
        value.kind == Value::Kind::kNumber ? PortType{&flow::type_info<double>(), value.unit} : value.type,
        at, ""};
  }
  return left.value;
}

Value ArithmeticLowering::function(const Expression& expression, const Call& call, const Function& function,
                                   Scope& scope, const std::string& path) {
  const text::Place& place = expression.place;
  if (function.name == kPlaceFunction) return places_.call(call, scope, place);
  const std::vector<std::string> names(function.inputs.begin(), function.inputs.end());
  const std::vector<GivenArgument> given = given_by(call, scope);
  const std::vector<int> matched = arguments_.match(call.callee, given, names);
  std::vector<std::optional<Operand>> read(names.size());
  bool is_right = std::ranges::find(matched, -1) == matched.end();
  for (std::size_t i = 0; i < given.size(); ++i) {
    auto one = operand(*given[i].expression, function.name, scope.angle_of_operand(expression, i), scope);
    is_right = is_right && one.has_value();
    if (matched[i] >= 0) read[static_cast<std::size_t>(matched[i])] = std::move(one);
  }
  std::vector<Operand> operands;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!read[i] && is_right) arguments_.say_missing(call.callee, names[i], {}, std::string(function.help));
    is_right = is_right && read[i].has_value();
    if (is_right) operands.push_back(std::move(*read[i]));
  }
  if (!is_right) return {};
  settle_lists(operands);
  const std::vector<PortType> types = types_of(operands);
  const Computation how = computation(function, types);
  // What gives radians by itself needs nobody to say so.
  const bool is_angle = how.type.unit == "rad" && function.name != "direction";
  Value value = compute(how, operands, is_angle ? scope.angle_of(expression) : path, place);
  if (is_angle && value.kind == Value::Kind::kWire) value = in_radians(std::move(value), path, "", place);
  return value;
}

}  // namespace mlab::cdl
