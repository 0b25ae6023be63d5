#include "mlab/designer/edit/change/states.h"

#include <algorithm>
#include <ranges>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/edit/change/layout.h"
#include "mlab/designer/edit/find/sequences.h"
#include "mlab/designer/edit/values.h"
#include "mlab/text/shown.h"

namespace mlab::designer {

// ---- states

Done add_state(Workspace& work, const AddState& change) {
  const text::Result<const cdl::Sequence*> all = find_sequence(work.model(), change.page());
  if (!all) return std::unexpected(all.error());
  const std::vector<cdl::State>& states = (*all)->states;
  std::set<std::string> taken;
  for (const cdl::State& state : states) taken.insert(state.name.text);
  std::string name = change.name();
  if (name.empty()) {
    name = "State";
    for (int number = 2; taken.contains(name); ++number) name = fmt::format("State_{}", number);
  }
  if (!is_cdl_name(name)) return refusal(fmt::format("`{}` is no name", text::shown(name)));
  if (taken.contains(name)) return refusal(fmt::format("there is a state `{}` already", name));
  if (!change.component().empty() && !work.model().components().find(change.component()))
    return refusal(fmt::format("nothing answers to `{}`", text::shown(change.component())));
  cdl::State state;
  state.name.text = name;
  state.is_start = states.empty();
  state.member = called(change.component().empty() ? "Stand" : change.component());
  work.changes().change<cdl::Sequence>(**all, [state](cdl::Sequence& now) { now.states.push_back(state); });
  if (const Done done = work.commit(); !done) return done;
  return arrange_one(work, change.page(), name, change);
}

Done set_state(Workspace& work, const SetState& change) {
  const text::Result<const cdl::Sequence*> all = find_sequence(work.model(), change.page());
  if (!all) return std::unexpected(all.error());
  const cdl::State* state = state_named(**all, change.state());
  if (state == nullptr) return refusal(fmt::format("there is no state `{}`", text::shown(change.state())));
  const bool becomes_start = change.has_is_start() ? change.is_start() : state->is_start;
  const bool becomes_final = change.has_is_final() ? change.is_final() : state->is_final;
  const cdl::ExpressionPtr member = change.has_member() ? typed_value(change.member()) : state->member;
  if (!member) return refusal(fmt::format("`{}` is no value", text::shown(change.member())));
  work.changes().change<cdl::State>(*state, [=](cdl::State& now) {
    now.is_start = becomes_start;
    now.is_final = becomes_final;
    now.member = member;
  });
  for (const cdl::State& other : (*all)->states) {  // there is one start
    if (&other != state && other.is_start && becomes_start && !state->is_start)
      work.changes().change<cdl::State>(other, [](cdl::State& now) { now.is_start = false; });
  }
  return work.commit();
}

Done remove_states(Workspace& work, const cdl::Sequence& all, const std::set<std::string>& gone) {
  const auto stays = [&](const cdl::State& state) { return !gone.contains(state.name.text); };
  const auto is_start = [](const cdl::State& state) { return state.is_start; };
  const auto first_left = std::ranges::find_if(all.states, stays);
  if (first_left == all.states.end()) return refusal("a sequence has one state at least");
  // Where it began has gone: it begins in the first that stays.
  if (std::ranges::any_of(all.states, is_start) &&
      std::ranges::none_of(all.states | std::views::filter(stays), is_start)) {
    work.changes().change<cdl::State>(*first_left, [](cdl::State& now) { now.is_start = true; });
  }
  for (const cdl::State& state : all.states) {
    const bool is_gone = gone.contains(state.name.text);
    for (const cdl::Transition& transition : state.transitions) {
      if (gone.contains(transition.target.text)) work.changes().remove(transition);
    }
    if (is_gone) work.changes().remove(state);
  }
  return work.commit();
}

// ---- transitions

Done add_transition(Workspace& work, const AddTransition& change) {
  const text::Result<const cdl::Sequence*> all = find_sequence(work.model(), change.page());
  if (!all) return std::unexpected(all.error());
  const cdl::State* from = state_named(**all, change.from());
  const cdl::State* to = state_named(**all, change.to());
  if (from == nullptr || to == nullptr)
    return refusal(
        fmt::format("there is no state `{}`", text::shown(from == nullptr ? change.from() : change.to())));
  // A trigger that is never true, which the checker marks: it is to be filled in.
  cdl::Transition transition;
  transition.trigger = change.trigger().empty() ? no_trigger() : typed_value(change.trigger());
  if (!transition.trigger) return refusal(fmt::format("`{}` is no trigger", text::shown(change.trigger())));
  transition.target.text = change.to();
  work.changes().change<cdl::State>(*from,
                                    [transition](cdl::State& now) { now.transitions.push_back(transition); });
  return work.commit();
}

Done set_transition(Workspace& work, const SetTransition& change) {
  const text::Result<const cdl::Transition*> found =
      find_transition(work.model(), change.page(), change.from(), change.index());
  if (!found) return std::unexpected(found.error());
  const cdl::Transition& old = **found;
  const text::Result<const cdl::Sequence*> all = find_sequence(work.model(), change.page());
  const cdl::State* from = state_named(**all, change.from());
  const cdl::ExpressionPtr trigger = change.has_trigger() ? typed_value(change.trigger()) : old.trigger;
  if (!trigger) return refusal(fmt::format("`{}` is no trigger", text::shown(change.trigger())));
  if (change.has_to() && change.to() != old.target.text && state_named(**all, change.to()) == nullptr)
    return refusal(fmt::format("there is no state `{}`", text::shown(change.to())));
  const std::string to = change.has_to() ? change.to() : old.target.text;
  const bool restarts = change.has_restarts() ? change.restarts() : old.restarts;
  work.changes().change<cdl::Transition>(old, [=](cdl::Transition& now) {
    now.trigger = trigger;
    now.target.text = to;
    now.restarts = restarts;
  });
  if (change.has_new_index()) {
    work.changes().change<cdl::State>(
        *from, [from_index = change.index(), index = change.new_index()](cdl::State& now) {
          const std::size_t last = std::min<std::size_t>(index, now.transitions.size() - 1);
          const cdl::Transition moved = now.transitions[from_index];
          now.transitions.erase(now.transitions.begin() + from_index);
          now.transitions.insert(now.transitions.begin() + static_cast<std::ptrdiff_t>(last), moved);
        });
  }
  return work.commit();
}

Done remove_transition(Workspace& work, const RemoveTransition& change) {
  const text::Result<const cdl::Transition*> gone =
      find_transition(work.model(), change.page(), change.from(), change.index());
  if (!gone) return std::unexpected(gone.error());
  work.changes().remove(**gone);
  return work.commit();
}

}  // namespace mlab::designer
