#include <map>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "mlab/export/graph.h"
#include "mlab/export/network_view.h"

namespace mlab::exports {
namespace {

using flow::Node;

std::string dot_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

// The nodes of a group, and the groups in it.
struct Group {
  std::vector<const Node*> nodes;
  std::map<std::string, Group> groups;
};

std::string shape(const Node& node, const NetworkView& view) {
  if (node.kind == Node::Kind::kSequence) return "octagon";
  if (node.kind == Node::Kind::kSelect) return "diamond";
  const std::string type = view.type(node);
  if (type.empty()) return "house";
  return type == "Vector" && view.unit(node).empty() ? "box" : "ellipse";
}

void put(const Node& node, const std::string& name, const NetworkView& view, const std::string& indent,
         std::string& out) {
  std::string label = name;
  if (node.kind == Node::Kind::kBehavior && node.behavior != name) label += "\\n" + node.behavior;
  for (const flow::State& state : node.states)
    label += fmt::format("\\n{}{}", state.name,
                         state.is_start   ? " (start)"
                         : state.is_final ? " (final)"
                                          : "");
  std::string text = dot_text(label);
  // `\n` is Graphviz's line break, not a backslash.
  for (std::size_t at = text.find("\\\\n"); at != std::string::npos; at = text.find("\\\\n", at))
    text.erase(at, 1);
  out += fmt::format("{}{} [label={}, shape={}];\n", indent, dot_text(node.name), text, shape(node, view));
}

void put(const Group& group, const std::string& path, const NetworkView& view, std::string& out) {
  std::size_t depth = 1;
  for (const char c : path) depth += c == '.' ? 1 : 0;
  const std::string indent((path.empty() ? depth : depth + 1) * 2, ' ');
  for (const Node* node : group.nodes)
    put(*node, path.empty() ? node->name : node->name.substr(path.size() + 1), view, indent, out);
  for (const auto& [name, inner] : group.groups) {
    const std::string inner_path = path.empty() ? name : path + "." + name;
    out += fmt::format("{}subgraph {} {{\n{}  label={};\n", indent, dot_text("cluster_" + inner_path), indent,
                       dot_text(name));
    put(inner, inner_path, view, out);
    out += indent + "}\n";
  }
}

std::string style(const Wire& wire) {
  switch (wire.role) {
    case Wire::Role::kInput:
      return fmt::format("label={}", dot_text(wire.port));
    case Wire::Role::kMember:
      return fmt::format("label={}, style=bold", dot_text(wire.port));
    case Wire::Role::kTrigger:
      return fmt::format("label={}, style=dashed", dot_text("leaves " + wire.port));
    case Wire::Role::kSelector:
      return "label=\"by\", style=dashed";
  }
  return "";
}

}  // namespace

std::optional<std::string> write_dot(const Subject& subject, text::Diagnostics&) {
  const NetworkView view(subject.network, subject.library);
  Group top;
  for (const Node& node : subject.network.nodes) {
    Group* group = &top;
    std::size_t begin = 0;
    for (std::size_t dot = node.name.find('.'); dot != std::string::npos; dot = node.name.find('.', begin)) {
      group = &group->groups[node.name.substr(begin, dot - begin)];
      begin = dot + 1;
    }
    group->nodes.push_back(&node);
  }
  std::string out = fmt::format("digraph {} {{\n  rankdir=LR;\n  node [fontname=\"sans-serif\"];\n",
                                dot_text(subject.robot.name.text));
  for (const flow::Parameter& one : subject.network.parameters)
    out += fmt::format("  {} [shape=note];\n", dot_text(one.name));
  put(top, "", view, out);
  for (const Wire& wire : view.wires())
    out += fmt::format("  {} -> {} [{}];\n", dot_text(wire.from), dot_text(wire.to), style(wire));
  return out + "}\n";
}

}  // namespace mlab::exports
