#include "mlab/designer/trial/marks.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/trial/live_paths.h"

namespace mlab::designer {
namespace {

constexpr int kDeepestWay = 100;

// Of a page's node as a port is called, below the place where the page runs.
std::string path_at(const std::string& place, const GraphPage& page, const std::string& path) {
  if (path == page.base) return place;
  return joined_path(place, page.base.empty() ? path : path.substr(page.base.size() + 1));
}

class WaySearch {
 public:
  WaySearch(const Model& model, const std::string& page, const std::string& place)
      : model_(model), page_(page), place_(place) {}

  bool search(const OwnerGraph& graph, const std::string& path, int depth) {
    if (graph.name == owner_of(page_)) {
      const int at = graph.find_page(page_);
      if (at >= 0 && joined_path(path, graph.pages[static_cast<std::size_t>(at)].base) == place_) return true;
    }
    if (depth > kDeepestWay) return false;
    for (const GraphPage& page : graph.pages) {
      for (const GraphNode& node : page.nodes) {
        const cdl::Assemblage* called = called_by(node);
        const std::string there = joined_path(path, node.path);
        if (called == nullptr || !(place_ == there || place_.starts_with(there + '.'))) continue;
        way.push_back({page.path, node.name, node.path});
        if (search(cdl::model_of(*called, model_.components().elaboration()), there, depth + 1)) return true;
        way.pop_back();
      }
    }
    return false;
  }

  std::vector<Hop> way;

 private:
  const cdl::Assemblage* called_by(const GraphNode& node) const {
    if (node.kind != GraphNode::Kind::kCall || node.expression == nullptr) return nullptr;
    const auto* call = std::get_if<cdl::Call>(&node.expression->what);
    return call == nullptr ? nullptr : model_.configuration().assemblage_named(call->callee);
  }

  const Model& model_;
  const std::string& page_;
  const std::string& place_;
};

const GraphPage* page_of(const Model& model, const std::string& path) {
  const Model::FoundPage found = model.page(path);
  return found.graph == nullptr ? nullptr : &found.graph->pages[static_cast<std::size_t>(found.page)];
}

const GraphNode* node_of(const GraphPage& page, const std::string& name) {
  const int at = page.find(name);
  return at < 0 ? nullptr : &page.nodes[static_cast<std::size_t>(at)];
}

// What is selected on the page to show it; empty: there is no such state or transition.
std::string drawn_id(const GraphPage& page, const std::string& from, const std::string& to) {
  if (page.sequence == nullptr) return "";
  const auto has = [&](const std::string& name) {
    return std::ranges::any_of(page.sequence->states, [&](const auto& s) { return s.name.text == name; });
  };
  if (from.empty() || to.empty()) return has(from.empty() ? to : from) ? from + to : "";
  for (const cdl::State& state : page.sequence->states) {
    if (state.name.text != from) continue;
    for (std::size_t i = 0; i < state.transitions.size(); ++i) {
      if (state.transitions[i].target.text == to) return fmt::format("{}/{}", from, i);
    }
  }
  return "";
}

bool has_trigger(const OwnerGraph& graph, const GraphPage& page, const std::string& live) {
  const std::string path = joined_path(page.base, live);
  return std::ranges::any_of(graph.hidden, [&](const auto& one) { return one.second == path; });
}

// What it is called in the program, by the place in which its page runs.
void set_port(Mark& mark, const GraphPage& page) {
  const GraphNode* node = mark.trigger().empty() ? node_of(page, mark.node()) : nullptr;
  std::string port;
  if (!mark.trigger().empty()) port = joined_path(mark.place(), mark.trigger());
  if (node != nullptr) port = path_at(mark.place(), page, node->path);
  mark.set_port(port);
  if (!mark.has_breakpoint()) return;
  if (mark.breakpoint().has_condition()) {
    mark.mutable_breakpoint()->mutable_condition()->set_port(port);
    return;
  }
  console::Breakpoint::Transition& transition = *mark.mutable_breakpoint()->mutable_transition();
  transition.set_sequence(mark.place());
  transition.set_from(mark.from());
  transition.set_to(mark.to());
}

// Where the page runs now, without the page's own base; nothing: a part of the way has gone.
std::optional<std::string> follow_way(std::vector<Hop>& way, const NameMap& names, const Model& model) {
  std::string place;
  for (Hop& hop : way) {
    if (!hop.page.empty()) {
      const std::optional<std::string> on = names.page(hop.page);
      const std::optional<std::string> called = names.node(hop.page, hop.node);
      const GraphPage* there = on ? page_of(model, *on) : nullptr;
      const GraphNode* node = there && called ? node_of(*there, *called) : nullptr;
      if (node == nullptr) return std::nullopt;
      hop = {*on, *called, node->path};
    }
    place = joined_path(place, hop.path);
  }
  return place;
}

}  // namespace

std::optional<std::vector<Hop>> way_to(const Model& model, std::string_view robot, const std::string& page,
                                       const std::string& place) {
  const auto found = model.configuration().robots.find(robot);
  if (found == model.configuration().robots.end()) return std::nullopt;
  WaySearch search(model, page, place);
  if (!search.search(cdl::model_of(*found->second, model.components().elaboration()), "", 0))
    return std::nullopt;
  return std::move(search.way);
}

std::uint32_t Marks::add(Mark mark, std::shared_ptr<const Model> model, std::optional<std::vector<Hop>> way) {
  follow(model);
  model_ = std::move(model);
  mark.set_id(++last_);
  mark.set_is_lost(false);
  all_.emplace(last_, KeptMark{std::move(mark), std::move(way)});
  return last_;
}

bool Marks::remove(std::uint32_t id) {
  return all_.erase(id) > 0;
}

bool Marks::follow(const std::shared_ptr<const Model>& model) {
  if (!model_ || model == model_ || all_.empty()) return false;
  const NameMap names(std::exchange(model_, model), model);
  bool is_changed = false;
  for (auto& [id, one] : all_) {
    KeptMark after = one;
    const bool is_found = follow(after, names, *model);
    if (!is_found) after = one;
    after.told.set_is_lost(!is_found);
    is_changed = is_changed || after.told.SerializeAsString() != one.told.SerializeAsString();
    one = std::move(after);
  }
  return is_changed;
}

bool Marks::follow(KeptMark& one, const NameMap& names, const Model& model) {
  Mark& mark = one.told;
  const std::string was = mark.page();
  const auto follow_state = [&](const std::string& name, auto set) {
    const std::optional<std::string> now = name.empty() ? name : names.node(was, name);
    if (now) set(*now);
    return now.has_value();
  };
  const std::optional<std::string> is = names.page(was);
  const GraphPage* page = is ? page_of(model, *is) : nullptr;
  if (page == nullptr) return false;
  const std::string state = mark.from();
  const std::string node_before = mark.node();
  const std::string port_before = mark.port();
  if (!follow_state(mark.from(), [&](const std::string& name) { mark.set_from(name); }) ||
      !follow_state(mark.to(), [&](const std::string& name) { mark.set_to(name); }) ||
      !follow_state(mark.node(), [&](const std::string& name) { mark.set_node(name); }))
    return false;
  mark.set_page(*is);
  if (one.way) {
    const std::optional<std::string> place = follow_way(*one.way, names, model);
    if (!place) return false;
    mark.set_place(joined_path(*place, page->base));
  }

  if (!mark.trigger().empty() && mark.trigger().starts_with(state + '.'))
    mark.set_trigger(mark.from() + mark.trigger().substr(state.size()));
  std::string drawn;
  if (!mark.trigger().empty()) {
    drawn = drawn_id(*page, mark.from(), mark.to());
    const OwnerGraph* graph = model.page(*is).graph;
    if (drawn.empty() || graph == nullptr || !has_trigger(*graph, *page, mark.trigger())) return false;
  } else if (!mark.node().empty()) {
    if (node_of(*page, mark.node()) == nullptr) return false;
    drawn = mark.node();
  } else {
    drawn = drawn_id(*page, mark.from(), mark.to());
    if (drawn.empty()) return false;
  }
  set_port(mark, *page);
  const bool is_same = !mark.node().empty() && mark.node() == node_before && mark.port() == port_before;
  if (!is_same || mark.drawn().empty()) mark.set_drawn(drawn);
  return true;
}

bool Marks::move_to(
    const Model& model,
    const std::function<std::optional<Run>(const std::string& page, const std::string& place)>& find) {
  bool is_changed = false;
  for (auto& [id, one] : all_) {
    const GraphPage* page = page_of(model, one.told.page());
    if (one.told.is_lost() || page == nullptr) continue;
    std::optional<Run> run = find(one.told.page(), one.told.place());
    if (!run || (run->place == one.told.place() && one.way)) continue;
    one.told.set_place(run->place);
    one.way = std::move(run->way);
    set_port(one.told, *page);
    is_changed = true;
  }
  return is_changed;
}

void Marks::encode(::mlab::designer::MarkList& out) const {
  for (const auto& [id, one] : all_) *out.add_marks() = one.told;
}

void Marks::encode(KeptMarks& out) const {
  if (model_) out.set_text(std::string(model_->source()->text()));
  for (const auto& [id, one] : all_) {
    KeptMarks::One& kept = *out.add_marks();
    *kept.mutable_mark() = one.told;
    kept.set_has_way(one.way.has_value());
    if (!one.way) continue;
    for (const Hop& hop : *one.way) {
      KeptMarks::Hop& step = *kept.add_way();
      step.set_page(hop.page);
      step.set_node(hop.node);
      step.set_path(hop.path);
    }
  }
}

Marks Marks::restored(const KeptMarks& kept, std::shared_ptr<const Model> model) {
  Marks out;
  out.model_ = std::move(model);
  for (const KeptMarks::One& one : kept.marks()) {
    if (out.all_.size() >= kMost) break;
    std::optional<std::vector<Hop>> way;
    if (one.has_way()) {
      way.emplace();
      for (const KeptMarks::Hop& step : one.way()) way->push_back({step.page(), step.node(), step.path()});
    }
    Mark mark = one.mark();
    mark.set_id(++out.last_);
    if (mark.has_breakpoint()) mark.mutable_breakpoint()->clear_id();
    out.all_.emplace(out.last_, KeptMark{std::move(mark), std::move(way)});
  }
  return out;
}

}  // namespace mlab::designer
