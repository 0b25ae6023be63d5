#include "mlab/designer/edit.h"

#include <utility>

#include <fmt/core.h>

#include "mlab/designer/editor.h"
#include "mlab/designer/shapes.h"

namespace mlab::designer {
namespace {

constexpr int kMostChanges = 10'000;

std::string several(int count, const std::string& one, const char* what) {
  return count == 1 ? one : fmt::format("{} {}", count, what);
}

// For undo, where the browser says nothing.
std::string name_of(const Change& change) {
  switch (change.change_case()) {
    case Change::kPlace:
      return "place " + change.place().component();
    case Change::kRemove:
      return "remove " + (change.remove().nodes().empty()
                              ? std::string()
                              : several(change.remove().nodes_size(), change.remove().nodes(0), "nodes"));
    case Change::kConnect:
      return change.connect().to_node() == "$result"
                 ? fmt::format("connect {} to the result", change.connect().from_node())
                 : fmt::format("connect {} to {}", change.connect().from_node(), change.connect().to_node());
    case Change::kDisconnect:
      return fmt::format("disconnect {} of {}", change.disconnect().to_port(), change.disconnect().to_node());
    case Change::kSetValue:
      return fmt::format("set {} of {}", change.set_value().port(), change.set_value().node());
    case Change::kExpose:
      return fmt::format("expose {} of {}", change.expose().port(), change.expose().node());
    case Change::kRename:
      return fmt::format("rename {} to {}", change.rename().node(), change.rename().name());
    case Change::kArrange:
      return "move " + several(change.arrange().nodes_size(),
                               change.arrange().nodes().empty() ? "" : change.arrange().nodes(0).node(),
                               "nodes");
    case Change::kSetActive:
      return "change the active part of " + change.set_active().node();
    case Change::kGroup:
      return "make assemblage " + change.group().name();
    case Change::kUngroup:
      return "take apart " + change.ungroup().node();
    case Change::kPaste:
      return "paste";
    case Change::kSetNote:
      return change.set_note().is_frame() ? "change a frame" : "change a note";
    case Change::kReplace:
      return fmt::format("replace {} by {}", change.replace().node(), change.replace().component());
    case Change::kAddDeclaration:
      return fmt::format("add {} {}", change.add_declaration().kind(), change.add_declaration().name());
    case Change::kSetParameter:
      return "change parameter " + change.set_parameter().name();
    case Change::kRemoveParameter:
      return "remove parameter " + change.remove_parameter().name();
    case Change::kSetHelp:
      return "describe " +
             (change.set_help().node().empty() ? change.set_help().page() : change.set_help().node());
    case Change::kCopyComponent:
      return "copy " + change.copy_component().component();
    case Change::kAddState:
      return "add a state";
    case Change::kSetState:
      return "change state " + change.set_state().state();
    case Change::kAddTransition:
      return fmt::format("add transition {} to {}", change.add_transition().from(),
                         change.add_transition().to());
    case Change::kSetTransition:
      return "change a transition of " + change.set_transition().from();
    case Change::kRemoveTransition:
      return "remove a transition of " + change.remove_transition().from();
    case Change::kSetClass:
      return change.set_class().class_name().empty() ? "make the robot abstract"
                                                     : "make it a " + change.set_class().class_name();
    case Change::kUseDevice:
      return "use " + change.use_device().device();
    case Change::kSetMember:
      return "change a member";
    case Change::kRemoveMember:
      return "remove a member";
    default:
      return "edit";
  }
}

}  // namespace

text::Result<Edited> edited(std::shared_ptr<const Model> model, const cdl::Environment& environment,
                            const Edit& edit, const std::vector<Offered>& offered) {
  if (!model->is_readable()) return refusal("the text has a slip of grammar: mend it first");
  if (edit.changes().empty()) return refusal("nothing is to be changed");
  if (edit.changes_size() > kMostChanges) return refusal("too many changes at once");
  const std::vector<std::string> files = files_needed(edit, *model, offered);
  Workspace work(std::move(model), environment);
  for (const std::string& file : files) {
    if (const Done done = add_use(work, file); !done) return std::unexpected(done.error());
  }
  Editor editor(work);
  for (const Change& change : edit.changes()) {
    if (const Done done = editor.apply(change); !done) return std::unexpected(done.error());
  }
  return Edited{std::string(work.text()), edit.name().empty() ? name_of(edit.changes(0)) : edit.name()};
}

// ---- what fits where

FitList fitting(const Model& model, const Fits& request, const std::vector<Offered>& offered) {
  FitList out;
  const Model::Found found = model.page(request.page());
  if (found.graph == nullptr) return out;
  const GraphPage& page = found.graph->pages[static_cast<std::size_t>(found.page)];
  const Components& components = model.components();
  const auto reads = [&](int start, int wanted) {  // directly or not, without a delay
    std::vector<int> open{start};
    std::vector<bool> seen(page.nodes.size(), false);
    while (!open.empty()) {
      const auto at = static_cast<std::size_t>(open.back());
      open.pop_back();
      if (static_cast<int>(at) == wanted) return true;
      if (seen[at]) continue;
      seen[at] = true;
      for (const GraphInput& input : page.nodes[at].inputs) {
        if (input.from >= 0 && input.role != Role::kDelayed) open.push_back(input.from);
      }
    }
    return false;
  };
  const auto wants = [&](const GraphNode& node, const GraphInput& input) -> cdl::PortType {
    const bool is_any = input.role == Role::kDelayed || input.role == Role::kInitial ||
                        input.role == Role::kSelector || input.role == Role::kCase ||
                        input.role == Role::kValue;
    if (is_any) return {};
    for (const Socket& socket : sockets(node, components, *found.graph)) {
      if (socket.name == input.port) return socket.type;
    }
    return {};
  };
  const auto result_type = [&]() -> cdl::PortType {
    const bool is_owner = page.parent < 0 && found.graph->assemblage != nullptr;
    return is_owner ? components.types().named(found.graph->assemblage->result_type.text) : cdl::PortType{};
  };
  const auto add = [&](const std::string& node, const std::string& port, std::optional<std::uint32_t> index,
                       const std::string& reason) {
    FitList::Fit& fit = *out.add_fits();
    fit.set_node(node);
    fit.set_port(port);
    if (index) fit.set_index(*index);
    fit.set_reason(reason);
  };

  if (!request.to_node().empty()) {
    cdl::PortType type;
    int target = -1;
    if (request.to_node() == "$result") {
      type = result_type();
    } else {
      target = page.find(request.to_node());
      if (target < 0) return out;
      const GraphNode& node = page.nodes[static_cast<std::size_t>(target)];
      for (const GraphInput& input : node.inputs) {
        if (input.port == request.to_port()) type = wants(node, input);
      }
    }
    for (std::size_t i = 0; i < page.nodes.size(); ++i) {
      const GraphNode& node = page.nodes[i];
      if (node.kind == GraphNode::Kind::kActuator) continue;
      std::string reason = why_not(found.graph->type_of(node), type);
      if (reason.empty() && target >= 0 && reads(static_cast<int>(i), target))
        reason = "that would be a loop without a delay";
      add(node.name, "", {}, reason);
    }
    const auto add_component = [&](const Callable& component) {
      if (component.gives_nothing) return;
      add(component.name, "component", {}, why_not(component.output, type));
    };
    for (const auto& [name, assemblage] : model.configuration().assemblages)
      add_component(components.of(*assemblage));
    for (const auto& [name, binding] : model.configuration().bindings) add_component(components.of(*binding));
    for (const flow::Behavior* behavior : model.library().behaviors())
      add_component(components.of(flow::Library::Entry{behavior, nullptr}));
    for (const Offered& file : offered) {
      for (const Callable& component : callables_of(*file.model)) add_component(component);
    }
    return out;
  }

  cdl::PortType type;
  int from = -1;
  if (!request.component().empty()) {
    std::optional<Callable> component = components.find(request.component());
    if (const Offered* file = find_offered(offered, model, request.component()))
      component = *find_callable(callables_of(*file->model), request.component());
    if (component) type = component->output;
    if (!component && request.component() != "delay" && request.component() != "select") {
      const bool is_logic =
          request.component() == "not" || request.component() == "and" || request.component() == "or";
      type = components.types().named(is_logic ? "bool" : "Vector");
    }
  } else {
    from = page.find(request.from_node());
    if (from < 0) return out;
    type = found.graph->type_of(page.nodes[static_cast<std::size_t>(from)]);
  }
  for (std::size_t i = 0; i < page.nodes.size(); ++i) {
    const GraphNode& node = page.nodes[i];
    for (const GraphInput& input : node.inputs) {
      if (input.role == Role::kValue || input.role == Role::kActive) continue;
      std::string reason = why_not(type, wants(node, input));
      const bool is_loop =
          reason.empty() && from >= 0 && input.role != Role::kDelayed && reads(from, static_cast<int>(i));
      if (is_loop) reason = "that would be a loop without a delay";
      add(node.name, input.port, input.index, reason);
    }
  }
  if (page.sequence == nullptr && !(found.graph->robot != nullptr && page.parent < 0))
    add("$result", "", {}, why_not(type, result_type()));
  return out;
}

}  // namespace mlab::designer
