// Arithmetic: operations, functions, named places.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/flow/port_types.h"
#include "mlab/lang/cdl/lower/lowering.h"
#include "mlab/lang/cdl/lower/naming.h"
#include "mlab/lang/cdl/syntax/signs.h"
#include "mlab/lang/cdl/types/arithmetic.h"
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

std::optional<Lowering::Operand> Lowering::operand(const Expression& expression, std::string_view of,
                                                   std::string angle, Scope& scope) {
  const Value value = lower(expression, scope);
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
    error("wrong-type", expression.place, fmt::format("`{}` is of numbers; `{}` is a bool", of, value.text))
        .hints = {"a bool is a condition by itself: `on`, and `not on` where it is to be false"};
    return std::nullopt;
  }
  bind(value, {&flow::type_info<double>(), ""}, nullptr, std::string(of),
       expression.place);  // says what is wrong
  return std::nullopt;
}

void Lowering::settle_lists(std::vector<Operand>& operands) {
  std::vector<PortType> types;
  std::vector<bool> is_list;
  for (const Operand& one : operands) {
    types.push_back(one.type);
    is_list.push_back(one.value.kind == Value::Kind::kList);
  }
  cdl::settle_lists(types, is_list);
  for (std::size_t i = 0; i < operands.size(); ++i) operands[i].type = types[i];
}

void Lowering::refuse(const Computation& how, const std::vector<Operand>& operands,
                      const text::Place& place) {
  const bool is_of_two = operands.size() == 2 && !how.refused;
  const text::Place& at = how.refused ? operands[*how.refused].place : is_of_two ? operands[1].place : place;
  text::Diagnostic& d = error(how.is_about_units ? "wrong-unit" : "wrong-type", at, how.refusal);
  const auto described = [](const PortType& type) {
    if (type.type == nullptr) return std::string("this can't be told");
    const bool is_number = type.type->kind == flow::TypeKind::kReal;
    return is_number ? fmt::format("this is {}", unit_in_words(type.unit))
                     : fmt::format("this is of type {}{}", type.name(), bracketed(type.unit));
  };
  if (is_of_two) {
    d.label = described(operands[1].type);
    d.notes.push_back({described(operands[0].type), operands[0].place});
  }
  if (!how.hint.empty()) d.hints.push_back(how.hint);
}

Value Lowering::fold(const Computation& how, const std::vector<Operand>& operands, const text::Place& place) {
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
      error("division-by-zero", operands[1].place, "this is 0, and nothing can be divided by it");
    else
      error("number-out-of-range", place, "the result is no number that a double can hold");
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
Value Lowering::in_radians(Value value, const std::string& path, const std::string& angle,
                           const text::Place& place) {
  flow::Node node = computing_node(path.empty() ? angle : path, "InRadians", place);
  node.links.push_back({"angle", {flow::Source::Kind::kName, value.text, place}, place});
  value.text = node.name;
  value.type.unit = value.counted_in = "rad";
  network_.nodes.push_back(std::move(node));
  return value;
}

void Lowering::link_operand(const Operand& operand, const flow::Input& input, flow::Node& node) {
  PortType type = operand.type;
  if (const std::optional<Unit> unit = unit_named(type.unit)) type.unit = si_unit(*unit);
  Value value = operand.value;
  if (value.kind == Value::Kind::kWire &&
      !is_convertible(value, type, std::string(input.name), operand.place))
    return;
  if (value.kind == Value::Kind::kWire && value.counted_in == "deg")
    value = in_radians(std::move(value), "", operand.angle, operand.place);
  if (auto source = bind(value, type, nullptr, std::string(input.name), operand.place))
    node.links.push_back({std::string(input.name), std::move(*source), operand.place});
}

Value Lowering::compute(const Computation& how, const std::vector<Operand>& operands, const std::string& path,
                        const text::Place& place) {
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
  const std::size_t errors_before = sink_.error_count();
  for (std::size_t i = 0; i < how.order.size(); ++i)
    link_operand(operands[how.order[i]], behavior->inputs[i], node);
  if (sink_.error_count() == errors_before) network_.nodes.push_back(std::move(node));
  return wire(path, how.type, place);
}

Value Lowering::lower_arithmetic(const Expression& expression, const Arithmetic& arithmetic, Scope& scope,
                                 const std::string& path, const text::Place& place) {
  std::vector<Operand> operands;
  for (std::size_t i = 0; i < arithmetic.operands.size(); ++i) {
    auto read =
        operand(*arithmetic.operands[i],
                sign_of(arithmetic.operations.empty() ? Operation::kAdd : arithmetic.operations.front()),
                angle_of_operand(expression, i, scope), scope);
    if (read) operands.push_back(std::move(*read));
  }
  if (operands.size() < arithmetic.operands.size() || arithmetic.operations.empty()) return {};
  settle_lists(operands);
  const bool is_signed = arithmetic.operations.front() == Operation::kNegate;
  Operand left = operands.front();
  for (std::size_t i = 0; i < arithmetic.operations.size(); ++i) {
    std::vector<Operand> both = {left};
    if (!is_signed) both.push_back(operands[i + 1]);
    std::vector<PortType> types;
    for (const Operand& one : both) types.push_back(one.type);
    const Computation how = computation(arithmetic.operations[i], types);
    const bool is_last = i + 1 == arithmetic.operations.size();
    const bool is_angle = is_last && how.type.unit == "rad";
    const text::Place at = is_last ? place : from_to(operands.front().place, both.back().place);
    Value value = compute(how, both,
                          is_angle  ? angle_of(expression, scope)
                          : is_last ? path
                                    : path_behind(*arithmetic.operands[i + 1], scope),
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

Value Lowering::call_function(const Expression& expression, const Call& call, const Function& function,
                              Scope& scope, const Spot& spot, const text::Place& place) {
  if (function.name == kPlaceFunction) return call_place(call, scope, place);
  const std::vector<std::string> names(function.inputs.begin(), function.inputs.end());
  const std::vector<Given> given = given_by(call, scope);
  const std::vector<int> matched = match(call.callee, given, names);
  std::vector<std::optional<Operand>> read(names.size());
  bool is_right = std::ranges::find(matched, -1) == matched.end();
  for (std::size_t i = 0; i < given.size(); ++i) {
    auto one = operand(*given[i].value, function.name, angle_of_operand(expression, i, scope), scope);
    is_right = is_right && one.has_value();
    if (matched[i] >= 0) read[static_cast<std::size_t>(matched[i])] = std::move(one);
  }
  std::vector<Operand> operands;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!read[i] && is_right) say_missing(call.callee, names[i], {}, std::string(function.help));
    is_right = is_right && read[i].has_value();
    if (is_right) operands.push_back(std::move(*read[i]));
  }
  if (!is_right) return {};
  settle_lists(operands);
  std::vector<PortType> types;
  for (const Operand& one : operands) types.push_back(one.type);
  const Computation how = computation(function, types);
  // What gives radians by itself needs nobody to say so.
  const bool is_angle = how.type.unit == "rad" && function.name != "direction";
  Value value = compute(how, operands, is_angle ? angle_of(expression, scope) : spot.path, place);
  if (is_angle && value.kind == Value::Kind::kWire)
    value = in_radians(std::move(value), spot.path, "", place);
  return value;
}

const std::string* Lowering::named_place(const Expression& expression) const {
  const auto* call = std::get_if<Call>(&expression.what);
  const bool is_place = call != nullptr && call->callee.text == kPlaceFunction &&
                        call->arguments.size() == 1 && types_.function(call->callee) != nullptr;
  if (!is_place) return nullptr;
  const Argument& name = call->arguments.front();
  const auto* text = std::get_if<Text>(&name.value->what);
  const bool is_named = name.name.text.empty() || name.name.text == "name";
  return text == nullptr || text->value.empty() || !is_named ? nullptr : &text->value;
}

// Different names may become the same when only letters, digits and `_` are left of them.
std::string Lowering::place_parameter(std::string_view place) {
  std::string stem = "place_";
  for (const char c : place) stem += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  int& count = place_stems_[stem];
  for (;;) {
    std::string out = ++count == 1 ? stem : fmt::format("{}_{}", stem, count);
    const bool is_taken = robot_names_ != nullptr && robot_names_->contains(out);
    if (!is_taken && place_names_.insert(out).second) return out;
  }
}

Value Lowering::call_place(const Call& call, Scope& scope, const text::Place& place) {
  Expression whole;
  whole.what = call;
  const std::string* name = named_place(whole);
  if (name == nullptr) {
    const std::vector<int> matched = match(call.callee, given_by(call, scope), {"name"});
    if (std::ranges::find(matched, -1) == matched.end())
      error("wrong-type", call.arguments.empty() ? place : call.arguments.front().value->place,
            "a place is named by a text")
          .hints = {"`place(\"Gate\")` is where the mission's overlay has Gate"};
    return {};
  }
  const PortType type{&flow::type_info<geom::Point>(), "m"};
  const auto [known, is_new] = places_.try_emplace(*name);
  if (!is_new) return wire(known->second, type, place);
  const std::string path = known->second = place_parameter(*name);
  flow::Parameter parameter;
  parameter.name = path;
  parameter.type = std::string(type.type->name);
  parameter.unit = type.unit;
  parameter.help = fmt::format("where `{}` lies in the mission's overlay", *name);
  parameter.initial = {flow::Source::Kind::kConstant, "{0, 0}", place};
  parameter.place = place;
  parameter.place_name = {*name, place};
  network_.parameters.push_back(std::move(parameter));
  return wire(path, type, place);
}

}  // namespace mlab::cdl
