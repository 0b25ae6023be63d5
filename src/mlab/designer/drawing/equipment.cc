// The pages of classes of robots, operators of societies and binding points: what serves what.

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/drawing/serving.h"
#include "mlab/designer/drawing/shapes.h"
#include "mlab/lang/cdl/types/body.h"
#include "mlab/lang/cdl/types/units.h"

namespace mlab::designer {
namespace {

struct BodyPart {
  std::string_view name;
  const char* title;
  const char* help;
};
constexpr BodyPart kParts[] = {
    {"body", "Body", "How large it is, and how well it knows where it is."},
    {"drive", "Drive", "How it moves, and how fast at most."},
    {"ring", "Range sensors", "A ring or a scanner that measures distances. With 0 of them it has none."},
    {"camera", "Camera", "What sees objects: how far around, and how it turns."},
    {"radio", "Radio", "How far the robot is heard by others, and how much of it arrives."},
};

bool names_parameter(const cdl::Expression& expression, const std::vector<cdl::Parameter>& parameters) {
  const auto* name = std::get_if<cdl::Name>(&expression.what);
  return name != nullptr && std::ranges::any_of(parameters, [&](const cdl::Parameter& parameter) {
           return parameter.name.text == name->name.text;
         });
}

/// Draws a class or an operator.
class EquipmentDrawer {
 public:
  EquipmentDrawer(const Model& model, const Equipped& drawn, const std::string& name, Drawing& out)
      : model_(model), drawn_(drawn), layout_(model.layout(name)), out_(out) {
    if (drawn.robot_class == nullptr) return;
    for (const auto* robot : model.configuration().own_robots) {
      if (robot->class_name.text == name) robots_.push_back(robot);
    }
  }

  void run() {
    if (drawn_.robot_class != nullptr) {
      out_.set_kind(Drawing::CLASS);
      out_.set_help(drawn_.robot_class->help);
      for (const cdl::Parameter& parameter : drawn_.robot_class->parameters)
        add_parameter(parameter, model_, out_);
      for (const BodyPart& part : kParts) add_part(part);
    } else {
      out_.set_kind(Drawing::OPERATOR);
      out_.set_help(drawn_.society_operator->help);
    }
    for (const cdl::Robot* robot : robots_) out_.mutable_equipment()->add_robots(robot->name.text);
    for (const cdl::Device& device : drawn_.devices()) add_device(device);
    add_points();
    for (Node& node : *out_.mutable_nodes()) set_place(node);
  }

 private:
  void set_place(Node& node) const {
    if (layout_ == nullptr) return;
    const std::string name = node.name().starts_with('$') ? node.name().substr(1) : node.name();
    for (const cdl::LayoutEntry& entry : layout_->entries) {
      if (entry.node.text != name) continue;
      node.set_x(entry.x);
      node.set_y(entry.y);
    }
  }

  // ---- the body

  const cdl::BodySetting* setting(std::string_view name) const {
    const auto& body = drawn_.robot_class->body;
    const auto found =
        std::ranges::find_if(body, [&](const cdl::BodySetting& one) { return one.name.text == name; });
    return found == body.end() ? nullptr : &*found;
  }

  std::string value_of_setting(std::string_view name, std::string_view initial) const {
    const cdl::BodySetting* said = setting(name);
    return said == nullptr || !said->value ? std::string(initial) : written(*said->value);
  }

  // What a body of that drive, or without range sensors, has no use for is asked only where it is said.
  bool is_asked(const cdl::BodyProperty& property) const {
    if (setting(property.name) != nullptr) return true;
    const std::string drive = value_of_setting("drive", cdl::kDrives.front());
    if (property.name == "axle") return drive == "differential";
    if (property.name == "max_wheel_speed") return drive == "differential" || drive == "synchro";
    if (property.name == "wheelbase" || property.name == "max_steer") return drive == "car";
    const bool is_ring = property.part == "ring" && property.name != "ring_count";
    return !is_ring || value_of_setting("ring_count", "0") != "0";
  }

  void add_part(const BodyPart& part) {
    Node& node = *out_.add_nodes();
    node.set_name(std::string(kBodyNode) + std::string(part.name));
    node.set_title(part.title);
    node.set_component("");
    node.set_shape(Node::BODY);
    node.set_icon("body");
    node.set_help(part.help);
    if (part.name == "drive") {
      Port& port = *node.add_inputs();
      port.set_name("drive");
      port.set_label("drive");
      port.set_help(std::string(cdl::kDriveHelp));
      port.set_initial(std::string(cdl::kDrives.front()));
      for (const std::string_view drive : cdl::kDrives) port.add_choices(std::string(drive));
      set_written(port);
    }
    for (const cdl::BodyProperty& property : cdl::body_properties()) {
      if (property.part == part.name && is_asked(property)) add_property(property, node);
    }
  }

  void add_property(const cdl::BodyProperty& property, Node& node) {
    Port& port = *node.add_inputs();
    port.set_name(std::string(property.name));
    std::string label(property.name);
    if (label.starts_with("ring_") || label.starts_with("camera_")) label.erase(0, label.find('_') + 1);
    std::ranges::replace(label, '_', ' ');
    port.set_label(label);
    port.set_type("double");
    port.set_unit(std::string(property.unit));
    port.set_help(std::string(property.help));
    port.set_initial(std::string(property.initial));
    port.set_min(property.min);
    port.set_max(property.max);
    set_written(port);
    // A bare number is one in SI units.
    const cdl::BodySetting* said = setting(property.name);
    const auto* number =
        said == nullptr || !said->value ? nullptr : std::get_if<cdl::Number>(&said->value->what);
    if (number != nullptr && number->unit.text.empty() && property.is_angle())
      port.set_value(port.value() + " " + cdl::si_unit(*cdl::unit_named(property.unit)));
  }

  void set_written(Port& port) const {
    const cdl::BodySetting* said = setting(port.name());
    if (said == nullptr || !said->value) return;
    port.set_value(written(*said->value));
    port.set_begin(said->value->place.span.begin);
    port.set_end(said->value->place.span.end);
    port.set_is_exposed(names_parameter(*said->value, drawn_.robot_class->parameters));
  }

  // ---- devices

  const cdl::Binding* binding_of(const cdl::Device& device) const {
    const auto& bindings = model_.configuration().bindings;
    const auto found = bindings.find(device.binds.text);
    return found == bindings.end() ? nullptr : found->second;
  }

  void add_device(const cdl::Device& device) {
    const std::optional<Callable>& by = model_.components().find(device.by.callee.text);
    Node& node = *out_.add_nodes();
    node.set_name(device.name.text);
    node.set_title(device.name.text);
    node.set_component(device.by.callee.text);
    const cdl::Binding* binding = binding_of(device);
    const bool is_actuator = binding != nullptr ? binding->result_type.text.empty() : device.is_actuator;
    node.set_shape(is_actuator ? Node::ACTUATOR : Node::SENSOR);
    node.set_icon(is_actuator ? "actuator" : "binding");
    node.set_help(!device.help.empty() ? device.help : by ? by->help : "");
    node.set_begin(device.whole.begin);
    node.set_end(device.whole.end);
    if (by && !is_actuator) {
      node.set_type(by->output.name());
      node.set_unit(by->output.unit);
    }
    if (by) {
      for (std::size_t i = 0; i < by->inputs.size(); ++i)
        add_argument(device, by->inputs[i], i, binding, node);
    }
    served_[device.binds.text].push_back(&device);
    Equipment::Device& told = *out_.mutable_equipment()->add_devices();
    told.set_name(device.name.text);
    told.set_component(device.by.callee.text);
    told.set_binds(device.binds.text);
    told.set_verdict(device_verdict(device, model_.components()));
  }

  void add_argument(const cdl::Device& device, const Socket& input, std::size_t at,
                    const cdl::Binding* binding, Node& node) const {
    Port& port = *node.add_inputs();
    const bool is_asked =
        binding != nullptr && std::ranges::any_of(binding->parameters, [&](const cdl::Parameter& one) {
          return one.name.text == input.name;
        });
    port.set_name(input.name);
    std::string label = input.name;
    std::ranges::replace(label, '_', ' ');
    port.set_label(label);
    port.set_type(input.type.name());
    port.set_unit(input.type.unit);
    port.set_help(input.help);
    port.set_is_required(input.is_required && !is_asked);
    if (is_asked)
      port.set_help(fmt::format("{}{}as it is asked for, where nothing is said", input.help,
                                input.help.empty() ? "" : "; "));
    else
      port.set_initial(input.initial);
    if (input.min) port.set_min(*input.min);
    if (input.max) port.set_max(*input.max);
    for (const std::string& choice : choices_of(input.type)) port.add_choices(choice);
    for (std::size_t i = 0; i < device.by.arguments.size(); ++i) {
      const cdl::Argument& argument = device.by.arguments[i];
      const bool is_it = argument.name.text.empty() ? i == at : argument.name.text == input.name;
      if (!is_it || !argument.value) continue;
      port.set_value(written(*argument.value));
      port.set_begin(argument.value->place.span.begin);
      port.set_end(argument.value->place.span.end);
      port.set_is_exposed(drawn_.robot_class != nullptr &&
                          names_parameter(*argument.value, drawn_.robot_class->parameters));
    }
  }

  // ---- binding points

  void add_points() {
    std::map<std::string, std::vector<std::string>> asked;
    for (const cdl::Robot* robot : robots_) {
      const std::set<std::string> overridden = overridden_bindings(model_.configuration(), *robot);
      for (const std::string& binding : requested_bindings(model_.configuration(), *robot)) {
        if (!overridden.contains(binding)) asked[binding].push_back(robot->name.text);
      }
    }
    for (const auto& [name, binding] : model_.configuration().bindings) {
      Equipment::Point& told = *out_.mutable_equipment()->add_points();
      told.set_name(name);
      told.set_type(binding->result_type.text);
      told.set_help(binding->help);
      told.set_is_served(served_.contains(name));
      for (const std::string& robot : asked[name]) told.add_asked_by(robot);
      if (told.is_served() || told.asked_by_size() > 0) draw_point(name, *binding, !asked[name].empty());
    }
  }

  void draw_point(const std::string& name, const cdl::Binding& binding, bool is_asked) {
    Node& node = *out_.add_nodes();
    node.set_name("$point." + name);
    node.set_title(name);
    node.set_component(name);
    node.set_shape(Node::BINDING);
    node.set_icon("binding");
    node.set_help(binding.help);
    const bool is_actuator = binding.result_type.text.empty();
    const auto& devices = served_[name];
    if (is_actuator) {
      const cdl::PortType driven = binding.parameters.empty()
                                       ? cdl::PortType{}
                                       : model_.components().types().of(binding.parameters.front());
      node.set_type(driven.name());
      node.set_is_loose(devices.empty());
    } else {
      Port& port = *node.add_inputs();
      port.set_name("served_by");
      port.set_label(devices.empty() ? "nothing serves it" : "served by");
      port.set_type(model_.components().types().named(binding.result_type.text).name());
      port.set_is_required(is_asked);
    }
    for (const cdl::Device* device : devices) {
      Wire& wire = *out_.add_wires();
      wire.set_from(is_actuator ? node.name() : device->name.text);
      wire.set_to(is_actuator ? device->name.text : node.name());
      wire.set_port(!is_actuator                 ? "served_by"
                    : binding.parameters.empty() ? "driven"
                                                 : binding.parameters.front().name.text);
      wire.set_type(is_actuator ? node.type() : node.inputs(0).type());
    }
  }

  const Model& model_;
  const Equipped drawn_;
  const cdl::Layout* layout_;
  Drawing& out_;
  std::vector<const cdl::Robot*> robots_;
  std::map<std::string, std::vector<const cdl::Device*>> served_;
};

// Of a binding point: who serves it at the left, who asks for it at the right.
class BindingDrawer {
 public:
  BindingDrawer(const Model& model, const cdl::Binding& binding, const DrawingContext& context, Drawing& out)
      : model_(model), binding_(binding), context_(context), out_(out) {}

  void run() {
    out_.set_kind(Drawing::BINDING);
    out_.set_help(binding_.help);
    Equipment::Point& told = *out_.mutable_equipment()->add_points();
    told.set_name(binding_.name.text);
    told.set_type(binding_.result_type.text);
    told.set_help(binding_.help);
    for (const cdl::Parameter& parameter : binding_.parameters) add_parameter(parameter, model_, out_);
    Node& point = *out_.add_nodes();
    point.set_name("$point." + binding_.name.text);
    point.set_title(binding_.name.text);
    point.set_component(binding_.name.text);
    point.set_shape(Node::BINDING);
    point.set_icon("binding");
    point.set_type(binding_.result_type.text.empty() ? "Vector" : binding_.result_type.text);
    const auto& configuration = model_.configuration();
    for (const auto& [name, robot_class] : configuration.classes)
      add_server(name, "class", robot_class->devices);
    for (const auto& [name, op] : configuration.operators) add_server(name, "operator", op->devices);
    for (const cdl::Robot* robot : configuration.own_robots) {
      if (!requested_bindings(configuration, *robot).contains(binding_.name.text)) continue;
      out_.mutable_equipment()->add_robots(robot->name.text);
      add_node(robot->name.text, "robot", Node::ROBOT);
      add_wire("$point." + binding_.name.text, robot->name.text, "asks");
    }
  }

 private:
  void add_server(const std::string& name, const char* kind, const std::vector<cdl::Device>& devices) {
    bool is_drawn = false;
    for (const cdl::Device& device : devices) {
      if (device.binds.text != binding_.name.text) continue;
      Equipment::Device& told = *out_.mutable_equipment()->add_devices();
      told.set_name(device.name.text);
      told.set_component(device.by.callee.text);
      told.set_binds(device.binds.text);
      told.set_verdict(device_verdict(device, model_.components()));
      told.set_owner(name);
      if (std::exchange(is_drawn, true)) continue;
      const std::string node = add_node(name, kind, Node::DECLARATION);
      add_wire(node, "$point." + binding_.name.text, "served_by");
    }
  }

  std::string add_node(const std::string& name, const char* kind, Node::Shape shape) {
    Node& node = *out_.add_nodes();
    // A class and a robot may be called the same.
    node.set_name(shape == Node::ROBOT ? name : fmt::format("${}.{}", kind, name));
    node.set_title(name);
    node.set_component(kind);
    node.set_shape(shape);
    node.set_icon(kind);
    const bool is_own = shape == Node::ROBOT || equipped(model_, name);
    if (is_own) {
      node.mutable_inner()->set_document(context_.document);
      node.mutable_inner()->set_path(name);
    }
    return node.name();
  }

  void add_wire(const std::string& from, const std::string& to, const char* port) {
    Wire& wire = *out_.add_wires();
    wire.set_from(from);
    wire.set_to(to);
    wire.set_port(port);
    wire.set_type(binding_.result_type.text);
  }

  const Model& model_;
  const cdl::Binding& binding_;
  const DrawingContext& context_;
  Drawing& out_;
};

}  // namespace

bool draw_equipment(const Model& model, const std::string& name, const DrawingContext& context,
                    Drawing& out) {
  if (const Equipped drawn = equipped(model, name)) {
    EquipmentDrawer(model, drawn, name, out).run();
    return true;
  }
  const cdl::Binding* binding = model.binding(name);
  if (binding == nullptr) return false;
  BindingDrawer(model, *binding, context, out).run();
  return true;
}

}  // namespace mlab::designer
