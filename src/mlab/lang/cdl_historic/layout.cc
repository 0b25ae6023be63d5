#include "mlab/lang/cdl_historic/layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mlab::cdl_historic {
namespace {

constexpr double kScale = 1.0;  // canvas units per pixel

std::vector<std::size_t> order_by(const std::vector<Node>& nodes, double Node::* coordinate) {
  std::vector<std::size_t> order(nodes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return nodes[i].*coordinate; });
  return order;
}

// Nodes of one row are moved right until they stand side by side.
std::vector<double> spread_columns(const std::vector<Node>& nodes) {
  std::vector<double> out(nodes.size());
  const std::vector<std::size_t> order = order_by(nodes, &Node::x);
  double last = 0.0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Node& node = nodes[order[k]];
    double at = k == 0 ? node.x * kScale : last + (node.x - nodes[order[k - 1]].x) * kScale;
    for (std::size_t j = 0; j < k; ++j) {
      const Node& other = nodes[order[j]];
      if (other.y == node.y && other.x < node.x) at = std::max(at, out[order[j]] + kNodeWidth);
    }
    out[order[k]] = last = at;
  }
  return out;
}

// Then whatever still overlaps is moved down.
std::vector<double> spread_rows(const std::vector<Node>& nodes, const std::vector<double>& columns) {
  std::vector<double> out(nodes.size());
  const std::vector<std::size_t> order = order_by(nodes, &Node::y);
  double last = 0.0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::size_t i = order[k];
    double at = k == 0 ? nodes[i].y * kScale : last + (nodes[i].y - nodes[order[k - 1]].y) * kScale;
    for (std::size_t j = 0; j < k; ++j) {
      const bool is_beside = std::abs(columns[order[j]] - columns[i]) >= kNodeWidth;
      if (!is_beside) at = std::max(at, out[order[j]] + kNodeHeight);
    }
    out[i] = last = at;
  }
  return out;
}

}  // namespace

cdl::Layout laid_out(const Drawing& drawing) {
  cdl::Layout out;
  out.owner.text = drawing.owner;
  const std::vector<double> x = spread_columns(drawing.nodes);
  const std::vector<double> y = spread_rows(drawing.nodes, x);
  for (std::size_t i = 0; i < drawing.nodes.size(); ++i) {
    cdl::LayoutEntry entry;
    entry.node.text = drawing.nodes[i].name;
    entry.x = std::round(x[i]);
    entry.y = std::round(y[i]);
    out.entries.push_back(std::move(entry));
  }
  return out;
}

}  // namespace mlab::cdl_historic
