// Names, help, and where things stand.

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/editor.h"
#include "mlab/lang/cdl/walk.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

constexpr double kFarthest = 1e6;  // [px]

double rounded(double value) {
  return std::isfinite(value) ? std::round(std::clamp(value, -kFarthest, kFarthest)) + 0.0 : 0.0;
}

// `$movement` is no name of CDL.
std::string layout_name(const std::string& node) {
  return node.starts_with('$') ? "actuator." + node.substr(1) : node;
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

std::string quoted(std::string line) {
  for (char& c : line) {
    if (c == '"') c = '\'';
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return '"' + line + '"';
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

Done Editor::set_layout(const std::string& page,
                        const std::vector<std::pair<std::string, std::string>>& entries) {
  if (entries.empty()) return true;
  const TokenMap& tokens = work_.tokens();
  const cdl::Layout* layout = work_.model().layout(page);
  if (layout == nullptr) {
    std::string block = page.empty() ? "layout {\n" : fmt::format("layout {} {{\n", page);
    for (const auto& [name, words] : entries) block += words + "\n";
    return add_text(block + "}");
  }
  // Behind the last of its words before its `}`.
  const std::uint32_t last = tokens.tokens()[tokens.at(layout->whole.end - 1) - 1].span.end;
  for (const auto& [name, words] : entries) {
    const auto known =
        std::ranges::find_if(layout->entries, [&](const cdl::LayoutEntry& e) { return e.node.text == name; });
    if (name.empty() || known == layout->entries.end()) {
      work_.insert_statement_behind(last, words);
      continue;
    }
    const std::uint32_t begin = known->node.place.span.begin;
    work_.replace({begin, tokens.statement_end(begin)}, words);
  }
  return true;
}

Done Editor::arrange(const Arrange& change) {
  if (!change.page().empty() && work_.model().society(change.page()) == nullptr) {
    const text::Result<PageView> view = page(change.page());
    if (!view) return std::unexpected(view.error());
  }
  std::vector<std::pair<std::string, std::string>> entries;
  std::set<std::string> seen;
  for (const Arrange::At& at : change.nodes()) {
    const std::string name = layout_name(at.node());
    if (!is_layout_name(name) || !seen.insert(name).second) continue;
    entries.emplace_back(name, fmt::format("{} {} {};", name, rounded(at.x()), rounded(at.y())));
  }
  const Done done = set_layout(change.page(), entries);
  return done ? work_.commit() : done;
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
    if (old != nullptr) work_.erase_statement(old->place.span.begin);
    return work_.commit();
  }
  std::string words =
      fmt::format("{} {} {}", change.is_frame() ? "frame" : "note", rounded(change.x()), rounded(change.y()));
  const std::vector<std::string> lines = split_lines(change.text());
  if (change.is_frame() || change.width() != 0.0 || change.height() != 0.0 || lines.empty())
    words += fmt::format(" {} {}", rounded(change.width()), rounded(change.height()));
  for (const std::string& line : lines) words += " " + quoted(line);
  words += ";";
  if (old != nullptr) {
    work_.replace({old->place.span.begin, work_.tokens().statement_end(old->place.span.begin)}, words);
    return work_.commit();
  }
  if (!change.page().empty() && work_.model().society(change.page()) == nullptr) {
    const text::Result<PageView> view = page(change.page());
    if (!view) return std::unexpected(view.error());
  }
  const Done done = set_layout(change.page(), {{"", words}});
  return done ? work_.commit() : done;
}

// ---- help

void Editor::write_help(std::uint32_t statement, const std::string& help) {
  const std::uint32_t begin = work_.tokens().help_begin(statement);
  std::string lines;
  for (const std::string& line : split_lines(help))
    lines += line.empty() ? "///\n" : fmt::format("/// {}\n", line);
  if (begin == statement) {
    work_.insert(statement, lines);
    return;
  }
  // The comments that stood there are what is replaced.
  Fragment what(lines);
  if (lines.empty()) {
    std::uint32_t to = statement;
    while (to > begin && (work_.text()[to - 1] == ' ' || work_.text()[to - 1] == '\t')) --to;
    work_.replace_all({begin, to}, "");
  } else {
    work_.replace_all({begin, statement}, lines);
  }
}

Done Editor::set_help(const SetHelp& change) {
  const TokenMap& tokens = work_.tokens();
  const auto declaration = [&](const text::Span& name) {
    write_help(tokens.tokens()[tokens.at(name.begin) - 1].span.begin, change.text());
    return work_.commit();
  };
  const auto of_declaration = [&](const std::string& name) -> Done {
    const std::map<std::string, Anchor> all = anchors_of(work_.model(), "", tokens);
    const auto found = all.find(name);
    if (found == all.end()) return refusal(fmt::format("there is no `{}`", text::shown(name)));
    return declaration({found->second, found->second});
  };
  if (change.page().empty()) return of_declaration(change.node());
  if (change.node().empty() && change.page().find('.') == std::string::npos)
    return of_declaration(change.page());
  const text::Result<PageView> view = page(change.page());
  if (!view) return std::unexpected(view.error());
  const auto of_state = [&](const cdl::State& state) {
    std::size_t at = tokens.at(state.name.place.span.begin);
    while (at > 0 && (tokens.word(at - 1) == "start" || tokens.word(at - 1) == "final")) --at;
    write_help(tokens.tokens()[at].span.begin, change.text());
    return work_.commit();
  };
  if (change.node().empty()) {
    if (view->page->state != nullptr) return of_state(*view->page->state);
    return refusal("this page has no help of its own");
  }
  if (view->page->sequence != nullptr) {
    for (const cdl::State& state : view->page->sequence->states) {
      if (state.name.text == change.node()) return of_state(state);
    }
  }
  const text::Result<int> at = node(*view, change.node());
  if (!at) return std::unexpected(at.error());
  const GraphNode& there = view->node(*at);
  if (there.parameter != nullptr) {
    SetParameter parameter;
    parameter.set_owner(view->graph->name);
    parameter.set_name(there.parameter->name.text);
    parameter.set_help(change.text());
    return set_parameter(parameter);
  }
  if (there.let != nullptr) return declaration(there.let->name.place.span);
  // A member of an operator has its line.
  if (there.reader >= 0) {
    const GraphInput& input = view->node(there.reader).inputs[static_cast<std::size_t>(there.reader_input)];
    if (input.role == Role::kMember) {
      const GraphInput& weight =
          view->node(there.reader).inputs[static_cast<std::size_t>(there.reader_input) + 1];
      const cdl::Expression& first =
          weight.role == Role::kWeight && weight.written ? *weight.written : *input.written;
      write_help(first.place.span.begin, change.text());
      return work_.commit();
    }
  }
  return refusal("only what has a line of its own can have help: a name, a member, a state");
}

// ---- names

Done Editor::rename(const Rename& change) {
  const std::string& to = change.name();
  if (!is_cdl_name(to))
    return refusal(
        fmt::format("`{}` is no name: a letter first, then letters, digits and `_`", text::shown(to)));
  if (change.node() == to) return true;
  if (change.page().empty()) return rename_declaration(change.node(), to);
  const text::Result<PageView> view = page(change.page());
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
  const text::Result<int> found = node(*view, change.node());
  if (!found) return std::unexpected(found.error());
  const GraphNode& there = view->node(*found);
  if (there.parameter != nullptr || there.let != nullptr) {
    const std::string from = there.parameter != nullptr ? there.parameter->name.text : there.let->name.text;
    return rename_local(*view, from, to);
  }
  if (there.expression == nullptr) return refusal("an actuator is called as its robot's class says");
  const cdl::Expression& expression = *there.expression;
  const TokenMap& tokens = work_.tokens();
  const bool is_own = to == default_name(expression);
  if (!expression.as.text.empty()) {
    const text::Span name = expression.as.place.span;
    if (is_own)
      work_.erase({tokens.tokens()[tokens.at(name.begin) - 2].span.end, name.end});
    else
      work_.replace(name, to);
  } else if (!is_own) {
    work_.replace(expression.place.span, value_as(expression, to));
  }
  return work_.commit();
}

// A `let` or a parameter, with all that reads it; a parameter also where calls give it.
Done Editor::rename_local(const PageView& view, const std::string& from, const std::string& to) {
  if (is_taken(view, to)) return refusal(fmt::format("`{}` is taken already", to));
  const OwnerGraph& graph = *view.graph;
  const auto rename_in = [&](const cdl::ExpressionPtr& expression) {
    if (!expression) return;
    cdl::for_each_expression(*expression, [&](const cdl::Expression& one) {
      const auto* name = std::get_if<cdl::Name>(&one.what);
      if (name != nullptr && name->name.text == from) work_.rename(name->name.place.span, to);
    });
  };
  for (const cdl::Let& let : graph.lets()) {
    if (let.name.text == from) work_.rename(let.name.place.span, to);
    rename_in(let.value);
  }
  bool is_parameter = false;
  for (const cdl::Parameter& parameter : graph.parameters()) {
    if (parameter.name.text == from) {
      work_.rename(parameter.name.place.span, to);
      is_parameter = true;
    }
    rename_in(parameter.initial);
  }
  if (graph.assemblage != nullptr) rename_in(graph.assemblage->body);
  if (graph.robot != nullptr) {
    for (const cdl::Drive& drive : graph.robot->drives) rename_in(drive.value);
  }
  if (!is_parameter || graph.assemblage == nullptr) return work_.commit();
  const auto rename_given = [&](const cdl::ExpressionPtr& expression) {
    if (!expression) return;
    cdl::for_each_expression(*expression, [&](const cdl::Expression& one) {
      const auto* call = std::get_if<cdl::Call>(&one.what);
      if (call == nullptr || call->callee.text != graph.name) return;
      for (const cdl::Argument& argument : call->arguments) {
        if (argument.name.text == from) work_.rename(argument.name.place.span, to);
      }
    });
  };
  for (const cdl::Item& item : work_.model().tree().items) {
    if (const auto* assemblage = std::get_if<cdl::Assemblage>(&item)) {
      for (const cdl::Let& let : assemblage->lets) rename_given(let.value);
      rename_given(assemblage->body);
    } else if (const auto* robot = std::get_if<cdl::Robot>(&item)) {
      for (const cdl::Let& let : robot->lets) rename_given(let.value);
      for (const cdl::Drive& drive : robot->drives) rename_given(drive.value);
    }
  }
  return work_.commit();
}

Done Editor::rename_state(const PageView& view, const std::string& from, const std::string& to) {
  for (const cdl::State& state : view.page->sequence->states) {
    if (state.name.text == to) return refusal(fmt::format("there is a state `{}` already", to));
  }
  for (const cdl::State& state : view.page->sequence->states) {
    if (state.name.text == from) work_.rename(state.name.place.span, to);
    for (const cdl::Transition& transition : state.transitions) {
      if (transition.target.text == from) work_.rename(transition.target.place.span, to);
    }
  }
  return work_.commit();
}

// A declaration, and every word of the file that means it.
Done Editor::rename_declaration(const std::string& from, const std::string& to) {
  const Model& model = work_.model();
  const std::map<std::string, Anchor> all = anchors_of(model, "", work_.tokens());
  if (!all.contains(from)) return refusal(fmt::format("there is no `{}`", text::shown(from)));
  if (all.contains(to)) return refusal(fmt::format("there is a `{}` already", to));
  const auto word = [&](const cdl::Word& one) {
    if (one.text == from) work_.rename(one.place.span, to);
  };
  const auto calls = [&](const cdl::ExpressionPtr& expression) {
    if (!expression) return;
    cdl::for_each_expression(*expression, [&](const cdl::Expression& one) {
      if (const auto* call = std::get_if<cdl::Call>(&one.what)) word(call->callee);
      if (const auto* by = std::get_if<cdl::Coordinate>(&one.what)) word(by->by.callee);
      if (const auto* by = std::get_if<cdl::Fuse>(&one.what)) word(by->by.callee);
    });
  };
  const auto devices = [&](const std::vector<cdl::Device>& all_devices) {
    for (const cdl::Device& device : all_devices) {
      word(device.by.callee);
      word(device.binds);
      for (const cdl::Argument& argument : device.by.arguments) calls(argument.value);
    }
  };
  const auto parameters_of = [&](const std::vector<cdl::Parameter>& parameters) {
    for (const cdl::Parameter& parameter : parameters) calls(parameter.initial);
  };
  const auto member = [&](const auto& self, const cdl::SocietyMember& one) -> void {
    word(one.name);
    word(one.by);
    for (const cdl::SocietyMember& inner : one.members) self(self, inner);
  };
  for (const cdl::Item& item : model.tree().items) {
    if (const auto* assemblage = std::get_if<cdl::Assemblage>(&item)) {
      word(assemblage->name);
      parameters_of(assemblage->parameters);
      for (const cdl::Let& let : assemblage->lets) calls(let.value);
      calls(assemblage->body);
    } else if (const auto* robot = std::get_if<cdl::Robot>(&item)) {
      word(robot->name);
      word(robot->class_name);
      parameters_of(robot->parameters);
      for (const cdl::Let& let : robot->lets) calls(let.value);
      for (const cdl::Choice& choice : robot->choices) word(choice.binding);
      for (const cdl::Drive& drive : robot->drives) {
        word(drive.binding);
        calls(drive.value);
      }
    } else if (const auto* robot_class = std::get_if<cdl::RobotClass>(&item)) {
      word(robot_class->name);
      devices(robot_class->devices);
    } else if (const auto* society = std::get_if<cdl::Society>(&item)) {
      word(society->name);
      member(member, society->what);
    } else if (const auto* op = std::get_if<cdl::SocietyOperator>(&item)) {
      word(op->name);
      devices(op->devices);
    } else if (const auto* binding = std::get_if<cdl::Binding>(&item)) {
      word(binding->name);
    }
  }
  return work_.commit();
}

}  // namespace mlab::designer
