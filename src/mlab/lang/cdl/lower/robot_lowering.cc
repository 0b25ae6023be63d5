#include "mlab/lang/cdl/lower/robot_lowering.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/flow/port_types.h"
#include "mlab/lang/cdl/types/units.h"

namespace mlab::cdl {
namespace {

// A range in the unit of the parameter.
double in_unit(const Number& number, const std::string& unit) {
  const std::optional<Unit> to = unit_named(unit);
  const std::optional<Unit> from = number.unit.text.empty() ? to : unit_named(number.unit.text);
  return from && to ? converted(number.value, *from, *to).value_or(number.value) : number.value;
}

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

std::map<std::string, double> BodyLowering::body(const RobotClass& robot_class, Scope& scope) {
  std::map<std::string, double> out;
  std::map<std::string_view, const BodySetting*> first;
  for (const BodySetting& setting : robot_class.body) {
    const auto [known, is_new] = first.try_emplace(setting.name.text, &setting);
    if (!is_new) {
      findings_
          .error("duplicate-name", setting.name.place, fmt::format("`{}` is set twice", setting.name.text))
          .notes.push_back({"the first is here", known->second->name.place});
    } else if (const std::optional<double> value = this->setting(setting, scope)) {
      out[setting.name.text] = *value;
    }
  }
  return out;
}

std::optional<double> BodyLowering::setting(const BodySetting& setting, Scope& scope) {
  const Value value = values_.value_of(*setting.value, scope);
  if (value.kind == Value::Kind::kNone) return std::nullopt;
  if (setting.name.text == "drive") return drive(setting, value);
  if (const BodyProperty* property = body_property(setting.name.text))
    return number(setting, *property, value);
  text::Diagnostic& d = findings_.error("unknown-body-setting", setting.name.place,
                                        fmt::format("a body has no `{}`", setting.name.text));
  Findings::hint_nearest(d, setting.name.text, body_settings());
  if (d.hints.empty()) d.hints.push_back(fmt::format("it has {}", fmt::join(body_settings(), ", ")));
  return std::nullopt;
}

std::optional<double> BodyLowering::drive(const BodySetting& setting, const Value& value) {
  const auto* const drive = std::ranges::find(kDrives, value.text);
  if (value.kind == Value::Kind::kWord && drive != kDrives.end())
    return static_cast<double>(drive - kDrives.begin());
  findings_.error("unknown-drive", setting.value->place, "a body has no such drive").hints = {
      fmt::format("there are {}", fmt::join(kDrives, ", "))};
  return std::nullopt;
}

// In SI units; nothing where it is no number of the body's.
std::optional<double> BodyLowering::number(const BodySetting& setting, const BodyProperty& property,
                                           const Value& value) {
  const std::optional<Unit> unit = unit_named(value.unit);
  const std::optional<Unit> wanted = unit_named(property.unit);
  if (value.kind != Value::Kind::kNumber || !unit || !wanted) {
    findings_.error("wrong-type", setting.value->place, "what a body has is a number").label =
        fmt::format("`{}` takes a number with its unit", property.name);
    return std::nullopt;
  }
  // Without a unit it is in SI units.
  switch (body_misfit(property, value.number,
                      value.unit.empty() ? unit_named(si_unit(*wanted)).value() : *unit)) {
    case BodyMisfit::kNone:
      return value.number * unit->numerator / unit->denominator;
    case BodyMisfit::kUnit:
      findings_
          .error("wrong-unit", setting.value->place,
                 fmt::format("`{}` is no quantity of this kind", value.unit))
          .label = property.unit.empty() ? fmt::format("`{}` takes a plain number", property.name)
                                         : fmt::format("`{}` takes {}", property.name, property.unit);
      break;
    case BodyMisfit::kRange:
      findings_
          .error("out-of-range", setting.value->place,
                 fmt::format("{} is out of range", quoted_number(value)))
          .label = fmt::format("`{}` takes {} .. {}{}", property.name, property.min, property.max,
                               bracketed(std::string(property.unit)));
      break;
    case BodyMisfit::kFraction:
      findings_
          .error("out-of-range", setting.value->place,
                 fmt::format("{} is no whole number", quoted_number(value)))
          .label = fmt::format("`{}` takes {} .. {}", property.name, property.min, property.max);
      break;
  }
  return std::nullopt;
}

void RobotLowering::declare_parameter(const Parameter& parameter, Scope& scope) {
  const PortType type = parts_.binder.type_of(parameter);
  Value& value = scope.names[parameter.name.text].value;
  if (type.type == nullptr) return;
  if (!parameter.initial) {
    parts_.findings
        .error("missing-default", parameter.name.place,
               fmt::format("parameter `{}` of a robot has no default", parameter.name.text))
        .hints = {"missions may set it, but need not: `= VALUE` behind its type"};
    value = wire(parameter.name.text, type, parameter.name.place);
    return;
  }
  value = wire(parameter.name.text, type, parameter.name.place);
  const std::string* place_name = parts_.places.name_in(*parameter.initial);
  const Value initial = place_name == nullptr ? parts_.values.value_of(*parameter.initial, scope)
                                              : some_place(parameter.initial->place);
  const auto bound =
      parts_.binder.bind(initial, type, nullptr, parameter.name.text, parameter.initial->place);
  if (!bound || !parts_.binder.check_range(initial, parameter, type)) return;
  if (bound->kind == flow::Source::Kind::kName) {
    parts_.findings.error("wrong-type", parameter.initial->place,
                          "the default of a robot's parameter is a constant");
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
  parts_.network.parameters.push_back(std::move(out));
}

// The class's parameters are the robot's, too; where both have one of a name, the robot's holds.
Scope& RobotLowering::declare_class(const RobotClass& robot_class, Scope& own) {
  Scope& scope = parts_.scopes.add();
  scope.nodes = own.nodes;
  for (const Parameter& parameter : robot_class.parameters) {
    const auto given = own.names.find(parameter.name.text);
    if (given == own.names.end() || given->second.let != nullptr) {
      declare_parameter(parameter, scope);
    } else {
      parts_.binder.fits(given->second.value.type, parts_.binder.type_of(parameter), parameter.name.text,
                         given->second.value.place);
      scope.names[parameter.name.text] = given->second;
    }
  }
  return scope;
}

Scope& RobotLowering::declare(const Robot& robot, LoweredRobot& out) {
  parts_.network.name = robot.name.text;
  Scope& scope = parts_.scopes.add();
  scope.nodes = &parts_.elaboration.names(robot);
  parts_.places.avoid(scope.nodes->top());
  for (const Parameter& parameter : robot.parameters) declare_parameter(parameter, scope);
  scope.declare(robot.lets);
  const RobotClass* robot_class = parts_.equipment.equip(robot);
  if (robot_class == nullptr) return scope;
  Scope& of_class = declare_class(*robot_class, scope);
  parts_.equipment.use_names(of_class);
  out.body = BodyLowering(parts_.findings, parts_.values).body(*robot_class, of_class);
  return scope;
}

void RobotLowering::drive(const Drive& drive, Scope& scope) {
  const Value value = parts_.values.value_of(*drive.value, scope);
  if (value.kind == Value::Kind::kSink) return;  // it is an actuator by itself
  const DeviceUse* use = parts_.equipment.actuator_of(drive);
  if (use == nullptr || !parts_.equipment.drive(*use, drive)) return;
  if (value.kind != Value::Kind::kNone)
    parts_.calls.drive(*use, value, scope.nodes->of(drive), drive.value->place);
}

void RobotLowering::drive(const Robot& robot, Scope& scope) {
  parts_.equipment.check_choices(robot);
  for (const Drive& drive : robot.drives) this->drive(drive, scope);
  if (!robot.drives.empty()) return;
  parts_.findings
      .warning("nothing-driven", robot.name.place,
               fmt::format("nothing drives the robot `{}`", robot.name.text))
      .label = "it will stand still";
}

}  // namespace mlab::cdl
