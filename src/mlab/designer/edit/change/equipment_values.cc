#include "mlab/designer/edit/change/equipment_values.h"

#include <algorithm>
#include <string>

#include <fmt/core.h>

#include "mlab/designer/edit/find/devices.h"
#include "mlab/designer/edit/values.h"
#include "mlab/lang/cdl/types/body.h"
#include "mlab/lang/cdl/types/units.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

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

// Those behind one that goes are said by name from now on.
bool name_arguments(Workspace& work, const cdl::Call& call, const Callable& component,
                    const cdl::Argument* gone) {
  bool is_behind = false;
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    const cdl::Argument& argument = call.arguments[i];
    if (is_behind && argument.name.text.empty()) {
      if (i >= component.inputs.size()) return false;
      work.changes().change<cdl::Argument>(
          argument, [name = component.inputs[i].name](cdl::Argument& now) { now.name.text = name; });
    }
    is_behind |= &argument == gone;
  }
  return true;
}

Done set_body(Workspace& work, const SetValue& change) {
  const cdl::RobotClass* robot_class = equipped(work.model(), change.page()).robot_class;
  if (robot_class == nullptr) return refusal("only a class of robots has a body");
  const std::string& name = change.port();
  const cdl::BodyProperty* property = cdl::body_property(name);
  if (property == nullptr && name != "drive")
    return refusal(fmt::format("a body has no `{}`", text::shown(name)));
  const auto known = std::ranges::find_if(
      robot_class->body, [&](const cdl::BodySetting& setting) { return setting.name.text == name; });
  if (change.value().empty()) {
    if (known != robot_class->body.end()) work.changes().remove(*known);
    return work.commit();
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
    work.changes().replace(*known->value, value);
  } else {
    work.changes().change<cdl::RobotClass>(
        *robot_class, [name, value](cdl::RobotClass& now) { now.body.push_back({{name, {}}, value}); });
  }
  return work.commit();
}

}  // namespace

Done set_equipment_value(Workspace& work, const SetValue& change) {
  if (change.node().starts_with(kBodyNode)) return set_body(work, change);
  const text::Result<DeviceSpot> spot = find_device(work.model(), change.page(), change.node());
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
    if (!name_arguments(work, call, *spot->by, known)) return refusal("nothing of its component takes that");
    work.changes().remove(*known);
    return work.commit();
  }
  const cdl::ExpressionPtr value = typed_value(change.value());
  if (!value) return refusal(fmt::format("`{}` is no value", text::shown(change.value())));
  if (known != nullptr && known->value) {
    work.changes().replace(*known->value, value);
  } else {
    work.changes().change<cdl::Call>(call, [name = change.port(), value](cdl::Call& now) {
      now.arguments.push_back({{name, {}}, value});
    });
  }
  return work.commit();
}

}  // namespace mlab::designer
