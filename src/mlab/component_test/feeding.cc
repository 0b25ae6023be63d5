#include "mlab/component_test/feeding.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/core.h>

namespace mlab::component_test {
namespace {

using flow::Node;
using flow::Source;

std::vector<std::string> sources_of(const Node& node) {
  std::vector<std::string> out;
  const auto add = [&](const Source& source) {
    if (source.kind == Source::Kind::kName) out.push_back(source.text);
  };
  for (const flow::Link& link : node.links) add(link.source);
  add(node.selector);
  for (const flow::Case& one : node.cases) add(one.member);
  for (const flow::State& state : node.states) {
    add(state.member);
    for (const flow::Transition& transition : state.transitions) add(transition.trigger);
  }
  return out;
}

bool is_inside(const text::Place& at, const text::Place& inside) {
  return at.source && at.source == inside.source && at.span.begin >= inside.span.begin &&
         at.span.end <= inside.span.end && at.span.begin < at.span.end;
}

std::string words_of(const Node& node, const text::Place& inside) {
  return is_inside(node.place, inside) ? in_short(node.place.source->text(node.place.span), 48) : node.name;
}

// Digits that nobody reads are left out.
std::string value_of(const flow::Program& program, const std::byte* frame, const flow::Port& port) {
  const std::string unit = port.unit.empty() ? "" : " " + port.unit;
  const auto rounded = [](double number) {
    return fmt::format("{:.4g}", std::abs(number) < 1e-9 ? 0.0 : number);
  };
  if (const auto vector = program.vector(frame, port))
    return fmt::format("[{}, {}]{}", rounded(vector->x), rounded(vector->y), unit);
  if (port.type->kind == flow::TypeKind::kReal) {
    if (const auto number = program.number(frame, port)) return rounded(*number) + unit;
  }
  return in_short(flow::Program::print(frame, port));
}

}  // namespace

std::string in_short(std::string_view text, std::size_t most) {
  std::string out;
  bool was_blank = false;
  for (const char c : text) {
    const bool is_blank = static_cast<unsigned char>(c) <= ' ';
    if (!is_blank && was_blank && !out.empty()) out += ' ';
    if (!is_blank) out += c;
    was_blank = is_blank;
    if (out.size() <= most) continue;
    std::size_t end = most - 3;
    while (end > 0 && (static_cast<unsigned char>(out[end]) & 0xC0U) == 0x80U) --end;
    return out.substr(0, end) + "...";
  }
  return out;
}

std::vector<const flow::Port*> written_below(const flow::Network& network, const flow::Program& program,
                                             const std::string& node, const text::Place& inside) {
  std::map<std::string_view, const Node*> nodes;
  for (const Node& one : network.nodes) nodes.try_emplace(one.name, &one);
  std::vector<const flow::Port*> out;
  std::set<std::string> seen = {node};
  std::vector<std::string> next = {node};
  for (std::size_t i = 0; i < next.size(); ++i) {
    const auto found = nodes.find(next[i]);
    if (found == nodes.end() || !is_inside(found->second->place, inside)) continue;
    if (const flow::Port* port = program.find(next[i])) out.push_back(port);
    for (std::string& source : sources_of(*found->second)) {
      if (seen.insert(source).second) next.push_back(std::move(source));
    }
  }
  return out;
}

std::vector<NodeValue> feeding(const flow::Network& network, const flow::Program& program,
                               const std::byte* frame, std::span<const std::uint32_t> ran,
                               const std::string& node, const text::Place& inside) {
  std::map<std::string_view, const Node*> nodes;
  for (const Node& one : network.nodes) nodes.try_emplace(one.name, &one);
  std::vector<NodeValue> out;
  std::set<std::string> seen = {node};
  std::vector<std::string> next = {node};
  for (std::size_t i = 0; i < next.size() && out.size() < kMostSaid; ++i) {
    const auto found = nodes.find(next[i]);
    if (i > 0) {
      const flow::Port* port = program.find(next[i]);
      if (port == nullptr) continue;
      const bool has_run =
          port->role != flow::Port::Role::kOutput || std::ranges::binary_search(ran, port->offset);
      if (!has_run) continue;
      out.push_back({found == nodes.end() ? next[i] : words_of(*found->second, inside),
                     value_of(program, frame, *port), next[i]});
    }
    if (found == nodes.end()) continue;
    for (std::string& source : sources_of(*found->second)) {
      if (seen.insert(source).second) next.push_back(std::move(source));
    }
  }
  return out;
}

}  // namespace mlab::component_test
