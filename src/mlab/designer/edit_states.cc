// States and transitions.

#include <algorithm>
#include <ranges>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/editor.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

const cdl::State* state_named(const cdl::Sequence& sequence, std::string_view name) {
  const auto found =
      std::ranges::find_if(sequence.states, [&](const cdl::State& state) { return state.name.text == name; });
  return found == sequence.states.end() ? nullptr : &*found;
}

std::string transition_words(const std::string& trigger, const std::string& to, bool restarts) {
  return fmt::format("when {} goto {}{};", trigger, to, restarts ? " restart" : "");
}

}  // namespace

text::Result<const cdl::Sequence*> Editor::sequence(const std::string& path) const {
  const text::Result<PageView> view = page(path);
  if (!view) return std::unexpected(view.error());
  if (view->page->sequence == nullptr) return refusal("this page has no states");
  return view->page->sequence;
}

Done Editor::add_state(const AddState& change) {
  const text::Result<const cdl::Sequence*> all = sequence(change.page());
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
  std::string member = "Stand()";
  if (!change.component().empty()) {
    if (!work_.model().components().find(change.component()))
      return refusal(fmt::format("nothing answers to `{}`", text::shown(change.component())));
    member = change.component() + "()";
  }
  const std::string words = fmt::format("{}{}: {};", states.empty() ? "start " : "", name, member);
  const TokenMap& tokens = work_.tokens();
  if (states.empty()) {
    const text::Result<PageView> view = page(change.page());
    std::size_t open = tokens.at(view->page->root != nullptr ? view->page->root->place.span.begin : 0);
    const GraphPage* here = view->page;
    if (here->root == nullptr) {
      for (const GraphPage& other : view->graph->pages) {
        for (const GraphNode& node : other.nodes) {
          if (node.inner >= 0 && &view->graph->pages[static_cast<std::size_t>(node.inner)] == here)
            open = tokens.at(node.expression->place.span.begin);
        }
      }
    }
    while (open + 1 < tokens.tokens().size() && tokens.word(open) != "{") ++open;
    const text::Span brace = tokens.tokens()[open].span;
    work_.insert(brace.end, "\n" + words + "\n");
  } else {
    work_.insert_statement_behind(states.back().whole.end, words);
  }
  if (const Done done = work_.commit(); !done) return done;
  if (change.x() == 0.0 && change.y() == 0.0) return true;
  Arrange where;
  where.set_page(change.page());
  Arrange::At& at = *where.add_nodes();
  at.set_node(name);
  at.set_x(change.x());
  at.set_y(change.y());
  return arrange(where);
}

Done Editor::set_state(const SetState& change) {
  const text::Result<const cdl::Sequence*> all = sequence(change.page());
  if (!all) return std::unexpected(all.error());
  const cdl::State* state = state_named(**all, change.state());
  if (state == nullptr) return refusal(fmt::format("there is no state `{}`", text::shown(change.state())));
  const auto mark = [&](const cdl::State& one, bool is_start, bool is_final) {
    const std::string words = fmt::format("{}{}", is_start ? "start " : "", is_final ? "final " : "");
    work_.replace({one.whole.begin, one.name.place.span.begin}, words);
  };
  const bool becomes_start = change.has_is_start() ? change.is_start() : state->is_start;
  const bool becomes_final = change.has_is_final() ? change.is_final() : state->is_final;
  if (becomes_start != state->is_start || becomes_final != state->is_final)
    mark(*state, becomes_start, becomes_final);
  if (becomes_start && !state->is_start) {  // there is one of them
    for (const cdl::State& other : (*all)->states) {
      if (&other != state && other.is_start) mark(other, false, other.is_final);
    }
  }
  if (change.has_member()) {
    if (!is_expression(change.member()))
      return refusal(fmt::format("`{}` is no value", text::shown(change.member())));
    work_.replace(state->member->place.span, change.member());
  }
  return work_.commit();
}

Done Editor::add_transition(const AddTransition& change) {
  const text::Result<const cdl::Sequence*> all = sequence(change.page());
  if (!all) return std::unexpected(all.error());
  const cdl::State* from = state_named(**all, change.from());
  const cdl::State* to = state_named(**all, change.to());
  if (from == nullptr || to == nullptr)
    return refusal(
        fmt::format("there is no state `{}`", text::shown(from == nullptr ? change.from() : change.to())));
  // A trigger that is never true, which the checker marks: it is to be filled in.
  const std::string trigger = change.trigger().empty() ? "Constant(value = false)" : change.trigger();
  if (!is_expression(trigger)) return refusal(fmt::format("`{}` is no trigger", text::shown(trigger)));
  work_.insert_statement_behind(from->whole.end, transition_words(trigger, change.to(), false));
  return work_.commit();
}

Done Editor::set_transition(const SetTransition& change) {
  const text::Result<const cdl::Sequence*> all = sequence(change.page());
  if (!all) return std::unexpected(all.error());
  const cdl::State* from = state_named(**all, change.from());
  if (from == nullptr) return refusal(fmt::format("there is no state `{}`", text::shown(change.from())));
  if (change.index() >= from->transitions.size()) return refusal("the transition has gone");
  const cdl::Transition& transition = from->transitions[change.index()];
  if (change.has_trigger()) {
    if (!is_expression(change.trigger()))
      return refusal(fmt::format("`{}` is no trigger", text::shown(change.trigger())));
    const TokenMap& tokens = work_.tokens();
    const std::uint32_t begin = tokens.tokens()[tokens.at(transition.place.span.begin) + 1].span.begin;
    std::size_t go = tokens.at(transition.target.place.span.begin) - 1;
    work_.replace({begin, tokens.tokens()[go - 1].span.end}, change.trigger());
  }
  if (change.has_to() && change.to() != transition.target.text) {
    if (state_named(**all, change.to()) == nullptr)
      return refusal(fmt::format("there is no state `{}`", text::shown(change.to())));
    work_.replace(transition.target.place.span, change.to());
  }
  if (change.has_restarts() && change.restarts() != transition.restarts) {
    if (change.restarts())
      work_.insert(transition.target.place.span.end, " restart");
    else
      work_.erase({transition.target.place.span.end, transition.place.span.end});
  }
  if (const Done done = work_.commit(); !done) return done;
  if (!change.has_new_index() || change.new_index() == change.index()) return true;
  // Another place in the order: the lines change places.
  const text::Result<const cdl::Sequence*> now = sequence(change.page());
  const std::vector<cdl::Transition>& transitions = state_named(**now, change.from())->transitions;
  const std::size_t to = std::min<std::size_t>(change.new_index(), transitions.size() - 1);
  if (to == change.index()) return true;
  const TokenMap& tokens = work_.tokens();
  const auto whole = [&](const cdl::Transition& one) {
    return text::Span{tokens.help_begin(one.place.span.begin), tokens.statement_end(one.place.span.end)};
  };
  const text::Span moved = whole(transitions[change.index()]);
  const std::string words(work_.text().substr(moved.begin, moved.end - moved.begin));
  const Fragment line = words.starts_with("///") ? Fragment(words) : work_.moved(moved);
  const std::size_t behind = to < change.index() ? to : to + 1;
  if (behind == 0)
    work_.insert_statement_behind(
        tokens.statement_end(state_named(**now, change.from())->member->place.span.end), line);
  else
    work_.insert_statement_behind(whole(transitions[behind - 1]).end, line);
  work_.erase_statement(transitions[change.index()].place.span.begin);
  return work_.commit();
}

Done Editor::remove_transition(const RemoveTransition& change) {
  const text::Result<const cdl::Sequence*> all = sequence(change.page());
  if (!all) return std::unexpected(all.error());
  const cdl::State* from = state_named(**all, change.from());
  if (from == nullptr || change.index() >= from->transitions.size())
    return refusal("the transition has gone");
  work_.erase_statement(from->transitions[change.index()].place.span.begin);
  return work_.commit();
}

// The states with their transitions, and those that lead to them.
Done Editor::remove_states(const PageView& view, const Remove& change) {
  const std::set<std::string> gone(change.nodes().begin(), change.nodes().end());
  const cdl::Sequence& all = *view.page->sequence;
  const auto stays = [&](const cdl::State& state) { return !gone.contains(state.name.text); };
  const auto is_start = [](const cdl::State& state) { return state.is_start; };
  const auto first_left = std::ranges::find_if(all.states, stays);
  if (first_left == all.states.end()) return refusal("a sequence has one state at least");
  // Where it began has gone: it begins in the first that stays.
  if (std::ranges::any_of(all.states, is_start) &&
      std::ranges::none_of(all.states | std::views::filter(stays), is_start)) {
    work_.insert(first_left->whole.begin, "start ");
  }
  for (const cdl::State& state : all.states) {
    const bool is_gone = gone.contains(state.name.text);
    for (const cdl::Transition& transition : state.transitions) {
      if (is_gone || gone.contains(transition.target.text))
        work_.erase_statement(transition.place.span.begin);
    }
    if (!is_gone) continue;
    work_.erase_statement(state.whole.begin);
  }
  return work_.commit();
}

}  // namespace mlab::designer
