#include "mlab/designer/drawing/shapes.h"

#include <algorithm>

#include <fmt/core.h>

namespace mlab::designer {
namespace {

using flow::TypeKind;

bool is_movement(const cdl::PortType& type) {
  return type.type != nullptr && type.type->kind == TypeKind::kVector && type.unit.empty();
}

std::size_t count_lists(const Callable& component) {
  return static_cast<std::size_t>(std::ranges::count_if(component.inputs, &Socket::is_list));
}

bool is_logic(const Callable& component) {
  return component.name == "Not" || component.name == "And" || component.name == "Or" ||
         component.name == "Constant";
}

Socket socket(std::string name, cdl::PortType type, std::string help, bool is_required) {
  Socket out;
  out.name = std::move(name);
  out.type = std::move(type);
  out.help = std::move(help);
  out.is_required = is_required;
  return out;
}

// The operator's own inputs: its first two lists are its members and their weights.
std::vector<Socket> generic(const cdl::Call& by, const Components& components) {
  std::vector<Socket> out;
  const std::optional<Callable>& component = components.find(by.callee.text);
  if (!component) return out;
  int lists = 0;
  for (const Socket& input : component->inputs) {
    const int which = input.is_list ? lists++ : 2;
    Socket own = input;
    if (which == 0) own.name = "members";
    if (which == 1) own.name = "weight";
    out.push_back(std::move(own));
  }
  return out;
}

std::vector<Socket> movements(const Components& components, const char* weight_help) {
  std::vector<Socket> out{socket("members", components.types().named("Vector"), "a movement", false)};
  if (weight_help != nullptr) {
    out.push_back(socket("weight", components.types().named("gain"), weight_help, false));
    out.back().initial = "1";
  }
  return out;
}

}  // namespace

std::optional<OperatorShape> operator_of(const cdl::Expression& expression) {
  const auto& what = expression.what;
  if (std::holds_alternative<cdl::Cooperate>(what))
    return OperatorShape{Node::COOPERATION, "cooperate", "cooperate",
                         "All members at once, each with its gain."};
  if (const auto* compete = std::get_if<cdl::Compete>(&what)) {
    if (compete->rule == cdl::CompetitionRule::kPriority)
      return OperatorShape{Node::COMPETITION, "compete by priority", "compete",
                           "The first member that wants anything."};
    return OperatorShape{Node::COMPETITION, "compete by strength", "compete",
                         "The member with the strongest activation."};
  }
  if (const auto* coordinate = std::get_if<cdl::Coordinate>(&what))
    return OperatorShape{Node::COORDINATION, "coordinate by " + coordinate->by.callee.text, "coordinate",
                         "Members put together by a procedure."};
  if (const auto* fuse = std::get_if<cdl::Fuse>(&what))
    return OperatorShape{Node::FUSION, "fuse by " + fuse->by.callee.text, "fuse",
                         "Percepts put together by a procedure."};
  if (std::holds_alternative<cdl::Sequence>(what))
    return OperatorShape{Node::SEQUENCE, "sequence", "sequence", "One state at a time."};
  if (std::holds_alternative<cdl::Select>(what))
    return OperatorShape{Node::SELECTION, "select", "select", "The case that the selector says."};
  if (std::holds_alternative<cdl::Delay>(what))
    return OperatorShape{Node::DELAY, "delay", "delay", "The value of the cycle before; breaks loops."};
  if (std::holds_alternative<cdl::Arithmetic>(what))
    return OperatorShape{Node::FORMULA, "formula", "formula",
                         "Computes with numbers, vectors and their units."};
  const auto* logic = std::get_if<cdl::Logic>(&what);
  if (logic == nullptr) return std::nullopt;
  switch (logic->connective) {
    case cdl::Connective::kNot:
      return OperatorShape{Node::LOGIC, "not", "logic", "True where its input is false."};
    case cdl::Connective::kAnd:
      return OperatorShape{Node::LOGIC, "and", "logic", "True where all inputs are."};
    default:
      return OperatorShape{Node::LOGIC, "or", "logic", "True where one of the inputs is."};
  }
}

bool is_operator(const Callable& component) {
  return component.kind == Callable::Kind::kProcedure && count_lists(component) > 0 &&
         is_movement(component.output);
}

Node::Shape shape_of(const Callable& component) {
  if (component.kind == Callable::Kind::kAssemblage) return Node::ASSEMBLAGE;
  if (component.kind == Callable::Kind::kBinding) return Node::BINDING;
  if (component.kind == Callable::Kind::kFunction) return Node::FORMULA;
  if (component.gives_nothing) return Node::ACTUATOR;
  if (is_operator(component)) return Node::COORDINATION;
  return is_movement(component.output) ? Node::BEHAVIOR : Node::PERCEPTION;
}

std::string icon_of(const Callable& component) {
  const bool is_trigger = component.output.type != nullptr && component.output.type->kind == TypeKind::kBool;
  if (component.kind == Callable::Kind::kAssemblage) return is_trigger ? "trigger" : "assemblage";
  if (component.kind == Callable::Kind::kBinding) return "binding";
  if (component.kind == Callable::Kind::kFunction) return "formula";
  if (component.gives_nothing) return "actuator";
  if (is_logic(component)) return "logic";
  if (is_operator(component)) return "coordinate";
  if (is_movement(component.output)) return "behavior";
  return is_trigger ? "trigger" : "perception";
}

std::string group_of(const Callable& component) {
  const bool is_trigger = component.output.type != nullptr && component.output.type->kind == TypeKind::kBool;
  if (component.kind == Callable::Kind::kAssemblage) return "Assemblages";
  if (component.kind == Callable::Kind::kBinding) return "Sensors";
  if (component.kind == Callable::Kind::kFunction) return "Numbers";
  if (component.gives_nothing) return "Actuators";
  if (is_logic(component)) return "Logic";
  if (is_operator(component)) return "Operators";
  if (is_movement(component.output)) return "Motor schemas";
  return is_trigger ? "Triggers" : "Perception";
}

std::vector<Socket> sockets(const GraphNode& node, const Components& components, const OwnerGraph& graph) {
  using Kind = GraphNode::Kind;
  if (node.kind == Kind::kActuator) {
    const auto binding = components.configuration().bindings.find(node.drive->binding.text);
    const bool is_known =
        binding != components.configuration().bindings.end() && !binding->second->parameters.empty();
    if (!is_known) return {};
    Socket out = components.socket(binding->second->parameters.front());
    out.name = "v";
    return {out};
  }
  if (node.expression == nullptr) return {};
  if (node.kind == Kind::kFormula) {
    std::vector<Socket> out{socket("formula", graph.type_of(*node.expression),
                                   "what is computed, 2 * near + 1 m for instance", true)};
    for (const GraphInput& input : node.inputs) {
      if (input.role == Role::kTerm)
        out.push_back(socket(input.port, graph.type_of(*input.written), "what the formula reads", true));
    }
    return out;
  }
  const auto& what = node.expression->what;
  if (const auto* call = std::get_if<cdl::Call>(&what)) {
    const std::optional<Callable>& component = components.find(call->callee.text);
    return component ? component->inputs : std::vector<Socket>{};
  }
  if (std::holds_alternative<cdl::Cooperate>(what)) return movements(components, "how much it counts");
  if (const auto* compete = std::get_if<cdl::Compete>(&what)) {
    const bool is_priority = compete->rule == cdl::CompetitionRule::kPriority;
    return movements(components, is_priority ? nullptr : "how strong it is");
  }
  if (const auto* coordinate = std::get_if<cdl::Coordinate>(&what))
    return generic(coordinate->by, components);
  if (const auto* fuse = std::get_if<cdl::Fuse>(&what)) return generic(fuse->by, components);
  if (std::holds_alternative<cdl::Logic>(what))
    return {socket("in", components.types().named("bool"), "", true)};
  const cdl::PortType own = graph.type_of(*node.expression);
  if (std::holds_alternative<cdl::Delay>(what))
    return {socket("value", own, "what is delayed", true),
            socket("initial", own, "what it gives first", false)};
  if (std::holds_alternative<cdl::Select>(what)) {
    const auto& select = std::get<cdl::Select>(what);
    const cdl::PortType by = select.by ? graph.type_of(*select.by) : cdl::PortType{};
    return {socket("by", by, "which case", true), socket("case", own, "", true)};
  }
  return {};
}

}  // namespace mlab::designer
