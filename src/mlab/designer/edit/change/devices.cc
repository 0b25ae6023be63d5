#include "mlab/designer/edit/change/devices.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "mlab/designer/drawing/serving.h"
#include "mlab/designer/edit/change/layout.h"
#include "mlab/designer/edit/find/devices.h"
#include "mlab/designer/edit/values.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

// ---- what is spoken of

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

text::Result<const cdl::Binding*> find_binding(const Workspace& work, const std::string& name) {
  const auto& bindings = work.model().configuration().bindings;
  const auto found = bindings.find(name);
  if (found == bindings.end())
    return refusal(fmt::format("there is no binding point `{}`", text::shown(name)));
  return found->second;
}

// A component that can serve the binding point.
text::Result<Callable> find_server(const Workspace& work, const std::string& component,
                                   const cdl::Binding& binding) {
  const std::optional<Callable>& by = work.model().components().find(component);
  if (!by) return refusal(fmt::format("nothing answers to `{}`", text::shown(component)));
  const std::string reason = why_not_serving(*by, binding, work.model().components());
  if (!reason.empty())
    return refusal(fmt::format("`{}` can't serve `{}`: {}", by->name, binding.name.text, reason));
  return *by;
}

std::string free_device_name(const Equipped& owner, const std::string& binding) {
  std::set<std::string> taken;
  for (const cdl::Device& device : owner.devices()) taken.insert(device.name.text);
  constexpr std::string_view kSense = "sense_";
  if (binding.starts_with(kSense)) return unique(binding.substr(kSense.size()), taken);
  // Not as the binding point itself: what drives it would be said by either name.
  return unique(binding == "movement" ? "base" : binding + "_device", taken);
}

// One that nothing serves yet before those that are served.
std::string point_for(const Workspace& work, const Equipped& owner, const Callable& by) {
  std::string served;
  for (const auto& [name, binding] : work.model().configuration().bindings) {
    if (!why_not_serving(by, *binding, work.model().components()).empty()) continue;
    const bool is_served = std::ranges::any_of(
        owner.devices(), [&](const cdl::Device& device) { return device.binds.text == name; });
    if (!is_served) return name;
    if (served.empty()) served = name;
  }
  return owner.robot_class != nullptr ? served : "";
}

// ---- parts of changes

Done add_device(Workspace& work, const Equipped& owner, const SetDevice& change) {
  const text::Result<const cdl::Binding*> point = find_binding(work, change.binds());
  if (!point) return std::unexpected(point.error());
  const text::Result<Callable> by = find_server(work, change.component(), **point);
  if (!by) return std::unexpected(by.error());
  if (owner.society_operator != nullptr && owner.device(change.binds()) != nullptr)
    return refusal(fmt::format("`{}` is served already", change.binds()));
  cdl::Device fresh;
  fresh.is_actuator = (*point)->result_type.text.empty();
  fresh.by.callee.text = by->name;
  fresh.binds.text = change.binds();
  if (owner.robot_class != nullptr) {
    fresh.name.text = free_device_name(owner, change.binds());
    work.changes().change<cdl::RobotClass>(*owner.robot_class,
                                           [fresh](cdl::RobotClass& now) { now.devices.push_back(fresh); });
  } else {
    fresh.name.text = change.binds();
    work.changes().change<cdl::SocietyOperator>(
        *owner.society_operator, [fresh](cdl::SocietyOperator& now) { now.devices.push_back(fresh); });
  }
  return work.commit();
}

// Robots of the class that chose it for what it serves no more.
void drop_choices(Workspace& work, const std::string& robot_class, const std::string& device) {
  for (const cdl::Item& item : work.model().tree().items) {
    const auto* robot = std::get_if<cdl::Robot>(&item);
    if (robot == nullptr || robot->class_name.text != robot_class) continue;
    for (const cdl::Choice& choice : robot->choices) {
      if (choice.device.text == device) work.changes().remove(choice);
    }
  }
}

}  // namespace

Done set_device(Workspace& work, const SetDevice& change) {
  const Equipped owner = equipped(work.model(), change.owner());
  if (!owner) return refusal(fmt::format("there is no class or operator `{}`", text::shown(change.owner())));
  if (change.device().empty()) return add_device(work, owner, change);
  const text::Result<DeviceSpot> spot = find_device(work.model(), change.owner(), change.device());
  if (!spot) return std::unexpected(spot.error());
  const cdl::Device& old = *spot->device;
  const std::string binds = change.has_binds() ? change.binds() : old.binds.text;
  const text::Result<const cdl::Binding*> point = find_binding(work, binds);
  if (!point) return std::unexpected(point.error());
  const text::Result<Callable> by =
      find_server(work, change.has_component() ? change.component() : old.by.callee.text, **point);
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
  work.changes().change<cdl::Device>(old, [now](cdl::Device& there) { there = now; });
  if (binds != old.binds.text) drop_choices(work, change.owner(), old.name.text);
  return work.commit();
}

Done connect_device(Workspace& work, const Connect& change) {
  const bool is_sensor = change.to_node().starts_with(kPointNode);
  const std::string& device = is_sensor ? change.from_node() : change.to_node();
  const std::string& point = is_sensor ? change.to_node() : change.from_node();
  if (!point.starts_with(kPointNode)) return refusal("a device leads to a binding point");
  SetDevice bound;
  bound.set_owner(change.page());
  bound.set_device(device);
  bound.set_binds(point.substr(kPointNode.size()));
  if (device.empty()) return refusal("a device leads to a binding point");
  return set_device(work, bound);
}

Done place_device(Workspace& work, const Place& change) {
  const Equipped owner = equipped(work.model(), change.page());
  const std::optional<Callable>& by = work.model().components().find(change.component());
  if (!by) return refusal(fmt::format("nothing answers to `{}`", text::shown(change.component())));
  const std::string binds = point_for(work, owner, *by);
  if (binds.empty()) return refusal(fmt::format("`{}` can serve no binding point that is known", by->name));
  SetDevice fresh;
  fresh.set_owner(change.page());
  fresh.set_binds(binds);
  fresh.set_component(by->name);
  const std::string name = owner.robot_class != nullptr ? free_device_name(owner, binds) : binds;
  if (const Done done = set_device(work, fresh); !done) return done;
  return arrange_one(work, change.page(), name, change);
}

Done replace_device(Workspace& work, const Replace& change) {
  if (change.node().empty()) return refusal("nothing is chosen");
  SetDevice by;
  by.set_owner(change.page());
  by.set_device(change.node());
  by.set_component(change.component());
  return set_device(work, by);
}

Done remove_devices(Workspace& work, const Remove& change) {
  if (change.nodes().empty()) return refusal("nothing is chosen");
  std::set<std::string> seen;
  for (const std::string& name : change.nodes()) {
    if (!seen.insert(name).second) continue;
    if (name.starts_with(kBodyNode)) return refusal("every robot has a body: its numbers can be changed");
    if (name.starts_with(kPointNode))
      return refusal("a binding point stands here as long as a device serves it or a robot asks for it");
    const text::Result<DeviceSpot> spot = find_device(work.model(), change.page(), name);
    if (!spot) return std::unexpected(spot.error());
    work.changes().remove(*spot->device);
    if (spot->owner.robot_class != nullptr) drop_choices(work, change.page(), name);
  }
  return work.commit();
}

}  // namespace mlab::designer
