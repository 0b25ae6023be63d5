#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/designer/graph.h"
#include "mlab/designer/model.h"
#include "mlab/designer/spans.h"
#include "mlab/text/diagnostic.h"

namespace mlab::designer {

/// A change that can't be done: why, as a sentence for a person.
inline std::unexpected<text::Diagnostic> refusal(std::string message) {
  return std::unexpected(
      text::Diagnostic{text::Severity::kError, "cannot-edit", std::move(message), {}, {}, {}, {}});
}
using Done = text::Result<bool>;

/// New text, some of which stood elsewhere before: so that it is known where the nodes in it went.
struct Fragment {
  struct Piece {
    std::string text;
    std::optional<std::uint32_t> origin;  ///< where it stood
  };
  std::vector<Piece> pieces;

  Fragment() = default;
  Fragment(std::string text) {
    pieces.push_back({std::move(text), std::nullopt});
  }  // NOLINT(google-explicit-constructor)
  Fragment(const char* text) : Fragment(std::string(text)) {}  // NOLINT(google-explicit-constructor)
  Fragment& add(const Fragment& other) {
    pieces.insert(pieces.end(), other.pieces.begin(), other.pieces.end());
    return *this;
  }
  std::string text() const;
};

/// A node of a page, by what it is made of: it is found again after the text has changed.
using Anchor = std::uint32_t;

/// A text in the middle of an edit. Splices are gathered and done by `commit`, which lays out the changed
/// lines, reads the text anew, and takes the layout block along. Nothing of an edit that fails is kept: who
/// makes the workspace throws it away.
class Workspace {
 public:
  Workspace(std::shared_ptr<const Model> model, const cdl::Environment& environment);

  const Model& model() const { return *model_; }
  std::string_view text() const { return model_->text(); }
  const TokenMap& tokens() const { return *tokens_; }

  // ---- splices of the text as it stands

  void replace(text::Span span, Fragment by);
  /// The same, with the comments in it.
  void replace_all(text::Span span, Fragment by) { splices_.push_back({span, std::move(by), false, false}); }
  void insert(std::uint32_t at, Fragment what);
  /// Takes it away; comments in it stay. A line that is empty then goes too.
  void erase(text::Span span);
  /// A statement with its line, and with the `///` above it.
  void erase_statement(std::uint32_t begin);
  /// A statement on a line of its own behind one that ends at a byte.
  void insert_statement_behind(std::uint32_t end, const Fragment& what);
  /// The words of the text. Lines that were only broken because they were long are not broken in it.
  Fragment moved(text::Span span) const;
  /// Another word in place of one, which means the same.
  void rename(text::Span word, const std::string& by);

  /// @errors  where the text could not be read afterwards
  Done commit();

  // ---- nodes that are followed through commits

  /// A handle of a byte: of a node's anchor.
  int follow(std::uint32_t byte);
  /// Where it stands now; nothing where it has gone.
  std::optional<std::uint32_t> where(int handle) const;

 private:
  struct Splice {
    text::Span span;
    Fragment by;
    bool keeps_comments = false;
    bool is_statement = false;  ///< on a line of its own
  };
  struct Segment {
    std::uint32_t from = 0;  // old
    std::uint32_t to = 0;    // new
    std::uint32_t size = 0;
  };
  std::string spliced(std::vector<Segment>& segments);
  std::string laid_out(const std::string& changed, const std::vector<text::Span>& touched,
                       std::vector<std::uint32_t>& moved_tokens) const;
  void set_text(std::string text);

  std::shared_ptr<const Model> model_;
  const cdl::Environment& environment_;
  std::unique_ptr<TokenMap> tokens_;
  std::vector<Splice> splices_;
  std::vector<std::optional<std::uint32_t>> followed_;
  bool is_formatted_ = false;
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
std::vector<PageAnchor> page_anchors(const Model& model, const TokenMap& tokens);
/// Every name that a layout block may have for a page, with what it stands for.
std::map<std::string, Anchor> anchors_of(const Model& model, std::string_view page, const TokenMap& tokens);

}  // namespace mlab::designer
