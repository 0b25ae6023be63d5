#include "mlab/designer/workspace.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/format.h"

namespace mlab::designer {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

std::uint32_t size_of(std::string_view text) {
  return static_cast<std::uint32_t>(text.size());
}

}  // namespace

std::string Fragment::text() const {
  std::string out;
  for (const Piece& piece : pieces) out += piece.text;
  return out;
}

Workspace::Workspace(std::shared_ptr<const Model> model, const cdl::Environment& environment)
    : model_(std::move(model)),
      environment_(environment),
      tokens_(std::make_unique<TokenMap>(model_->text())),
      is_formatted_(cdl::laid_out(model_->text()) == model_->text()) {}

void Workspace::replace(text::Span span, Fragment by) {
  splices_.push_back({span, std::move(by), true, false});
}

void Workspace::insert(std::uint32_t at, Fragment what) {
  splices_.push_back({{at, at}, std::move(what), false, false});
}

void Workspace::erase(text::Span span) {
  const std::string_view all = text();
  std::uint32_t begin = span.begin;
  while (begin > 0 && is_blank(all[begin - 1])) --begin;
  std::uint32_t end = span.end;
  while (end < all.size() && is_blank(all[end])) ++end;
  const bool starts_line = begin == 0 || all[begin - 1] == '\n';
  const bool ends_line = end == all.size() || all[end] == '\n';
  if (starts_line && ends_line) {
    span.begin = begin;
    span.end = std::min(end + 1, size_of(all));
  }
  splices_.push_back({span, {}, true, false});
}

void Workspace::erase_statement(std::uint32_t begin) {
  const std::uint32_t end = tokens_->statement_end(begin);
  const std::uint32_t help = tokens_->help_begin(begin);
  if (help != begin) {
    std::uint32_t from = help;
    while (from > 0 && is_blank(text()[from - 1])) --from;
    std::uint32_t to = begin;
    while (to > from && is_blank(text()[to - 1])) --to;
    splices_.push_back({{from, to}, {}, false, false});
  }
  erase({begin, end});
}

void Workspace::insert_statement_behind(std::uint32_t end, const Fragment& what) {
  // Behind what is said of the statement on its line.
  const std::string_view all = text();
  const std::size_t token = tokens_->at(end);
  std::uint32_t at = end;
  const std::uint32_t first = token == 0 ? 0 : tokens_->tokens()[token - 1].comments;
  for (std::uint32_t i = first; i < tokens_->tokens()[token].comments; ++i) {
    const text::Span comment = tokens_->comments()[i].span;
    if (comment.begin < at) continue;
    if (all.substr(at, comment.begin - at).find('\n') != std::string_view::npos) break;
    at = comment.end;
    while (at > end && (all[at - 1] == '\n' || all[at - 1] == '\r')) --at;
  }
  splices_.push_back({{at, at}, Fragment("\n").add(what), false, true});
}

void Workspace::rename(text::Span word, const std::string& by) {
  Fragment what;
  what.pieces.push_back({by, word.begin});
  splices_.push_back({word, std::move(what), false, false});
}

Fragment Workspace::moved(text::Span span) const {
  Fragment out;
  const std::string_view words = text().substr(span.begin, span.end - span.begin);
  const auto has_comment = [&] {
    return std::ranges::any_of(tokens_->comments(), [&](const cdl::Comment& comment) {
      return comment.span.begin >= span.begin && comment.span.end <= span.end;
    });
  };
  if (words.find('\n') == std::string_view::npos || words.find('{') != std::string_view::npos ||
      has_comment()) {
    out.pieces.push_back({std::string(words), span.begin});
    return out;
  }
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find('\n', begin), words.size());
    out.pieces.push_back(
        {std::string(words.substr(begin, end - begin)), span.begin + static_cast<std::uint32_t>(begin)});
    begin = std::min(words.find_first_not_of(" \t\r\n", end), words.size());
    if (begin < words.size()) out.add(" ");
  }
  return out;
}

int Workspace::follow(std::uint32_t byte) {
  followed_.emplace_back(byte);
  return static_cast<int>(followed_.size()) - 1;
}

std::optional<std::uint32_t> Workspace::where(int handle) const {
  return followed_[static_cast<std::size_t>(handle)];
}

// The new text, and which parts of it stood where.
std::string Workspace::spliced(std::vector<Segment>& segments) {
  std::ranges::stable_sort(splices_, {}, [](const Splice& s) { return s.span.begin; });
  const std::string_view all = text();
  std::string out;
  std::uint32_t done = 0;
  // Comments in what is moved go with it.
  std::vector<text::Span> origins;
  for (const Splice& splice : splices_) {
    for (const Fragment::Piece& piece : splice.by.pieces) {
      if (piece.origin) origins.push_back({*piece.origin, *piece.origin + size_of(piece.text)});
    }
  }
  const auto is_moved = [&](const text::Span& comment) {
    return std::ranges::any_of(origins, [&](const text::Span& origin) {
      return origin.begin <= comment.begin && comment.end <= origin.end;
    });
  };
  const auto keep = [&](std::uint32_t begin, std::uint32_t end) {
    if (end <= begin) return;
    segments.push_back({begin, size_of(out), end - begin});
    out += all.substr(begin, end - begin);
  };
  for (const Splice& splice : splices_) {
    keep(done, splice.span.begin);
    if (splice.keeps_comments) {
      for (const cdl::Comment& comment : tokens_->comments()) {
        if (comment.span.begin < std::max(splice.span.begin, done) || comment.span.end > splice.span.end)
          continue;
        if (is_moved(comment.span)) continue;
        out += " ";
        keep(comment.span.begin, comment.span.end);
        if (!out.ends_with('\n')) out += '\n';
      }
    }
    // A statement where a line was taken away.
    const bool is_line = splice.is_statement && out.ends_with('\n');
    for (std::size_t i = 0; i < splice.by.pieces.size(); ++i) {
      const Fragment::Piece& piece = splice.by.pieces[i];
      const std::string_view words = std::string_view(piece.text).substr(is_line && i == 0 ? 1 : 0);
      if (piece.origin) segments.push_back({*piece.origin, size_of(out), size_of(words)});
      out += words;
    }
    if (is_line) out += '\n';
    done = std::max(done, splice.span.end);
  }
  keep(done, size_of(all));
  return out;
}

// The canonical layout: of the whole text where it had it before, else of the tokens around what has changed.
std::string Workspace::laid_out(const std::string& changed, const std::vector<text::Span>& touched,
                                std::vector<std::uint32_t>& moved_tokens) const {
  std::string formatted = cdl::laid_out(changed);
  const cdl::Tokens before = cdl::lex(changed);
  const cdl::Tokens after = cdl::lex(formatted);
  std::string out;
  if (is_formatted_ || before.tokens.size() != after.tokens.size() ||
      before.comments.size() != after.comments.size()) {
    for (const cdl::Token& token : after.tokens) moved_tokens.push_back(token.span.begin);
    return formatted;
  }
  // Tokens and comments in their order, with what stands between them from one text or the other.
  struct Word {
    text::Span old_span;
    text::Span new_span;
    bool is_token = false;
  };
  std::vector<Word> words;
  std::size_t comment = 0;
  for (std::size_t i = 0; i < before.tokens.size(); ++i) {
    for (; comment < before.tokens[i].comments; ++comment)
      words.push_back({before.comments[comment].span, after.comments[comment].span, false});
    words.push_back({before.tokens[i].span, after.tokens[i].span, true});
  }
  std::uint32_t old_end = 0;
  std::uint32_t new_end = 0;
  for (const Word& word : words) {
    const bool is_touched = std::ranges::any_of(touched, [&](const text::Span& span) {
      return span.begin <= word.old_span.begin && old_end <= span.end;
    });
    out += is_touched ? formatted.substr(new_end, word.new_span.begin - new_end)
                      : changed.substr(old_end, word.old_span.begin - old_end);
    if (word.is_token) moved_tokens.push_back(size_of(out));
    out += changed.substr(word.old_span.begin, word.old_span.end - word.old_span.begin);
    old_end = word.old_span.end;
    new_end = word.new_span.end;
  }
  return out + changed.substr(old_end);
}

void Workspace::set_text(std::string text) {
  model_ = std::make_shared<const Model>(
      std::make_shared<const text::Source>(model_->source()->name(), std::move(text)), environment_);
  tokens_ = std::make_unique<TokenMap>(model_->text());
}

Done Workspace::commit() {
  if (splices_.empty()) return true;
  constexpr int kMostCommits = 5000;
  if (++commits_ > kMostCommits) return refusal("that is too much at once");
  // Before: what the names in layout blocks stand for.
  std::map<std::string, std::map<std::string, Anchor>> places;
  for (const cdl::Item& item : model_->tree().items) {
    const auto* layout = std::get_if<cdl::Layout>(&item);
    if (layout != nullptr) places[layout->owner.text] = anchors_of(*model_, layout->owner.text, *tokens_);
  }
  std::map<std::string, Anchor> pages;
  if (!places.empty()) {
    for (const PageAnchor& one : page_anchors(*model_, *tokens_))
      pages[one.path] = one.sequence.value_or(one.owner);
  }

  std::vector<Segment> segments;
  const std::string changed = spliced(segments);
  std::vector<text::Span> touched;
  std::uint32_t at = 0;
  std::ranges::sort(segments, {}, &Segment::to);
  for (const Segment& segment : segments) {
    if (segment.to > at || segment.from != at) touched.push_back({at, segment.to});
    at = segment.to + segment.size;
    touched.push_back({at, at});
  }
  touched.push_back({at, size_of(changed)});
  splices_.clear();

  const cdl::Tokens lexed = cdl::lex(changed);
  std::vector<std::uint32_t> token_at;
  std::string formatted = laid_out(changed, touched, token_at);
  const auto now = [&](std::uint32_t byte) -> std::optional<std::uint32_t> {
    for (const Segment& segment : segments) {
      if (byte < segment.from || byte >= segment.from + segment.size) continue;
      const std::uint32_t there = segment.to + (byte - segment.from);
      const auto token =
          std::ranges::lower_bound(lexed.tokens, there, {}, [](const cdl::Token& t) { return t.span.begin; });
      const auto index = static_cast<std::size_t>(token - lexed.tokens.begin());
      if (index >= token_at.size()) return std::nullopt;
      return token_at[index];
    }
    return std::nullopt;
  };
  for (std::optional<std::uint32_t>& byte : followed_) {
    if (byte) byte = now(*byte);
  }
  const std::shared_ptr<const Model> before = model_;
  set_text(std::move(formatted));
  if (!model_->is_readable()) {
    for (const text::Diagnostic& d : model_->problems().items()) {
      if (d.severity == text::Severity::kError)
        return refusal(fmt::format("that can't be read: {}", d.message));
    }
    return refusal("that can't be read");
  }

  // The layout goes along: nodes that are called otherwise now, and those that have gone.
  std::vector<Splice> mends;
  std::map<Anchor, std::string> paths;
  if (!places.empty()) {
    for (const PageAnchor& one : page_anchors(*model_, *tokens_)) {
      paths.try_emplace(one.owner, one.path);
      if (one.sequence) paths[*one.sequence] = one.path;
    }
  }
  for (const cdl::Item& item : model_->tree().items) {
    const auto* layout = std::get_if<cdl::Layout>(&item);
    if (layout == nullptr) continue;
    const auto known = places.find(layout->owner.text);
    if (known == places.end()) continue;
    const std::string& page = layout->owner.text;
    std::string is = page;
    if (const auto was = pages.find(page); was != pages.end()) {
      const std::optional<std::uint32_t> there = now(was->second);
      const auto found = there ? paths.find(*there) : paths.end();
      if (found == paths.end()) {
        mends.push_back({layout->whole, {}, true, false});
        continue;
      }
      is = found->second;
      if (is != page) mends.push_back({layout->owner.place.span, is, false, false});
    }
    std::map<Anchor, std::string> names;
    for (const auto& [name, anchor] : anchors_of(*model_, is, *tokens_)) names[anchor] = name;
    std::set<std::string> taken;
    std::vector<Splice> gone;
    for (const cdl::LayoutEntry& entry : layout->entries) {
      const auto was = known->second.find(entry.node.text);
      if (was == known->second.end()) continue;  // it stood for nothing before, either
      const std::optional<std::uint32_t> there = now(was->second);
      const auto called = there ? names.find(*there) : names.end();
      if (called == names.end() || !taken.insert(called->second).second) {
        const std::uint32_t begin = entry.node.place.span.begin;
        gone.push_back({{begin, tokens_->statement_end(begin)}, {}, true, false});
      } else if (called->second != entry.node.text) {
        mends.push_back({entry.node.place.span, called->second, false, false});
      }
    }
    // A block of which nothing is left goes as a whole.
    const bool is_empty = layout->notes.empty() && !gone.empty() && gone.size() == layout->entries.size();
    if (is_empty && is != page) mends.pop_back();
    if (is_empty && !page.empty()) gone.assign(1, {layout->whole, {}, true, false});
    for (Splice& splice : gone) mends.push_back(std::move(splice));
  }
  if (mends.empty()) return true;
  for (Splice& mend : mends) {
    if (mend.by.pieces.empty())
      erase(mend.span);
    else
      splices_.push_back(std::move(mend));
  }
  std::vector<Segment> kept;
  std::string mended = spliced(kept);
  splices_.clear();
  for (std::optional<std::uint32_t>& byte : followed_) {
    if (!byte) continue;
    const std::uint32_t old = *byte;
    byte.reset();
    for (const Segment& segment : kept) {
      if (old >= segment.from && old < segment.from + segment.size) byte = segment.to + (old - segment.from);
    }
  }
  if (is_formatted_) {
    // Layout blocks stand behind everything that is followed, so only they move.
    mended = cdl::laid_out(mended);
  }
  set_text(std::move(mended));
  return true;
}

// ---- anchors

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
  if (const auto* by = std::get_if<cdl::Coordinate>(&expression.what)) return by->by.callee.place.span.begin;
  if (const auto* by = std::get_if<cdl::Fuse>(&expression.what)) return by->by.callee.place.span.begin;
  if (const auto* call = std::get_if<cdl::Call>(&expression.what)) return call->callee.place.span.begin;
  std::size_t i = tokens.at(expression.place.span.begin);
  while (tokens.word(i) == "(") ++i;
  return tokens.tokens()[i].span.begin;
}

std::vector<PageAnchor> page_anchors(const Model& model, const TokenMap& tokens) {
  std::vector<PageAnchor> out;
  for (const auto& [name, anchor] : anchors_of(model, "", tokens)) {
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
  const Model::Found found = model.page(page);
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
