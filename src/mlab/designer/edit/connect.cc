// Changes of a dataflow: wires, values, nodes.

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/drawing/shapes.h"
#include "mlab/designer/edit/change/declarations.h"
#include "mlab/designer/edit/change/devices.h"
#include "mlab/designer/edit/change/equipment_values.h"
#include "mlab/designer/edit/change/exposing.h"
#include "mlab/designer/edit/change/help.h"
#include "mlab/designer/edit/change/names.h"
#include "mlab/designer/edit/change/parameters.h"
#include "mlab/designer/edit/change/robots.h"
#include "mlab/designer/edit/change/societies.h"
#include "mlab/designer/edit/change/states.h"
#include "mlab/designer/edit/editor.h"
#include "mlab/designer/edit/values.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

using Kind = GraphNode::Kind;

std::optional<std::uint32_t> index_of(const auto& change) {
  return change.has_index() ? std::optional<std::uint32_t>(change.index()) : std::nullopt;
}

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

// Whether a block or a big call may stand there.
bool takes(const Spot& spot, const cdl::Expression& expression) {
  const GraphInput* input = spot.at();
  const Role role = input == nullptr ? Role::kMember : input->role;
  const bool is_line =
      role == Role::kMember || role == Role::kDrive || role == Role::kCase || role == Role::kValue;
  if (is_block(expression)) return is_line;
  return role != Role::kWeight || std::holds_alternative<cdl::Call>(expression.what);
}

}  // namespace

Done Editor::connect(const Connect& change) {
  if (is_equipment(work_.model(), change.page())) return connect_device(work_, change);
  text::Result<PageView> view = find_page(work_.model(), change.page());
  if (!view) return std::unexpected(view.error());
  const text::Result<int> from = find_node(*view, change.from_node());
  if (!from) return std::unexpected(from.error());
  const text::Result<Spot> to = find_spot(*view, change.to_node(), change.to_port(), index_of(change), true);
  if (!to) return std::unexpected(to.error());
  const GraphNode& source = view->node(*from);
  if (source.kind == Kind::kActuator) return refusal("an actuator gives no value");
  const GraphInput* input = to->at();
  if (input != nullptr && input->from == *from && !input->is_open) return true;
  if (const std::string reason = why_not(view->type_of(*from), wanted_type(work_.model(), *to));
      !reason.empty())
    return refusal(reason);
  const bool is_delayed = input != nullptr && input->role == Role::kDelayed;
  if (to->node >= 0 && !is_delayed && reaches(*view, *from, to->node))
    return refusal(
        fmt::format("`{}` is made from `{}`: a loop needs a delay", source.name, view->node(to->node).name));

  if (source.parameter != nullptr) {
    const Done done = pages_.write(*to, named(source.parameter->name.text));
    return done ? work_.commit() : done;
  }
  if (source.kind == Kind::kOuter || source.let != nullptr) return connect_let(*view, *from, *to);
  // It is written where it is read first: from now on both read a name.
  const std::string owner = view->graph->name;
  const int target = to->node < 0 ? -1 : follow(work_, *view, to->node);
  const std::string name = pages_.make_let(Spot{*view, source.reader, source.reader_input, ""});
  if (const Done done = work_.commit(); !done) return done;
  Connect again = change;
  again.set_from_node(name);
  if (target >= 0) {
    const auto found = followed(work_, owner, target);
    if (!found) return refusal("the node has gone");
    again.set_page(found->first.page->path);
    again.set_to_node(found->first.node(found->second).name);
  }
  return connect(again);
}

// What nobody reads yet is written where it is read now, if it can stand there.
Done Editor::connect_let(const PageView& view, int from, const Spot& to) {
  const GraphNode& source = view.node(from);
  const cdl::Let& let = *source.let;
  const bool is_alone = count_uses(*view.graph, let.name.text) == 0;
  const bool has_help = !let.help.empty() && (to.at() == nullptr || to.at()->role != Role::kMember);
  const bool makes_itself = to.node >= 0 && reaches(view, from, to.node);
  const bool is_inlined = is_alone && !has_help && !makes_itself && takes(to, *let.value) &&
                          source.kind != Kind::kValue && source.kind != Kind::kOuter;
  if (is_inlined) work_.changes().remove(let);
  const Done done = pages_.write(to, is_inlined ? bare_as(*let.value, let.name.text) : named(let.name.text));
  return done ? work_.commit() : done;
}

Done Editor::disconnect(const Disconnect& change) {
  if (is_equipment(work_.model(), change.page()))
    return refusal("a device serves a binding point: lead it to another one, or remove it");
  const text::Result<PageView> view = find_page(work_.model(), change.page());
  if (!view) return std::unexpected(view.error());
  const text::Result<Spot> to = find_spot(*view, change.to_node(), change.to_port(), index_of(change), false);
  if (!to) return std::unexpected(to.error());
  if (to->written() == nullptr) return refusal("nothing is connected there");
  const Done done = pages_.clear(*to);
  return done ? work_.commit() : done;
}

Done Editor::set_value(const SetValue& change) {
  if (is_equipment(work_.model(), change.page())) return set_equipment_value(work_, change);
  const text::Result<PageView> view = find_page(work_.model(), change.page());
  if (!view) return std::unexpected(view.error());
  const bool is_new = change.has_index() || !change.value().empty();
  text::Result<Spot> to = find_spot(*view, change.node(), change.port(), index_of(change), false);
  if (!to && is_new) to = find_spot(*view, change.node(), change.port(), index_of(change), true);
  if (!to) return std::unexpected(to.error());
  if (change.value().empty()) {
    const Done done = pages_.clear(*to);
    return done ? work_.commit() : done;
  }
  const cdl::ExpressionPtr value = typed_value(change.value());
  if (!value) return refusal(fmt::format("`{}` is no value", text::shown(change.value())));
  const Done done = pages_.write(*to, value);
  return done ? work_.commit() : done;
}

Done Editor::place(const Place& change) {
  if (is_equipment(work_.model(), change.page())) return place_device(work_, change);
  text::Result<PageView> view = find_page(work_.model(), change.page());
  if (!view) return std::unexpected(view.error());
  const Components& components = work_.model().components();
  const std::optional<std::string> words = words_of(change.component(), components);
  if (!words) return refusal(fmt::format("nothing answers to `{}`", text::shown(change.component())));
  if (view->page->asks != nullptr) return place_in_trigger(*view, change);
  if (const std::optional<Callable> callable = components.find(change.component())) {
    if (callable->gives_nothing) return place_sink(*view, change);
    const bool is_itself = callable->assemblage != nullptr && callable->assemblage == view->graph->assemblage;
    if (is_itself) return refusal("an assemblage can't be a part of itself");
  }
  if (!change.name().empty() &&
      (!is_cdl_name(change.name()) || pages_.names().is_taken(*view->graph, change.name())))
    return refusal(fmt::format("`{}` is no free name", text::shown(change.name())));
  const std::string name = !change.name().empty()
                               ? change.name()
                               : pages_.names().free_name(*view->graph, base_of(change.component()));
  pages_.add_let(*view, name, value_of(*words));
  if (const Done done = work_.commit(); !done) return done;
  if (const Done done = arrange_one(work_, change.page(), name, change); !done) return done;
  if (change.to_node().empty()) return true;
  Connect wire;
  wire.set_page(change.page());
  wire.set_from_node(name);
  wire.set_to_node(change.to_node());
  wire.set_to_port(change.to_port());
  return connect(wire);
}

// What moves or tells something by itself: a robot drives it under a name of its own.
Done Editor::place_sink(const PageView& view, const Place& change) {
  if (view.graph->robot == nullptr || view.page->parent >= 0)
    return refusal("what gives nothing stands on the page of a robot or, as a device, of a class");
  std::set<std::string> taken;
  for (const cdl::Drive& drive : view.graph->robot->drives) taken.insert(drive.binding.text);
  const std::string name = unique(change.component().starts_with("Report") ? "report" : "acts", taken);
  work_.changes().change<cdl::Robot>(
      *view.graph->robot,
      [name, by = called(change.component())](cdl::Robot& now) { now.drives.push_back({{name, {}}, by}); });
  return work_.commit();
}

Done Editor::remove(const Remove& change) {
  if (change.page().empty()) return remove_declarations(work_, change);
  if (is_equipment(work_.model(), change.page())) return remove_devices(work_, change);
  const text::Result<PageView> view = find_page(work_.model(), change.page());
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
      if (const Done done = remove_parameter(pages_, parameter); !done) return done;
      Remove rest;
      rest.set_page(change.page());
      for (const std::string& other : change.nodes()) {
        if (other != name) rest.add_nodes(other);
      }
      return rest.nodes().empty() ? Done(true) : remove(rest);
    }
    handles.push_back(follow(work_, *view, *found));
  }
  const std::string owner = view->graph->name;
  if (!states.empty()) {
    if (const Done done = remove_states(work_, *view->page->sequence, states); !done) return done;
  }
  for (const int handle : handles) {
    if (const Done done = remove_node(owner, handle, handles); !done) return done;
  }
  return true;
}

// What drives it stays, as a node that leads nowhere, unless it is to be removed as well.
Done Editor::remove_node(const std::string& owner, int handle, const std::vector<int>& others) {
  auto found = followed(work_, owner, handle);
  if (!found) return true;
  // First the nodes that are written inside of it.
  for (std::size_t i = 0; i < found->first.node(found->second).inputs.size();) {
    const PageView view = found->first;
    const GraphInput& input = view.node(found->second).inputs[i];
    const bool is_removed = input.is_inline && std::ranges::any_of(others, [&](int other) {
                              const auto there = followed(work_, owner, other);
                              return there && there->first.page == view.page && there->second == input.from;
                            });
    // What stands in for a case that nobody fills is no node that was there.
    const bool is_filler =
        input.role == Role::kCase && input.written && default_name(*input.written) == "Stand";
    if (!input.is_inline || is_removed || is_filler) {
      ++i;
      continue;
    }
    if (const Done done = pages_.clear(Spot{view, found->second, static_cast<int>(i), ""}); !done)
      return done;
    if (const Done done = work_.commit(); !done) return done;
    found = followed(work_, owner, handle);
    if (!found) return true;
    i = 0;
  }
  const PageView view = found->first;
  const GraphNode& node = view.node(found->second);
  if (node.kind == Kind::kActuator) {
    const Done done = pages_.clear(Spot{view, found->second, 0, ""});
    return done ? work_.commit() : done;
  }
  if (node.let == nullptr) {
    // The node itself is lost with what stands at its reader's input.
    pages_.make_let(Spot{view, node.reader, node.reader_input, ""});
    if (const Done done = work_.commit(); !done) return done;
    return remove_node(owner, handle, others);
  }
  // Readers of the name lose it, one after the other.
  const std::string name = node.let->name.text;
  if (const std::optional<Spot> reader = reader_of(*view.graph, name)) {
    if (const Done done = pages_.clear(*reader); !done) return done;
    if (const Done done = work_.commit(); !done) return done;
    return remove_node(owner, handle, others);
  }
  if (count_uses(*view.graph, name) > 0)
    return refusal(fmt::format("a trigger needs `{}`: change the transition first", name));
  work_.changes().remove(*node.let);
  return work_.commit();
}

Done Editor::set_active(const SetActive& change) {
  const text::Result<PageView> view = find_page(work_.model(), change.page());
  if (!view) return std::unexpected(view.error());
  const text::Result<int> at = find_node(*view, change.node());
  if (!at) return std::unexpected(at.error());
  const cdl::Expression* expression = view->node(*at).expression;
  if (expression == nullptr) return refusal("only a behavior or a percept has an active part");
  if (expression->active) {
    const auto& inputs = view->node(*at).inputs;
    const auto input = std::ranges::find(inputs, Role::kActive, &GraphInput::role);
    const Done done = pages_.clear(Spot{*view, *at, static_cast<int>(input - inputs.begin()), ""});
    if (!done) return done;
    const std::string owner = view->graph->name;
    const int handle = follow(work_, *view, *at);
    if (const Done committed = work_.commit(); !committed) return committed;
    if (change.component().empty()) return true;
    const auto found = followed(work_, owner, handle);
    if (!found) return refusal("the node has gone");
    SetActive again = change;
    again.set_page(found->first.page->path);
    again.set_node(found->first.node(found->second).name);
    return set_active(again);
  }
  if (change.component().empty()) return true;
  const std::optional<Callable> callable = work_.model().components().find(change.component());
  if (!callable) return refusal(fmt::format("nothing answers to `{}`", text::shown(change.component())));
  const cdl::PortType& type = callable->output;
  const bool moves = type.type != nullptr &&
                     (type.type->kind == flow::TypeKind::kVector || type.type->kind == flow::TypeKind::kBool);
  if (!moves) return refusal("an active part gives a bool or a Vector");
  work_.changes().change<cdl::Expression>(
      *expression, [part = called(change.component())](cdl::Expression& now) { now.active = part; });
  return work_.commit();
}

// Another component in its place: inputs of the same name and a fitting type stay.
Done Editor::replace(const Replace& change) {
  if (is_equipment(work_.model(), change.page())) return replace_device(work_, change);
  const text::Result<PageView> view = find_page(work_.model(), change.page());
  if (!view) return std::unexpected(view.error());
  const text::Result<int> at = find_node(*view, change.node());
  if (!at) return std::unexpected(at.error());
  const cdl::Expression* old = view->node(*at).expression;
  if (old == nullptr) return refusal("only a component has something in its place");
  const Components& components = work_.model().components();
  const std::optional<std::string> words = words_of(change.component(), components);
  if (!words) return refusal(fmt::format("nothing answers to `{}`", text::shown(change.component())));
  if (!std::holds_alternative<cdl::Call>(old->what)) return replace_operator(*view, *at, *value_of(*words));
  const std::optional<Callable> other = components.find(change.component());
  if (!other) return refusal("a call is replaced by another call only");
  return replace_call(view->graph->name, follow(work_, *view, *at), *other);
}

Done Editor::replace_operator(const PageView& view, int at, const cdl::Expression& other) {
  const GraphNode& old = view.node(at);
  if (members_of(*old.expression) == nullptr || members_of(other) == nullptr)
    return refusal("an operator is replaced by another operator only");
  const auto* compete = std::get_if<cdl::Compete>(&other.what);
  if (compete != nullptr &&
      compete->rule == cdl::CompetitionRule::kPriority) {  // its members have no weights
    for (std::size_t i = 0; i < old.inputs.size(); ++i) {
      if (old.inputs[i].role != Role::kWeight || !old.inputs[i].written) continue;
      if (const Done done = pages_.clear(Spot{view, at, static_cast<int>(i), ""}); !done) return done;
    }
  }
  // The word by which it is known stays the same one.
  const Anchor byte = *anchor_of(old, work_.tokens());
  const text::Place known{work_.model().source(), {byte, byte + 1}};
  work_.changes().change<cdl::Expression>(*old.expression, [what = other.what, known](cdl::Expression& now) {
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
  return work_.commit();
}

// What the other does not take loses its place, one after the other.
Done Editor::replace_call(const std::string& owner, int handle, const Callable& other) {
  const auto found = followed(work_, owner, handle);
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
        why_not(input.from < 0 ? wanted_type(work_.model(), spot) : view.type_of(input.from), socket->type)
            .empty();
    if (is_taken) continue;
    if (const Done done = pages_.clear(spot); !done) return done;
    if (const Done done = work_.commit(); !done) return done;
    return replace_call(owner, handle, other);
  }
  const auto& call = std::get<cdl::Call>(there.expression->what);
  for (const GraphInput& input : there.inputs) {  // by position means another input now
    if (input.at < 0 || input.role != Role::kArgument || input.item > 0) continue;
    const cdl::Argument& argument = call.arguments[static_cast<std::size_t>(input.at)];
    if (argument.name.text.empty()) work_.changes().rename(argument.name, input.port);
  }
  work_.changes().rename(call.callee, other.name);
  return work_.commit();
}

// NOLINTNEXTLINE(readability-function-size): a row for each change
Done Editor::apply(const Change& change) {
  switch (change.change_case()) {
    case Change::kPlace:
      return place(change.place());
    case Change::kRemove:
      return remove(change.remove());
    case Change::kConnect:
      return connect(change.connect());
    case Change::kDisconnect:
      return disconnect(change.disconnect());
    case Change::kSetValue:
      return set_value(change.set_value());
    case Change::kExpose:
      return is_equipment(work_.model(), change.expose().page()) ? expose_equipment(work_, change.expose())
                                                                 : expose_input(pages_, change.expose());
    case Change::kRename:
      return rename(work_, pages_.names(), change.rename());
    case Change::kArrange:
      return arrange(work_, change.arrange());
    case Change::kSetActive:
      return set_active(change.set_active());
    case Change::kGroup:
      return group(change.group());
    case Change::kUngroup:
      return ungroup(change.ungroup());
    case Change::kPaste:
      return paste(change.paste());
    case Change::kSetNote:
      return set_note(work_, change.set_note());
    case Change::kReplace:
      return replace(change.replace());
    case Change::kAddDeclaration:
      return add_declaration(work_, change.add_declaration());
    case Change::kSetParameter:
      return set_parameter(work_, change.set_parameter());
    case Change::kRemoveParameter:
      return remove_parameter(pages_, change.remove_parameter());
    case Change::kSetHelp:
      return set_help(work_, change.set_help());
    case Change::kCopyComponent:
      return copy_component(work_, change.copy_component());
    case Change::kAddState:
      return add_state(work_, change.add_state());
    case Change::kSetState:
      return set_state(work_, change.set_state());
    case Change::kAddTransition:
      return add_transition(work_, change.add_transition());
    case Change::kSetTransition:
      return set_transition(work_, change.set_transition());
    case Change::kRemoveTransition:
      return remove_transition(work_, change.remove_transition());
    case Change::kChangeTrigger:
      return change_trigger(change.change_trigger());
    case Change::kSetDevice:
      return set_device(work_, change.set_device());
    case Change::kSetBinding:
      return set_binding(work_, change.set_binding());
    case Change::kGroupMembers:
      return group_members(work_, change.group_members());
    case Change::kUngroupMembers:
      return ungroup_members(work_, change.ungroup_members());
    case Change::kMoveMember:
      return move_member(work_, change.move_member());
    case Change::kSetClass:
      return set_class(work_, change.set_class());
    case Change::kUseDevice:
      return use_device(work_, change.use_device());
    case Change::kSetMember:
      return set_member(work_, change.set_member());
    case Change::kRemoveMember:
      return remove_member(work_, change.remove_member());
    case Change::CHANGE_NOT_SET:
      break;
  }
  return refusal("nothing is to be changed");
}

}  // namespace mlab::designer
