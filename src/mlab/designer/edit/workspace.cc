#include "mlab/designer/edit/workspace.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/drawing/serving.h"

namespace mlab::designer {

Workspace::Workspace(std::shared_ptr<const Model> model, const cdl::Environment& environment)
    : model_(std::move(model)),
      environment_(environment),
      tokens_(std::make_unique<TokenMap>(model_->text())),
      changes_(std::make_unique<cdl::Changes>(model_->tree())) {}

void Workspace::add(cdl::Item item) {
  const cdl::Item* before = nullptr;
  if (!std::holds_alternative<cdl::Layout>(item)) {
    const auto& items = model_->tree().items;
    const auto layout = std::ranges::find_if(
        items, [](const cdl::Item& one) { return std::holds_alternative<cdl::Layout>(one); });
    if (layout != items.end()) before = &*layout;
  }
  changes_->add(std::move(item), before);
}

int Workspace::follow(std::uint32_t byte) {
  followed_.emplace_back(byte);
  return static_cast<int>(followed_.size()) - 1;
}

std::optional<std::uint32_t> Workspace::where(int handle) const {
  return followed_[static_cast<std::size_t>(handle)];
}

cdl::Reprinted Workspace::reprint() {
  cdl::Reprinted done = changes_->done();
  for (std::optional<std::uint32_t>& byte : followed_) {
    if (byte) byte = done.now(*byte);
  }
  model_ = std::make_shared<const Model>(
      std::make_shared<const text::Source>(model_->source()->name(), std::move(done.text)), environment_);
  tokens_ = std::make_unique<TokenMap>(model_->text());
  changes_ = std::make_unique<cdl::Changes>(model_->tree());
  return done;
}

Done Workspace::readable() const {
  if (model_->is_readable()) return true;
  for (const text::Diagnostic& d : model_->problems().items()) {
    if (d.severity == text::Severity::kError)
      return refusal(fmt::format("that can't be read: {}", d.message));
  }
  return refusal("that can't be read");
}

Done Workspace::commit() {
  if (changes_->empty()) return true;
  constexpr int kMostCommits = 5000;
  if (++commits_ > kMostCommits) return refusal("that is too much at once");
  const std::map<std::string, Named> before = named_by_layouts();
  const cdl::Reprinted went = reprint();
  if (const Done done = readable(); !done) return done;
  mend_layouts(before, went);
  if (!changes_->empty()) reprint();
  return true;
}

// ---- layout blocks go along

std::map<std::string, Workspace::Named> Workspace::named_by_layouts() const {
  std::map<std::string, Named> out;
  for (const cdl::Item& item : model_->tree().items) {
    const auto* layout = std::get_if<cdl::Layout>(&item);
    if (layout != nullptr) out[layout->owner.text].nodes = anchors_of(*model_, layout->owner.text, *tokens_);
  }
  for (auto& [path, named] : out) {
    for (const PageAnchor& one : page_anchors(*model_, *tokens_, owner_of(path))) {
      if (one.path == path) named.page = one.sequence.value_or(one.owner);
    }
  }
  return out;
}

// The page that is known by a word.
std::optional<std::string> Workspace::page_at(Anchor anchor) const {
  for (const cdl::Item& item : model_->tree().items) {
    const std::string* owner = std::visit(
        [&](const auto& one) -> const std::string* {
          if constexpr (requires { one.name; })
            return one.whole.begin <= anchor && anchor < one.whole.end ? &one.name.text : nullptr;
          return nullptr;
        },
        item);
    if (owner == nullptr) continue;
    std::optional<std::string> by_owner;
    for (const PageAnchor& one : page_anchors(*model_, *tokens_, *owner)) {
      if (one.sequence == anchor) return one.path;
      if (one.owner == anchor && !by_owner) by_owner = one.path;
    }
    return by_owner;
  }
  return std::nullopt;
}

void Workspace::mend_layouts(const std::map<std::string, Named>& before, const cdl::Reprinted& went) {
  for (const cdl::Item& item : model_->tree().items) {
    const auto* layout = std::get_if<cdl::Layout>(&item);
    if (layout == nullptr) continue;
    const auto known = before.find(layout->owner.text);
    if (known != before.end()) mend_layout(*layout, known->second, went);
  }
}

// Nodes that are called otherwise now, and those that have gone.
void Workspace::mend_layout(const cdl::Layout& layout, const Named& before, const cdl::Reprinted& went) {
  std::string page = layout.owner.text;
  if (before.page) {
    const std::optional<std::uint32_t> there = went.now(*before.page);
    const std::optional<std::string> found = there ? page_at(*there) : std::nullopt;
    if (!found) {
      changes_->remove(layout);
      return;
    }
    page = *found;
  }
  std::map<Anchor, std::string> names;
  for (const auto& [name, anchor] : anchors_of(*model_, page, *tokens_)) names[anchor] = name;
  std::set<std::string> taken;
  std::size_t gone = 0;
  for (const cdl::LayoutEntry& entry : layout.entries) {
    const auto was = before.nodes.find(entry.node.text);
    if (was == before.nodes.end()) continue;  // it stood for nothing before, either
    const std::optional<std::uint32_t> there = went.now(was->second);
    const auto called = there ? names.find(*there) : names.end();
    if (called == names.end() || !taken.insert(called->second).second) {
      changes_->remove(entry);
      ++gone;
    } else if (called->second != entry.node.text) {
      changes_->rename(entry.node, called->second);
    }
  }
  // A block of which nothing is left goes as a whole.
  if (layout.notes.empty() && gone > 0 && gone == layout.entries.size() && !page.empty())
    changes_->remove(layout);
  else if (page != layout.owner.text)
    changes_->rename(layout.owner, page);
}

// ---- anchors

namespace {

// The first sign that joins two.
std::optional<Anchor> anchor_of_sign(const cdl::Arithmetic& arithmetic, const cdl::Expression& expression,
                                     const TokenMap& tokens) {
  if (arithmetic.operands.size() < 2) return expression.place.span.begin;
  std::size_t i = tokens.at(arithmetic.operands.front()->place.span.end);
  while (i < tokens.tokens().size() && tokens.word(i) == ")") ++i;
  return i < tokens.tokens().size() ? std::optional<Anchor>(tokens.tokens()[i].span.begin) : std::nullopt;
}

}  // namespace

std::optional<Anchor> anchor_of(const GraphNode& node, const TokenMap& tokens) {
  using Kind = GraphNode::Kind;
  if (node.parameter != nullptr) return node.parameter->name.place.span.begin;
  if (node.drive != nullptr) return node.drive->binding.place.span.begin;
  if (node.kind == Kind::kOuter || node.kind == Kind::kValue) return node.let->name.place.span.begin;
  if (node.expression == nullptr) return std::nullopt;
  const cdl::Expression& expression = *node.expression;
  const auto* logic = std::get_if<cdl::Logic>(&expression.what);
  if (logic != nullptr && logic->connective != cdl::Connective::kNot) {
    const char* word = logic->connective == cdl::Connective::kAnd ? "and" : "or";
    for (std::size_t i = tokens.at(logic->operands.front()->place.span.end); i < tokens.tokens().size();
         ++i) {
      if (tokens.word(i) == word) return tokens.tokens()[i].span.begin;
    }
    return std::nullopt;
  }
  if (const auto* arithmetic = std::get_if<cdl::Arithmetic>(&expression.what))
    return anchor_of_sign(*arithmetic, expression, tokens);
  if (const auto* by = std::get_if<cdl::Coordinate>(&expression.what)) return by->by.callee.place.span.begin;
  if (const auto* by = std::get_if<cdl::Fuse>(&expression.what)) return by->by.callee.place.span.begin;
  if (const auto* call = std::get_if<cdl::Call>(&expression.what)) return call->callee.place.span.begin;
  std::size_t i = tokens.at(expression.place.span.begin);
  while (tokens.word(i) == "(") ++i;
  return tokens.tokens()[i].span.begin;
}

std::vector<PageAnchor> page_anchors(const Model& model, const TokenMap& tokens, std::string_view owner) {
  std::vector<PageAnchor> out;
  for (const auto& [name, anchor] : anchors_of(model, "", tokens)) {
    if (!owner.empty() && name != owner) continue;
    const OwnerGraph* graph = model.graph(name);
    if (graph == nullptr) {
      out.push_back({name, anchor, {}});
      continue;
    }
    std::map<int, Anchor> inner;
    for (const GraphPage& page : graph->pages) {
      for (const GraphNode& node : page.nodes) {
        const std::optional<Anchor> own = node.inner < 0 ? std::nullopt : anchor_of(node, tokens);
        if (own) inner[node.inner] = *own;
      }
    }
    for (std::size_t i = 0; i < graph->pages.size(); ++i) {
      const GraphPage& page = graph->pages[i];
      PageAnchor one{page.path, anchor, {}};
      if (page.state != nullptr) one.owner = page.state->name.place.span.begin;
      if (page.sequence != nullptr && page.root != nullptr)
        one.sequence = tokens.tokens()[tokens.at(page.root->place.span.begin)].span.begin;
      if (const auto found = inner.find(static_cast<int>(i)); found != inner.end())
        one.sequence = one.owner = found->second;
      out.push_back(std::move(one));
    }
  }
  return out;
}

std::map<std::string, Anchor> anchors_of(const Model& model, std::string_view page, const TokenMap& tokens) {
  std::map<std::string, Anchor> out;
  if (page.empty()) {
    for (const cdl::Item& item : model.tree().items) {
      std::visit(
          [&](const auto& one) {
            if constexpr (requires { one.name.place; }) out[one.name.text] = one.name.place.span.begin;
          },
          item);
    }
    return out;
  }
  const Model::FoundPage found = model.page(page);
  if (const Equipped owner = found.graph == nullptr ? equipped(model, page) : Equipped()) {
    for (const cdl::Device& device : owner.devices())
      out.try_emplace(device.name.text, device.name.place.span.begin);
  }
  if (found.graph == nullptr) return out;
  const GraphPage& there = found.graph->pages[static_cast<std::size_t>(found.page)];
  for (const GraphNode& node : there.nodes) {
    const std::string name = node.drive != nullptr ? "actuator." + node.drive->binding.text : node.name;
    if (const std::optional<Anchor> anchor = anchor_of(node, tokens)) out.try_emplace(name, *anchor);
  }
  if (there.sequence != nullptr) {
    for (const cdl::State& state : there.sequence->states) out[state.name.text] = state.name.place.span.begin;
  }
  return out;
}

}  // namespace mlab::designer
