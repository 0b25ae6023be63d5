// The clipboard: nodes, states and declarations as text, and where they stood.

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/drawing.h"
#include "mlab/designer/edit.h"
#include "mlab/designer/edit_words.h"
#include "mlab/designer/editor.h"
#include "mlab/designer/spread.h"
#include "mlab/lang/cdl/parser.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

// The `layout` behind copied nodes, which is taken off the text.
std::vector<cdl::LayoutEntry> take_layout(std::string& text) {
  const std::size_t at = text.rfind("\nlayout {");
  if (at == std::string::npos) return {};
  text::Diagnostics sink;
  const auto source = std::make_shared<const text::Source>("clipboard", text.substr(at + 1));
  const cdl::Tree tree = cdl::parse(source, sink);
  const auto* layout = tree.items.size() == 1 ? std::get_if<cdl::Layout>(&tree.items.front()) : nullptr;
  if (sink.has_errors() || layout == nullptr) return {};
  text.erase(at + 1);
  return layout->entries;
}

}  // namespace

Done Editor::paste(const Paste& change) {
  if (change.text().find_first_not_of(" \t\r\n") == std::string::npos)
    return refusal("there is nothing to paste");
  if (change.page().empty()) {
    // Declarations, each under a free name.
    text::Diagnostics sink;
    const auto source = std::make_shared<const text::Source>("clipboard", change.text());
    const auto tree = std::make_shared<const Model>(
        source, cdl::Environment{work_.model().configuration().built_in, nullptr});
    if (!tree->is_readable() || tree->tree().items.empty())
      return refusal("the clipboard holds no declarations");
    const std::map<std::string, Anchor> all = anchors_of(*tree, "", TokenMap(source->text()));
    std::string words(change.text());
    std::set<std::string> taken;
    for (const auto& [name, at] : anchors_of(work_.model(), "", work_.tokens())) taken.insert(name);
    std::vector<std::pair<Anchor, std::string>> order;
    for (const auto& [name, at] : all) order.emplace_back(at, name);
    std::ranges::sort(order, std::greater<>());
    for (const auto& [at, name] : order) {
      const std::string free = unique(name, taken);
      taken.insert(free);
      words.replace(at, name.size(), free);
    }
    while (!words.empty() && (words.back() == '\n' || words.back() == ' ')) words.pop_back();
    if (const Done done = add_text(words); !done) return done;
    return work_.commit();
  }
  const text::Result<PageView> found = page(change.page());
  if (!found) return std::unexpected(found.error());
  // Nodes come as `let`s, states as they stand in a sequence.
  std::string copy = change.text();
  const std::vector<cdl::LayoutEntry> layout = take_layout(copy);
  const bool is_states = !copy.starts_with("let ");
  const std::string wrapped = is_states ? fmt::format("assemblage A() {{ sequence {{\n{}\n}} }}", copy)
                                        : fmt::format("assemblage A() {{\n{}\n}}", copy);
  text::Diagnostics sink;
  const auto source = std::make_shared<const text::Source>("clipboard", wrapped);
  const cdl::Tree tree = cdl::parse(source, sink);
  const auto* holder = tree.items.size() == 1 ? std::get_if<cdl::Assemblage>(&tree.items.front()) : nullptr;
  if (sink.has_errors() || holder == nullptr)
    return refusal("the clipboard holds nothing that can stand here");
  const PageView view = *found;
  std::vector<Swap> swaps;
  std::set<std::string> taken;
  std::vector<std::string> names;
  std::map<std::string, std::string> renamed;
  if (is_states) {
    const auto* pasted = holder->body ? std::get_if<cdl::Sequence>(&holder->body->what) : nullptr;
    if (pasted == nullptr || view.page->sequence == nullptr || view.page->sequence->states.empty())
      return refusal("states can only be pasted between states");
    for (const cdl::State& state : view.page->sequence->states) taken.insert(state.name.text);
    const TokenMap tokens(source->text());
    for (const cdl::State& state : pasted->states) {
      renamed[state.name.text] = unique(state.name.text, taken);
      taken.insert(renamed[state.name.text]);
      names.push_back(renamed[state.name.text]);
      std::size_t first = tokens.at(state.name.place.span.begin);
      while (tokens.word(first - 1) == "start" || tokens.word(first - 1) == "final") --first;
      swaps.push_back({{tokens.tokens()[first].span.begin, state.name.place.span.end},
                       (state.is_final ? "final " : "") + renamed[state.name.text]});
    }
    for (const cdl::State& state : pasted->states) {
      for (const cdl::Transition& transition : state.transitions) {
        const auto target = renamed.find(transition.target.text);
        if (target != renamed.end()) {
          swaps.push_back({transition.target.place.span, target->second});
        } else if (!taken.contains(transition.target.text)) {
          const std::size_t semicolon = tokens.at(transition.place.span.end);
          swaps.push_back({{transition.place.span.begin, tokens.tokens()[semicolon].span.end}, ""});
        }
      }
    }
    const auto begin = static_cast<std::uint32_t>(wrapped.find('\n') + 1);
    const std::string words =
        swapped(wrapped, {begin, begin + static_cast<std::uint32_t>(copy.size())}, swaps);
    const cdl::State& last = view.page->sequence->states.back();
    const std::uint32_t end =
        last.transitions.empty() ? last.member->place.span.end : last.transitions.back().place.span.end;
    work_.insert_statement_behind(work_.tokens().statement_end(end), words);
  } else {
    if (holder->body || holder->lets.empty()) return refusal("the clipboard holds no nodes");
    for (const cdl::Let& let : view.graph->lets()) taken.insert(let.name.text);
    for (const cdl::Parameter& parameter : view.graph->parameters()) taken.insert(parameter.name.text);
    for (const GraphNode& one : view.graph->pages.front().nodes) taken.insert(one.name);
    for (const cdl::Let& let : holder->lets) {
      renamed[let.name.text] = unique(let.name.text, taken);
      taken.insert(renamed[let.name.text]);
      names.push_back(renamed[let.name.text]);
      swaps.push_back({let.name.place.span, renamed[let.name.text]});
    }
    for (const cdl::Let& let : holder->lets) {
      for_each_name(*let.value, [&](const cdl::Name& name, const cdl::Expression&) {
        const auto known = renamed.find(name.name.text);
        if (known != renamed.end()) swaps.push_back({name.name.place.span, known->second});
      });
    }
    const auto begin = static_cast<std::uint32_t>(wrapped.find('\n') + 1);
    std::string words = swapped(wrapped, {begin, begin + static_cast<std::uint32_t>(copy.size())}, swaps);
    // Its first words are `let NAME = `, its last `;`: what stands between is what add_let puts there.
    while (!words.empty() && (words.back() == '\n' || words.back() == ' ' || words.back() == ';'))
      words.pop_back();
    const std::size_t first = words.find('=');
    add_let(view, names.front(), words.substr(first + 2));
  }
  if (const Done done = work_.commit(); !done) return done;
  Arrange where;
  where.set_page(change.page());
  // As they stood; the leftmost and the topmost of them where the pointer is.
  double left = std::numeric_limits<double>::infinity();
  double top = left;
  for (const cdl::LayoutEntry& entry : layout) {
    left = std::min(left, entry.x);
    top = std::min(top, entry.y);
  }
  for (const cdl::LayoutEntry& entry : layout) {
    const std::string& path = entry.node.text;
    const std::string first = path.substr(0, path.find('.'));
    const auto known = renamed.find(first);
    if (known == renamed.end()) continue;
    Arrange::At& at = *where.add_nodes();
    at.set_node(known->second + path.substr(first.size()));
    at.set_x(change.x() + entry.x - left);
    at.set_y(change.y() + entry.y - top);
  }
  // Others one below the other.
  constexpr double kStep = 40.0;  // [px]
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (place_of(where.nodes(), names[i]) != nullptr) continue;
    Arrange::At& at = *where.add_nodes();
    at.set_node(names[i]);
    at.set_x(change.x() + kStep * static_cast<double>(i));
    at.set_y(change.y() + kStep * static_cast<double>(i));
  }
  if (const Done done = arrange(where); !done || change.taken().empty()) return done;
  const DrawingContext context{"pasted.cdl", 1, false, [](std::string_view) { return std::string(); }};
  std::vector<DrawnBox> boxes = placed_boxes(draw(work_.model(), change.page(), context));
  std::erase_if(boxes, [&](const DrawnBox& box) { return place_of(where.nodes(), box.name) == nullptr; });
  std::vector<DrawnBox> there;
  for (const Paste::Box& box : change.taken())
    there.push_back({"", box.x(), box.y(), {box.width(), box.height()}});
  const auto [right, down] = way_aside(boxes, there);
  if (right == 0.0 && down == 0.0) return true;
  for (Arrange::At& at : *where.mutable_nodes()) {
    at.set_x(at.x() + right);
    at.set_y(at.y() + down);
  }
  return arrange(where);
}

text::Result<std::string> copied(const Model& model, const Copy& request) {
  std::string out;
  const auto words = [&](text::Span span) {
    return std::string(model.text().substr(span.begin, span.end - span.begin));
  };
  if (request.page().empty()) {
    for (const std::string& name : request.nodes()) {
      const text::Span span = declaration_span(model, name);
      if (span.begin == span.end) return refusal(fmt::format("there is no `{}`", text::shown(name)));
      out += (out.empty() ? "" : "\n\n") + words(span);
    }
    return out + "\n";
  }
  const Model::Found found = model.page(request.page());
  if (found.graph == nullptr)
    return refusal(fmt::format("there is no page `{}`", text::shown(request.page())));
  const GraphPage& page = found.graph->pages[static_cast<std::size_t>(found.page)];
  const TokenMap tokens(model.text());
  std::set<int> chosen;
  std::vector<std::string> states;
  for (const std::string& name : request.nodes()) {
    bool is_state = false;
    for (const cdl::State& state :
         page.sequence == nullptr ? std::vector<cdl::State>{} : page.sequence->states) {
      if (state.name.text != name) continue;
      is_state = true;
      std::size_t first = tokens.at(state.name.place.span.begin);
      while (first > 0 && (tokens.word(first - 1) == "start" || tokens.word(first - 1) == "final")) --first;
      const std::uint32_t last =
          state.transitions.empty() ? state.member->place.span.end : state.transitions.back().place.span.end;
      states.push_back(words({tokens.tokens()[first].span.begin, tokens.statement_end(last)}));
    }
    if (is_state) continue;
    const int at = page.find(name);
    if (at < 0) return refusal(fmt::format("there is no `{}` on this page", text::shown(name)));
    if (page.nodes[static_cast<std::size_t>(at)].expression != nullptr) chosen.insert(at);
  }
  std::string layout;
  const auto stands = [&](std::string_view node, const std::string& as) {
    const Arrange::At* at = place_of(request.places(), node);
    if (at != nullptr) layout += fmt::format("  {} {:.0f} {:.0f};\n", as, at->x(), at->y());
  };
  const auto with_layout = [&] {
    return layout.empty() ? out : fmt::format("{}layout {{\n{}}}\n", out, layout);
  };
  for (const std::string& one : states) out += one + "\n";
  for (const std::string& name : request.nodes()) {
    if (!states.empty()) stands(name, name);
  }
  if (!states.empty()) return with_layout();
  std::set<std::string> taken;
  for (const int at : chosen) {
    const GraphNode& node = page.nodes[static_cast<std::size_t>(at)];
    // What is written inside of another chosen node comes with it.
    bool is_inside = false;
    for (int reader = node.reader; reader >= 0; reader = page.nodes[static_cast<std::size_t>(reader)].reader)
      is_inside |= chosen.contains(reader);
    if (is_inside) continue;
    const cdl::Expression& expression = *node.expression;
    std::string name = node.let != nullptr           ? node.let->name.text
                       : !expression.as.text.empty() ? expression.as.text
                                                     : default_name(expression);
    name = unique(name, taken);
    taken.insert(name);
    std::string value = words(expression.place.span);
    if (node.let == nullptr && !expression.as.text.empty()) {
      const std::uint32_t begin = expression.place.span.begin;
      const std::size_t as = tokens.at(expression.as.place.span.begin);
      const std::uint32_t from = tokens.tokens()[as - 2].span.end;
      value.erase(from - begin, expression.as.place.span.end - from);
    }
    out += fmt::format("let {} = {};\n", name, value);
    stands(node.name, name);
    for (std::size_t k = 0; k < page.nodes.size(); ++k) {
      const GraphNode& part = page.nodes[k];
      for (int reader = part.reader; reader >= 0;
           reader = page.nodes[static_cast<std::size_t>(reader)].reader) {
        if (reader == at) stands(part.name, name + "." + below(part.path, node.path));
      }
    }
  }
  if (out.empty()) return refusal("nothing of this can be copied");
  return with_layout();
}

}  // namespace mlab::designer
