#include "mlab/designer/trial/live_paths.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>

namespace mlab::designer {
namespace {

constexpr int kDeepestCall = 100;
constexpr std::size_t kMostInstances = 20'000;

/// Walks down from a robot. A level is made once, however often it runs.
class InstanceVisit {
 public:
  using Show = std::function<void(const OwnerGraph& graph, const std::string& path)>;
  InstanceVisit(const Model& model, const Show& show) : model_(model), show_(show) {}

  void visit(const OwnerGraph& graph, const std::string& path, int depth) {
    if (depth > kDeepestCall || ++count_ > kMostInstances) return;
    show_(graph, path);
    std::set<std::string> seen;  // a node can be drawn on several pages
    for (const GraphPage& page : graph.pages) {
      for (const GraphNode& node : page.nodes) {
        if (node.kind != GraphNode::Kind::kCall || node.expression == nullptr) continue;
        const auto* call = std::get_if<cdl::Call>(&node.expression->what);
        const cdl::Assemblage* called =
            call == nullptr ? nullptr : model_.configuration().assemblage_named(call->callee);
        if (called != nullptr && seen.insert(node.path).second)
          visit(graph_of_called(*called), joined_path(path, node.path), depth + 1);
      }
    }
  }

 private:
  const OwnerGraph& graph_of_called(const cdl::Assemblage& assemblage) {
    std::unique_ptr<OwnerGraph>& known = graphs_[&assemblage];
    if (!known)
      known = std::make_unique<OwnerGraph>(cdl::model_of(assemblage, model_.components().elaboration()));
    return *known;
  }

  const Model& model_;
  const Show& show_;
  std::map<const cdl::Assemblage*, std::unique_ptr<OwnerGraph>> graphs_;
  std::size_t count_ = 0;
};

std::string_view declaring_source(const OwnerGraph& graph) {
  const text::Place& place =
      graph.assemblage != nullptr ? graph.assemblage->name.place : graph.robot->name.place;
  return place.source ? std::string_view(place.source->name()) : std::string_view();
}

using ShowInstance = std::function<void(const OwnerGraph& graph, const std::string& path)>;

void visit_instances_of(const Model& model, const cdl::Robot& robot, const ShowInstance& show) {
  const OwnerGraph graph = cdl::model_of(robot, model.components().elaboration());
  InstanceVisit(model, show).visit(graph, "", 0);
}

}  // namespace

void visit_instances(const Model& model, std::string_view robot, const ShowInstance& show) {
  const auto found = model.configuration().robots.find(robot);
  if (found != model.configuration().robots.end()) visit_instances_of(model, *found->second, show);
}

std::vector<std::string> live_paths(const Model& model, std::string_view robot, std::string_view source,
                                    std::string_view page) {
  const auto found = model.configuration().robots.find(robot);
  if (found == model.configuration().robots.end()) return {};
  return live_paths(model, *found->second, source, page);
}

std::vector<std::string> live_paths(const Model& model, const cdl::Robot& robot, std::string_view source,
                                    std::string_view page) {
  std::vector<std::string> out;
  visit_instances_of(model, robot, [&](const OwnerGraph& graph, const std::string& path) {
    if (graph.name != owner_of(page) || declaring_source(graph) != source) return;
    const int at = graph.find_page(page);
    if (at < 0) return;
    std::string there = joined_path(path, graph.pages[static_cast<std::size_t>(at)].base);
    if (std::ranges::find(out, there) == out.end()) out.push_back(std::move(there));
  });
  return out;
}

}  // namespace mlab::designer
