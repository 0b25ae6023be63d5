// Names, help, and where things stand.

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/edit/editor.h"
#include "mlab/designer/edit/values.h"
#include "mlab/lang/cdl/syntax/parts.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

constexpr double kFarthest = 1e6;  // [px]

double rounded(double value) {
  return std::isfinite(value) ? std::round(std::clamp(value, -kFarthest, kFarthest)) + 0.0 : 0.0;
}

// `$movement` is no name of CDL.
std::string layout_name(const std::string& node) {
  if (!node.starts_with('$')) return node;
  // `$body.drive` of a class has a name below another one already.
  return node.find('.') == std::string::npos ? "actuator." + node.substr(1) : node.substr(1);
}

bool is_layout_name(std::string_view name) {
  while (!name.empty()) {
    const std::size_t dot = std::min(name.find('.'), name.size());
    if (!is_cdl_name(name.substr(0, dot))) return false;
    if (dot == name.size()) return true;
    name.remove_prefix(dot + 1);
  }
  return false;
}

// As a text may stand in a file.
std::string quotable(std::string line) {
  for (char& c : line) {
    if (c == '"') c = '\'';
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return line;
}

std::vector<std::string> split_lines(std::string_view text) {
  std::vector<std::string> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

}  // namespace

// ---- where things stand

Done Editor::change_layout(const std::string& page, const std::function<void(cdl::Layout&)>& how) {
  const bool has_no_graph = page.empty() || work_.model().society(page) != nullptr ||
                            is_equipment(work_.model(), page) || work_.model().binding(page) != nullptr;
  if (!has_no_graph) {
    const text::Result<PageView> view = find_page(work_.model(), page);
    if (!view) return std::unexpected(view.error());
  }
  if (const cdl::Layout* layout = work_.model().layout(page)) {
    work_.changes().change<cdl::Layout>(*layout, how);
  } else {
    cdl::Layout fresh;
    fresh.owner.text = page;
    how(fresh);
    if (!fresh.entries.empty() || !fresh.notes.empty()) work_.add(std::move(fresh));
  }
  return work_.commit();
}

Done Editor::arrange(const Arrange& change) {
  std::vector<cdl::LayoutEntry> entries;
  std::set<std::string> seen;
  for (const Arrange::At& at : change.nodes()) {
    const std::string name = layout_name(at.node());
    if (is_layout_name(name) && seen.insert(name).second)
      entries.push_back({{name, {}}, rounded(at.x()), rounded(at.y())});
  }
  if (entries.empty()) return true;
  return change_layout(change.page(), [entries](cdl::Layout& now) {
    for (const cdl::LayoutEntry& one : entries) {
      const auto known = std::ranges::find_if(
          now.entries, [&](const cdl::LayoutEntry& entry) { return entry.node.text == one.node.text; });
      if (known == now.entries.end())
        now.entries.push_back(one);
      else
        *known = {known->node, one.x, one.y};
    }
  });
}

Done Editor::set_note(const SetNote& change) {
  const bool is_gone = change.text().empty() && change.width() == 0.0 && change.height() == 0.0;
  const cdl::Layout* layout = work_.model().layout(change.page());
  const cdl::LayoutNote* old = nullptr;
  for (std::size_t i = 0; layout != nullptr && i < layout->notes.size(); ++i) {
    if (fmt::format("{}", i + 1) == change.id()) old = &layout->notes[i];
  }
  if (!change.id().empty() && old == nullptr) return refusal("the note has gone");
  if (is_gone) {
    if (old != nullptr) work_.changes().remove(*old);
    return work_.commit();
  }
  cdl::LayoutNote note;
  note.is_frame = change.is_frame();
  note.x = rounded(change.x());
  note.y = rounded(change.y());
  note.width = rounded(change.width());
  note.height = rounded(change.height());
  for (const std::string& line : split_lines(change.text())) note.lines.push_back(quotable(line));
  if (old == nullptr)
    return change_layout(change.page(), [note](cdl::Layout& now) { now.notes.push_back(note); });
  work_.changes().change<cdl::LayoutNote>(*old, [note](cdl::LayoutNote& now) {
    const text::Place place = now.place;
    now = note;
    now.place = place;
  });
  return work_.commit();
}

// ---- help

template <class X>
Done Editor::write_help(const X& what, const std::string& help) {
  work_.changes().change<X>(what, [help](X& now) { now.help = help; });
  return work_.commit();
}

Done Editor::set_declaration_help(const std::string& name, const std::string& help) {
  const auto note = [&]<class X>(const X& one) {
    work_.changes().change<X>(one, [help](X& now) { now.help = help; });
  };
  if (!visit_declaration(work_.model().tree(), name, note))
    return refusal(fmt::format("there is no `{}`", text::shown(name)));
  return work_.commit();
}

Done Editor::set_help(const SetHelp& change) {
  if (change.page().empty()) return set_declaration_help(change.node(), change.text());
  if (change.node().empty() && change.page().find('.') == std::string::npos)
    return set_declaration_help(change.page(), change.text());
  if (is_equipment(work_.model(), change.page())) return help_device(change);
  const text::Result<PageView> view = find_page(work_.model(), change.page());
  if (!view) return std::unexpected(view.error());
  if (change.node().empty()) {
    if (view->page->state != nullptr) return write_help(*view->page->state, change.text());
    return refusal("this page has no help of its own");
  }
  if (view->page->sequence != nullptr) {
    for (const cdl::State& state : view->page->sequence->states) {
      if (state.name.text == change.node()) return write_help(state, change.text());
    }
  }
  const text::Result<int> at = find_node(*view, change.node());
  if (!at) return std::unexpected(at.error());
  const GraphNode& there = view->node(*at);
  if (there.parameter != nullptr) return write_help(*there.parameter, change.text());
  if (there.let != nullptr) return write_help(*there.let, change.text());
  // A member of an operator has its line.
  const GraphInput* input =
      there.reader < 0 ? nullptr
                       : &view->node(there.reader).inputs[static_cast<std::size_t>(there.reader_input)];
  if (input == nullptr || input->role != Role::kMember)
    return refusal("only what has a line of its own can have help: a name, a member, a state");
  const auto& members = *members_of(*view->node(there.reader).expression);
  return write_help(members[static_cast<std::size_t>(input->at)], change.text());
}

// ---- names

Done Editor::rename(const Rename& change) {
  const std::string& to = change.name();
  if (!is_cdl_name(to))
    return refusal(
        fmt::format("`{}` is no name: a letter first, then letters, digits and `_`", text::shown(to)));
  if (change.node() == to) return true;
  if (change.page().empty()) return rename_declaration(change.node(), to);
  if (is_equipment(work_.model(), change.page())) return rename_device(change);
  const text::Result<PageView> view = find_page(work_.model(), change.page());
  if (!view) return std::unexpected(view.error());
  if (view->page->sequence != nullptr) {
    for (const cdl::State& state : view->page->sequence->states) {
      if (state.name.text == change.node()) return rename_state(*view, change.node(), to);
    }
  }
  const int at = view->page->find(change.node());
  const bool is_parameter =
      at < 0 &&
      std::ranges::any_of(
          view->graph->parameters(), [&](const cdl::Parameter& p) { return p.name.text == change.node(); });
  if (is_parameter) return rename_local(*view, change.node(), to);
  const text::Result<int> found = find_node(*view, change.node());
  if (!found) return std::unexpected(found.error());
  const GraphNode& there = view->node(*found);
  if (there.parameter != nullptr || there.let != nullptr) {
    const std::string from = there.parameter != nullptr ? there.parameter->name.text : there.let->name.text;
    return rename_local(*view, from, to);
  }
  if (there.expression == nullptr) return refusal("an actuator is called as its robot's class says");
  // What would be called so by itself needs no name.
  const std::string as = to == default_name(*there.expression) ? "" : to;
  work_.changes().change<cdl::Expression>(*there.expression,
                                          [as](cdl::Expression& now) { now.as.text = as; });
  return work_.commit();
}

// A `let` or a parameter, with all that reads it; a parameter also where calls give it.
Done Editor::rename_local(const PageView& view, const std::string& from, const std::string& to) {
  if (pages_.names().is_taken(*view.graph, to)) return refusal(fmt::format("`{}` is taken already", to));
  const OwnerGraph& graph = *view.graph;
  const auto rename = [&](const cdl::Word& word) {
    if (word.text == from) work_.changes().rename(word, to);
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
  if (!is_parameter || graph.assemblage == nullptr) return work_.commit();
  for_each_call(work_.model().tree(), graph.name, [&](const cdl::Call& call) {
    for (const cdl::Argument& argument : call.arguments) rename(argument.name);
  });
  return work_.commit();
}

Done Editor::rename_state(const PageView& view, const std::string& from, const std::string& to) {
  for (const cdl::State& state : view.page->sequence->states) {
    if (state.name.text == to) return refusal(fmt::format("there is a state `{}` already", to));
  }
  for (const cdl::State& state : view.page->sequence->states) {
    if (state.name.text == from) work_.changes().rename(state.name, to);
    for (const cdl::Transition& transition : state.transitions) {
      if (transition.target.text == from) work_.changes().rename(transition.target, to);
    }
  }
  return work_.commit();
}

// A declaration, and every word of the file that means it.
Done Editor::rename_declaration(const std::string& from, const std::string& to) {
  if (!is_declared(work_, from)) return refusal(fmt::format("there is no `{}`", text::shown(from)));
  if (is_declared(work_, to)) return refusal(fmt::format("there is a `{}` already", to));
  const auto rename = [&](const cdl::Word& word) {
    if (word.text == from) work_.changes().rename(word, to);
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
  for (const cdl::Item& item : work_.model().tree().items) {
    std::visit(
        [&]<class X>(const X& one) {
          if constexpr (requires { one.name; } && !std::same_as<X, cdl::Architecture>) rename(one.name);
        },
        item);
    cdl::for_each_construct(item, look);
  }
  return work_.commit();
}

}  // namespace mlab::designer
