#include "mlab/lang/cnl/load.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

#include <fmt/core.h>

#include "mlab/lang/cnl/lexer.h"
#include "mlab/lang/cnl/parser.h"
#include "mlab/text/shown.h"

namespace mlab::cnl {
namespace {

namespace fs = std::filesystem;

class Loader {
 public:
  Loader(text::Diagnostics& diagnostics, std::vector<std::string>* files, const text::Files& reader)
      : diagnostics_(diagnostics), files_(files), reader_(reader) {}

  Tree read(const text::SourcePtr& source) {
    const std::string path = normal(source->name());
    seen_.insert(path);
    open_.push_back(path);
    Tree tree = parse(source, diagnostics_);
    for (Item& item : tree.items) {
      if (auto* include = std::get_if<Include>(&item)) follow(*include, source->name());
    }
    open_.pop_back();
    return tree;
  }

 private:
  static std::string normal(const std::string& path) {
    std::error_code failure;
    const fs::path canonical = fs::weakly_canonical(path, failure);
    return failure ? path : canonical.string();
  }

  void follow(Include& include, const std::string& from) {
    if (include.path.text.empty() || include.path.text.find('\0') != std::string::npos) {
      diagnostics_.error("cannot-read", include.path.place, "this is not the name of a file");
      return;
    }
    const std::string path = (fs::path(from).parent_path() / include.path.text).string();
    const std::string key = normal(path);
    if (std::ranges::find(open_, key) != open_.end()) {
      diagnostics_.error("include-cycle", include.path.place,
                         fmt::format("`{}` includes itself", text::shown(include.path.text)));
      return;
    }
    if (seen_.contains(key)) return;
    if (open_.size() >= kMaxIncludeDepth) {
      diagnostics_.error("include-too-deep", include.path.place,
                         fmt::format("more than {} files include each other", kMaxIncludeDepth));
      return;
    }
    const auto source = reader_.read(path);
    if (!source) {
      text::Diagnostic failure = source.error();
      failure.place = include.path.place;
      diagnostics_.report(std::move(failure));
      return;
    }
    if (files_) files_->push_back(path);
    include.tree = std::make_shared<const Tree>(read(*source));
  }

  text::Diagnostics& diagnostics_;
  std::vector<std::string>* files_;
  const text::Files& reader_;
  std::set<std::string> seen_;
  std::vector<std::string> open_;
};

// The word that a declaration starts with and its place, or empty for what belongs to a network.
struct Declared {
  std::string what;
  text::Place place;
};

Declared declared(const Item& item) {
  if (const auto* procedure = std::get_if<Procedure>(&item)) {
    return {fmt::format("the procedure `{}`", procedure->name.text), procedure->name.place};
  }
  if (const auto* type = std::get_if<TypeDecl>(&item))
    return {fmt::format("the type `{}`", type->name.text), type->name.place};
  if (const auto* module = std::get_if<ModuleDecl>(&item)) {
    return {fmt::format("the module `{}`", module->name.text), module->name.place};
  }
  return {};
}

}  // namespace

Tree load(const text::SourcePtr& source, text::Diagnostics& diagnostics, std::vector<std::string>* files,
          const text::Files& reader) {
  Tree tree = Loader(diagnostics, files, reader).read(source);
  check_order(tree, diagnostics);
  return tree;
}

void check_order(const Tree& tree, text::Diagnostics& diagnostics) {
  const NodeDecl* first = nullptr;
  visit_items(tree, [&](const Item& item) {
    if (const auto* node = std::get_if<NodeDecl>(&item); node && !first) first = node;
    if (!first) return;
    const Declared late = declared(item);
    if (late.what.empty()) return;
    diagnostics
        .error("declaration-after-node", late.place,
               fmt::format("{} is declared behind the first node", late.what))
        .notes.push_back({fmt::format("`{}` is the first node", first->node.name), first->node.place});
  });
}

bool looks_like_cnl(std::string_view text) {
  constexpr std::size_t kEnough = 1 << 16;
  const Lexer lexer(text.substr(0, kEnough));
  std::string_view before;
  for (Token token = lexer.next(0); token.kind != Token::Kind::kEnd; token = lexer.next(token.span.end)) {
    const std::string_view word = text.substr(token.span.begin, token.span.end - token.span.begin);
    const bool is_word = token.kind == Token::Kind::kName;
    if (is_word && (before == "procedure" || before == "nprocedure" || before == "node")) return true;
    if ((before == "type" && word == "<") || (before == "modulename" && word == "=")) return true;
    if (before == "parameter" && is_word) return true;
    if (word == "init" && lexer.starts_line(token.span.begin) &&
        text.find("\niend") != std::string_view::npos)
      return true;
    // Only what may come first is passed over; anything else is another language.
    const bool may_come_first = word == "external" || word == "public" || word == "remote" ||
                                word == "procedure" || word == "nprocedure" || word == "node" ||
                                word == "modulename" || word == "type" || word == "parameter" ||
                                token.kind == Token::Kind::kDirective;
    if (!may_come_first) return false;
    before = word;
  }
  return false;
}

}  // namespace mlab::cnl
