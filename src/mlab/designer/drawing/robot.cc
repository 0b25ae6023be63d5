// What robots are bound to: the classes and devices of a robot, and the pages of classes, operators and
// binding points.

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/designer/drawing/serving.h"
#include "mlab/designer/drawing/shapes.h"
#include "mlab/lang/cdl/types/body.h"

namespace mlab::designer {
namespace {

bool is_served(const cdl::RobotClass& robot_class, std::string_view binding) {
  return std::ranges::any_of(robot_class.devices,
                             [&](const cdl::Device& device) { return device.binds.text == binding; });
}

std::string class_verdict(const cdl::RobotClass& robot_class, const std::set<std::string>& asked,
                          const std::set<std::string>& overridden) {
  std::vector<std::string> missing;
  for (const std::string& name : asked) {
    if (!overridden.contains(name) && !is_served(robot_class, name))
      missing.push_back(fmt::format("`{}`", name));
  }
  return missing.empty() ? "" : fmt::format("has nothing that serves {}", fmt::join(missing, ", "));
}

void add_actuators(const cdl::RobotClass* robot_class, const cdl::Robot& robot, const Model& model,
                   Drawing& out) {
  std::vector<std::string> wanted;
  if (robot_class != nullptr) {
    for (const cdl::Device& device : robot_class->devices) {
      if (device.is_actuator) wanted.push_back(device.binds.text);
    }
  }
  if (robot_class == nullptr && robot.drives.empty()) wanted.emplace_back("movement");
  for (const std::string& binding : wanted) {
    const std::string name = "$" + binding;
    const bool is_there =
        std::ranges::any_of(out.nodes(), [&](const Node& node) { return node.name() == name; });
    if (is_there) continue;
    Node& node = *out.add_nodes();
    node.set_name(name);
    node.set_title(binding);
    node.set_component(binding);
    node.set_shape(Node::ACTUATOR);
    node.set_icon("actuator");
    Port& port = *node.add_inputs();
    port.set_name("v");
    port.set_label("v");
    port.set_type("Vector");
    if (const auto found = model.configuration().bindings.find(binding);
        found != model.configuration().bindings.end())
      node.set_help(found->second->help);
  }
}

void set_class_page(const cdl::RobotClass& robot_class, const Model& model, const DrawingContext& context,
                    Robot::Class& out) {
  const text::SourcePtr& source = robot_class.name.place.source;
  if (!source) return;
  const bool is_own = source == model.source();
  const std::string document = is_own ? context.document : context.document_of(source->name());
  if (document.empty() || (is_own && !equipped(model, robot_class.name.text))) return;
  out.mutable_page()->set_document(document);
  out.mutable_page()->set_path(robot_class.name.text);
}

}  // namespace

void add_robot(const Model& model, const cdl::Robot& robot, const DrawingContext& context, Drawing& out) {
  const cdl::Configuration& configuration = model.configuration();
  const std::set<std::string> asked = requested_bindings(configuration, robot);
  const std::set<std::string> overridden = overridden_bindings(configuration, robot);
  Robot& into = *out.mutable_robot();
  into.set_class_name(robot.class_name.text);
  for (const auto& [name, robot_class] : configuration.classes) {
    Robot::Class& one = *into.add_classes();
    one.set_name(name);
    one.set_help(robot_class->help);
    one.set_verdict(class_verdict(*robot_class, asked, overridden));
    set_class_page(*robot_class, model, context, one);
  }
  const auto found = configuration.classes.find(robot.class_name.text);
  const cdl::RobotClass* own = found == configuration.classes.end() ? nullptr : found->second;
  for (const std::string& name : asked) {
    const cdl::Binding& binding = *configuration.bindings.find(name)->second;
    Robot::Binding& one = *into.add_bindings();
    one.set_name(name);
    one.set_type(binding.result_type.text);
    one.set_help(binding.help);
    for (const cdl::Choice& choice : robot.choices) {
      if (choice.binding.text == name) one.set_chosen(choice.device.text);
    }
    int fitting = 0;
    for (const cdl::Device& device : own == nullptr ? std::vector<cdl::Device>{} : own->devices) {
      if (device.binds.text != name) continue;
      Robot::Device& served = *one.add_devices();
      served.set_name(device.name.text);
      served.set_component(device.by.callee.text);
      served.set_verdict(device_verdict(device, model.components()));
      if (served.verdict().empty()) ++fitting;
    }
    if (overridden.contains(name)) continue;
    if (own == nullptr)
      one.set_verdict(robot.class_name.text.empty() ? "the robot has no class yet" : "the class is unknown");
    else if (fitting == 0)
      one.set_verdict(fmt::format("`{}` has nothing that serves it", own->name.text));
    else if (fitting > 1 && one.chosen().empty())
      one.set_verdict("several devices serve it: choose one");
  }
  add_actuators(own, robot, model, out);
}

}  // namespace mlab::designer
