// Robots: their classes, and which device serves what.

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/edit/editor.h"
#include "mlab/text/shown.h"

namespace mlab::designer {

Done Editor::set_class(const SetClass& change) {
  const cdl::Robot* robot = work_.model().robot(change.robot());
  if (robot == nullptr) return refusal(fmt::format("there is no robot `{}`", text::shown(change.robot())));
  const std::string& wanted = change.class_name();
  if (!wanted.empty() && !work_.model().configuration().classes.contains(wanted))
    return refusal(fmt::format("there is no class `{}`", text::shown(wanted)));
  if (wanted == robot->class_name.text) return true;
  work_.changes().change<cdl::Robot>(*robot, [wanted](cdl::Robot& now) { now.class_name.text = wanted; });
  // Devices of the class before are none of this one.
  const auto other = work_.model().configuration().classes.find(wanted);
  for (const cdl::Choice& choice : robot->choices) {
    const bool stays =
        other != work_.model().configuration().classes.end() &&
        std::ranges::any_of(other->second->devices, [&](const cdl::Device& device) {
          return device.name.text == choice.device.text && device.binds.text == choice.binding.text;
        });
    if (!stays) work_.changes().remove(choice);
  }
  return work_.commit();
}

Done Editor::use_device(const UseDevice& change) {
  const cdl::Robot* robot = work_.model().robot(change.robot());
  if (robot == nullptr) return refusal(fmt::format("there is no robot `{}`", text::shown(change.robot())));
  const auto known = std::ranges::find_if(
      robot->choices, [&](const cdl::Choice& choice) { return choice.binding.text == change.binding(); });
  if (change.device().empty()) {
    if (known != robot->choices.end()) work_.changes().remove(*known);
    return work_.commit();
  }
  const auto& classes = work_.model().configuration().classes;
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
    work_.changes().rename(known->device, change.device());
  } else {
    const cdl::Choice choice{{change.device(), {}}, {change.binding(), {}}};
    work_.changes().change<cdl::Robot>(*robot, [choice](cdl::Robot& now) { now.choices.push_back(choice); });
  }
  return work_.commit();
}

}  // namespace mlab::designer
