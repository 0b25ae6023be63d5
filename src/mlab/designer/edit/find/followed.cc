#include "mlab/designer/edit/find/followed.h"

namespace mlab::designer {

int follow(Workspace& work, const PageView& view, int node) {
  const std::optional<Anchor> anchor = anchor_of(view.node(node), work.tokens());
  return anchor ? work.follow(*anchor) : -1;
}

std::optional<std::pair<PageView, int>> followed(const Workspace& work, const std::string& owner,
                                                 int handle) {
  const std::optional<std::uint32_t> anchor = handle < 0 ? std::nullopt : work.where(handle);
  const OwnerGraph* graph = work.model().graph(owner);
  if (!anchor || graph == nullptr) return std::nullopt;
  for (const GraphPage& page : graph->pages) {
    for (std::size_t i = 0; i < page.nodes.size(); ++i) {
      if (page.nodes[i].kind == GraphNode::Kind::kOuter || page.nodes[i].parameter != nullptr) continue;
      if (anchor_of(page.nodes[i], work.tokens()) == anchor)
        return std::pair(PageView{graph, &page}, static_cast<int>(i));
    }
  }
  return std::nullopt;
}

}  // namespace mlab::designer
