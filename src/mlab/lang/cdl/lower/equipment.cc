#include "mlab/lang/cdl/lower/equipment.h"

#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

namespace mlab::cdl {

const RobotClass* Equipment::equip(const Robot& robot) {
  robot_name_ = robot.name;
  devices_ = elaboration_.devices(robot);
  if (robot.class_name.text.empty()) return nullptr;
  const auto found = configuration_.classes.find(robot.class_name.text);
  if (found == configuration_.classes.end()) {
    text::Diagnostic& d = findings_.error("unknown-class", robot.class_name.place,
                                          fmt::format("unknown class of robots `{}`", robot.class_name.text));
    Findings::hint_nearest(d, robot.class_name.text, names_in(configuration_.classes));
    class_is_broken_ = true;
    return nullptr;
  }
  const RobotClass& robot_class = *found->second;
  class_name_ = robot_class.name.text;
  class_place_ = robot.class_name.place;
  for (const Device& device : robot_class.devices)
    class_is_broken_ |= !configuration_.bindings.contains(device.binds.text);
  return &robot_class;
}

bool Equipment::drive(const DeviceUse& use, const Drive& drive) {
  if (driven_.insert(use.device).second) return true;
  findings_
      .error("driven-twice", drive.binding.place, fmt::format("`{}` is driven twice", use.device->name.text))
      .hints = {"`cooperate` or `compete` makes one movement of two"};
  return false;
}

void Equipment::check_choices(const Robot& robot) {
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
          findings_.error("unknown-device", choice.device.place,
                          fmt::format("class `{}` has no device `{}`", class_name_, choice.device.text));
      Findings::hint_nearest(d, choice.device.text, names);
    } else if (chosen->binds.text != choice.binding.text) {
      findings_
          .error("wrong-device", choice.binding.place,
                 fmt::format("`{}` serves `{}`, not `{}`", choice.device.text, chosen->binds.text,
                             choice.binding.text))
          .notes.push_back({"the device is here", chosen->name.place});
    }
  }
}

Scope& Equipment::scope_of(const DeviceUse& use, const Spot& spot) {
  Scope& out = scopes_.add();
  if (!use.overrides && class_scope_ != nullptr) out.names = class_scope_->names;
  out.path = spot.path;
  out.nodes = &elaboration_.names(*use.device, *spot.taken);
  return out;
}

const DeviceUse* Equipment::serving(const Word& binding) {
  const auto [found, fitting] = device_for(devices_, binding.text);
  const text::Place& place = class_name_.empty() ? robot_name_.place : class_place_;
  if (fitting.size() > 1) {
    findings_
        .error("several-devices", place,
               fmt::format("several devices of `{}` serve `{}`: {}", class_name_, binding.text,
                           fmt::join(fitting, ", ")))
        .hints = {fmt::format("choose one: `use {} for {};`", fitting.front(), binding.text)};
  }
  if (found == nullptr && !class_is_broken_) {
    const std::string who = class_name_.empty() ? fmt::format("robot `{}`", robot_name_.text)
                                                : fmt::format("class `{}`", class_name_);
    text::Diagnostic& d = findings_.error("device-not-offered", place,
                                          fmt::format("{} has nothing that serves `{}`", who, binding.text));
    d.hints.push_back(class_name_.empty()
                          ? fmt::format("say what it is: `robot {} is CLASS`", robot_name_.text)
                          : fmt::format("the class needs `sensor NAME: ... binds {};`", binding.text));
    d.notes.push_back({"asked for here", binding.place});
    class_is_broken_ = class_name_.empty();
  }
  return found;
}

const DeviceUse* Equipment::actuator_of(const Drive& drive) {
  const auto [found, fitting] = actuator_for(devices_, drive.binding.text);
  if (fitting.size() > 1) {
    findings_
        .error("several-devices", drive.binding.place,
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
        findings_.error("unknown-actuator", drive.binding.place,
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

}  // namespace mlab::cdl
