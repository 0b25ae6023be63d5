// What the names of a change stand for, and whether a wire fits.

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/drawing/shapes.h"
#include "mlab/designer/edit/edit.h"
#include "mlab/designer/edit/editor.h"
#include "mlab/designer/edit/values.h"
#include "mlab/text/shown.h"

namespace mlab::designer {

text::Result<PageView> Editor::page(const std::string& path) const {
  const Model::Found found = work_.model().page(path);
  if (found.graph == nullptr) return refusal(why_no_components(work_.model(), path));
  return PageView{found.graph, &found.graph->pages[static_cast<std::size_t>(found.page)]};
}

text::Result<int> Editor::node(const PageView& view, const std::string& name) const {
  const int found = view.page->find(name);
  if (found < 0) return refusal(fmt::format("there is no `{}` on this page", text::shown(name)));
  return found;
}

text::Result<Spot> Editor::spot(const PageView& view, const std::string& node, const std::string& port,
                                std::optional<std::uint32_t> index, bool for_new) const {
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
  const text::Result<int> found = this->node(view, node);
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

const cdl::Expression* Editor::written(const Spot& spot) const {
  if (spot.is_result()) return spot.view.page->root;
  const GraphInput* input = spot.at();
  return input == nullptr ? nullptr : input->written.get();
}

int Editor::inline_node(const Spot& spot) const {
  if (spot.is_result()) {
    const int result = spot.view.page->result;
    if (result < 0) return -1;
    return spot.view.node(result).expression == spot.view.page->root ? result : -1;
  }
  const GraphInput* input = spot.at();
  return input != nullptr && input->is_inline ? input->from : -1;
}

std::optional<Spot> Editor::reader_of(const OwnerGraph& graph, std::string_view name) {
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

cdl::PortType Editor::wanted(const Spot& spot) const {
  const Components& components = work_.model().components();
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

cdl::PortType Editor::given(const PageView& view, int at) const {
  return view.graph->type_of(view.node(at));
}

bool Editor::is_taken(const PageView& view, std::string_view name) const {
  const auto is_it = [&](const auto& one) { return one.name.text == name; };
  return std::ranges::any_of(view.graph->lets(), is_it) ||
         std::ranges::any_of(view.graph->parameters(), is_it) ||
         given_names_.contains({view.graph->name, std::string(name)});
}

std::string Editor::free_name(const PageView& view, const std::string& wanted) const {
  std::set<std::string> taken;
  for (const cdl::Let& let : view.graph->lets()) taken.insert(let.name.text);
  for (const cdl::Parameter& parameter : view.graph->parameters()) taken.insert(parameter.name.text);
  for (const auto& [owner, name] : given_names_) {
    if (owner == view.graph->name) taken.insert(name);
  }
  const GraphPage& own = view.graph->pages.front();
  for (const GraphNode& node : own.nodes) taken.insert(node.name);
  if (own.sequence != nullptr) {
    for (const cdl::State& state : own.sequence->states) taken.insert(state.name.text);
  }
  return unique(wanted, taken);
}

bool Editor::reaches(const PageView& view, int from, int to) const {
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
