#include "mlab/lang/cdl/lower/static_check.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/lang/cdl/syntax/walk.h"
#include "mlab/text/shown.h"

namespace mlab::cdl {
namespace {

constexpr std::size_t kShownOfPath = 200;

std::set<std::string> names_used(const Expression& expression) {
  std::set<std::string> out;
  for_each_expression(expression, [&](const Expression& one) {
    if (const auto* name = std::get_if<Name>(&one.what)) out.insert(name->name.text);
  });
  return out;
}

// The word that an operator starts with, rather than all of it.
text::Place first_word(const text::Place& place, std::size_t size) {
  text::Place out = place;
  out.span.end = std::min(out.span.end, out.span.begin + static_cast<std::uint32_t>(size));
  return out;
}

std::set<std::string> reached_states(const Sequence& sequence) {
  std::set<std::string> reached;
  std::vector<std::string> waiting;
  for (const State& state : sequence.states) {
    if (state.is_start) waiting.push_back(state.name.text);
  }
  std::map<std::string, const State*> states;
  for (const State& state : sequence.states) states.try_emplace(state.name.text, &state);
  while (!waiting.empty()) {
    const std::string name = std::move(waiting.back());
    waiting.pop_back();
    const auto state = states.find(name);
    if (state == states.end() || !reached.insert(name).second) continue;
    for (const Transition& transition : state->second->transitions) waiting.push_back(transition.target.text);
  }
  return reached;
}

// Of all robots and societies that it consists of.
void add_names(const SocietyMember& member, std::vector<const Word*>& out) {
  if (member.kind != SocietyMember::Kind::kCaste) out.push_back(&member.name);
  for (const SocietyMember& one : member.members) add_names(one, out);
}

bool leaves(const State& state) {
  return std::ranges::any_of(state.transitions,
                             [&](const Transition& one) { return one.target.text != state.name.text; });
}

}  // namespace

void StaticCheck::check_names(const std::vector<Parameter>& parameters, const std::vector<Let>& lets) {
  std::map<std::string, text::Place> first;
  const auto add = [&](const Word& name) {
    const auto [it, is_new] = first.try_emplace(name.text, name.place);
    if (is_new) return;
    sink_.error("duplicate-name", name.place, fmt::format("`{}` is declared twice", name.text))
        .notes.push_back({"the first is here", it->second});
  };
  for (const Parameter& parameter : parameters) add(parameter.name);
  for (const Let& let : lets) add(let.name);
}

void StaticCheck::sequence_errors(const Expression& expression) {
  for_each_expression(expression, [&](const Expression& one) {
    if (const auto* sequence = std::get_if<Sequence>(&one.what)) sequence_errors(*sequence, one.place);
  });
}

void StaticCheck::sequence_errors(const Sequence& sequence, const text::Place& place) {
  std::vector<std::string> names;
  std::map<std::string, text::Place> first;
  const State* start = nullptr;
  for (const State& state : sequence.states) {
    const auto [it, is_new] = first.try_emplace(state.name.text, state.name.place);
    if (!is_new) {
      sink_
          .error("duplicate-state", state.name.place,
                 fmt::format("state `{}` is declared twice", state.name.text))
          .notes.push_back({"the first is here", it->second});
    }
    if (is_new) names.push_back(state.name.text);
    if (!state.is_start) continue;
    if (start != nullptr) {
      sink_
          .error("two-start-states", state.name.place,
                 fmt::format("a second start state `{}`", state.name.text))
          .notes.push_back({"the first is here", start->name.place});
    }
    start = start == nullptr ? &state : start;
  }
  if (start == nullptr && !sequence.states.empty()) {
    sink_.error("no-start-state", first_word(place, 8), "this sequence has no start state").hints = {
        fmt::format("write `start {}: ...`, or `start` before another of its states", names.front())};
  }
  std::set<std::string> said;
  for (const State& state : sequence.states) {
    for (const Transition& transition : state.transitions) {
      const std::string& target = transition.target.text;
      if (first.contains(target) || !said.insert(target).second) continue;
      text::Diagnostic& d = sink_.error("unknown-state", transition.target.place,
                                        fmt::format("there is no state `{}`", target));
      const std::string nearest = text::nearest_name(target, names);
      d.hints.push_back(nearest.empty() ? fmt::format("its states are {}", fmt::join(names, ", "))
                                        : fmt::format("did you mean `{}`?", nearest));
    }
  }
}

void StaticCheck::sequence_warnings(const Expression& expression) {
  for_each_expression(expression, [&](const Expression& one) {
    if (const auto* sequence = std::get_if<Sequence>(&one.what)) sequence_warnings(*sequence);
  });
}

void StaticCheck::sequence_warnings(const Sequence& sequence) {
  const std::set<std::string> reached = reached_states(sequence);
  for (const State& state : sequence.states) {
    if (!reached.contains(state.name.text)) {
      text::Diagnostic& d = sink_.warning("unreachable-state", state.name.place,
                                          fmt::format("no way leads to state `{}`", state.name.text));
      d.label = "what it does is never done";
    } else if (!leaves(state) && !state.is_final) {
      text::Diagnostic& d = sink_.warning("no-way-out", state.name.place,
                                          fmt::format("no transition leaves state `{}`", state.name.text));
      d.label = "once in it, the robot stays in it";
      d.hints.push_back(fmt::format("write `final {}: ...` if that is meant", state.name.text));
    }
    transition_warnings(state);
  }
}

namespace {

// Somebody who writes that a state is left at once means it: `FirstTime` and `Immediate` of historic files
// are written so.
bool says_at_once(const Expression& trigger) {
  if (const auto* name = std::get_if<Name>(&trigger.what)) return name->name.text == "true";
  const auto* call = std::get_if<Call>(&trigger.what);
  return call != nullptr && call->arguments.empty() &&
         (call->callee.text == "Constant" || call->callee.text == "Immediate" ||
          call->callee.text == "FIRST_TIME");
}

}  // namespace

void StaticCheck::transition_warnings(const State& state) {
  using Constant = TriggerLogic::Constant;
  const std::vector<TriggerLogic::Verdict> verdicts = logic_.judge(state, *parameters_, *lets_);
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    const TriggerLogic::Verdict& verdict = verdicts[i];
    const text::Place& place = state.transitions[i].trigger->place;
    const bool is_constant = verdict.constant != Constant::kNo;
    if (verdict.is_hidden && (verdict.is_same || !is_constant)) {
      text::Diagnostic& d =
          verdict.is_same
              ? sink_.warning("same-trigger", place, "two transitions of this state have the same trigger")
              : sink_.warning("hidden-transition", place,
                              "whenever this trigger is true, one above it is true as well");
      d.label = verdict.hidden_by ? "never made: the one above is made first"
                                  : "never made: one of those above is made first";
      const std::size_t other = verdict.hidden_by.value_or(0);
      d.notes.push_back({verdict.hidden_by ? "the other is here" : "the first of them is here",
                         state.transitions[other].trigger->place});
      continue;
    }
    const Constant value = verdict.constant;
    if (value == Constant::kNo || says_at_once(*state.transitions[i].trigger)) continue;
    text::Diagnostic& d = sink_.warning("constant-trigger", place,
                                        value == Constant::kTrue    ? "this trigger is always true"
                                        : value == Constant::kFalse ? "this trigger is never true"
                                                                    : "this trigger never changes");
    d.label = value == Constant::kTrue    ? i == 0 ? "the state is left as soon as it is entered"
                                                   : "the state is left in its first cycle"
              : value == Constant::kFalse ? "the transition is never made"
                                          : "the transition is made at once, or never";
  }
}

void StaticCheck::errors_of(const Assemblage& assemblage) {
  check_names(assemblage.parameters, assemblage.lets);
  if (assemblage.body) sequence_errors(*assemblage.body);
  for (const Let& let : assemblage.lets) sequence_errors(*let.value);
}

void StaticCheck::errors_of(const Robot& robot) {
  check_names(robot.parameters, robot.lets);
  for (const Let& let : robot.lets) sequence_errors(*let.value);
  for (const Drive& drive : robot.drives) sequence_errors(*drive.value);
}

void StaticCheck::errors_of(const RobotClass& robot_class) {
  check_names(robot_class.parameters, {});
  std::map<std::string, text::Place> first;
  for (const Device& device : robot_class.devices) {
    const auto [it, is_new] = first.try_emplace(device.name.text, device.name.place);
    if (is_new) continue;
    sink_
        .error("duplicate-name", device.name.place,
               fmt::format("device `{}` is declared twice", device.name.text))
        .notes.push_back({"the first is here", it->second});
  }
}

void StaticCheck::check_member(const SocietyMember& member) {
  const auto refuse = [&](const char* kind, const char* what, const Word& name,
                          const std::vector<std::string>& names) {
    text::Diagnostic& d = sink_.error(kind, name.place, fmt::format("unknown {} `{}`", what, name.text));
    const std::string nearest = text::nearest_name(name.text, names);
    if (!nearest.empty()) d.hints.push_back(fmt::format("did you mean `{}`?", nearest));
  };
  if (!member.by.text.empty() && !configuration_.operators.contains(member.by.text))
    refuse("unknown-operator", "operator", member.by, names_in(configuration_.operators));
  for (const SocietyMember& one : member.members) check_member(one);
  if (member.kind == SocietyMember::Kind::kCaste) return;
  if (configuration_.robots.contains(member.name.text) || configuration_.societies.contains(member.name.text))
    return;
  std::vector<std::string> names = names_in(configuration_.robots);
  for (const std::string& name : names_in(configuration_.societies)) names.push_back(name);
  refuse("unknown-robot", "robot", member.name, names);
}

// Goes down by itself: whoever wrote the file says how deep.
void StaticCheck::check_circle(const Society& society) {
  struct Entered {
    const Society* society;
    std::vector<const Word*> members;
    std::size_t next = 0;
  };
  std::vector<Entered> open;
  const auto enter = [&](const Society& one) {
    open.push_back({&one, {}});
    add_names(one.what, open.back().members);
  };
  if (!without_circle_.contains(&society)) enter(society);
  while (!open.empty()) {
    Entered& here = open.back();
    if (here.next == here.members.size()) {
      without_circle_.insert(here.society);
      open.pop_back();
      continue;
    }
    const Word& name = *here.members[here.next++];
    const auto found = configuration_.societies.find(name.text);
    const bool is_robot = configuration_.robots.contains(name.text);
    if (is_robot || found == configuration_.societies.end() || without_circle_.contains(found->second))
      continue;
    const auto first = std::ranges::find(open, found->second, &Entered::society);
    if (first != open.end()) {
      std::string path;
      for (auto it = first; it != open.end(); ++it) path += it->society->name.text + " -> ";
      sink_.error(
          "recursive-society", name.place,
          fmt::format("societies contain each other: {}{}", text::shown(path, kShownOfPath), name.text));
    } else if (open.size() == kMaxSocietyDepth) {
      sink_.error("nested-too-deep", name.place,
                  fmt::format("societies stand more than {} deep in each other", kMaxSocietyDepth));
      for (const Entered& one : open) without_circle_.insert(one.society);
      return;
    } else {
      enter(*found->second);
    }
  }
}

void StaticCheck::errors_of(const Society& society) {
  check_member(society.what);
  check_circle(society);
}

void StaticCheck::warn_unused(const std::vector<Parameter>& parameters, const std::vector<Let>& lets,
                              const std::set<std::string>& used) {
  for (const Parameter& parameter : parameters) {
    if (used.contains(parameter.name.text)) continue;
    sink_
        .warning("unused-parameter", parameter.name.place,
                 fmt::format("parameter `{}` is never used", parameter.name.text))
        .label = "setting it changes nothing";
  }
  for (const Let& let : lets) {
    if (used.contains(let.name.text)) continue;
    sink_.warning("unused-let", let.name.place, fmt::format("`{}` is never used", let.name.text)).label =
        "it is never evaluated";
  }
}

void StaticCheck::warnings_of(const Assemblage& assemblage) {
  parameters_ = &assemblage.parameters;
  lets_ = &assemblage.lets;
  if (!assemblage.body) return;
  std::set<std::string> used = names_used(*assemblage.body);
  for (const Let& let : assemblage.lets) used.merge(names_used(*let.value));
  for (const Parameter& parameter : assemblage.parameters) {
    if (parameter.initial) used.merge(names_used(*parameter.initial));
  }
  warn_unused(assemblage.parameters, assemblage.lets, used);
  sequence_warnings(*assemblage.body);
  for (const Let& let : assemblage.lets) sequence_warnings(*let.value);
}

void StaticCheck::warnings_of(const Robot& robot) {
  parameters_ = &robot.parameters;
  lets_ = &robot.lets;
  std::set<std::string> used;
  for (const Let& let : robot.lets) used.merge(names_used(*let.value));
  for (const Drive& drive : robot.drives) used.merge(names_used(*drive.value));
  if (const auto found = configuration_.classes.find(robot.class_name.text);
      found != configuration_.classes.end()) {
    for (const Parameter& parameter : found->second->parameters) used.insert(parameter.name.text);
  }
  warn_unused(robot.parameters, robot.lets, used);
  for (const Let& let : robot.lets) sequence_warnings(*let.value);
  for (const Drive& drive : robot.drives) sequence_warnings(*drive.value);
}

}  // namespace mlab::cdl
