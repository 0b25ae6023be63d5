// Several nodes at once: assemblages made of them and put back.

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/designer/edit.h"
#include "mlab/designer/edit_words.h"
#include "mlab/designer/editor.h"
#include "mlab/text/shown.h"

namespace mlab::designer {

// The nodes have one value that others take: it is what the new assemblage gives.
Done Editor::group(const Group& change) {
  const text::Result<PageView> found = page(change.page());
  if (!found) return std::unexpected(found.error());
  const PageView view = *found;
  const std::string& name = change.name();
  if (!is_cdl_name(name)) return refusal(fmt::format("`{}` is no name", text::shown(name)));
  const bool is_known = anchors_of(work_.model(), "", work_.tokens()).contains(name) ||
                        work_.model().components().find(name).has_value();
  if (is_known) return refusal(fmt::format("there is a `{}` already", name));
  std::set<int> chosen;
  for (const std::string& one : change.nodes()) {
    const text::Result<int> at = node(view, one);
    if (!at) return std::unexpected(at.error());
    if (view.node(*at).expression != nullptr) chosen.insert(*at);
  }
  if (chosen.empty()) return refusal("no node is chosen that could be a part of an assemblage");

  // Which of them others read: inline elsewhere, by name elsewhere, as the page's result.
  const auto is_inside = [&](int at) { return chosen.contains(at); };
  std::set<int> outputs;
  for (const int at : chosen) {
    const GraphNode& one = view.node(at);
    bool is_read_inside = false;
    bool is_read_outside = view.page->result == at;
    for (std::size_t k = 0; k < view.page->nodes.size(); ++k) {
      for (const GraphInput& input : view.page->nodes[k].inputs) {
        if (input.from != at) continue;
        (is_inside(static_cast<int>(k)) ? is_read_inside : is_read_outside) = true;
      }
    }
    if (one.let != nullptr) {
      int inside = 0;
      for (const int other : chosen) {
        for (const GraphInput& input : view.node(other).inputs) {
          const auto* reads = input.written ? std::get_if<cdl::Name>(&input.written->what) : nullptr;
          if (reads != nullptr && reads->name.text == one.let->name.text) ++inside;
        }
      }
      if (count_uses(*view.graph, one.let->name.text) > inside) is_read_outside = true;
    }
    if (is_read_outside || !is_read_inside) outputs.insert(at);
  }
  if (outputs.size() != 1) {
    std::vector<std::string> names;
    for (const int at : outputs) names.push_back(fmt::format("`{}`", view.node(at).name));
    return refusal(
        fmt::format("an assemblage gives one value, and these give several: {}; choose what they lead to "
                    "as well, so that one is left",
                    fmt::join(names, ", ")));
  }
  const int top = *outputs.begin();
  const GraphNode& output = view.node(top);

  // What drives them from outside becomes parameters.
  struct Given {
    std::string name;
    std::string words;    // type and default
    std::string outside;  // what the caller gives
  };
  std::vector<Given> given;
  std::set<std::string> taken;
  for (const int at : chosen) {
    if (view.node(at).let != nullptr) taken.insert(view.node(at).let->name.text);
  }
  std::vector<Swap> swaps;
  std::vector<text::Span> hoisted;  // expressions that go to the caller
  const auto text_of = [&](text::Span span) {
    return std::string(work_.text().substr(span.begin, span.end - span.begin));
  };
  const auto add = [&](const std::string& wanted, const std::string& words, const std::string& outside) {
    for (const Given& one : given) {
      if (one.outside == outside) return one.name;
    }
    const std::string free = unique(wanted, taken);
    taken.insert(free);
    given.push_back({free, words, outside});
    return free;
  };
  const auto is_chosen_let = [&](std::string_view let) {
    return std::ranges::any_of(
        chosen, [&](int at) { return view.node(at).let != nullptr && view.node(at).let->name.text == let; });
  };
  for (const int at : chosen) {
    for (const GraphInput& input : view.node(at).inputs) {
      if (!input.written || (input.is_inline && is_inside(input.from))) continue;
      if (input.is_inline) {  // written here, and stays outside
        const cdl::PortType type = this->given(view, input.from);
        if (type.type == nullptr)
          return refusal(fmt::format("what type `{}` has can't be told", view.node(input.from).name));
        const std::string param = add(input.port == "members" ? default_name(*input.written) : input.port,
                                      type_words(type), text_of(input.written->place.span));
        swaps.push_back({input.written->place.span, param});
        hoisted.push_back(input.written->place.span);
      }
    }
  }
  const auto is_hoisted = [&](text::Span span) {
    return std::ranges::any_of(
        hoisted, [&](text::Span one) { return one.begin <= span.begin && span.end <= one.end; });
  };
  std::string trouble;
  const auto look = [&](const cdl::Expression& expression) {
    for_each_name(expression, [&](const cdl::Name& one, const cdl::Expression& whole) {
      const std::string& word = one.name.text;
      if (is_hoisted(whole.place.span) || is_chosen_let(word)) return;
      for (const cdl::Parameter& parameter : view.graph->parameters()) {
        if (parameter.name.text != word) continue;
        const text::Span span = parameter.whole;
        const std::string words = text_of({parameter.type.place.span.begin, span.end});
        const std::string param = add(word, words, word);
        if (param != word) swaps.push_back({one.name.place.span, param});
      }
      for (const cdl::Let& let : view.graph->lets()) {
        if (let.name.text != word) continue;
        const cdl::PortType type = view.graph->type_of(*let.value);
        if (type.type == nullptr) trouble = word;
        const std::string param = add(word, type.type == nullptr ? "" : type_words(type), word);
        if (param != word) swaps.push_back({one.name.place.span, param});
      }
    });
  };
  look(*output.expression);
  for (const int at : chosen) {
    if (view.node(at).let != nullptr && at != top) look(*view.node(at).let->value);
  }
  if (!trouble.empty()) return refusal(fmt::format("what type `{}` has can't be told", trouble));
  // Parameters with a default come behind those without.
  std::ranges::stable_partition(given,
                                [](const Given& one) { return one.words.find('=') == std::string::npos; });

  Fragment declaration(fmt::format("assemblage {}(", name));
  for (std::size_t i = 0; i < given.size(); ++i)
    declaration.add(fmt::format("{}{}: {}", i == 0 ? "" : ", ", given[i].name, given[i].words));
  declaration.add(") {\n");
  for (const cdl::Let& let : view.graph->lets()) {
    for (const int at : chosen) {
      if (view.node(at).let != &let || at == top) continue;
      declaration.add(fmt::format("let {} = ", let.name.text))
          .add(swapped(work_, let.value->place.span, swaps))
          .add(";\n");
    }
  }
  const cdl::Expression& body = *output.expression;
  text::Span words = body.place.span;
  const bool has_name = !body.as.text.empty() && !body.active;
  if (has_name) words.end = work_.tokens().tokens()[work_.tokens().at(body.as.place.span.begin) - 2].span.end;
  const Fragment made = swapped(work_, words, swaps);
  declaration.add(made).add(made.text().ends_with('}') ? "\n}\n\n" : ";\n}\n\n");

  std::string call = name + "(";
  for (std::size_t i = 0; i < given.size(); ++i)
    call += fmt::format("{}{} = {}", i == 0 ? "" : ", ", given[i].name, given[i].outside);
  call += ")";
  if (has_name) call += " as " + body.as.text;
  // Before the declaration that they come from.
  const text::Span owner = declaration_span(work_.model(), view.graph->name);
  work_.insert(owner.begin, declaration);
  work_.replace_all(body.place.span, call);
  for (const int at : chosen) {
    if (view.node(at).let != nullptr && at != top) erase_let(*view.node(at).let);
  }
  const std::vector<Stood> stood = places(view, change.page(), chosen);
  if (const Done done = work_.commit(); !done) return done;
  return arrange_group(change, stood);
}

// Where the layout has these nodes, and by what they are found again.
std::vector<Editor::Stood> Editor::places(const PageView& view, const std::string& page,
                                          const std::set<int>& nodes) {
  std::vector<Stood> out;
  const cdl::Layout* layout = work_.model().layout(page);
  if (layout == nullptr) return out;
  for (const int at : nodes) {
    const GraphNode& one = view.node(at);
    const auto entry = std::ranges::find_if(
        layout->entries, [&](const cdl::LayoutEntry& e) { return e.node.text == one.name; });
    const std::optional<Anchor> anchor = anchor_of(one, work_.tokens());
    if (entry != layout->entries.end() && anchor) out.push_back({work_.follow(*anchor), entry->x, entry->y});
  }
  return out;
}

// The nodes stand in the new assemblage as they stood, and its own node where the change says.
Done Editor::arrange_group(const Group& change, const std::vector<Stood>& stood) {
  Arrange inside;
  inside.set_page(change.name());
  const auto add = [](Arrange& where, const std::string& node, double x, double y) {
    Arrange::At& at = *where.add_nodes();
    at.set_node(node);
    at.set_x(x);
    at.set_y(y);
  };
  for (const auto& [name, anchor] : anchors_of(work_.model(), change.name(), work_.tokens())) {
    for (const Stood& one : stood) {
      if (work_.where(one.handle) == anchor) add(inside, name, one.x, one.y);
    }
  }
  if (inside.nodes_size() > 0) {
    if (const Done done = arrange(inside); !done) return done;
  }
  if (!change.has_x() || !change.has_y()) return true;
  const text::Result<PageView> found = page(change.page());
  if (!found) return std::unexpected(found.error());
  Arrange outside;
  outside.set_page(change.page());
  for (const GraphNode& one : found->page->nodes) {
    const auto* call = one.expression == nullptr ? nullptr : std::get_if<cdl::Call>(&one.expression->what);
    if (call != nullptr && call->callee.text == change.name()) add(outside, one.name, change.x(), change.y());
  }
  return outside.nodes_size() == 0 ? Done(true) : arrange(outside);
}

// What the called assemblage is made of, with the call's values in place of its parameters.
Done Editor::ungroup(const Ungroup& change) {
  const text::Result<PageView> found = page(change.page());
  if (!found) return std::unexpected(found.error());
  const PageView view = *found;
  const text::Result<int> at = node(view, change.node());
  if (!at) return std::unexpected(at.error());
  const GraphNode& there = view.node(*at);
  const auto* call = there.expression == nullptr ? nullptr : std::get_if<cdl::Call>(&there.expression->what);
  const auto& assemblages = work_.model().configuration().assemblages;
  if (call == nullptr || !assemblages.contains(call->callee.text))
    return refusal("only an assemblage is made of something");
  const cdl::Assemblage& assemblage = *assemblages.find(call->callee.text)->second;
  if (!assemblage.body) return refusal("the assemblage is empty");
  const std::string_view source = assemblage.name.place.source->text();

  std::map<std::string, std::string> values;
  for (std::size_t i = 0; i < call->arguments.size(); ++i) {
    const cdl::Argument& argument = call->arguments[i];
    std::string name = argument.name.text;
    if (name.empty() && i < assemblage.parameters.size()) name = assemblage.parameters[i].name.text;
    const text::Span span = argument.value->place.span;
    values[name] = work_.text().substr(span.begin, span.end - span.begin);
  }
  std::set<std::string> taken;
  for (const cdl::Let& let : view.graph->lets()) taken.insert(let.name.text);
  for (const cdl::Parameter& parameter : view.graph->parameters()) taken.insert(parameter.name.text);
  std::vector<std::string> statements;
  std::map<std::string, std::string> names;
  std::map<std::string, int> uses;
  const auto count = [&](const cdl::ExpressionPtr& expression) {
    for_each_name(*expression,
                  [&](const cdl::Name& name, const cdl::Expression&) { ++uses[name.name.text]; });
  };
  count(assemblage.body);
  for (const cdl::Let& let : assemblage.lets) count(let.value);
  for (const cdl::Parameter& parameter : assemblage.parameters) {
    const std::string& name = parameter.name.text;
    const auto value = values.find(name);
    if (value == values.end() && !parameter.initial)
      return refusal(fmt::format("`{}` has no value here", name));
    std::string words = value != values.end()
                            ? value->second
                            : std::string(source.substr(
                                  parameter.initial->place.span.begin,
                                  parameter.initial->place.span.end - parameter.initial->place.span.begin));
    // A node that several of its parts read stays one node.
    const bool is_node = words.find('(') != std::string::npos || words.find('{') != std::string::npos;
    if (is_node && uses[name] > 1) {
      const std::string own = unique(name, taken);
      taken.insert(own);
      statements.push_back(fmt::format("let {} = {};", own, words));
      words = own;
    }
    names[name] = words;
  }
  for (const cdl::Let& let : assemblage.lets) {
    names[let.name.text] = unique(let.name.text, taken);
    taken.insert(names[let.name.text]);
  }
  const auto words_of = [&](const cdl::Expression& expression) {
    std::vector<Swap> swaps;
    for_each_name(expression, [&](const cdl::Name& name, const cdl::Expression&) {
      const auto known = names.find(name.name.text);
      if (known != names.end() && known->second != name.name.text)
        swaps.push_back({name.name.place.span, known->second});
    });
    return swapped(source, expression.place.span, std::move(swaps));
  };
  for (const cdl::Let& let : assemblage.lets)
    statements.push_back(fmt::format("let {} = {};", names[let.name.text], words_of(*let.value)));
  std::string body = words_of(*assemblage.body);
  if (!there.expression->as.text.empty() && assemblage.body->as.text.empty() && !assemblage.body->active &&
      !default_name(*assemblage.body).empty())
    body += " as " + there.expression->as.text;
  const bool is_line = there.reader < 0 || there.let != nullptr;
  const GraphInput* input =
      there.reader < 0 ? nullptr
                       : &view.node(there.reader).inputs[static_cast<std::size_t>(there.reader_input)];
  const bool takes_block =
      is_line || (input != nullptr && (input->role == Role::kMember || input->role == Role::kCase ||
                                       input->role == Role::kDrive));
  if (!takes_block && body.find('{') != std::string::npos) {
    const std::string own = unique(default_name(*assemblage.body), taken);
    statements.push_back(fmt::format("let {} = {};", own, body));
    body = own;
  }
  if (!statements.empty()) {
    std::string all;
    for (const std::string& one : statements) all += (all.empty() ? "" : "\n") + one;
    // One statement after the other behind the last `let`.
    const std::size_t first = all.find(" = ");
    const std::string name = all.substr(4, first - 4);
    add_let(view, name, all.substr(first + 3, all.size() - first - 4));
  }
  work_.replace(there.expression->place.span, body);
  return work_.commit();
}

}  // namespace mlab::designer
