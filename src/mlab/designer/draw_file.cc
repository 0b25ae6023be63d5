// Pages that are no dataflow: the declarations of a file, a society; and what is said of a robot's devices.

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/designer/shapes.h"
#include "mlab/lang/cdl/walk.h"

namespace mlab::designer {
namespace {

// What of a declaration is shown and asked, whatever its kind.
struct Shown {
  std::string kind;
  std::string name;
  std::string help;
  text::Span span;
  std::set<std::string> uses;  ///< names of declarations
  bool has_page = false;
  cdl::PortType type;
};

void add_calls(const cdl::ExpressionPtr& expression, std::set<std::string>& out) {
  if (!expression) return;
  cdl::for_each_expression(*expression, [&](const cdl::Expression& one) {
    if (const auto* call = std::get_if<cdl::Call>(&one.what)) out.insert(call->callee.text);
    if (const auto* by = std::get_if<cdl::Coordinate>(&one.what)) out.insert(by->by.callee.text);
    if (const auto* by = std::get_if<cdl::Fuse>(&one.what)) out.insert(by->by.callee.text);
  });
}

void add_members(const cdl::SocietyMember& member, std::set<std::string>& out) {
  if (!member.name.text.empty()) out.insert(member.name.text);
  if (!member.by.text.empty()) out.insert(member.by.text);
  for (const cdl::SocietyMember& one : member.members) add_members(one, out);
}

Shown shown(const cdl::Item& item, const Model& model) {
  Shown out;
  if (const auto* assemblage = std::get_if<cdl::Assemblage>(&item)) {
    out = {"assemblage",
           assemblage->name.text,
           assemblage->help,
           assemblage->name.place.span,
           {},
           true,
           model.components().of(*assemblage).output};
    for (const cdl::Let& let : assemblage->lets) add_calls(let.value, out.uses);
    add_calls(assemblage->body, out.uses);
  } else if (const auto* robot = std::get_if<cdl::Robot>(&item)) {
    out = {"robot", robot->name.text, robot->help, robot->name.place.span, {}, true, {}};
    for (const cdl::Let& let : robot->lets) add_calls(let.value, out.uses);
    for (const cdl::Drive& drive : robot->drives) add_calls(drive.value, out.uses);
    out.uses.insert(robot->class_name.text);
  } else if (const auto* robot_class = std::get_if<cdl::RobotClass>(&item)) {
    out = {"class", robot_class->name.text, robot_class->help, robot_class->name.place.span, {}, false, {}};
    for (const cdl::Device& device : robot_class->devices) out.uses.insert(device.by.callee.text);
  } else if (const auto* society = std::get_if<cdl::Society>(&item)) {
    out = {"society", society->name.text, society->help, society->name.place.span, {}, true, {}};
    add_members(society->what, out.uses);
  } else if (const auto* op = std::get_if<cdl::SocietyOperator>(&item)) {
    out = {"operator", op->name.text, op->help, op->name.place.span, {}, false, {}};
    for (const cdl::Device& device : op->devices) out.uses.insert(device.by.callee.text);
  } else if (const auto* binding = std::get_if<cdl::Binding>(&item)) {
    out = {"binding",
           binding->name.text,
           binding->help,
           binding->name.place.span,
           {},
           false,
           model.components().types().named(binding->result_type.text)};
  }
  return out;
}

std::vector<Shown> all_shown(const Model& model) {
  std::vector<Shown> out;
  for (const cdl::Item& item : model.tree().items) {
    Shown one = shown(item, model);
    if (!one.name.empty()) out.push_back(std::move(one));
  }
  return out;
}

// ---- societies

class SocietyDrawer {
 public:
  SocietyDrawer(const Model& model, const cdl::Society& society, const DrawingContext& context, Drawing& out)
      : model_(model), context_(context), layout_(model.layout(society.name.text)), out_(out) {}

  std::string add(const cdl::SocietyMember& member, const std::vector<std::uint32_t>& path,
                  const std::string& fallback) {
    Node& node = *out_.add_nodes();
    const bool is_caste = member.kind == cdl::SocietyMember::Kind::kCaste;
    const std::string name = free_name(is_caste ? fallback : member.name.text);
    node.set_name(name);
    node.set_component(is_caste ? "caste" : member.name.text);
    node.set_title(is_caste ? fallback : member.name.text);
    node.set_begin(member.place.span.begin);
    node.set_end(member.place.span.end);
    for (const std::uint32_t index : path) node.add_member(index);
    if (!member.by.text.empty()) {
      Port& port = *node.add_inputs();
      port.set_name("by");
      port.set_label("by");
      port.set_value(member.by.text);
    }
    describe(member, node);
    if (layout_ != nullptr) {
      for (const cdl::LayoutEntry& entry : layout_->entries) {
        if (entry.node.text != name) continue;
        node.set_x(entry.x);
        node.set_y(entry.y);
      }
    }
    for (std::size_t i = 0; i < member.members.size(); ++i) {
      std::vector<std::uint32_t> inner = path;
      inner.push_back(static_cast<std::uint32_t>(i));
      const std::string part = add(member.members[i], inner, fmt::format("caste{}", fmt::join(inner, "_")));
      Wire& wire = *out_.add_wires();
      wire.set_from(part);
      wire.set_to(name);
      wire.set_port("members");
      wire.set_index(static_cast<std::uint32_t>(i));
    }
    return name;
  }

 private:
  std::string free_name(const std::string& wanted) {
    std::string out = wanted;
    for (int number = 2; !taken_.insert(out).second; ++number) out = fmt::format("{}_{}", wanted, number);
    return out;
  }

  void describe(const cdl::SocietyMember& member, Node& node) const {
    const auto& configuration = model_.configuration();
    node.set_count(member.count);
    if (member.kind == cdl::SocietyMember::Kind::kCaste) {
      node.set_shape(Node::CASTE);
      node.set_icon("caste");
      return;
    }
    const bool is_team = member.kind == cdl::SocietyMember::Kind::kTeam;
    if (is_team) {
      node.set_shape(Node::TEAM);
      node.set_icon("team");
    } else if (configuration.societies.contains(member.name.text)) {
      node.set_shape(Node::SOCIETY);
      node.set_icon("society");
    } else {
      node.set_shape(configuration.robots.contains(member.name.text) ? Node::ROBOT : Node::UNKNOWN);
      node.set_icon("robot");
    }
    const bool is_own =
        model_.robot(member.name.text) != nullptr || model_.society(member.name.text) != nullptr;
    if (is_own) {
      node.mutable_inner()->set_document(context_.document);
      node.mutable_inner()->set_path(member.name.text);
    }
    if (const auto robot = configuration.robots.find(member.name.text); robot != configuration.robots.end())
      node.set_help(robot->second->help);
  }

  const Model& model_;
  const DrawingContext& context_;
  const cdl::Layout* layout_;
  Drawing& out_;
  std::set<std::string> taken_;
};

// ---- robots

/// The binding points that a robot asks for, through all assemblages that it is made of.
class RequestedBindings {
 public:
  RequestedBindings(const cdl::Configuration& configuration, const cdl::Robot& robot)
      : configuration_(configuration) {
    for (const cdl::Let& let : robot.lets) add(let.value);
    for (const cdl::Drive& drive : robot.drives) {
      add(drive.value);
      if (configuration.bindings.contains(drive.binding.text)) names_.insert(drive.binding.text);
    }
  }
  const std::set<std::string>& names() const { return names_; }

 private:
  void add(const cdl::ExpressionPtr& expression) {
    std::set<std::string> calls;
    add_calls(expression, calls);
    for (const std::string& name : calls) {
      if (configuration_.bindings.contains(name)) {
        names_.insert(name);
        continue;
      }
      const auto found = configuration_.assemblages.find(name);
      if (found == configuration_.assemblages.end() || !seen_.insert(name).second) continue;
      for (const cdl::Let& let : found->second->lets) add(let.value);
      add(found->second->body);
    }
  }

  const cdl::Configuration& configuration_;
  std::set<std::string> names_;
  std::set<std::string> seen_;
};

std::string device_verdict(const cdl::Device& device, const cdl::Binding& binding,
                           const Components& components) {
  const std::optional<Callable>& by = components.find(device.by.callee.text);
  if (!by) return fmt::format("nothing answers to `{}`", device.by.callee.text);
  if (binding.result_type.text.empty() || by->gives_nothing)
    return binding.result_type.text.empty() == by->gives_nothing ? ""
                                                                 : "one gives a value and the other none";
  return why_not(by->output, components.types().named(binding.result_type.text));
}

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

}  // namespace

void add_declarations(const Model& model, Document& document) {
  for (const Shown& one : all_shown(model)) {
    Declaration& out = *document.add_declarations();
    out.set_kind(one.kind);
    out.set_name(one.name);
    out.set_type(one.type.name());
    out.set_help(one.help);
    out.set_begin(one.span.begin);
    out.set_end(one.span.end);
  }
}

void draw_file(const Model& model, const DrawingContext& context, Drawing& out) {
  out.set_kind(Drawing::FILE);
  const std::vector<Shown> all = all_shown(model);
  const cdl::Layout* layout = model.layout("");
  for (const Shown& one : all) {
    Node& node = *out.add_nodes();
    node.set_name(one.name);
    node.set_title(one.name);
    node.set_component(one.kind);
    node.set_shape(Node::DECLARATION);
    node.set_icon(one.kind);
    node.set_help(one.help);
    node.set_type(one.type.name());
    node.set_unit(one.type.unit);
    node.set_begin(one.span.begin);
    node.set_end(one.span.end);
    if (one.has_page) {
      node.mutable_inner()->set_document(context.document);
      node.mutable_inner()->set_path(one.name);
    }
    for (const cdl::LayoutEntry& entry :
         layout == nullptr ? std::vector<cdl::LayoutEntry>{} : layout->entries) {
      if (entry.node.text != one.name) continue;
      node.set_x(entry.x);
      node.set_y(entry.y);
    }
    for (const Shown& other : all) {
      if (!one.uses.contains(other.name) || other.name == one.name) continue;
      Wire& wire = *out.add_wires();
      wire.set_from(other.name);
      wire.set_to(one.name);
      wire.set_port("uses");
    }
  }
}

void draw_society(const Model& model, const cdl::Society& society, const DrawingContext& context,
                  Drawing& out) {
  out.set_kind(Drawing::SOCIETY);
  out.set_help(society.help);
  out.set_result_node(SocietyDrawer(model, society, context, out).add(society.what, {}, society.name.text));
}

void add_robot(const Model& model, const cdl::Robot& robot, Drawing& out) {
  const cdl::Configuration& configuration = model.configuration();
  const RequestedBindings asker(configuration, robot);
  const std::set<std::string>& asked = asker.names();
  std::set<std::string> overridden;
  for (const cdl::SocietyOperator* op : cdl::operators_of(configuration, robot)) {
    for (const cdl::Device& device : op->devices) overridden.insert(device.binds.text);
  }
  Robot& into = *out.mutable_robot();
  into.set_class_name(robot.class_name.text);
  for (const auto& [name, robot_class] : configuration.classes) {
    Robot::Class& one = *into.add_classes();
    one.set_name(name);
    one.set_help(robot_class->help);
    one.set_verdict(class_verdict(*robot_class, asked, overridden));
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
      served.set_verdict(device_verdict(device, binding, model.components()));
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
