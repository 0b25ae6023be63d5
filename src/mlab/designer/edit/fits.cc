// What may be connected on a page, while somebody draws a wire or holds a component over it.

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mlab/designer/drawing/serving.h"
#include "mlab/designer/drawing/shapes.h"
#include "mlab/designer/edit/edit.h"

namespace mlab::designer {
namespace {

constexpr const char* kLoop = "that would be a loop without a delay";

class Fitting {
 public:
  Fitting(const Model& model, const Model::FoundPage& found, const std::vector<Offered>& offered)
      : model_(model),
        graph_(*found.graph),
        page_(found.graph->pages[static_cast<std::size_t>(found.page)]),
        offered_(offered) {}

  FitList of(const Fits& request) {
    if (!request.to_node().empty())
      sources_for(request);
    else
      targets_for(request);
    return std::move(out_);
  }

 private:
  // What may drive an input of a node, or the page's result.
  void sources_for(const Fits& request) {
    cdl::PortType type = result_type();
    int target = -1;
    if (request.to_node() != "$result") {
      target = page_.find(request.to_node());
      if (target < 0) return;
      type = {};
      const GraphNode& node = page_.nodes[static_cast<std::size_t>(target)];
      for (const GraphInput& input : node.inputs) {
        if (input.port == request.to_port()) type = wanted_by(node, input);
      }
    }
    for (std::size_t i = 0; i < page_.nodes.size(); ++i) {
      const GraphNode& node = page_.nodes[i];
      if (node.kind == GraphNode::Kind::kActuator) continue;
      std::string reason = why_not(graph_.type_of(node), type);
      if (reason.empty() && target >= 0 && reads(static_cast<int>(i), target)) reason = kLoop;
      add(node.name, "", {}, reason);
    }
    components_for(type);
  }

  void components_for(const cdl::PortType& type) {
    const Components& components = model_.components();
    const auto add_component = [&](const Callable& component) {
      if (!component.gives_nothing) add(component.name, "component", {}, why_not(component.output, type));
    };
    for (const auto& [name, assemblage] : model_.configuration().assemblages)
      add_component(components.of(*assemblage));
    for (const auto& [name, binding] : model_.configuration().bindings)
      add_component(components.of(*binding));
    for (const flow::Behavior* behavior : model_.library().behaviors())
      add_component(components.of(flow::Library::Entry{behavior, nullptr}));
    for (const Offered& file : offered_) {
      for (const Callable& component : callables_of(*file.model)) add_component(component);
    }
  }

  // What a node, or a component that is to become one, may drive.
  void targets_for(const Fits& request) {
    cdl::PortType type;
    int from = -1;
    if (request.component().empty()) {
      from = page_.find(request.from_node());
      if (from < 0) return;
      type = graph_.type_of(page_.nodes[static_cast<std::size_t>(from)]);
    } else {
      type = output_of(request.component());
    }
    for (std::size_t i = 0; i < page_.nodes.size(); ++i) {
      const GraphNode& node = page_.nodes[i];
      for (const GraphInput& input : node.inputs) {
        if (input.role == Role::kValue || input.role == Role::kFormula || input.role == Role::kTerm ||
            input.role == Role::kActive)
          continue;
        std::string reason = why_not(type, wanted_by(node, input));
        if (reason.empty() && from >= 0 && input.role != Role::kDelayed && reads(from, static_cast<int>(i)))
          reason = kLoop;
        add(node.name, input.port, input.index, reason);
      }
    }
    if (page_.sequence == nullptr && !(graph_.robot != nullptr && page_.parent < 0))
      add("$result", "", {}, why_not(type, result_type()));
  }

  // Of a component by its name, or of an operator; empty: any.
  cdl::PortType output_of(const std::string& name) const {
    const Components& components = model_.components();
    if (const Offered* file = find_offered(offered_, model_, name))
      return find_callable(callables_of(*file->model), name)->output;
    if (const std::optional<Callable> component = components.find(name)) return component->output;
    if (name == "delay" || name == "select" || name == "formula") return {};
    const bool is_logic = name == kComparison || name == "not" || name == "and" || name == "or";
    return components.types().named(is_logic ? "bool" : "Vector");
  }

  cdl::PortType wanted_by(const GraphNode& node, const GraphInput& input) const {
    const bool is_any = input.role == Role::kDelayed || input.role == Role::kInitial ||
                        input.role == Role::kSelector || input.role == Role::kCase ||
                        input.role == Role::kValue;
    if (is_any) return {};
    for (const Socket& socket : sockets(node, model_.components(), graph_)) {
      if (socket.name == input.port) return socket.type;
    }
    return {};
  }

  cdl::PortType result_type() const {
    if (page_.asks != nullptr) return model_.components().types().named("bool");
    const bool is_owner = page_.parent < 0 && graph_.assemblage != nullptr;
    return is_owner ? model_.components().types().named(graph_.assemblage->result_type.text)
                    : cdl::PortType{};
  }

  // Directly or not, without a delay.
  bool reads(int start, int wanted) const {
    std::vector<int> open{start};
    std::vector<bool> seen(page_.nodes.size(), false);
    while (!open.empty()) {
      const auto at = static_cast<std::size_t>(open.back());
      open.pop_back();
      if (static_cast<int>(at) == wanted) return true;
      if (seen[at]) continue;
      seen[at] = true;
      for (const GraphInput& input : page_.nodes[at].inputs) {
        if (input.from >= 0 && input.role != Role::kDelayed) open.push_back(input.from);
      }
    }
    return false;
  }

  void add(const std::string& node, const std::string& port, std::optional<std::uint32_t> index,
           const std::string& reason) {
    FitList::Fit& fit = *out_.add_fits();
    fit.set_node(node);
    fit.set_port(port);
    if (index) fit.set_index(*index);
    fit.set_reason(reason);
  }

  const Model& model_;
  const OwnerGraph& graph_;
  const GraphPage& page_;
  const std::vector<Offered>& offered_;
  FitList out_;
};

void add_fit(const std::string& node, const char* port, const std::string& reason, FitList& out) {
  FitList::Fit& fit = *out.add_fits();
  fit.set_node(node);
  fit.set_port(port);
  fit.set_reason(reason);
}

// What may serve a binding point; as for inputs, with the project's files that are not used yet.
FitList servers_of(const Model& model, const std::string& point, const std::vector<Offered>& offered) {
  FitList out;
  const Components& components = model.components();
  const auto binding = model.configuration().bindings.find(point);
  if (binding == model.configuration().bindings.end()) return out;
  const auto add = [&](const Callable& component) {
    add_fit(component.name, "component", why_not_serving(component, *binding->second, components), out);
  };
  for (const auto& [name, assemblage] : model.configuration().assemblages) add(components.of(*assemblage));
  for (const flow::Behavior* behavior : model.library().behaviors())
    add(components.of(flow::Library::Entry{behavior, nullptr}));
  for (const Offered& file : offered) {
    for (const Callable& component : callables_of(*file.model)) add(component);
  }
  return out;
}

// Which binding points a device, or a component that is to become one, may serve.
FitList points_for(const Model& model, const Equipped& owner, const Fits& request,
                   const std::vector<Offered>& offered) {
  FitList out;
  constexpr std::string_view kPoint = "$point.";
  if (request.from_node().starts_with(kPoint)) {
    const auto binding = model.configuration().bindings.find(request.from_node().substr(kPoint.size()));
    const bool is_known = binding != model.configuration().bindings.end();
    for (const cdl::Device& one : is_known ? owner.devices() : std::vector<cdl::Device>()) {
      const std::optional<Callable>& by = model.components().find(one.by.callee.text);
      const auto& driven = binding->second->parameters;
      if (by && !driven.empty())
        add_fit(one.name.text, driven.front().name.text.c_str(),
                why_not_serving(*by, *binding->second, model.components()), out);
    }
    return out;
  }
  const cdl::Device* device = owner.device(request.from_node());
  const std::string name = !request.component().empty() ? request.component()
                           : device != nullptr          ? device->by.callee.text
                                                        : "";
  std::optional<Callable> by = model.components().find(name);
  if (const Offered* file = find_offered(offered, model, name))
    by = *find_callable(callables_of(*file->model), name);
  if (!by) return out;
  for (const auto& [point, binding] : model.configuration().bindings)
    add_fit("$point." + point, "served_by", why_not_serving(*by, *binding, model.components()), out);
  return out;
}

}  // namespace

FitList fitting(const Model& model, const Fits& request, const std::vector<Offered>& offered) {
  if (const Equipped owner = equipped(model, request.page())) {
    return request.to_port().empty() ? points_for(model, owner, request, offered)
                                     : servers_of(model, request.to_port(), offered);
  }
  const Model::FoundPage found = model.page(request.page());
  return found.graph == nullptr ? FitList() : Fitting(model, found, offered).of(request);
}

}  // namespace mlab::designer
