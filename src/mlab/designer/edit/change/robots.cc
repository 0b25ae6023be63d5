#include "mlab/designer/edit/change/robots.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/drawing/serving.h"
#include "mlab/designer/edit/change/devices.h"
#include "mlab/text/shown.h"

namespace mlab::designer {

Done set_class(Workspace& work, const SetClass& change) {
  const cdl::Robot* robot = work.model().robot(change.robot());
  if (robot == nullptr) return refusal(fmt::format("there is no robot `{}`", text::shown(change.robot())));
  const std::string& wanted = change.class_name();
  if (!wanted.empty() && !work.model().configuration().classes.contains(wanted))
    return refusal(fmt::format("there is no class `{}`", text::shown(wanted)));
  if (wanted == robot->class_name.text) return true;
  work.changes().change<cdl::Robot>(*robot, [wanted](cdl::Robot& now) { now.class_name.text = wanted; });
  // Devices of the class before are none of this one.
  const auto other = work.model().configuration().classes.find(wanted);
  for (const cdl::Choice& choice : robot->choices) {
    const bool stays =
        other != work.model().configuration().classes.end() &&
        std::ranges::any_of(other->second->devices, [&](const cdl::Device& device) {
          return device.name.text == choice.device.text && device.binds.text == choice.binding.text;
        });
    if (!stays) work.changes().remove(choice);
  }
  return work.commit();
}

Done use_device(Workspace& work, const UseDevice& change) {
  const cdl::Robot* robot = work.model().robot(change.robot());
  if (robot == nullptr) return refusal(fmt::format("there is no robot `{}`", text::shown(change.robot())));
  const auto known = std::ranges::find_if(
      robot->choices, [&](const cdl::Choice& choice) { return choice.binding.text == change.binding(); });
  if (change.device().empty()) {
    if (known != robot->choices.end()) work.changes().remove(*known);
    return work.commit();
  }
  const auto& classes = work.model().configuration().classes;
  const auto found = classes.find(robot->class_name.text);
  if (found == classes.end()) return refusal("the robot has no class yet, so it has no devices");
  const auto& devices = found->second->devices;
  const bool fits = std::ranges::any_of(devices, [&](const cdl::Device& device) {
    return device.name.text == change.device() && device.binds.text == change.binding();
  });
  if (!fits)
    return refusal(fmt::format("`{}` has no device `{}` that serves `{}`", found->first,
                               text::shown(change.device()), text::shown(change.binding())));
  if (known != robot->choices.end()) {
    work.changes().rename(known->device, change.device());
  } else {
    const cdl::Choice choice{{change.device(), {}}, {change.binding(), {}}};
    work.changes().change<cdl::Robot>(*robot, [choice](cdl::Robot& now) { now.choices.push_back(choice); });
  }
  return work.commit();
}

Done add_class_for(Workspace& work, const std::string& name, const std::string& robot_name) {
  const cdl::Robot* robot = work.model().robot(robot_name);
  if (robot == nullptr) return refusal(fmt::format("there is no robot `{}`", text::shown(robot_name)));
  const std::set<std::string> overridden = overridden_bindings(work.model().configuration(), *robot);
  for (const std::string& asked : requested_bindings(work.model().configuration(), *robot)) {
    const std::string component = overridden.contains(asked) ? "" : usual_component(work.model(), asked);
    if (component.empty()) continue;
    SetDevice fresh;
    fresh.set_owner(name);
    fresh.set_binds(asked);
    fresh.set_component(component);
    if (const Done done = set_device(work, fresh); !done) return done;
  }
  SetClass bound;
  bound.set_robot(robot_name);
  bound.set_class_name(name);
  return set_class(work, bound);
}

}  // namespace mlab::designer
