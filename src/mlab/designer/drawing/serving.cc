#include "mlab/designer/drawing/serving.h"

#include <algorithm>
#include <map>

#include <fmt/core.h>

#include "mlab/lang/cdl/syntax/parts.h"
#include "mlab/lang/cdl/syntax/walk.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

class RequestedBindings {
 public:
  RequestedBindings(const cdl::Configuration& configuration, const cdl::Robot& robot)
      : configuration_(configuration) {
    for (const cdl::Let& let : robot.lets) add(let.value);
    for (const cdl::Drive& drive : robot.drives) {
      add(drive.value);
      if (configuration.bindings.contains(drive.binding.text)) names.insert(drive.binding.text);
    }
  }

  std::set<std::string> names;

 private:
  void add(const cdl::ExpressionPtr& expression) {
    std::set<std::string> calls;
    add_calls(expression, calls);
    for (const std::string& name : calls) {
      if (configuration_.bindings.contains(name)) {
        names.insert(name);
        continue;
      }
      const auto found = configuration_.assemblages.find(name);
      if (found == configuration_.assemblages.end() || !seen_.insert(name).second) continue;
      for (const cdl::Let& let : found->second->lets) add(let.value);
      add(found->second->body);
    }
  }

  const cdl::Configuration& configuration_;
  std::set<std::string> seen_;
};

// What the device still needs: inputs without a default that neither it nor the binding point gives.
std::string missing_input(const cdl::Device& device, const cdl::Binding& binding, const Callable& by) {
  for (std::size_t i = 0; i < by.inputs.size(); ++i) {
    const Socket& input = by.inputs[i];
    const bool is_asked = std::ranges::any_of(
        binding.parameters, [&](const cdl::Parameter& one) { return one.name.text == input.name; });
    const bool is_given = i < device.by.arguments.size() && device.by.arguments[i].name.text.empty();
    const bool is_named = std::ranges::any_of(
        device.by.arguments, [&](const cdl::Argument& one) { return one.name.text == input.name; });
    if (input.is_required && !is_asked && !is_given && !is_named) return input.name;
  }
  return "";
}

}  // namespace

const cdl::Device* Equipped::device(std::string_view name) const {
  const auto found =
      std::ranges::find_if(devices(), [&](const cdl::Device& device) { return device.name.text == name; });
  return found == devices().end() ? nullptr : &*found;
}

Equipped equipped(const Model& model, std::string_view name) {
  if (model.robot(name) != nullptr || model.assemblage(name) != nullptr) return {};
  const cdl::RobotClass* robot_class = model.robot_class(name);
  return {robot_class, robot_class == nullptr ? model.society_operator(name) : nullptr};
}

std::string why_not_serving(const Callable& component, const cdl::Binding& binding,
                            const Components& components) {
  const bool is_actuator = binding.result_type.text.empty();
  if (component.kind == Callable::Kind::kBinding) return "it is a binding point itself";
  if (is_actuator && !component.gives_nothing) return "it gives a value and moves nothing";
  if (!is_actuator && component.gives_nothing) return "it gives nothing";
  if (!is_actuator) {
    const std::string reason = why_not(component.output, components.types().named(binding.result_type.text));
    if (!reason.empty()) return reason;
  }
  for (const cdl::Parameter& asked : binding.parameters) {
    const auto input = std::ranges::find(component.inputs, asked.name.text, &Socket::name);
    if (input == component.inputs.end()) return fmt::format("it has no input `{}`", asked.name.text);
    const std::string reason = why_not(components.types().of(asked), input->type);
    if (!reason.empty()) return fmt::format("`{}`: {}", asked.name.text, reason);
  }
  return "";
}

std::string device_verdict(const cdl::Device& device, const Components& components) {
  const auto& bindings = components.configuration().bindings;
  const auto binding = bindings.find(device.binds.text);
  if (binding == bindings.end())
    return fmt::format("there is no binding point `{}`", text::shown(device.binds.text));
  const std::optional<Callable>& by = components.find(device.by.callee.text);
  if (!by) return fmt::format("nothing answers to `{}`", text::shown(device.by.callee.text));
  std::string reason = why_not_serving(*by, *binding->second, components);
  if (!reason.empty()) return reason;
  const std::string missing = missing_input(device, *binding->second, *by);
  return missing.empty() ? "" : fmt::format("its `{}` needs a value", missing);
}

std::set<std::string> requested_bindings(const cdl::Configuration& configuration, const cdl::Robot& robot) {
  return RequestedBindings(configuration, robot).names;
}

std::set<std::string> overridden_bindings(const cdl::Configuration& configuration, const cdl::Robot& robot) {
  std::set<std::string> out;
  for (const cdl::SocietyOperator* op : cdl::operators_of(configuration, robot)) {
    for (const cdl::Device& device : op->devices) out.insert(device.binds.text);
  }
  return out;
}

std::string why_no_components(const Model& model, const std::string& page) {
  if (equipped(model, page)) return fmt::format("on the page of `{}` stand devices, and nothing else", page);
  if (model.society(page) != nullptr) return fmt::format("`{}` has members, and nothing else", page);
  if (model.binding(page) != nullptr) return "a binding point is no page for components";
  return fmt::format("there is no page `{}`", text::shown(page));
}

bool reads_parameter(const cdl::RobotClass& robot_class, std::string_view parameter) {
  bool out = false;
  cdl::for_each_construct(robot_class, [&]<class X>(const X& one) {
    if constexpr (std::same_as<X, cdl::Name>) out |= one.name.text == parameter;
  });
  return out;
}

void add_calls(const cdl::ExpressionPtr& expression, std::set<std::string>& out) {
  if (!expression) return;
  cdl::for_each_expression(*expression, [&](const cdl::Expression& one) {
    if (const auto* call = std::get_if<cdl::Call>(&one.what)) out.insert(call->callee.text);
    if (const auto* by = std::get_if<cdl::Coordinate>(&one.what)) out.insert(by->by.callee.text);
    if (const auto* by = std::get_if<cdl::Fuse>(&one.what)) out.insert(by->by.callee.text);
  });
}

std::string usual_component(const Model& model, const std::string& binding) {
  const auto& configuration = model.configuration();
  const auto asked = configuration.bindings.find(binding);
  if (asked == configuration.bindings.end()) return "";
  // As the classes that are known have it, the library's with them.
  std::map<std::string, int> votes;
  for (const auto& [name, robot_class] : configuration.classes) {
    for (const cdl::Device& device : robot_class->devices) {
      const std::optional<Callable>& by = model.components().find(device.by.callee.text);
      const bool serves = device.binds.text == binding && by &&
                          why_not_serving(*by, *asked->second, model.components()).empty();
      if (serves) ++votes[by->name];
    }
  }
  const auto most = std::ranges::max_element(votes, {}, &std::pair<const std::string, int>::second);
  return most == votes.end() ? "" : most->first;
}

}  // namespace mlab::designer
