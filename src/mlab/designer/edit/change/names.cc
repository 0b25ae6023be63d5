#include "mlab/designer/edit/change/names.h"

#include <algorithm>
#include <string>

#include <fmt/core.h>

#include "mlab/designer/edit/find/declared.h"
#include "mlab/designer/edit/find/devices.h"
#include "mlab/designer/edit/find/pages.h"
#include "mlab/designer/edit/values.h"
#include "mlab/lang/cdl/syntax/parts.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

// A `let` or a parameter, with all that reads it; a parameter also where calls give it.
Done rename_local(Workspace& work, const OwnerNames& names, const PageView& view, const std::string& from,
                  const std::string& to) {
  if (names.is_taken(*view.graph, to)) return refusal(fmt::format("`{}` is taken already", to));
  const OwnerGraph& graph = *view.graph;
  const auto rename = [&](const cdl::Word& word) {
    if (word.text == from) work.changes().rename(word, to);
  };
  bool is_parameter = false;
  const auto rename_in = [&]<class X>(const X& one) {
    if constexpr (std::same_as<X, cdl::Name> || std::same_as<X, cdl::Let>) rename(one.name);
    if constexpr (std::same_as<X, cdl::Parameter>) {
      rename(one.name);
      is_parameter |= one.name.text == from;
    }
  };
  if (graph.assemblage != nullptr) cdl::for_each_construct(*graph.assemblage, rename_in);
  if (graph.robot != nullptr) cdl::for_each_construct(*graph.robot, rename_in);
  if (!is_parameter || graph.assemblage == nullptr) return work.commit();
  for_each_call(work.model().tree(), graph.name, [&](const cdl::Call& call) {
    for (const cdl::Argument& argument : call.arguments) rename(argument.name);
  });
  return work.commit();
}

Done rename_state(Workspace& work, const PageView& view, const std::string& from, const std::string& to) {
  for (const cdl::State& state : view.page->sequence->states) {
    if (state.name.text == to) return refusal(fmt::format("there is a state `{}` already", to));
  }
  for (const cdl::State& state : view.page->sequence->states) {
    if (state.name.text == from) work.changes().rename(state.name, to);
    for (const cdl::Transition& transition : state.transitions) {
      if (transition.target.text == from) work.changes().rename(transition.target, to);
    }
  }
  return work.commit();
}

// A declaration, and every word of the file that means it.
Done rename_declaration(Workspace& work, const std::string& from, const std::string& to) {
  if (!is_declared(work, from)) return refusal(fmt::format("there is no `{}`", text::shown(from)));
  if (is_declared(work, to)) return refusal(fmt::format("there is a `{}` already", to));
  const auto rename = [&](const cdl::Word& word) {
    if (word.text == from) work.changes().rename(word, to);
  };
  const auto look = [&]<class X>(const X& one) {
    if constexpr (requires { one.callee; }) rename(one.callee);
    if constexpr (requires { one.binds; }) rename(one.binds);
    if constexpr (requires { one.class_name; }) rename(one.class_name);
    if constexpr (std::same_as<X, cdl::Choice> || std::same_as<X, cdl::Drive>) rename(one.binding);
    if constexpr (std::same_as<X, cdl::SocietyMember>) {
      rename(one.name);
      rename(one.by);
    }
  };
  for (const cdl::Item& item : work.model().tree().items) {
    std::visit(
        [&]<class X>(const X& one) {
          if constexpr (requires { one.name; } && !std::same_as<X, cdl::Architecture>) rename(one.name);
        },
        item);
    cdl::for_each_construct(item, look);
  }
  return work.commit();
}

// A device, with the robots of its class that speak of it.
Done rename_device(Workspace& work, const Rename& change) {
  const text::Result<DeviceSpot> spot = find_device(work.model(), change.page(), change.node());
  if (!spot) return std::unexpected(spot.error());
  if (spot->owner.robot_class == nullptr)
    return refusal("what an operator serves is called by its binding point");
  if (spot->owner.device(change.name()) != nullptr)
    return refusal(fmt::format("there is a device `{}` already", change.name()));
  work.changes().rename(spot->device->name, change.name());
  for (const cdl::Item& item : work.model().tree().items) {
    const auto* robot = std::get_if<cdl::Robot>(&item);
    if (robot == nullptr || robot->class_name.text != change.page()) continue;
    for (const cdl::Choice& choice : robot->choices) {
      if (choice.device.text == change.node()) work.changes().rename(choice.device, change.name());
    }
    for (const cdl::Drive& drive : robot->drives) {
      const bool is_it = drive.binding.text == change.node() &&
                         !work.model().configuration().bindings.contains(change.node());
      if (is_it) work.changes().rename(drive.binding, change.name());
    }
  }
  return work.commit();
}

}  // namespace

Done rename(Workspace& work, const OwnerNames& names, const Rename& change) {
  const std::string& to = change.name();
  if (!is_cdl_name(to))
    return refusal(
        fmt::format("`{}` is no name: a letter first, then letters, digits and `_`", text::shown(to)));
  if (change.node() == to) return true;
  if (change.page().empty()) return rename_declaration(work, change.node(), to);
  if (is_equipment(work.model(), change.page())) return rename_device(work, change);
  const text::Result<PageView> view = find_page(work.model(), change.page());
  if (!view) return std::unexpected(view.error());
  if (view->page->sequence != nullptr) {
    for (const cdl::State& state : view->page->sequence->states) {
      if (state.name.text == change.node()) return rename_state(work, *view, change.node(), to);
    }
  }
  const int at = view->page->find(change.node());
  const bool is_parameter =
      at < 0 &&
      std::ranges::any_of(
          view->graph->parameters(), [&](const cdl::Parameter& p) { return p.name.text == change.node(); });
  if (is_parameter) return rename_local(work, names, *view, change.node(), to);
  const text::Result<int> found = find_node(*view, change.node());
  if (!found) return std::unexpected(found.error());
  const GraphNode& there = view->node(*found);
  if (there.parameter != nullptr || there.let != nullptr) {
    const std::string from = there.parameter != nullptr ? there.parameter->name.text : there.let->name.text;
    return rename_local(work, names, *view, from, to);
  }
  if (there.expression == nullptr) return refusal("an actuator is called as its robot's class says");
  // What would be called so by itself needs no name.
  const std::string as = to == default_name(*there.expression) ? "" : to;
  work.changes().change<cdl::Expression>(*there.expression, [as](cdl::Expression& now) { now.as.text = as; });
  return work.commit();
}

}  // namespace mlab::designer
