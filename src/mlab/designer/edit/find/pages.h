#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/designer/drawing/graph.h"
#include "mlab/designer/drawing/model.h"
#include "mlab/text/diagnostic.h"

// Pages, nodes and inputs that a change speaks of. All of it only reads; what is found points into the model,
// and is gone with the next commit.

namespace mlab::designer {

/// A page of a model.
struct PageView {
  const OwnerGraph* graph = nullptr;
  const GraphPage* page = nullptr;

  const GraphNode& node(int at) const { return page->nodes[static_cast<std::size_t>(at)]; }
  const std::vector<cdl::Let>& lets() const { return graph->lets(); }
  /// What a node gives.
  cdl::PortType type_of(int at) const { return graph->type_of(node(at)); }
};

/// An input that a change speaks of: of a node, or what the page gives.
struct Spot {
  PageView view;
  int node = -1;  ///< -1: what the page gives
  int input = -1;
  std::string drive;  ///< an actuator that nothing drives yet

  bool is_result() const { return node < 0 && drive.empty(); }
  const GraphInput* at() const {
    return node < 0 ? nullptr : &view.node(node).inputs[static_cast<std::size_t>(input)];
  }
  /// The expression that stands there; null: nothing.
  const cdl::Expression* written() const;
  /// The node that drives it and is written there; -1: none.
  int inline_node() const;
  /// Whether a node is written there that would be lost.
  bool is_kept() const { return inline_node() >= 0 && view.page->asks == nullptr; }
};

/// @errors  `cannot-edit`: nothing is called so, or it has no nodes
text::Result<PageView> find_page(const Model& model, const std::string& path);
/// @errors  `cannot-edit`: the page has no such node
text::Result<int> find_node(const PageView& view, const std::string& name);
/// @param node     `$result`: what the page gives; `$NAME`: an actuator
/// @param for_new  an open place of a list is meant where no index is said
/// @errors         `cannot-edit`: the page has no such node, or the node no such input
text::Result<Spot> find_spot(const PageView& view, const std::string& node, const std::string& port,
                             std::optional<std::uint32_t> index, bool for_new);

/// What may be connected there; without a type: anything.
cdl::PortType wanted_type(const Model& model, const Spot& spot);
/// Whether a value of `to` goes, directly or not, into `from` without a delay: a wire from `from` to `to`
/// would close a loop.
bool reaches(const PageView& view, int from, int to);
/// An input that a name drives, or a page that it gives; nothing where nobody reads it.
std::optional<Spot> reader_of(const OwnerGraph& graph, std::string_view name);

}  // namespace mlab::designer
