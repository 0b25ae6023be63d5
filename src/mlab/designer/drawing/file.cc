// Pages that are no dataflow: the declarations of a file, a society.

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/designer/drawing/serving.h"
#include "mlab/designer/drawing/shapes.h"

namespace mlab::designer {
namespace {

// What of a declaration is shown and asked, whatever its kind.
struct Summary {
  std::string kind;
  std::string name;
  std::string help;
  text::Span span;
  std::set<std::string> uses;  ///< names of declarations
  bool has_page = false;
  cdl::PortType type;
};

void add_members(const cdl::SocietyMember& member, std::set<std::string>& out) {
  if (!member.name.text.empty()) out.insert(member.name.text);
  if (!member.by.text.empty()) out.insert(member.by.text);
  for (const cdl::SocietyMember& one : member.members) add_members(one, out);
}

Summary shown(const cdl::Item& item, const Model& model) {
  Summary out;
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
    out = {"class",
           robot_class->name.text,
           robot_class->help,
           robot_class->name.place.span,
           {},
           bool(equipped(model, robot_class->name.text)),
           {}};
    for (const cdl::Device& device : robot_class->devices) out.uses.insert(device.by.callee.text);
  } else if (const auto* society = std::get_if<cdl::Society>(&item)) {
    out = {"society", society->name.text, society->help, society->name.place.span, {}, true, {}};
    add_members(society->what, out.uses);
  } else if (const auto* op = std::get_if<cdl::SocietyOperator>(&item)) {
    out = {"operator", op->name.text, op->help, op->name.place.span, {}, bool(equipped(model, op->name.text)),
           {}};
    for (const cdl::Device& device : op->devices) out.uses.insert(device.by.callee.text);
  } else if (const auto* binding = std::get_if<cdl::Binding>(&item)) {
    out = {"binding",
           binding->name.text,
           binding->help,
           binding->name.place.span,
           {},
           true,
           model.components().types().named(binding->result_type.text)};
  }
  return out;
}

std::vector<Summary> all_shown(const Model& model) {
  std::vector<Summary> out;
  for (const cdl::Item& item : model.tree().items) {
    Summary one = shown(item, model);
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

}  // namespace

void add_declarations(const Model& model, Document& document) {
  for (const Summary& one : all_shown(model)) {
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
  const std::vector<Summary> all = all_shown(model);
  const cdl::Layout* layout = model.layout("");
  for (const Summary& one : all) {
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
    for (const Summary& other : all) {
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

}  // namespace mlab::designer
