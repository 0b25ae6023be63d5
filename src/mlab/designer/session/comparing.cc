#include "mlab/designer/session/comparing.h"

#include <map>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/difference/tell.h"

namespace mlab::designer {
namespace {

using difference::Difference;
using difference::Thing;
using difference::What;

constexpr std::uint32_t kFirstGone = 1000;  // index of transitions that have gone

DifferenceKind kind_of(What what) {
  switch (what) {
    case What::kAdded:
      return ADDED;
    case What::kRemoved:
      return REMOVED;
    case What::kRenamed:
      return RENAMED;
    case What::kMoved:
      return MOVED;
    case What::kChanged:
      break;
  }
  return CHANGED;
}

difference::Version version_of(const Model& model) {
  return {model.tree(), model.components().elaboration(), !model.is_readable()};
}

void add_details(const Difference& from, auto& to) {
  for (const difference::Detail& detail : from.details) {
    DifferenceDetail& one = *to.add_details();
    one.set_what(detail.what);
    one.set_before(detail.before);
    one.set_after(detail.after);
  }
}

std::string gone(const std::string& name) {
  return "-" + name;
}

// What stands for it on the page that it is on now; empty: nothing does.
std::string name_on_page(const Difference& one) {
  const bool is_gone = one.what == What::kRemoved;
  const std::string& name = is_gone ? one.name_before : one.name_after;
  switch (one.thing) {
    case Thing::kNode:
    case Thing::kState:
    case Thing::kDeclaration:
      return is_gone ? gone(name) : name;
    case Thing::kTransition:
      return is_gone ? "" : fmt::format("{}/{}", name, one.index_after);
    case Thing::kUse:
    case Thing::kArchitecture:
    case Thing::kParameter:
    case Thing::kSetting:
    case Thing::kDevice:
    case Thing::kChoice:
    case Thing::kResult:
    case Thing::kNote:
      break;
  }
  return "";
}

// They came with their states, and are told by those alone.
void mark_transitions_of_new_states(const Drawing& after, PageDifference& out) {
  std::set<std::string> added;
  for (const PageDifference::Mark& mark : out.marks()) {
    if (mark.kind() == ADDED) added.insert(mark.name());
  }
  for (const Transition& transition : after.transitions()) {
    if (!added.contains(transition.from())) continue;
    PageDifference::Mark& told = *out.add_marks();
    told.set_name(fmt::format("{}/{}", transition.from(), transition.index()));
    told.set_kind(ADDED);
  }
}

/// A page of before, drawn for who looks at the one of now.
class Ghosts {
 public:
  Ghosts(const Drawing& before, const Drawing& after, std::map<std::string, std::string> names)
      : before_(before), after_(after), names_(std::move(names)) {
    for (const Node& node : after.nodes()) now_.insert(node.name());
    for (const State& state : after.states()) now_.insert(state.name());
  }

  void draw(PageDifference& out) const {
    for (const Node& node : before_.nodes()) {
      if (is_there(node.name())) continue;
      Node& ghost = *out.add_nodes();
      ghost = node;
      ghost.set_name(gone(node.name()));
      ghost.clear_inner();
      ghost.clear_live();
    }
    for (const State& state : before_.states()) {
      if (is_there(state.name())) continue;
      State& ghost = *out.add_states();
      ghost = state;
      ghost.set_name(gone(state.name()));
      ghost.clear_inner();
      ghost.clear_calls();
      ghost.clear_live();
    }
    draw_wires(out);
  }

  /// Transitions that have gone, by the state and the index that they had.
  void draw_transitions(const std::set<std::pair<std::string, int>>& which, PageDifference& out) const {
    for (const Transition& transition : before_.transitions()) {
      const bool is_gone = which.contains({transition.from(), static_cast<int>(transition.index())}) ||
                           !is_there(transition.from());
      if (!is_gone) continue;
      Transition& ghost = *out.add_transitions();
      ghost = transition;
      ghost.set_from(called(transition.from()));
      ghost.set_to(called(transition.to()));
      ghost.set_index(kFirstGone + static_cast<std::uint32_t>(out.transitions_size() - 1));
      ghost.clear_conditions();
    }
  }

 private:
  bool is_there(const std::string& name) const {
    const auto found = names_.find(name);
    return found != names_.end() && now_.contains(found->second);
  }
  std::string called(const std::string& name) const {
    if (name.starts_with("$result")) return name;
    return is_there(name) ? names_.at(name) : gone(name);
  }

  // Wires by their two ends; where one is in a list does not matter.
  static std::string key(const std::string& from, const std::string& to, const std::string& port) {
    return from + '\n' + to + '\n' + port;
  }
  void draw_wires(PageDifference& out) const {
    std::map<std::string, int> were;
    for (const Wire& wire : before_.wires()) ++were[key(called(wire.from()), called(wire.to()), wire.port())];
    std::map<std::string, int> are;
    for (const Wire& wire : after_.wires()) {
      const std::string one = key(wire.from(), wire.to(), wire.port());
      if (++are[one] > were[one]) *out.add_added_wires() = wire;
    }
    for (const Wire& wire : before_.wires()) {
      const std::string one = key(called(wire.from()), called(wire.to()), wire.port());
      if (are[one]-- > 0) continue;
      Wire& ghost = *out.add_wires();
      ghost = wire;
      ghost.set_from(called(wire.from()));
      ghost.set_to(called(wire.to()));
      ghost.clear_live();
    }
  }

  const Drawing& before_;
  const Drawing& after_;
  std::map<std::string, std::string> names_;
  std::set<std::string> now_;
};

}  // namespace

void Comparing::set_base(std::shared_ptr<const Model> base) {
  base_ = std::move(base);
  ++number_;
}

void Comparing::set_now(std::shared_ptr<const Model> now) {
  if (now_ == now) return;
  now_ = std::move(now);
  ++number_;
}

const difference::Comparison& Comparing::comparison() const {
  if (compared_ != number_) {
    comparison_ = difference::compare(version_of(*base_), version_of(*now_));
    compared_ = number_;
  }
  return comparison_;
}

Differences Comparing::list() const {
  Differences out;
  out.set_title(title_);
  const auto add = [&](const Difference& one) {
    Differences::Entry& entry = *out.add_entries();
    entry.set_kind(kind_of(one.what));
    entry.set_thing(std::string(difference::word_of(one.thing)));
    entry.set_text(difference::sentence(one));
    entry.set_page(one.page_after);
    entry.set_node(name_on_page(one));
    add_details(one, entry);
  };
  for (const Difference& one : comparison().meaning) add(one);
  for (const Difference& one : comparison().layout) add(one);
  for (std::string& remark : difference::remarks(comparison())) out.add_remarks(std::move(remark));
  if (!now_->is_readable())
    out.set_trouble("the text can't be read right now: this is what could be read before");
  return out;
}

PageDifference Comparing::page(const std::string& path, const DrawingContext& context) const {
  PageDifference out;
  out.mutable_page()->set_document(context.document);
  out.mutable_page()->set_path(path);
  const difference::Comparison& all = comparison();
  std::set<std::pair<std::string, int>> gone_transitions;
  const auto mark = [&](const Difference& one) {
    const bool is_here = one.page_after == path && one.thing != Thing::kResult;
    if (!is_here) return;
    if (one.what == What::kRemoved && one.thing == Thing::kTransition)
      gone_transitions.emplace(one.name_before, one.index_before);
    const std::string name = name_on_page(one);
    if (name.empty() || one.what == What::kRemoved) return;
    PageDifference::Mark& told = *out.add_marks();
    told.set_name(name);
    told.set_kind(kind_of(one.what));
    add_details(one, told);
  };
  for (const Difference& one : all.meaning) mark(one);
  for (const Difference& one : all.layout) mark(one);
  // Where nothing differs, nothing has to be drawn.
  std::string before_path;
  std::map<std::string, std::string> names;
  for (const difference::SamePage& page : all.pages) {
    if (page.after != path) continue;
    before_path = page.before;
    names.insert(page.names.begin(), page.names.end());
  }
  if (path.empty()) names.insert(all.owners.begin(), all.owners.end());
  if (!path.empty() && before_path.empty()) return out;
  const Drawing before = designer::draw(*base_, before_path, context);
  const Drawing after = designer::draw(*now_, path, context);
  mark_transitions_of_new_states(after, out);
  // Parameters and what comes from outside are nodes as well.
  for (const Node& node : before.nodes())
    names.try_emplace(node.name(), node.shape() == Node::PARAMETER ? node.name() : "");
  std::erase_if(names, [](const auto& one) { return one.second.empty(); });
  const Ghosts ghosts(before, after, std::move(names));
  ghosts.draw(out);
  ghosts.draw_transitions(gone_transitions, out);
  return out;
}

}  // namespace mlab::designer
