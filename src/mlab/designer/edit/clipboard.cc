// The clipboard: nodes, states and declarations as text, and where they stood.

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/drawing/drawing.h"
#include "mlab/designer/edit/edit.h"
#include "mlab/designer/edit/editor.h"
#include "mlab/designer/edit/spread.h"
#include "mlab/designer/edit/values.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

// What was copied of a page: nodes as `let`s, or states, and where they stood.
struct Clipboard {
  std::vector<cdl::Let> lets;
  std::vector<cdl::State> states;
  std::vector<cdl::LayoutEntry> places;
};

// Nothing where it holds something else.
std::optional<Clipboard> clipboard_of(std::string text) {
  Clipboard out;
  const std::size_t layout_at = text.rfind("\nlayout {");
  if (layout_at != std::string::npos) {
    const std::vector<cdl::Item> items = items_of(text.substr(layout_at + 1));
    const auto* layout = items.size() == 1 ? std::get_if<cdl::Layout>(&items.front()) : nullptr;
    if (layout != nullptr) {
      out.places = layout->entries;
      text.erase(layout_at + 1);
    }
  }
  const bool has_states = !text.starts_with("let ");
  const std::string wrapped = has_states ? fmt::format("assemblage A() {{ sequence {{\n{}\n}} }}", text)
                                         : fmt::format("assemblage A() {{\n{}\n}}", text);
  text::Diagnostics sink;
  const cdl::Tree tree = cdl::parse(std::make_shared<const text::Source>("clipboard", wrapped), sink);
  const auto* holder = tree.items.size() == 1 ? std::get_if<cdl::Assemblage>(&tree.items.front()) : nullptr;
  if (sink.has_errors() || holder == nullptr) return std::nullopt;
  if (!has_states && !holder->body) out.lets = holder->lets;
  const auto* sequence = holder->body ? std::get_if<cdl::Sequence>(&holder->body->what) : nullptr;
  if (has_states && sequence != nullptr) out.states = sequence->states;
  return out;
}

}  // namespace

Done Editor::paste(const Paste& change) {
  if (change.text().find_first_not_of(" \t\r\n") == std::string::npos)
    return refusal("there is nothing to paste");
  if (change.page().empty()) return paste_declarations(change.text());
  const text::Result<PageView> view = find_page(work_.model(), change.page());
  if (!view) return std::unexpected(view.error());
  const std::optional<Clipboard> clipboard = clipboard_of(change.text());
  if (!clipboard) return refusal("the clipboard holds nothing that can stand here");
  const bool has_lets = change.text().starts_with("let ");
  if (has_lets && clipboard->lets.empty()) return refusal("the clipboard holds no nodes");
  const text::Result<Renamed> renamed =
      has_lets ? paste_lets(*view, clipboard->lets) : paste_states(*view, clipboard->states);
  if (!renamed) return std::unexpected(renamed.error());
  if (const Done done = work_.commit(); !done) return done;
  return arrange_pasted(change, *renamed, clipboard->places);
}

// Each under a free name.
Done Editor::paste_declarations(const std::string& text) {
  const Model clipboard(std::make_shared<const text::Source>("clipboard", text),
                        cdl::Environment{work_.model().configuration().built_in, nullptr});
  if (!clipboard.is_readable() || clipboard.tree().items.empty())
    return refusal("the clipboard holds no declarations");
  std::set<std::string> taken;
  for (const auto& [name, at] : anchors_of(work_.model(), "", work_.tokens())) taken.insert(name);
  for (cdl::Item item : clipboard.tree().items) {
    std::visit(
        [&](auto& one) {
          if constexpr (requires { one.name; }) {
            const std::string free = unique(one.name.text, taken);
            taken.insert(free);
            if (free != one.name.text) one.whole = {};
            one.name.text = free;
          }
        },
        item);
    work_.add(std::move(item));
  }
  return work_.commit();
}

text::Result<Editor::Renamed> Editor::paste_states(const PageView& view, std::vector<cdl::State> states) {
  if (states.empty() || view.page->sequence == nullptr || view.page->sequence->states.empty())
    return refusal("states can only be pasted between states");
  std::set<std::string> taken;
  for (const cdl::State& state : view.page->sequence->states) taken.insert(state.name.text);
  Renamed out;
  for (const cdl::State& state : states) {
    out.emplace_back(state.name.text, unique(state.name.text, taken));
    taken.insert(out.back().second);
  }
  for (std::size_t i = 0; i < states.size(); ++i) {
    cdl::State& state = states[i];
    state.name.text = out[i].second;
    state.is_start = false;
    state.whole = {};
    for (cdl::Transition& transition : state.transitions) {
      const auto known = std::ranges::find(out, transition.target.text, &Renamed::value_type::first);
      if (known != out.end()) transition.target.text = known->second;
    }
    std::erase_if(state.transitions,
                  [&](const cdl::Transition& one) { return !taken.contains(one.target.text); });
  }
  work_.changes().change<cdl::Sequence>(*view.page->sequence, [states](cdl::Sequence& now) {
    now.states.insert(now.states.end(), states.begin(), states.end());
  });
  return out;
}

text::Result<Editor::Renamed> Editor::paste_lets(const PageView& view, std::vector<cdl::Let> lets) {
  std::set<std::string> taken;
  for (const cdl::Let& let : view.lets()) taken.insert(let.name.text);
  for (const cdl::Parameter& parameter : view.graph->parameters()) taken.insert(parameter.name.text);
  for (const GraphNode& one : view.graph->pages.front().nodes) taken.insert(one.name);
  Renamed out;
  for (const cdl::Let& let : lets) {
    out.emplace_back(let.name.text, unique(let.name.text, taken));
    taken.insert(out.back().second);
  }
  static const cdl::Tree kNoTree;
  cdl::Changes renamed(kNoTree);
  for (const cdl::Let& let : lets) {
    cdl::for_each_construct(let, [&]<class X>(const X& one) {
      if constexpr (std::same_as<X, cdl::Name>) {
        const auto known = std::ranges::find(out, one.name.text, &Renamed::value_type::first);
        if (known != out.end() && known->second != known->first) renamed.rename(one.name, known->second);
      }
    });
  }
  for (std::size_t i = 0; i < lets.size(); ++i) {
    const cdl::ExpressionPtr value = renamed.of(lets[i].value);
    if (value != lets[i].value || out[i].second != out[i].first) lets[i].whole = {};
    lets[i].value = value;
    lets[i].name.text = out[i].second;
  }
  add_lets(work_, *view.graph, std::move(lets));
  return out;
}

// As they stood; the leftmost and the topmost of them where the pointer is. Others one below the other.
Done Editor::arrange_pasted(const Paste& change, const Renamed& renamed,
                            const std::vector<cdl::LayoutEntry>& places) {
  Arrange where;
  where.set_page(change.page());
  const auto add = [&](const std::string& node, double x, double y) {
    Arrange::At& at = *where.add_nodes();
    at.set_node(node);
    at.set_x(change.x() + x);
    at.set_y(change.y() + y);
  };
  double left = std::numeric_limits<double>::infinity();
  double top = left;
  for (const cdl::LayoutEntry& entry : places) {
    left = std::min(left, entry.x);
    top = std::min(top, entry.y);
  }
  for (const cdl::LayoutEntry& entry : places) {
    const std::string& path = entry.node.text;
    const std::string first = path.substr(0, path.find('.'));
    const auto known = std::ranges::find(renamed, first, &Renamed::value_type::first);
    if (known != renamed.end()) add(known->second + path.substr(first.size()), entry.x - left, entry.y - top);
  }
  constexpr double kStep = 40.0;  // [px]
  for (std::size_t i = 0; i < renamed.size(); ++i) {
    const double step = kStep * static_cast<double>(i);
    if (place_of(where.nodes(), renamed[i].second) == nullptr) add(renamed[i].second, step, step);
  }
  if (const Done done = arrange(work_, where); !done || change.taken().empty()) return done;
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
  return arrange(work_, where);
}

namespace {

// Writes what is copied of a page.
class Copier {
 public:
  Copier(const Model& model, const GraphPage& page, const Copy& request)
      : model_(model), page_(page), request_(request), tokens_(model.text()) {}

  text::Result<std::string> run() {
    std::set<int> chosen;
    bool has_states = false;
    for (const std::string& name : request_.nodes()) {
      if (const cdl::State* state = find_state(name)) {
        has_states = true;
        out_ += std::string(words(state->whole)) + "\n";
        continue;
      }
      const int at = page_.find(name);
      if (at < 0) return refusal(fmt::format("there is no `{}` on this page", text::shown(name)));
      if (page_.nodes[static_cast<std::size_t>(at)].expression != nullptr) chosen.insert(at);
    }
    if (has_states) {
      for (const std::string& name : request_.nodes()) put_place(name, name);
    } else {
      for (const int at : chosen) copy_node(at, chosen);
    }
    if (out_.empty()) return refusal("nothing of this can be copied");
    return layout_.empty() ? out_ : fmt::format("{}layout {{\n{}}}\n", out_, layout_);
  }

 private:
  const cdl::State* find_state(const std::string& name) const {
    if (page_.sequence == nullptr) return nullptr;
    const auto& states = page_.sequence->states;
    const auto found = std::ranges::find_if(states, [&](const auto& one) { return one.name.text == name; });
    return found == states.end() ? nullptr : &*found;
  }

  void copy_node(int at, const std::set<int>& chosen) {
    const GraphNode& node = page_.nodes[static_cast<std::size_t>(at)];
    // What is written inside of another chosen node comes with it.
    if (is_inside(node, [&](int reader) { return chosen.contains(reader); })) return;
    const cdl::Expression& expression = *node.expression;
    const std::string name = unique(node.let != nullptr           ? node.let->name.text
                                    : !expression.as.text.empty() ? expression.as.text
                                                                  : default_name(expression),
                                    taken_);
    taken_.insert(name);
    out_ += fmt::format("let {} = {};\n", name, value_of_node(node));
    put_place(node.name, name);
    for (const GraphNode& part : page_.nodes) {
      if (is_inside(part, [&](int reader) { return reader == at; }))
        put_place(part.name, name + "." + below(part.path, node.path));
    }
  }

  // As it is written, without `as` and its name.
  std::string value_of_node(const GraphNode& node) const {
    const cdl::Expression& expression = *node.expression;
    std::string out(words(expression.place.span));
    if (node.let != nullptr || expression.as.text.empty()) return out;
    const std::size_t as = tokens_.at(expression.as.place.span.begin);
    const std::uint32_t from = tokens_.tokens()[as - 2].span.end;
    out.erase(from - expression.place.span.begin, expression.as.place.span.end - from);
    return out;
  }

  bool is_inside(const GraphNode& node, const auto& of) const {
    for (int reader = node.reader; reader >= 0;
         reader = page_.nodes[static_cast<std::size_t>(reader)].reader) {
      if (of(reader)) return true;
    }
    return false;
  }

  void put_place(std::string_view node, const std::string& as) {
    const Arrange::At* at = place_of(request_.places(), node);
    if (at != nullptr) layout_ += fmt::format("  {} {:.0f} {:.0f};\n", as, at->x(), at->y());
  }

  std::string_view words(text::Span span) const {
    return model_.text().substr(span.begin, span.end - span.begin);
  }

  const Model& model_;
  const GraphPage& page_;
  const Copy& request_;
  TokenMap tokens_;
  std::set<std::string> taken_;
  std::string out_;
  std::string layout_;
};

text::Result<std::string> copied_declarations(const Model& model, const Copy& request) {
  std::string out;
  for (const std::string& name : request.nodes()) {
    const text::Span span = declaration_span(model, name);
    if (span.begin == span.end) return refusal(fmt::format("there is no `{}`", text::shown(name)));
    out += out.empty() ? "" : "\n\n";
    out += model.text().substr(span.begin, span.end - span.begin);
  }
  return out + "\n";
}

}  // namespace

text::Result<std::string> copied(const Model& model, const Copy& request) {
  if (request.page().empty()) return copied_declarations(model, request);
  const Model::Found found = model.page(request.page());
  if (found.graph == nullptr) return refusal(why_no_components(model, request.page()));
  return Copier(model, found.graph->pages[static_cast<std::size_t>(found.page)], request).run();
}

}  // namespace mlab::designer
