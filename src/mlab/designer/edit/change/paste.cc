#include "mlab/designer/edit/change/paste.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/designer/drawing/drawing.h"
#include "mlab/designer/edit/change/layout.h"
#include "mlab/designer/edit/find/pages.h"
#include "mlab/designer/edit/page_writer.h"
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

using NewNames = std::vector<std::pair<std::string, std::string>>;  // what they were called, and are

// Each under a free name.
Done paste_declarations(Workspace& work, const std::string& text) {
  const Model clipboard(std::make_shared<const text::Source>("clipboard", text),
                        cdl::Environment{work.model().configuration().built_in, nullptr});
  if (!clipboard.is_readable() || clipboard.tree().items.empty())
    return refusal("the clipboard holds no declarations");
  std::set<std::string> taken;
  for (const auto& [name, at] : anchors_of(work.model(), "", work.tokens())) taken.insert(name);
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
    work.add(std::move(item));
  }
  return work.commit();
}

text::Result<NewNames> paste_states(Workspace& work, const PageView& view, std::vector<cdl::State> states) {
  if (states.empty() || view.page->sequence == nullptr || view.page->sequence->states.empty())
    return refusal("states can only be pasted between states");
  std::set<std::string> taken;
  for (const cdl::State& state : view.page->sequence->states) taken.insert(state.name.text);
  NewNames out;
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
      const auto known = std::ranges::find(out, transition.target.text, &NewNames::value_type::first);
      if (known != out.end()) transition.target.text = known->second;
    }
    std::erase_if(state.transitions,
                  [&](const cdl::Transition& one) { return !taken.contains(one.target.text); });
  }
  work.changes().change<cdl::Sequence>(*view.page->sequence, [states](cdl::Sequence& now) {
    now.states.insert(now.states.end(), states.begin(), states.end());
  });
  return out;
}

text::Result<NewNames> paste_lets(Workspace& work, const PageView& view, std::vector<cdl::Let> lets) {
  std::set<std::string> taken;
  for (const cdl::Let& let : view.lets()) taken.insert(let.name.text);
  for (const cdl::Parameter& parameter : view.graph->parameters()) taken.insert(parameter.name.text);
  for (const GraphNode& one : view.graph->pages.front().nodes) taken.insert(one.name);
  NewNames out;
  for (const cdl::Let& let : lets) {
    out.emplace_back(let.name.text, unique(let.name.text, taken));
    taken.insert(out.back().second);
  }
  static const cdl::Tree kNoTree;
  cdl::Changes renamed(kNoTree);
  for (const cdl::Let& let : lets) {
    cdl::for_each_construct(let, [&]<class X>(const X& one) {
      if constexpr (std::same_as<X, cdl::Name>) {
        const auto known = std::ranges::find(out, one.name.text, &NewNames::value_type::first);
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
  add_lets(work, *view.graph, std::move(lets));
  return out;
}

// As they stood; the leftmost and the topmost of them where the pointer is. Others one below the other.
Done arrange_pasted(Workspace& work, const Paste& change, const NewNames& renamed,
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
    const auto known = std::ranges::find(renamed, first, &NewNames::value_type::first);
    if (known != renamed.end()) add(known->second + path.substr(first.size()), entry.x - left, entry.y - top);
  }
  constexpr double kStep = 40.0;  // [px]
  for (std::size_t i = 0; i < renamed.size(); ++i) {
    const double step = kStep * static_cast<double>(i);
    if (place_of(where.nodes(), renamed[i].second) == nullptr) add(renamed[i].second, step, step);
  }
  if (const Done done = arrange(work, where); !done || change.taken().empty()) return done;
  const DrawingContext context{"pasted.cdl", 1, false, [](std::string_view) { return std::string(); }};
  std::vector<DrawnBox> boxes = placed_boxes(draw(work.model(), change.page(), context));
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
  return arrange(work, where);
}

}  // namespace

Done paste(Workspace& work, const Paste& change) {
  if (change.text().find_first_not_of(" \t\r\n") == std::string::npos)
    return refusal("there is nothing to paste");
  if (change.page().empty()) return paste_declarations(work, change.text());
  const text::Result<PageView> view = find_page(work.model(), change.page());
  if (!view) return std::unexpected(view.error());
  const std::optional<Clipboard> clipboard = clipboard_of(change.text());
  if (!clipboard) return refusal("the clipboard holds nothing that can stand here");
  const bool has_lets = change.text().starts_with("let ");
  if (has_lets && clipboard->lets.empty()) return refusal("the clipboard holds no nodes");
  const text::Result<NewNames> renamed =
      has_lets ? paste_lets(work, *view, clipboard->lets) : paste_states(work, *view, clipboard->states);
  if (!renamed) return std::unexpected(renamed.error());
  if (const Done done = work.commit(); !done) return done;
  return arrange_pasted(work, change, *renamed, clipboard->places);
}

}  // namespace mlab::designer
