#include "mlab/export/network_view.h"

#include <set>
#include <utility>

#include <fmt/core.h>

namespace mlab::exports {

using flow::Node;

NetworkView::NetworkView(const flow::Network& network, const flow::Library& library)
    : network_(network), library_(library) {
  for (const Node& node : network.nodes) nodes_.emplace(node.name, &node);
  for (const flow::Parameter& parameter : network.parameters) {
    parameters_.emplace(parameter.name, &parameter);
    for (const std::string& other : parameter.other_names) parameters_.emplace(other, &parameter);
  }
  for (const Node& node : network.nodes) {
    for (const flow::Link& link : node.links) add(link.source, node, link.input, Wire::Role::kInput);
    if (node.kind == Node::Kind::kSelect) add(node.selector, node, "by", Wire::Role::kSelector);
    for (const flow::Case& one : node.cases) add(one.member, node, case_name(one), Wire::Role::kMember);
    for (const flow::State& state : node.states) {
      add(state.member, node, state.name, Wire::Role::kMember);
      for (const flow::Transition& transition : state.transitions)
        add(transition.trigger, node, state.name, Wire::Role::kTrigger);
    }
  }
}

void NetworkView::add(const flow::Source& source, const Node& to, std::string port, Wire::Role role) {
  if (source.kind != flow::Source::Kind::kName) return;
  const auto parameter = parameters_.find(source.text);
  const bool is_node = nodes_.contains(source.text);
  if (!is_node && parameter == parameters_.end()) return;
  wires_.push_back({is_node ? source.text : parameter->second->name, to.name, std::move(port), role});
}

const Node* NetworkView::node(std::string_view name) const {
  const auto found = nodes_.find(name);
  return found == nodes_.end() ? nullptr : found->second;
}

const flow::Behavior* NetworkView::behavior(const Node& node) const {
  return node.kind == Node::Kind::kBehavior ? library_.find(node.behavior).behavior : nullptr;
}

std::string NetworkView::type(const Node& node) const {
  if (node.kind != Node::Kind::kBehavior) return node.behavior;
  const flow::Behavior* found = behavior(node);
  return found == nullptr || found->output == nullptr ? "" : std::string(found->output->name);
}

std::string NetworkView::unit(const Node& node) const {
  const flow::Behavior* found = behavior(node);
  return found == nullptr ? "" : std::string(found->output_unit);
}

std::vector<const Node*> NetworkView::inputs(const Node& node) const {
  std::vector<const Node*> out;
  for (const flow::Link& link : node.links) {
    const Node* from = link.source.kind == flow::Source::Kind::kName ? this->node(link.source.text) : nullptr;
    if (from != nullptr) out.push_back(from);
  }
  return out;
}

std::vector<const Node*> NetworkView::roots() const {
  std::vector<const Node*> out;
  for (const Node& node : network_.nodes) {
    if (node.is_public || type(node).empty()) out.push_back(&node);
  }
  return out;
}

std::string case_name(const flow::Case& one) {
  if (one.values.empty()) return "otherwise";
  std::string out = "case";
  for (const std::int64_t value : one.values)
    out += value < 0 ? fmt::format("_minus{}", -value) : fmt::format("_{}", value);
  return out;
}

}  // namespace mlab::exports
