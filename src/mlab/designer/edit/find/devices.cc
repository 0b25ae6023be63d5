#include "mlab/designer/edit/find/devices.h"

#include <fmt/core.h>

#include "mlab/designer/edit/refusal.h"
#include "mlab/text/shown.h"

namespace mlab::designer {

bool is_equipment(const Model& model, const std::string& page) {
  return bool(equipped(model, page));
}

text::Result<DeviceSpot> find_device(const Model& model, const std::string& owner, const std::string& name) {
  const Equipped found = equipped(model, owner);
  if (!found) return refusal(fmt::format("there is no class or operator `{}`", text::shown(owner)));
  const cdl::Device* device = found.device(name);
  if (device == nullptr)
    return refusal(fmt::format("`{}` has no device `{}`", text::shown(owner), text::shown(name)));
  const std::optional<Callable>& by = model.components().find(device->by.callee.text);
  return DeviceSpot{found, device, by ? &*by : nullptr};
}

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

}  // namespace mlab::designer
