#include "mlab/lang/cdl/lower/elaboration.h"

#include <algorithm>
#include <ranges>
#include <utility>

#include "mlab/lang/cdl/lower/naming.h"

namespace mlab::cdl {
namespace {

// Whether there is a name to be given where the expression is evaluated.
bool makes_names(const Expression& expression) {
  const bool is_plain = default_name(expression).empty() && !std::holds_alternative<List>(expression.what);
  return !is_plain || expression.active || !expression.as.text.empty();
}

// A device of the class as its robot has it.
DeviceUse use_of(const Device& device, const Robot& robot) {
  const bool is_chosen = std::ranges::any_of(robot.choices, [&](const Choice& choice) {
    return choice.device.text == device.name.text && choice.binding.text == device.binds.text;
  });
  return {&device, is_chosen, false};
}

}  // namespace

const std::vector<DeviceUse>& Elaboration::devices(const Robot& robot) const {
  const auto [at, is_new] = devices_.try_emplace(&robot);
  std::vector<DeviceUse>& out = at->second;
  if (!is_new) return out;
  for (const SocietyOperator* op : operators_of(configuration_, robot) | std::views::reverse) {
    for (const Device& device : op->devices) out.push_back({&device, false, true});
  }
  const auto found = configuration_.classes.find(robot.class_name.text);
  if (robot.class_name.text.empty() || found == configuration_.classes.end()) return out;
  for (const Device& device : found->second->devices) out.push_back(use_of(device, robot));
  return out;
}

template <class Make>
const NodeNames& Elaboration::kept(Key key, const Make& make) const {
  std::unique_ptr<const NodeNames>& out = names_[std::move(key)];
  if (!out) out = std::make_unique<const NodeNames>(make(Naming(configuration_, types_)));
  return *out;
}

const NodeNames& Elaboration::names(const Robot& robot) const {
  return kept({&robot, {}, {}}, [&](Naming naming) {
    std::vector<const Device*> actuators;
    for (const Drive& drive : robot.drives) {
      const DeviceUse* use = actuator_for(devices(robot), drive.binding.text).use;
      actuators.push_back(use == nullptr ? nullptr : use->device);
    }
    return naming.of(robot, actuators);
  });
}

const NodeNames& Elaboration::names(const Assemblage& assemblage, const std::vector<bool>& given,
                                    const NamesBelow& taken) const {
  std::vector<const Parameter*> defaults;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const Parameter& parameter = assemblage.parameters[i];
    if (!given[i] && parameter.initial && makes_names(*parameter.initial)) defaults.push_back(&parameter);
  }
  const auto with = [&](const NamesBelow& names) -> const NodeNames& {
    return kept({&assemblage, defaults, names},
                [&](Naming naming) { return naming.of(assemblage, defaults, names); });
  };
  const NodeNames& alone = with({});
  return alone.stay_with(taken) ? alone : with(taken);
}

const NodeNames& Elaboration::names(const Device& device, const NamesBelow& taken) const {
  return kept({&device, {}, taken}, [&](Naming naming) { return naming.of(device, taken); });
}

FoundDevice actuator_for(const std::vector<DeviceUse>& devices, std::string_view name) {
  FoundDevice out;
  for (const DeviceUse& use : devices) {
    const Device& device = *use.device;
    if (!device.is_actuator) continue;
    if (device.name.text == name) return {&use, {}};
    if (device.binds.text != name) continue;
    if (use.is_chosen) return {&use, {}};
    out.fitting.push_back(device.name.text);
    if (out.use == nullptr) out.use = &use;
  }
  return out;
}

FoundDevice device_for(const std::vector<DeviceUse>& devices, std::string_view binding) {
  FoundDevice out;
  for (const DeviceUse& use : devices) {
    if (use.device->binds.text != binding) continue;
    if (use.overrides || use.is_chosen) return {&use, {}};
    out.fitting.push_back(use.device->name.text);
    if (out.use == nullptr) out.use = &use;
  }
  return out;
}

}  // namespace mlab::cdl
