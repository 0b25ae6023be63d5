#include "mlab/designer/edit/find/pages.h"

#include <set>
#include <vector>

#include <fmt/core.h>

#include "mlab/designer/drawing/components.h"
#include "mlab/designer/drawing/serving.h"
#include "mlab/designer/drawing/shapes.h"
#include "mlab/designer/edit/refusal.h"
#include "mlab/designer/edit/values.h"
#include "mlab/text/shown.h"

namespace mlab::designer {

text::Result<PageView> find_page(const Model& model, const std::string& path) {
  const Model::FoundPage found = model.page(path);
  if (found.graph == nullptr) return refusal(why_no_components(model, path));
  return PageView{found.graph, &found.graph->pages[static_cast<std::size_t>(found.page)]};
}

text::Result<int> find_node(const PageView& view, const std::string& name) {
  const int found = view.page->find(name);
  if (found < 0) return refusal(fmt::format("there is no `{}` on this page", text::shown(name)));
  return found;
}

text::Result<Spot> find_spot(const PageView& view, const std::string& node, const std::string& port,
                             std::optional<std::uint32_t> index, bool for_new) {
  Spot out{view, -1, -1, ""};
  if (node == "$result") {
    if (view.page->sequence != nullptr) return refusal("a sequence gives what its states give");
    if (view.graph->robot != nullptr && view.page->parent < 0)
      return refusal("a robot gives nothing: it drives actuators");
    return out;
  }
  if (node.starts_with('$') && view.page->find(node) < 0) {
    const bool is_actuator = view.graph->robot != nullptr && view.page->parent < 0 &&
                             is_cdl_name(std::string_view(node).substr(1));
    if (!is_actuator) return refusal(fmt::format("there is no `{}` on this page", text::shown(node)));
    out.drive = node.substr(1);
    return out;
  }
  const text::Result<int> found = find_node(view, node);
  if (!found) return std::unexpected(found.error());
  out.node = *found;
  const GraphNode& there = view.node(*found);
  const bool is_drive = there.kind == GraphNode::Kind::kActuator;
  for (std::size_t i = 0; i < there.inputs.size(); ++i) {
    const GraphInput& input = there.inputs[i];
    if (!is_drive && input.port != port) continue;
    const bool is_it =
        is_drive || (index                      ? input.index == index && !input.is_open
                     : for_new && input.is_open ? true
                                                : !input.is_open && (!for_new || !input.index));
    if (is_it) {
      out.input = static_cast<int>(i);
      return out;
    }
  }
  // An index one behind the last means one more.
  for (std::size_t i = 0; i < there.inputs.size(); ++i) {
    if (for_new && index && there.inputs[i].port == port && there.inputs[i].is_open) {
      out.input = static_cast<int>(i);
      return out;
    }
  }
  return refusal(fmt::format("`{}` has no input `{}`", text::shown(node), text::shown(port)));
}

const cdl::Expression* Spot::written() const {
  if (is_result()) return view.page->root;
  const GraphInput* there = at();
  return there == nullptr ? nullptr : there->written.get();
}

int Spot::inline_node() const {
  if (is_result()) {
    const int result = view.page->result;
    if (result < 0) return -1;
    return view.node(result).expression == view.page->root ? result : -1;
  }
  const GraphInput* there = at();
  return there != nullptr && there->is_inline ? there->from : -1;
}

std::optional<Spot> reader_of(const OwnerGraph& graph, std::string_view name) {
  const auto reads = [&](const cdl::Expression* written) {
    const auto* one = written == nullptr ? nullptr : std::get_if<cdl::Name>(&written->what);
    return one != nullptr && one->name.text == name;
  };
  for (const GraphPage& page : graph.pages) {
    for (std::size_t i = 0; i < page.nodes.size(); ++i) {
      for (std::size_t k = 0; k < page.nodes[i].inputs.size(); ++k) {
        if (reads(page.nodes[i].inputs[k].written.get()))
          return Spot{{&graph, &page}, static_cast<int>(i), static_cast<int>(k), ""};
      }
    }
    if (reads(page.root)) return Spot{{&graph, &page}, -1, -1, ""};
  }
  return std::nullopt;
}

cdl::PortType wanted_type(const Model& model, const Spot& spot) {
  const Components& components = model.components();
  if (spot.is_result()) {
    const OwnerGraph& graph = *spot.view.graph;
    if (spot.view.page->asks != nullptr) return components.types().named("bool");
    if (spot.view.page->parent < 0 && graph.assemblage != nullptr &&
        !graph.assemblage->result_type.text.empty())
      return components.types().named(graph.assemblage->result_type.text);
    return {};
  }
  if (!spot.drive.empty()) {
    const auto binding = components.configuration().bindings.find(spot.drive);
    const bool is_known =
        binding != components.configuration().bindings.end() && !binding->second->parameters.empty();
    return is_known ? components.types().of(binding->second->parameters.front()) : cdl::PortType{};
  }
  const GraphNode& node = spot.view.node(spot.node);
  const GraphInput& input = *spot.at();
  // What these take is what they are given.
  const bool is_any = input.role == Role::kDelayed || input.role == Role::kInitial ||
                      input.role == Role::kSelector || input.role == Role::kCase ||
                      input.role == Role::kValue || input.role == Role::kFormula ||
                      input.role == Role::kTerm || input.role == Role::kActive;
  if (is_any) return {};
  for (const Socket& socket : sockets(node, components, *spot.view.graph)) {
    if (socket.name == input.port) return socket.type;
  }
  return {};
}

bool reaches(const PageView& view, int from, int to) {
  // Backwards through all that drives `from`.
  std::set<int> seen;
  std::vector<int> open{from};
  while (!open.empty()) {
    const int at = open.back();
    open.pop_back();
    if (at == to) return true;
    if (at < 0 || !seen.insert(at).second) continue;
    const GraphNode& node = view.node(at);
    for (const GraphInput& input : node.inputs) {
      if (input.role != Role::kDelayed && input.from >= 0) open.push_back(input.from);
    }
  }
  return false;
}

}  // namespace mlab::designer
