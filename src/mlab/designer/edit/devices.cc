// Classes of robots: their bodies and devices; operators of societies; binding points.

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/drawing/serving.h"
#include "mlab/designer/edit/editor.h"
#include "mlab/designer/edit/values.h"
#include "mlab/lang/cdl/types/body.h"
#include "mlab/lang/cdl/types/units.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

const cdl::Argument* argument_of(const cdl::Call& call, const Callable& component, std::string_view name) {
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    const cdl::Argument& argument = call.arguments[i];
    const std::string_view called = !argument.name.text.empty()   ? std::string_view(argument.name.text)
                                    : i < component.inputs.size() ? std::string_view(component.inputs[i].name)
                                                                  : std::string_view();
    if (called == name) return &argument;
  }
  return nullptr;
}

// The arguments of a call that another component takes as well, by name.
std::vector<cdl::Argument> kept_arguments(const cdl::Call& call, const Callable* before,
                                          const Callable& now) {
  std::vector<cdl::Argument> out;
  for (std::size_t i = 0; before != nullptr && i < call.arguments.size(); ++i) {
    const cdl::Argument& argument = call.arguments[i];
    if (argument.name.text.empty() && i >= before->inputs.size()) continue;
    const std::string name = argument.name.text.empty() ? before->inputs[i].name : argument.name.text;
    const auto had = std::ranges::find(before->inputs, name, &Socket::name);
    const auto takes = std::ranges::find(now.inputs, name, &Socket::name);
    if (had == before->inputs.end() || takes == now.inputs.end()) continue;
    if (why_not(had->type, takes->type).empty()) out.push_back({{name, {}}, argument.value});
  }
  return out;
}

// A number that somebody typed for a property is in the unit that its field shows.
cdl::ExpressionPtr in_unit_of(const cdl::BodyProperty& property, const cdl::ExpressionPtr& value,
                              const std::string& typed) {
  const auto* number = std::get_if<cdl::Number>(&value->what);
  if (number == nullptr || !number->unit.text.empty() || property.unit.empty()) return value;
  return value_of(fmt::format("{} {}", typed, property.unit));
}

// Of a number alone: what a formula or a parameter gives is the checker's.
std::string why_not_property(const cdl::BodyProperty& property, const cdl::Expression& value) {
  const auto* number = std::get_if<cdl::Number>(&value.what);
  const bool is_word = std::holds_alternative<cdl::Name>(value.what);
  const bool is_computed = std::holds_alternative<cdl::Arithmetic>(value.what);
  if (number == nullptr) return is_word || is_computed ? "" : fmt::format("`{}` is a number", property.name);
  const auto unit = cdl::unit_named(number->unit.text);
  switch (unit ? cdl::body_misfit(property, number->value, *unit) : cdl::BodyMisfit::kUnit) {
    case cdl::BodyMisfit::kNone:
      return "";
    case cdl::BodyMisfit::kUnit:
      return property.unit.empty() ? fmt::format("`{}` is a plain number", property.name)
                                   : fmt::format("`{}` is in {}", property.name, property.unit);
    case cdl::BodyMisfit::kRange:
      return fmt::format("`{}` is {} .. {}{}{}", property.name, property.min, property.max,
                         property.unit.empty() ? "" : " ", property.unit);
    case cdl::BodyMisfit::kFraction:
      return fmt::format("`{}` is a whole number", property.name);
  }
  return "";
}

}  // namespace

// ---- what is spoken of

text::Result<const cdl::Binding*> Editor::binding(const std::string& name) const {
  const auto& bindings = work_.model().configuration().bindings;
  const auto found = bindings.find(name);
  if (found == bindings.end())
    return refusal(fmt::format("there is no binding point `{}`", text::shown(name)));
  return found->second;
}

text::Result<Callable> Editor::server(const std::string& component, const cdl::Binding& binding) const {
  const std::optional<Callable>& by = work_.model().components().find(component);
  if (!by) return refusal(fmt::format("nothing answers to `{}`", text::shown(component)));
  const std::string reason = why_not_serving(*by, binding, work_.model().components());
  if (!reason.empty())
    return refusal(fmt::format("`{}` can't serve `{}`: {}", by->name, binding.name.text, reason));
  return *by;
}

std::string Editor::free_device_name(const Equipped& owner, const std::string& binding) const {
  std::set<std::string> taken;
  for (const cdl::Device& device : owner.devices()) taken.insert(device.name.text);
  constexpr std::string_view kSense = "sense_";
  if (binding.starts_with(kSense)) return unique(binding.substr(kSense.size()), taken);
  // Not as the binding point itself: what drives it would be said by either name.
  return unique(binding == "movement" ? "base" : binding + "_device", taken);
}

// ---- devices

Done Editor::set_device(const SetDevice& change) {
  const Equipped owner = equipped(work_.model(), change.owner());
  if (!owner) return refusal(fmt::format("there is no class or operator `{}`", text::shown(change.owner())));
  if (change.device().empty()) return add_device(owner, change);
  const text::Result<DeviceSpot> spot = find_device(work_.model(), change.owner(), change.device());
  if (!spot) return std::unexpected(spot.error());
  const cdl::Device& old = *spot->device;
  const std::string binds = change.has_binds() ? change.binds() : old.binds.text;
  const text::Result<const cdl::Binding*> point = binding(binds);
  if (!point) return std::unexpected(point.error());
  const text::Result<Callable> by =
      server(change.has_component() ? change.component() : old.by.callee.text, **point);
  if (!by) return std::unexpected(by.error());
  const bool is_other = by->name != old.by.callee.text;
  if (!is_other && binds == old.binds.text) return true;
  if (owner.society_operator != nullptr && binds != old.binds.text && owner.device(binds) != nullptr)
    return refusal(fmt::format("`{}` is served already", binds));
  cdl::Device now = old;
  now.whole = {};
  now.binds = {binds, {}};
  now.is_actuator = (*point)->result_type.text.empty();
  if (is_other) {
    now.by.callee = {by->name, {}};
    now.by.arguments = kept_arguments(old.by, spot->by, *by);
  }
  if (owner.society_operator != nullptr) now.name = now.binds;
  work_.changes().change<cdl::Device>(old, [now](cdl::Device& there) { there = now; });
  if (binds != old.binds.text) drop_choices(change.owner(), old.name.text);
  return work_.commit();
}

Done Editor::add_device(const Equipped& owner, const SetDevice& change) {
  const text::Result<const cdl::Binding*> point = binding(change.binds());
  if (!point) return std::unexpected(point.error());
  const text::Result<Callable> by = server(change.component(), **point);
  if (!by) return std::unexpected(by.error());
  if (owner.society_operator != nullptr && owner.device(change.binds()) != nullptr)
    return refusal(fmt::format("`{}` is served already", change.binds()));
  cdl::Device fresh;
  fresh.is_actuator = (*point)->result_type.text.empty();
  fresh.by.callee.text = by->name;
  fresh.binds.text = change.binds();
  if (owner.robot_class != nullptr) {
    fresh.name.text = free_device_name(owner, change.binds());
    work_.changes().change<cdl::RobotClass>(*owner.robot_class,
                                            [fresh](cdl::RobotClass& now) { now.devices.push_back(fresh); });
  } else {
    fresh.name.text = change.binds();
    work_.changes().change<cdl::SocietyOperator>(
        *owner.society_operator, [fresh](cdl::SocietyOperator& now) { now.devices.push_back(fresh); });
  }
  return work_.commit();
}

// Robots of the class that chose it for what it serves no more.
void Editor::drop_choices(const std::string& robot_class, const std::string& device) {
  for (const cdl::Item& item : work_.model().tree().items) {
    const auto* robot = std::get_if<cdl::Robot>(&item);
    if (robot == nullptr || robot->class_name.text != robot_class) continue;
    for (const cdl::Choice& choice : robot->choices) {
      if (choice.device.text == device) work_.changes().remove(choice);
    }
  }
}

Done Editor::remove_devices(const Remove& change) {
  if (change.nodes().empty()) return refusal("nothing is chosen");
  std::set<std::string> seen;
  for (const std::string& name : change.nodes()) {
    if (!seen.insert(name).second) continue;
    if (name.starts_with(kBodyNode)) return refusal("every robot has a body: its numbers can be changed");
    if (name.starts_with(kPointNode))
      return refusal("a binding point stands here as long as a device serves it or a robot asks for it");
    const text::Result<DeviceSpot> spot = find_device(work_.model(), change.page(), name);
    if (!spot) return std::unexpected(spot.error());
    work_.changes().remove(*spot->device);
    if (spot->owner.robot_class != nullptr) drop_choices(change.page(), name);
  }
  return work_.commit();
}

// ---- values

Done Editor::set_equipment_value(const SetValue& change) {
  if (change.node().starts_with(kBodyNode)) return set_body(change);
  const text::Result<DeviceSpot> spot = find_device(work_.model(), change.page(), change.node());
  if (!spot) return std::unexpected(spot.error());
  const cdl::Call& call = spot->device->by;
  const auto* input = spot->by == nullptr ? nullptr : [&]() -> const Socket* {
    const auto found = std::ranges::find(spot->by->inputs, change.port(), &Socket::name);
    return found == spot->by->inputs.end() ? nullptr : &*found;
  }();
  if (input == nullptr)
    return refusal(
        fmt::format("`{}` has no input `{}`", text::shown(change.node()), text::shown(change.port())));
  const cdl::Argument* known = argument_of(call, *spot->by, change.port());
  if (change.value().empty()) {
    if (known == nullptr) return refusal("nothing is said there");
    if (!name_arguments(call, *spot->by, known)) return refusal("nothing of its component takes that");
    work_.changes().remove(*known);
    return work_.commit();
  }
  const cdl::ExpressionPtr value = typed_value(change.value());
  if (!value) return refusal(fmt::format("`{}` is no value", text::shown(change.value())));
  if (known != nullptr && known->value) {
    work_.changes().replace(*known->value, value);
  } else {
    work_.changes().change<cdl::Call>(call, [name = change.port(), value](cdl::Call& now) {
      now.arguments.push_back({{name, {}}, value});
    });
  }
  return work_.commit();
}

// Those behind one that goes are said by name from now on.
bool Editor::name_arguments(const cdl::Call& call, const Callable& component, const cdl::Argument* gone) {
  bool is_behind = false;
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    const cdl::Argument& argument = call.arguments[i];
    if (is_behind && argument.name.text.empty()) {
      if (i >= component.inputs.size()) return false;
      work_.changes().change<cdl::Argument>(
          argument, [name = component.inputs[i].name](cdl::Argument& now) { now.name.text = name; });
    }
    is_behind |= &argument == gone;
  }
  return true;
}

Done Editor::set_body(const SetValue& change) {
  const cdl::RobotClass* robot_class = equipped(work_.model(), change.page()).robot_class;
  if (robot_class == nullptr) return refusal("only a class of robots has a body");
  const std::string& name = change.port();
  const cdl::BodyProperty* property = cdl::body_property(name);
  if (property == nullptr && name != "drive")
    return refusal(fmt::format("a body has no `{}`", text::shown(name)));
  const auto known = std::ranges::find_if(
      robot_class->body, [&](const cdl::BodySetting& setting) { return setting.name.text == name; });
  if (change.value().empty()) {
    if (known != robot_class->body.end()) work_.changes().remove(*known);
    return work_.commit();
  }
  cdl::ExpressionPtr value = typed_value(change.value());
  if (!value) return refusal(fmt::format("`{}` is no value", text::shown(change.value())));
  if (property == nullptr) {
    const auto* word = std::get_if<cdl::Name>(&value->what);
    if (word == nullptr || std::ranges::find(cdl::kDrives, word->name.text) == cdl::kDrives.end())
      return refusal(fmt::format("a body has no drive `{}`", text::shown(change.value())));
  } else {
    value = in_unit_of(*property, value, change.value());
    if (!value) return refusal(fmt::format("`{}` is no value", text::shown(change.value())));
    const std::string reason = why_not_property(*property, *value);
    if (!reason.empty()) return refusal(reason);
  }
  if (known != robot_class->body.end() && known->value) {
    work_.changes().replace(*known->value, value);
  } else {
    work_.changes().change<cdl::RobotClass>(
        *robot_class, [name, value](cdl::RobotClass& now) { now.body.push_back({{name, {}}, value}); });
  }
  return work_.commit();
}

// A number of the body, or an input of a device, becomes a parameter of the class.
Done Editor::expose_equipment(const Expose& change) {
  const cdl::RobotClass* robot_class = equipped(work_.model(), change.page()).robot_class;
  if (robot_class == nullptr) return refusal("an operator of societies has no parameters");
  const std::string name = change.parameter().empty() ? change.port() : change.parameter();
  if (!is_cdl_name(name)) return refusal(fmt::format("`{}` is no name", text::shown(name)));
  const bool is_known = std::ranges::any_of(robot_class->parameters,
                                            [&](const cdl::Parameter& one) { return one.name.text == name; });
  text::Result<SetParameter> parameter = exposed(change, *robot_class);
  if (!parameter) return std::unexpected(parameter.error());
  if (parameter->initial() == name) return refusal(fmt::format("`{}` is one already", name));
  if (is_known && change.parameter().empty())
    return refusal(fmt::format("there is a parameter `{}` already: type its name", name));
  if (!is_known) {
    parameter->set_owner(change.page());
    parameter->set_name(name);
    if (const Done done = set_parameter(*parameter); !done) return done;
  }
  SetValue reads;
  reads.set_page(change.page());
  reads.set_node(change.node());
  reads.set_port(change.port());
  reads.set_value(name);
  return set_equipment_value(reads);
}

// The type and default of the parameter that something becomes.
text::Result<SetParameter> Editor::exposed(const Expose& change, const cdl::RobotClass& robot_class) const {
  SetParameter out;
  if (change.node().starts_with(kBodyNode)) {
    const cdl::BodyProperty* property = cdl::body_property(change.port());
    if (property == nullptr) return refusal("what drive it has is no parameter");
    const auto known = std::ranges::find_if(robot_class.body, [&](const cdl::BodySetting& setting) {
      return setting.name.text == property->name;
    });
    const bool is_said = known != robot_class.body.end() && known->value;
    // A parameter is in SI units; its default may be in any.
    const auto unit = cdl::unit_named(property->unit);
    out.set_type(property->unit.empty() ? "number" : fmt::format("double [{}]", cdl::si_unit(*unit)));
    out.set_initial(is_said ? text_of(*known->value) : std::string(property->initial));
    return out;
  }
  const text::Result<DeviceSpot> spot = find_device(work_.model(), change.page(), change.node());
  if (!spot) return std::unexpected(spot.error());
  if (spot->by == nullptr) return refusal("what type it has can't be told");
  const auto socket = std::ranges::find(spot->by->inputs, change.port(), &Socket::name);
  if (socket == spot->by->inputs.end() || socket->type.type == nullptr)
    return refusal("what type it has can't be told");
  const cdl::Argument* known = argument_of(spot->device->by, *spot->by, change.port());
  out.set_type(type_words(socket->type));
  out.set_initial(known != nullptr && known->value ? text_of(*known->value) : socket->initial);
  if (out.initial().empty()) return refusal("it needs a value first: a class's parameters have defaults");
  return out;
}

std::string Editor::text_of(const cdl::Expression& expression) const {
  const text::Span span = expression.place.span;
  return std::string(work_.text().substr(span.begin, span.end - span.begin));
}

// ---- wires and what is placed

// A wire between a device and the binding point that it is to serve.
Done Editor::connect_device(const Connect& change) {
  const bool is_sensor = change.to_node().starts_with(kPointNode);
  const std::string& device = is_sensor ? change.from_node() : change.to_node();
  const std::string& point = is_sensor ? change.to_node() : change.from_node();
  if (!point.starts_with(kPointNode)) return refusal("a device leads to a binding point");
  SetDevice bound;
  bound.set_owner(change.page());
  bound.set_device(device);
  bound.set_binds(point.substr(kPointNode.size()));
  if (device.empty()) return refusal("a device leads to a binding point");
  return set_device(bound);
}

Done Editor::place_device(const Place& change) {
  const Equipped owner = equipped(work_.model(), change.page());
  const std::optional<Callable>& by = work_.model().components().find(change.component());
  if (!by) return refusal(fmt::format("nothing answers to `{}`", text::shown(change.component())));
  const std::string binds = point_for(owner, *by);
  if (binds.empty()) return refusal(fmt::format("`{}` can serve no binding point that is known", by->name));
  SetDevice fresh;
  fresh.set_owner(change.page());
  fresh.set_binds(binds);
  fresh.set_component(by->name);
  const std::string name = owner.robot_class != nullptr ? free_device_name(owner, binds) : binds;
  if (const Done done = set_device(fresh); !done) return done;
  return arrange_one(work_, change.page(), name, change);
}

// One that nothing serves yet before those that are served.
std::string Editor::point_for(const Equipped& owner, const Callable& by) const {
  std::string served;
  for (const auto& [name, binding] : work_.model().configuration().bindings) {
    if (!why_not_serving(by, *binding, work_.model().components()).empty()) continue;
    const bool is_served = std::ranges::any_of(
        owner.devices(), [&](const cdl::Device& device) { return device.binds.text == name; });
    if (!is_served) return name;
    if (served.empty()) served = name;
  }
  return owner.robot_class != nullptr ? served : "";
}

// ---- binding points

Done Editor::set_binding(const SetBinding& change) {
  const cdl::Binding* binding = work_.model().binding(change.binding());
  if (binding == nullptr)
    return refusal(fmt::format("there is no binding point `{}`", text::shown(change.binding())));
  if (change.type() == binding->result_type.text) return true;
  const bool is_known =
      change.type().empty() || work_.model().components().types().named(change.type()).type != nullptr;
  if (!is_known) return refusal(fmt::format("there is no type `{}`", text::shown(change.type())));
  work_.changes().change<cdl::Binding>(
      *binding, [type = change.type()](cdl::Binding& now) { now.result_type.text = type; });
  return work_.commit();
}

// ---- a class for a robot

Done Editor::add_class_for(const std::string& name, const std::string& robot_name) {
  const cdl::Robot* robot = work_.model().robot(robot_name);
  if (robot == nullptr) return refusal(fmt::format("there is no robot `{}`", text::shown(robot_name)));
  const std::set<std::string> overridden = overridden_bindings(work_.model().configuration(), *robot);
  for (const std::string& asked : requested_bindings(work_.model().configuration(), *robot)) {
    const std::string component = overridden.contains(asked) ? "" : usual_component(work_.model(), asked);
    if (component.empty()) continue;
    SetDevice fresh;
    fresh.set_owner(name);
    fresh.set_binds(asked);
    fresh.set_component(component);
    if (const Done done = set_device(fresh); !done) return done;
  }
  SetClass bound;
  bound.set_robot(robot_name);
  bound.set_class_name(name);
  return set_class(bound);
}

}  // namespace mlab::designer
