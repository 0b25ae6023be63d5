#include "mlab/export/graph.h"

#include <map>
#include <set>
#include <string_view>

#include <nlohmann/json.hpp>

#include "mlab/export/network_view.h"
#include "mlab/flow/limit.h"

namespace mlab::exports {
namespace {

using Json = nlohmann::ordered_json;
using flow::Node;

std::string group_of(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string::npos ? "" : path.substr(0, dot);
}

Json place_json(const text::Place& place) {
  if (!place.source) return nullptr;
  const text::LineColumn at = place.source->line_column(place.span.begin);
  return {{"file", place.source->name()}, {"line", at.line}, {"column", at.column}};
}

std::string_view kind_name(Node::Kind kind) {
  switch (kind) {
    case Node::Kind::kBehavior:
      return "behavior";
    case Node::Kind::kSequence:
      return "sequence";
    case Node::Kind::kSelect:
      return "select";
    case Node::Kind::kDelay:
      return "delay";
  }
  return "";
}

// What an input is given: a constant's text, or where the value comes from.
Json source_json(const flow::Source& source) {
  if (source.kind == flow::Source::Kind::kName) return {{"from", source.text}};
  return {{"constant", source.text}};
}

Json input_json(const flow::Input& input, const Node& node) {
  Json out = {{"name", input.name},
              {"type", input.type->name},
              {"unit", input.unit},
              {"help", input.help},
              {"list", input.is_list}};
  Json sources = Json::array();
  for (const flow::Link& link : node.links) {
    if (link.input == input.name) sources.push_back(source_json(link.source));
  }
  if (sources.empty() && !input.is_list) out["default"] = input.default_text;
  out["sources"] = std::move(sources);
  return out;
}

Json state_json(const flow::State& state) {
  Json transitions = Json::array();
  for (const flow::Transition& one : state.transitions) {
    transitions.push_back({{"trigger", source_json(one.trigger)},
                           {"negated", one.is_negated},
                           {"target", one.target},
                           {"restarts", one.restarts},
                           {"place", place_json(one.place)}});
  }
  return {{"name", state.name},
          {"start", state.is_start},
          {"final", state.is_final},
          {"member", source_json(state.member)},
          {"transitions", std::move(transitions)},
          {"place", place_json(state.place)}};
}

Json node_json(const Node& node, const NetworkView& view) {
  Json out;
  out["path"] = node.name;
  out["group"] = group_of(node.name);
  out["kind"] = kind_name(node.kind);
  if (node.kind == Node::Kind::kBehavior) out["component"] = node.behavior;
  const std::string type = view.type(node);
  out["type"] = type.empty() ? Json(nullptr) : Json(type);
  out["unit"] = view.unit(node);
  Json inputs = Json::array();
  if (const flow::Behavior* behavior = view.behavior(node)) {
    for (const flow::Input& input : behavior->inputs) inputs.push_back(input_json(input, node));
  } else {
    for (const flow::Link& link : node.links)
      inputs.push_back({{"name", link.input}, {"sources", Json::array({source_json(link.source)})}});
  }
  out["inputs"] = std::move(inputs);
  if (node.kind == Node::Kind::kSequence) {
    out["states"] = Json::array();
    for (const flow::State& state : node.states) out["states"].push_back(state_json(state));
  }
  if (node.kind == Node::Kind::kSelect) {
    out["selector"] = source_json(node.selector);
    out["cases"] = Json::array();
    for (const flow::Case& one : node.cases)
      out["cases"].push_back(
          {{"name", case_name(one)}, {"values", one.values}, {"member", source_json(one.member)}});
  }
  out["place"] = place_json(node.place);
  return out;
}

std::string_view role_name(Wire::Role role) {
  switch (role) {
    case Wire::Role::kInput:
      return "input";
    case Wire::Role::kMember:
      return "member";
    case Wire::Role::kTrigger:
      return "trigger";
    case Wire::Role::kSelector:
      return "selector";
  }
  return "";
}

Json groups_json(const flow::Network& network) {
  std::set<std::string> groups;
  for (const Node& node : network.nodes) {
    for (std::string group = group_of(node.name); !group.empty(); group = group_of(group))
      groups.insert(group);
  }
  Json out = Json::array();
  for (const std::string& group : groups) out.push_back({{"path", group}, {"parent", group_of(group)}});
  return out;
}

Json layout_json(const cdl::Configuration& configuration) {
  Json out = Json::array();
  for (const auto& tree : configuration.trees) {
    for (const cdl::Item& item : tree->items) {
      const auto* layout = std::get_if<cdl::Layout>(&item);
      if (layout == nullptr) continue;
      for (const cdl::LayoutEntry& entry : layout->entries)
        out.push_back(
            {{"owner", layout->owner.text}, {"node", entry.node.text}, {"x", entry.x}, {"y", entry.y}});
    }
  }
  return out;
}

}  // namespace

std::optional<std::string> write_graph(const Subject& subject, text::Diagnostics&) {
  const NetworkView view(subject.network, subject.library);
  Json out;
  out["version"] = 1;
  out["robot"] = subject.robot.name.text;
  out["class"] = subject.robot.class_name.text;
  out["architecture"] = subject.configuration.architecture;
  out["parameters"] = Json::array();
  for (const flow::Parameter& one : subject.network.parameters) {
    Json parameter = {{"name", one.name},
                      {"type", one.type},
                      {"unit", one.unit},
                      {"help", one.help},
                      {"value", one.initial.text}};
    if (flow::is_limit(one.min)) parameter["min"] = one.min;
    if (flow::is_limit(one.max)) parameter["max"] = one.max;
    out["parameters"].push_back(std::move(parameter));
  }
  out["groups"] = groups_json(subject.network);
  out["nodes"] = Json::array();
  for (const Node& node : subject.network.nodes) out["nodes"].push_back(node_json(node, view));
  out["wires"] = Json::array();
  for (const Wire& wire : view.wires())
    out["wires"].push_back(
        {{"from", wire.from}, {"to", wire.to}, {"port", wire.port}, {"role", role_name(wire.role)}});
  out["layout"] = layout_json(subject.configuration);
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace mlab::exports
