#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include "mlab/designer/drawing/serving.h"
#include "mlab/designer/edit/edit.h"
#include "mlab/designer/edit/spans.h"
#include "mlab/designer/edit/values.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
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
  const Model::FoundPage found = model.page(request.page());
  if (found.graph == nullptr) return refusal(why_no_components(model, request.page()));
  return Copier(model, found.graph->pages[static_cast<std::size_t>(found.page)], request).run();
}

}  // namespace mlab::designer
