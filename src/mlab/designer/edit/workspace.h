#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/designer/drawing/graph.h"
#include "mlab/designer/drawing/model.h"
#include "mlab/designer/edit/refusal.h"
#include "mlab/designer/edit/spans.h"
#include "mlab/lang/cdl/print/changes.h"

namespace mlab::designer {

/// A node of a page, by what it is made of: it is found again after the text has changed.
using Anchor = std::uint32_t;

/// A text in the middle of an edit. Changes of its tree are gathered and done by `commit`, which prints what
/// is new, reads the text anew, and takes the layout blocks along. Nothing of an edit that fails is kept: who
/// makes the workspace throws it away.
class Workspace {
 public:
  Workspace(std::shared_ptr<const Model> model, const cdl::Environment& environment);

  const Model& model() const { return *model_; }
  std::string_view text() const { return model_->text(); }
  const TokenMap& tokens() const { return *tokens_; }

  /// What becomes of parts of the model's own tree with the next commit.
  cdl::Changes& changes() { return *changes_; }
  /// A declaration more: behind the others, before the layout blocks, which are the end of the file.
  void add(cdl::Item item);

  /// @errors  where the text could not be read afterwards
  Done commit();

  // ---- nodes that are followed through commits

  /// A handle of a byte: of a node's anchor.
  int follow(std::uint32_t byte);
  /// Where it stands now; nothing where it has gone.
  std::optional<std::uint32_t> where(int handle) const;

 private:
  /// What the names in a layout block stand for.
  struct Named {
    std::optional<Anchor> page;
    std::map<std::string, Anchor> nodes;
  };
  std::map<std::string, Named> named_by_layouts() const;
  void mend_layouts(const std::map<std::string, Named>& before, const cdl::Reprinted& went);
  void mend_layout(const cdl::Layout& layout, const Named& before, const cdl::Reprinted& went);
  std::optional<std::string> page_at(Anchor anchor) const;
  /// Does the changes. @return where words went
  cdl::Reprinted reprint();
  Done readable() const;

  std::shared_ptr<const Model> model_;
  const cdl::Environment& environment_;
  std::unique_ptr<TokenMap> tokens_;
  std::unique_ptr<cdl::Changes> changes_;
  std::vector<std::optional<std::uint32_t>> followed_;
  int commits_ = 0;
};

/// The byte by which a node is followed; nothing where it stands nowhere.
std::optional<Anchor> anchor_of(const GraphNode& node, const TokenMap& tokens);
/// A page by what it belongs to: a declaration or a state, and its sequence, which may become a page
/// elsewhere.
struct PageAnchor {
  std::string path;
  Anchor owner = 0;
  std::optional<Anchor> sequence;
};
/// @param owner  of the pages; empty: all
std::vector<PageAnchor> page_anchors(const Model& model, const TokenMap& tokens, std::string_view owner = "");
/// Every name that a layout block may have for a page, with what it stands for.
std::map<std::string, Anchor> anchors_of(const Model& model, std::string_view page, const TokenMap& tokens);

}  // namespace mlab::designer
