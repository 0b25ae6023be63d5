#include "mlab/lang/cdl/lower/declaration_check.h"

#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/lower/robot_lowering.h"

namespace mlab::cdl {
// Parameters as somebody will give them: their defaults, or a value of their type.
void DeclarationCheck::declare(const std::vector<Parameter>& parameters, Scope& scope) {
  for (const Parameter& parameter : parameters) {
    Value& value = scope.names[parameter.name.text].value;
    const PortType type = parts_.binder.type_of(parameter);
    if (parameter.initial) {
      value = parts_.calls.default_of(parameter, scope);
    } else if (type.type != nullptr) {
      value = wire(parameter.name.text, type, parameter.name.place);
    }
  }
}

void DeclarationCheck::check(const Assemblage& assemblage) {
  Scope& scope = parts_.scopes.add();
  scope.path = assemblage.name.text;
  const std::vector<bool> given(assemblage.parameters.size(), false);
  scope.nodes = &parts_.elaboration.names(assemblage, given, {});
  const Findings::Inside inside(parts_.findings, assemblage);
  declare(assemblage.parameters, scope);
  const Value out = parts_.calls.check_value(assemblage, scope);
  const bool is_constant = out.kind == Value::Kind::kWord || out.kind == Value::Kind::kText;
  if (!is_constant) return;
  parts_.binder.bind(out, parts_.types.named("Vector"), nullptr, assemblage.name.text,
                     assemblage.body->place);
}

void DeclarationCheck::check(const Device& device) {
  const auto found = parts_.configuration.bindings.find(device.binds.text);
  if (found == parts_.configuration.bindings.end()) {
    text::Diagnostic& d = parts_.findings.error("unknown-binding", device.binds.place,
                                                fmt::format("unknown binding point `{}`", device.binds.text));
    Findings::hint_nearest(d, device.binds.text, names_in(parts_.configuration.bindings));
    return;
  }
  const Binding& binding = *found->second;
  const bool is_actuator = binding.result_type.text.empty();
  if (!is_actuator) {
    check_sensor(device, binding);
  } else if (!binding.parameters.empty()) {
    const Value driven = wire("driven", parts_.binder.type_of(binding.parameters.front()), device.name.place);
    parts_.calls.drive({&device}, driven, device.name.text, device.by.callee.place);
  }
}

void DeclarationCheck::check_sensor(const Device& device, const Binding& binding) {
  const text::Place& place = device.by.callee.place;
  if (!parts_.binder.fits(parts_.types.of_call(device.by.callee),
                          parts_.binder.type_named(binding.result_type), device.binds.text, place))
    return;
  std::vector<GivenArgument> asked;
  for (const Parameter& parameter : binding.parameters) {
    const PortType type = parts_.binder.type_of(parameter);
    asked.push_back(
        {{parameter.name.text, place}, nullptr, nullptr, wire(parameter.name.text, type, place), place});
  }
  const Value value =
      parts_.calls.serve({&device}, std::move(asked), {device.name.text, &kNothingBelow}, device.name.place);
  if (value.kind == Value::Kind::kWire)
    parts_.binder.fits(value.type, parts_.binder.type_named(binding.result_type), device.binds.text, place);
}

void DeclarationCheck::check(const RobotClass& robot_class) {
  Scope& scope = parts_.scopes.add();
  scope.nodes = &kUnnamed;
  parts_.equipment.use_names(scope);
  declare(robot_class.parameters, scope);
  for (const Device& device : robot_class.devices) check(device);
  BodyLowering(parts_.findings, parts_.values).body(robot_class, scope);
}

void DeclarationCheck::check(const SocietyOperator& op) {
  for (const Device& device : op.devices) check(device);
}

}  // namespace mlab::cdl
