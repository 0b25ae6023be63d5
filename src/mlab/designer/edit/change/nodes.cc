#include "mlab/designer/edit/change/nodes.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/designer/drawing/shapes.h"
#include "mlab/designer/edit/change/layout.h"
#include "mlab/designer/edit/change/parameters.h"
#include "mlab/designer/edit/change/states.h"
#include "mlab/designer/edit/change/triggers.h"
#include "mlab/designer/edit/change/wires.h"
#include "mlab/designer/edit/find/followed.h"
#include "mlab/designer/edit/find/pages.h"
#include "mlab/designer/edit/values.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

using Kind = GraphNode::Kind;

// What Place makes of the name of a component: the words of an operator, or a call.
std::optional<std::string> words_of(const std::string& component, const Components& components) {
  if (component == "cooperate" || component == "compete by priority" || component == "compete by strength")
    return component + " {}";
  for (const std::string_view by : {"coordinate by ", "fuse by "}) {
    if (!component.starts_with(by)) continue;
    const std::string callee = component.substr(by.size());
    if (!components.find(callee)) return std::nullopt;
    return component + "() {}";
  }
  if (component == "sequence") return "sequence {\nstart final Waiting: Stand();\n}";
  if (component == "select") return "select by true {\notherwise: Stand();\n}";
  if (component == "delay") return "delay([0, 0])";
  if (component == "formula") return "1 + 1";
  if (component == kComparison) return kComparisonWords;
  if (component == "not") return "not false";
  if (component == "and") return "true and true";
  if (component == "or") return "false or false";
  if (!components.find(component)) return std::nullopt;
  return component + "()";
}

// And the name that it gets.
std::string base_of(const std::string& component) {
  if (component == "not") return "Not";
  if (component == "and") return "And";
  if (component == "or") return "Or";
  for (const std::string_view by : {"coordinate by ", "fuse by "}) {
    if (component.starts_with(by)) return component.substr(by.size());
  }
  return component.substr(0, component.find(' '));
}

// What moves or tells something by itself: a robot drives it under a name of its own.
Done place_sink(Workspace& work, const PageView& view, const Place& change) {
  if (view.graph->robot == nullptr || view.page->parent >= 0)
    return refusal("what gives nothing stands on the page of a robot or, as a device, of a class");
  std::set<std::string> taken;
  for (const cdl::Drive& drive : view.graph->robot->drives) taken.insert(drive.binding.text);
  const std::string name = unique(change.component().starts_with("Report") ? "report" : "acts", taken);
  work.changes().change<cdl::Robot>(
      *view.graph->robot,
      [name, by = called(change.component())](cdl::Robot& now) { now.drives.push_back({{name, {}}, by}); });
  return work.commit();
}

// What drives it stays, as a node that leads nowhere, unless it is to be removed as well.
Done remove_node(PageWriter& pages, const std::string& owner, int handle, const std::vector<int>& others) {
  Workspace& work = pages.work();
  auto found = followed(work, owner, handle);
  if (!found) return true;
  // First the nodes that are written inside of it.
  for (std::size_t i = 0; i < found->first.node(found->second).inputs.size();) {
    const PageView view = found->first;
    const GraphInput& input = view.node(found->second).inputs[i];
    const bool is_removed = input.is_inline && std::ranges::any_of(others, [&](int other) {
                              const auto there = followed(work, owner, other);
                              return there && there->first.page == view.page && there->second == input.from;
                            });
    // What stands in for a case that nobody fills is no node that was there.
    const bool is_filler =
        input.role == Role::kCase && input.written && default_name(*input.written) == "Stand";
    if (!input.is_inline || is_removed || is_filler) {
      ++i;
      continue;
    }
    if (const Done done = pages.clear(Spot{view, found->second, static_cast<int>(i), ""}); !done) return done;
    if (const Done done = work.commit(); !done) return done;
    found = followed(work, owner, handle);
    if (!found) return true;
    i = 0;
  }
  const PageView view = found->first;
  const GraphNode& node = view.node(found->second);
  if (node.kind == Kind::kActuator) {
    const Done done = pages.clear(Spot{view, found->second, 0, ""});
    return done ? work.commit() : done;
  }
  if (node.let == nullptr) {
    // The node itself is lost with what stands at its reader's input.
    pages.make_let(Spot{view, node.reader, node.reader_input, ""});
    if (const Done done = work.commit(); !done) return done;
    return remove_node(pages, owner, handle, others);
  }
  // Readers of the name lose it, one after the other.
  const std::string name = node.let->name.text;
  if (const std::optional<Spot> reader = reader_of(*view.graph, name)) {
    if (const Done done = pages.clear(*reader); !done) return done;
    if (const Done done = work.commit(); !done) return done;
    return remove_node(pages, owner, handle, others);
  }
  if (count_uses(*view.graph, name) > 0)
    return refusal(fmt::format("a trigger needs `{}`: change the transition first", name));
  work.changes().remove(*node.let);
  return work.commit();
}

Done replace_operator(PageWriter& pages, const PageView& view, int at, const cdl::Expression& other) {
  Workspace& work = pages.work();
  const GraphNode& old = view.node(at);
  if (members_of(*old.expression) == nullptr || members_of(other) == nullptr)
    return refusal("an operator is replaced by another operator only");
  const auto* compete = std::get_if<cdl::Compete>(&other.what);
  if (compete != nullptr &&
      compete->rule == cdl::CompetitionRule::kPriority) {  // its members have no weights
    for (std::size_t i = 0; i < old.inputs.size(); ++i) {
      if (old.inputs[i].role != Role::kWeight || !old.inputs[i].written) continue;
      if (const Done done = pages.clear(Spot{view, at, static_cast<int>(i), ""}); !done) return done;
    }
  }
  // The word by which it is known stays the same one.
  const Anchor byte = *anchor_of(old, work.tokens());
  const text::Place known{work.model().source(), {byte, byte + 1}};
  work.changes().change<cdl::Expression>(*old.expression, [what = other.what, known](cdl::Expression& now) {
    const std::vector<cdl::Member> members = *members_of(now);
    now.what = what;
    now.place = known;
    std::visit(
        [&](auto& operation) {
          if constexpr (requires { operation.members; }) operation.members = members;
          if constexpr (requires { operation.by.callee; })
            operation.by.callee.place = std::exchange(now.place, {});
        },
        now.what);
  });
  return work.commit();
}

// What the other does not take loses its place, one after the other.
Done replace_call(PageWriter& pages, const std::string& owner, int handle, const Callable& other) {
  Workspace& work = pages.work();
  const auto found = followed(work, owner, handle);
  if (!found) return refusal("the node has gone");
  const auto& [view, at] = *found;
  const GraphNode& there = view.node(at);
  for (std::size_t i = 0; i < there.inputs.size(); ++i) {
    const GraphInput& input = there.inputs[i];
    if (!input.written || input.role == Role::kActive) continue;
    const Spot spot{view, at, static_cast<int>(i), ""};
    const auto socket = std::ranges::find(other.inputs, input.port, &Socket::name);
    const bool is_taken =
        socket != other.inputs.end() &&
        why_not(input.from < 0 ? wanted_type(work.model(), spot) : view.type_of(input.from), socket->type)
            .empty();
    if (is_taken) continue;
    if (const Done done = pages.clear(spot); !done) return done;
    if (const Done done = work.commit(); !done) return done;
    return replace_call(pages, owner, handle, other);
  }
  const auto& call = std::get<cdl::Call>(there.expression->what);
  for (const GraphInput& input : there.inputs) {  // by position means another input now
    if (input.at < 0 || input.role != Role::kArgument || input.item > 0) continue;
    const cdl::Argument& argument = call.arguments[static_cast<std::size_t>(input.at)];
    if (argument.name.text.empty()) work.changes().rename(argument.name, input.port);
  }
  work.changes().rename(call.callee, other.name);
  return work.commit();
}

}  // namespace

Done place_node(PageWriter& pages, const Place& change) {
  Workspace& work = pages.work();
  text::Result<PageView> view = find_page(work.model(), change.page());
  if (!view) return std::unexpected(view.error());
  const Components& components = work.model().components();
  const std::optional<std::string> words = words_of(change.component(), components);
  if (!words) return refusal(fmt::format("nothing answers to `{}`", text::shown(change.component())));
  if (view->page->asks != nullptr) return place_in_trigger(pages, *view, change);
  if (const std::optional<Callable> callable = components.find(change.component())) {
    if (callable->gives_nothing) return place_sink(work, *view, change);
    const bool is_itself = callable->assemblage != nullptr && callable->assemblage == view->graph->assemblage;
    if (is_itself) return refusal("an assemblage can't be a part of itself");
  }
  if (!change.name().empty() &&
      (!is_cdl_name(change.name()) || pages.names().is_taken(*view->graph, change.name())))
    return refusal(fmt::format("`{}` is no free name", text::shown(change.name())));
  const std::string name = !change.name().empty()
                               ? change.name()
                               : pages.names().free_name(*view->graph, base_of(change.component()));
  pages.add_let(*view, name, value_of(*words));
  if (const Done done = work.commit(); !done) return done;
  if (const Done done = arrange_one(work, change.page(), name, change); !done) return done;
  if (change.to_node().empty()) return true;
  Connect wire;
  wire.set_page(change.page());
  wire.set_from_node(name);
  wire.set_to_node(change.to_node());
  wire.set_to_port(change.to_port());
  return connect(pages, wire);
}

Done remove_from_page(PageWriter& pages, const Remove& change) {
  Workspace& work = pages.work();
  const text::Result<PageView> view = find_page(work.model(), change.page());
  if (!view) return std::unexpected(view.error());
  if (change.nodes().empty()) return refusal("nothing is chosen");
  std::vector<int> handles;
  std::set<std::string> states;
  for (const std::string& name : change.nodes()) {
    const int at = view->page->find(name);
    const bool is_state = view->page->sequence != nullptr &&
                          std::ranges::any_of(view->page->sequence->states, [&](const cdl::State& state) {
                            return state.name.text == name;
                          });
    if (is_state && at < 0) {
      states.insert(name);
      continue;
    }
    const text::Result<int> found = find_node(*view, name);
    if (!found) return std::unexpected(found.error());
    const GraphNode& one = view->node(*found);
    if (one.parameter != nullptr) {
      RemoveParameter parameter;
      parameter.set_owner(view->graph->name);
      parameter.set_name(one.parameter->name.text);
      if (const Done done = remove_parameter(pages, parameter); !done) return done;
      Remove rest;
      rest.set_page(change.page());
      for (const std::string& other : change.nodes()) {
        if (other != name) rest.add_nodes(other);
      }
      return rest.nodes().empty() ? Done(true) : remove_from_page(pages, rest);
    }
    handles.push_back(follow(work, *view, *found));
  }
  const std::string owner = view->graph->name;
  if (!states.empty()) {
    if (const Done done = remove_states(work, *view->page->sequence, states); !done) return done;
  }
  for (const int handle : handles) {
    if (const Done done = remove_node(pages, owner, handle, handles); !done) return done;
  }
  return true;
}

Done set_active(PageWriter& pages, const SetActive& change) {
  Workspace& work = pages.work();
  const text::Result<PageView> view = find_page(work.model(), change.page());
  if (!view) return std::unexpected(view.error());
  const text::Result<int> at = find_node(*view, change.node());
  if (!at) return std::unexpected(at.error());
  const cdl::Expression* expression = view->node(*at).expression;
  if (expression == nullptr) return refusal("only a behavior or a percept has an active part");
  if (expression->active) {
    const auto& inputs = view->node(*at).inputs;
    const auto input = std::ranges::find(inputs, Role::kActive, &GraphInput::role);
    const Done done = pages.clear(Spot{*view, *at, static_cast<int>(input - inputs.begin()), ""});
    if (!done) return done;
    const std::string owner = view->graph->name;
    const int handle = follow(work, *view, *at);
    if (const Done committed = work.commit(); !committed) return committed;
    if (change.component().empty()) return true;
    const auto found = followed(work, owner, handle);
    if (!found) return refusal("the node has gone");
    SetActive again = change;
    again.set_page(found->first.page->path);
    again.set_node(found->first.node(found->second).name);
    return set_active(pages, again);
  }
  if (change.component().empty()) return true;
  const std::optional<Callable> callable = work.model().components().find(change.component());
  if (!callable) return refusal(fmt::format("nothing answers to `{}`", text::shown(change.component())));
  const cdl::PortType& type = callable->output;
  const bool moves = type.type != nullptr &&
                     (type.type->kind == flow::TypeKind::kVector || type.type->kind == flow::TypeKind::kBool);
  if (!moves) return refusal("an active part gives a bool or a Vector");
  work.changes().change<cdl::Expression>(
      *expression, [part = called(change.component())](cdl::Expression& now) { now.active = part; });
  return work.commit();
}

Done replace_node(PageWriter& pages, const Replace& change) {
  Workspace& work = pages.work();
  const text::Result<PageView> view = find_page(work.model(), change.page());
  if (!view) return std::unexpected(view.error());
  const text::Result<int> at = find_node(*view, change.node());
  if (!at) return std::unexpected(at.error());
  const cdl::Expression* old = view->node(*at).expression;
  if (old == nullptr) return refusal("only a component has something in its place");
  const Components& components = work.model().components();
  const std::optional<std::string> words = words_of(change.component(), components);
  if (!words) return refusal(fmt::format("nothing answers to `{}`", text::shown(change.component())));
  if (!std::holds_alternative<cdl::Call>(old->what))
    return replace_operator(pages, *view, *at, *value_of(*words));
  const std::optional<Callable> other = components.find(change.component());
  if (!other) return refusal("a call is replaced by another call only");
  return replace_call(pages, view->graph->name, follow(work, *view, *at), *other);
}

}  // namespace mlab::designer
