// Robots: parameters that missions set, devices that serve binding points, what drives the actuators.

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/flow/port_types.h"
#include "mlab/lang/cdl/lower/lowering.h"
#include "mlab/lang/cdl/types/body.h"
#include "mlab/lang/cdl/types/units.h"

namespace mlab::cdl {
namespace {

// A range in the unit of the parameter.
double in_unit(const Number& number, const std::string& unit) {
  const std::optional<Unit> to = unit_named(unit);
  const std::optional<Unit> from = number.unit.text.empty() ? to : unit_named(number.unit.text);
  return from && to ? converted(number.value, *from, *to).value_or(number.value) : number.value;
}

const NamesBelow kNothing;

// What stands for a named place until a mission says where it is.
Value some_place(const text::Place& place) {
  Value out;
  out.kind = Value::Kind::kWord;
  out.text = "{0, 0}";
  out.type = {&flow::type_info<geom::Point>(), "m"};
  out.place = place;
  return out;
}

}  // namespace

void Lowering::declare_lets(const std::vector<Let>& lets, Scope& scope) {
  for (const Let& let : lets) {
    Scope::Named& named = scope.names[let.name.text];
    named.let = &let;
    named.state = Scope::Named::State::kWaiting;
  }
}

void Lowering::declare_network_parameter(const Parameter& parameter, Scope& scope) {
  const PortType type = type_of(parameter);
  Value& value = scope.names[parameter.name.text].value;
  if (type.type == nullptr) return;
  if (!parameter.initial) {
    error("missing-default", parameter.name.place,
          fmt::format("parameter `{}` of a robot has no default", parameter.name.text))
        .hints = {"missions may set it, but need not: `= VALUE` behind its type"};
    value = wire(parameter.name.text, type, parameter.name.place);
    return;
  }
  value = wire(parameter.name.text, type, parameter.name.place);
  const std::string* place_name = named_place(*parameter.initial);
  const Value initial =
      place_name == nullptr ? lower(*parameter.initial, scope) : some_place(parameter.initial->place);
  const auto bound = bind(initial, type, nullptr, parameter.name.text, parameter.initial->place);
  if (!bound || !check_range(initial, parameter, type)) return;
  if (bound->kind == flow::Source::Kind::kName) {
    error("wrong-type", parameter.initial->place, "the default of a robot's parameter is a constant");
    return;
  }
  flow::Parameter out;
  out.name = parameter.name.text;
  out.type = std::string(type.type->name);
  out.unit = type.unit;
  out.help = parameter.help;
  out.initial = *bound;
  out.place = parameter.name.place;
  if (place_name != nullptr) out.place_name = {*place_name, parameter.initial->place};
  if (parameter.low) out.min = in_unit(*parameter.low, type.unit);
  if (parameter.high) out.max = in_unit(*parameter.high, type.unit);
  network_.parameters.push_back(std::move(out));
}

// The class's parameters are the robot's, too; where both have one of a name, the robot's holds.
Scope& Lowering::declare_class(const RobotClass& robot_class, Scope& own) {
  Scope& scope = new_scope();
  scope.nodes = own.nodes;
  for (const Parameter& parameter : robot_class.parameters) {
    const auto given = own.names.find(parameter.name.text);
    if (given == own.names.end() || given->second.let != nullptr) {
      declare_network_parameter(parameter, scope);
    } else {
      fits(given->second.value.type, type_of(parameter), parameter.name.text, given->second.value.place);
      scope.names[parameter.name.text] = given->second;
    }
  }
  return scope;
}

void Lowering::find_devices(const Robot& robot, Scope& own, LoweredRobot& out) {
  devices_ = elaboration_.devices(robot);
  if (robot.class_name.text.empty()) return;
  const auto found = configuration_.classes.find(robot.class_name.text);
  if (found == configuration_.classes.end()) {
    text::Diagnostic& d = error("unknown-class", robot.class_name.place,
                                fmt::format("unknown class of robots `{}`", robot.class_name.text));
    hint_nearest(d, robot.class_name.text, names_in(configuration_.classes));
    class_is_broken_ = true;
    return;
  }
  const RobotClass& robot_class = *found->second;
  class_name_ = robot_class.name.text;
  class_place_ = robot.class_name.place;
  class_scope_ = &declare_class(robot_class, own);
  for (const Device& device : robot_class.devices)
    class_is_broken_ |= !configuration_.bindings.contains(device.binds.text);
  lower_body(robot_class, *class_scope_, out);
}

void Lowering::choose_devices(const Robot& robot) {
  for (const Choice& choice : robot.choices) {
    const Device* chosen = nullptr;
    std::vector<std::string> names;
    for (const DeviceUse& use : devices_) {
      if (use.overrides) continue;
      names.push_back(use.device->name.text);
      if (use.device->name.text == choice.device.text) chosen = use.device;
    }
    if (chosen == nullptr) {
      if (class_is_broken_) continue;
      text::Diagnostic& d =
          error("unknown-device", choice.device.place,
                fmt::format("class `{}` has no device `{}`", class_name_, choice.device.text));
      hint_nearest(d, choice.device.text, names);
    } else if (chosen->binds.text != choice.binding.text) {
      error("wrong-device", choice.binding.place,
            fmt::format("`{}` serves `{}`, not `{}`", choice.device.text, chosen->binds.text,
                        choice.binding.text))
          .notes.push_back({"the device is here", chosen->name.place});
    }
  }
}

void Lowering::lower_body(const RobotClass& robot_class, Scope& scope, LoweredRobot& out) {
  std::map<std::string_view, const BodySetting*> set;
  for (const BodySetting& setting : robot_class.body) {
    const auto [first, is_new] = set.try_emplace(setting.name.text, &setting);
    if (!is_new) {
      error("duplicate-name", setting.name.place, fmt::format("`{}` is set twice", setting.name.text))
          .notes.push_back({"the first is here", first->second->name.place});
      continue;
    }
    const Value value = lower(*setting.value, scope);
    if (value.kind == Value::Kind::kNone) continue;
    if (setting.name.text == "drive") {
      const auto* const drive = std::ranges::find(kDrives, value.text);
      if (value.kind == Value::Kind::kWord && drive != kDrives.end()) {
        out.body["drive"] = static_cast<double>(drive - kDrives.begin());
      } else {
        error("unknown-drive", setting.value->place, "a body has no such drive").hints = {
            fmt::format("there are {}", fmt::join(kDrives, ", "))};
      }
      continue;
    }
    const BodyProperty* property = body_property(setting.name.text);
    if (property == nullptr) {
      text::Diagnostic& d = error("unknown-body-setting", setting.name.place,
                                  fmt::format("a body has no `{}`", setting.name.text));
      hint_nearest(d, setting.name.text, body_settings());
      if (d.hints.empty()) d.hints.push_back(fmt::format("it has {}", fmt::join(body_settings(), ", ")));
      continue;
    }
    if (const auto number = body_number(setting, *property, value)) out.body[setting.name.text] = *number;
  }
}

// In SI units; nothing where it is no number of the body's.
std::optional<double> Lowering::body_number(const BodySetting& setting, const BodyProperty& property,
                                            const Value& value) {
  const std::optional<Unit> unit = unit_named(value.unit);
  const std::optional<Unit> wanted = unit_named(property.unit);
  if (value.kind != Value::Kind::kNumber || !unit || !wanted) {
    error("wrong-type", setting.value->place, "what a body has is a number").label =
        fmt::format("`{}` takes a number with its unit", property.name);
    return std::nullopt;
  }
  // Without a unit it is in SI units.
  switch (body_misfit(property, value.number,
                      value.unit.empty() ? unit_named(si_unit(*wanted)).value() : *unit)) {
    case BodyMisfit::kNone:
      return value.number * unit->numerator / unit->denominator;
    case BodyMisfit::kUnit:
      error("wrong-unit", setting.value->place, fmt::format("`{}` is no quantity of this kind", value.unit))
          .label = property.unit.empty() ? fmt::format("`{}` takes a plain number", property.name)
                                         : fmt::format("`{}` takes {}", property.name, property.unit);
      break;
    case BodyMisfit::kRange:
      error("out-of-range", setting.value->place, fmt::format("{} is out of range", quoted_number(value)))
          .label = fmt::format("`{}` takes {} .. {}{}", property.name, property.min, property.max,
                               bracketed(std::string(property.unit)));
      break;
    case BodyMisfit::kFraction:
      error("out-of-range", setting.value->place, fmt::format("{} is no whole number", quoted_number(value)))
          .label = fmt::format("`{}` takes {} .. {}", property.name, property.min, property.max);
      break;
  }
  return std::nullopt;
}

// The actuator that a drive speaks of, by the device's name or by the binding point.
const DeviceUse* Lowering::actuator_of(const Drive& drive) {
  const auto [found, fitting] = actuator_for(devices_, drive.binding.text);
  if (fitting.size() > 1) {
    error("several-devices", drive.binding.place,
          fmt::format("several devices of `{}` serve `{}`: {}", class_name_, drive.binding.text,
                      fmt::join(fitting, ", ")))
        .hints = {fmt::format("drive one by its name: `{} = ...;`", fitting.front())};
  }
  if (found == nullptr && !class_is_broken_) {
    std::vector<std::string> names;
    for (const DeviceUse& use : devices_) {
      if (use.device->is_actuator) names.insert(names.end(), {use.device->name.text, use.device->binds.text});
    }
    text::Diagnostic& d =
        error("unknown-actuator", drive.binding.place,
              fmt::format("robot `{}` has no actuator `{}`", robot_name_.text, drive.binding.text));
    const std::string nearest = text::nearest_name(drive.binding.text, names);
    if (!nearest.empty()) {
      d.hints.push_back(fmt::format("did you mean `{}`?", nearest));
    } else if (class_name_.empty()) {
      d.hints.push_back(fmt::format("say what it is: `robot {} is CLASS`", robot_name_.text));
      class_is_broken_ = true;
    } else if (!names.empty()) {
      d.hints.push_back(fmt::format("class `{}` has {}", class_name_, fmt::join(names, ", ")));
    }
  }
  return found;
}

void Lowering::drive_device(const DeviceUse& use, const Value& value, const std::string& path,
                            const text::Place& place) {
  const Device& device = *use.device;
  Scope& scope = device_scope(use, {path, &kNothing});
  std::vector<Given> given = given_by(device.by, scope);
  const auto binding = configuration_.bindings.find(device.binds.text);
  std::string input;
  if (binding != configuration_.bindings.end() && !binding->second->parameters.empty()) {
    const Parameter& driven = binding->second->parameters.front();
    input = driven.name.text;
    if (value.kind == Value::Kind::kWire && !fits(value.type, type_of(driven), device.binds.text, place))
      return;
  }
  given.push_back({{input, device.by.callee.place}, nullptr, nullptr, value, place});
  if (input.empty()) std::ranges::rotate(given, given.end() - 1);  // by position, the first
  const Value out = instantiate(device.by.callee, given, {path, &scope.nodes->top()}, device.name.place);
  if (out.kind == Value::Kind::kWire) {
    error("not-an-actuator", device.by.callee.place,
          fmt::format("`{}` gives a value and moves nothing", device.by.callee.text))
        .hints = {"an actuator is a `procedure void`, such as Drive"};
  }
}

void Lowering::lower_drive(const Drive& drive, Scope& scope) {
  const Value value = lower(*drive.value, scope);
  if (value.kind == Value::Kind::kSink) return;  // it is an actuator by itself
  const DeviceUse* use = actuator_of(drive);
  if (use == nullptr) return;
  if (!driven_.insert(use->device).second) {
    error("driven-twice", drive.binding.place, fmt::format("`{}` is driven twice", use->device->name.text))
        .hints = {"`cooperate` or `compete` makes one movement of two"};
    return;
  }
  if (value.kind != Value::Kind::kNone) drive_device(*use, value, scope.nodes->of(drive), drive.value->place);
}

LoweredRobot Lowering::robot(const Robot& robot) {
  LoweredRobot out;
  robot_name_ = robot.name;
  network_.name = robot.name.text;
  Scope& scope = new_scope();
  scope.nodes = &elaboration_.names(robot);
  robot_names_ = &scope.nodes->top();
  for (const Parameter& parameter : robot.parameters) declare_network_parameter(parameter, scope);
  declare_lets(robot.lets, scope);
  find_devices(robot, scope, out);
  choose_devices(robot);
  for (const Drive& drive : robot.drives) lower_drive(drive, scope);
  if (robot.drives.empty()) {
    warning("nothing-driven", robot.name.place, fmt::format("nothing drives the robot `{}`", robot.name.text))
        .label = "it will stand still";
  }
  out.network = std::move(network_);
  return out;
}

// Parameters as somebody will give them: their defaults, or a value of their type.
void Lowering::declare_typed(const std::vector<Parameter>& parameters, Scope& scope) {
  for (const Parameter& parameter : parameters) {
    Value& value = scope.names[parameter.name.text].value;
    const PortType type = type_of(parameter);
    if (parameter.initial) {
      value = default_of(parameter, scope);
    } else if (type.type != nullptr) {
      value = wire(parameter.name.text, type, parameter.name.place);
    }
  }
}

void Lowering::check_assemblage(const Assemblage& assemblage) {
  is_checking_ = true;
  Scope& scope = new_scope();
  scope.path = assemblage.name.text;
  scope.nodes = &elaboration_.names(assemblage, std::vector<bool>(assemblage.parameters.size(), false), {});
  inside_ = &assemblage;
  declare_typed(assemblage.parameters, scope);
  open_.push_back(&assemblage);
  const Value out = lower_assemblage(assemblage, scope, assemblage.name.place);
  for (const Let& let : assemblage.lets) lower_let(scope.names[let.name.text], scope);
  open_.pop_back();
  const bool is_constant = out.kind == Value::Kind::kWord || out.kind == Value::Kind::kText;
  if (is_constant) bind(out, types_.named("Vector"), nullptr, assemblage.name.text, assemblage.body->place);
}

void Lowering::check_device(const Device& device) {
  const auto found = configuration_.bindings.find(device.binds.text);
  if (found == configuration_.bindings.end()) {
    text::Diagnostic& d = error("unknown-binding", device.binds.place,
                                fmt::format("unknown binding point `{}`", device.binds.text));
    hint_nearest(d, device.binds.text, names_in(configuration_.bindings));
    return;
  }
  const Binding& binding = *found->second;
  const bool is_actuator = binding.result_type.text.empty();
  if (is_actuator) {
    Value driven;
    if (!binding.parameters.empty())
      driven = wire("driven", type_of(binding.parameters.front()), device.name.place);
    if (driven.kind != Value::Kind::kNone)
      drive_device({&device}, driven, device.name.text, device.by.callee.place);
    return;
  }
  if (!fits(types_.of_call(device.by.callee), type_named(binding.result_type), device.binds.text,
            device.by.callee.place))
    return;
  std::vector<Given> asked;
  for (const Parameter& parameter : binding.parameters) {
    const PortType type = type_of(parameter);
    asked.push_back({{parameter.name.text, device.by.callee.place},
                     nullptr,
                     nullptr,
                     wire(parameter.name.text, type, device.by.callee.place),
                     device.by.callee.place});
  }
  const Value value = serve({&device}, std::move(asked), {device.name.text, &kNothing}, device.name.place);
  if (value.kind == Value::Kind::kWire)
    fits(value.type, type_named(binding.result_type), device.binds.text, device.by.callee.place);
}

void Lowering::check_class(const RobotClass& robot_class) {
  is_checking_ = true;
  Scope& scope = new_scope();
  scope.nodes = &kUnnamed;
  class_scope_ = &scope;
  declare_typed(robot_class.parameters, scope);
  for (const Device& device : robot_class.devices) check_device(device);
  LoweredRobot ignored;
  lower_body(robot_class, scope, ignored);
}

void Lowering::check_operator(const SocietyOperator& op) {
  is_checking_ = true;
  for (const Device& device : op.devices) check_device(device);
}

}  // namespace mlab::cdl
