#include "mlab/lang/cdl/static_check.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/print.h"
#include "mlab/lang/cdl/walk.h"

namespace mlab::cdl {
namespace {

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
    names.push_back(state.name.text);
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
      if (!nearest.empty()) d.hints.push_back(fmt::format("did you mean `{}`?", nearest));
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
    } else if (state.transitions.empty() && !state.is_final) {
      text::Diagnostic& d = sink_.warning("no-way-out", state.name.place,
                                          fmt::format("no transition leaves state `{}`", state.name.text));
      d.label = "once in it, the robot stays in it";
      d.hints.push_back(fmt::format("write `final {}: ...` if that is meant", state.name.text));
    }
    transition_warnings(state);
  }
}

void StaticCheck::transition_warnings(const State& state) {
  std::map<std::string, text::Place> first;
  for (const Transition& transition : state.transitions) {
    const text::Place& place = transition.trigger->place;
    const auto [it, is_new] = first.try_emplace(print(*transition.trigger), place);
    if (!is_new) {
      text::Diagnostic& d =
          sink_.warning("same-trigger", place, "two transitions of this state have the same trigger");
      d.label = fmt::format("never made: the one above is made first");
      d.notes.push_back({"the other is here", it->second});
      continue;
    }
    const Constant value = constant(*transition.trigger);
    if (value == Constant::kNo) continue;
    text::Diagnostic& d = sink_.warning("constant-trigger", place,
                                        value == Constant::kTrue    ? "this trigger is always true"
                                        : value == Constant::kFalse ? "this trigger is never true"
                                                                    : "this trigger never changes");
    d.label = value == Constant::kTrue    ? "the state is left as soon as it is entered"
              : value == Constant::kFalse ? "the transition is never made"
                                          : "the transition is made at once, or never";
  }
}

bool StaticCheck::is_literal(const Expression& expression) const {
  if (std::holds_alternative<Number>(expression.what) || std::holds_alternative<Text>(expression.what))
    return true;
  if (const auto* list = std::get_if<List>(&expression.what))
    return std::ranges::all_of(list->items, [&](const ExpressionPtr& item) { return is_literal(*item); });
  const auto* name = std::get_if<Name>(&expression.what);
  if (name == nullptr) return false;
  const auto is_it = [&](const auto& declared) { return declared.name.text == name->name.text; };
  return std::ranges::none_of(*parameters_, is_it) && std::ranges::none_of(*lets_, is_it);
}

// A call without memory, of constants alone.
StaticCheck::Constant StaticCheck::constant_call(const Call& call) const {
  if (configuration_.assemblages.contains(call.callee.text) ||
      configuration_.bindings.contains(call.callee.text))
    return Constant::kNo;
  const flow::Behavior* behavior = library_.find(call.callee.text).behavior;
  const bool can_be = behavior != nullptr && behavior->is_pure;
  if (!can_be ||
      !std::ranges::all_of(call.arguments, [&](const Argument& a) { return is_literal(*a.value); }))
    return Constant::kNo;
  if (behavior->name != "Constant") return Constant::kSome;
  return call.arguments.empty() ? Constant::kTrue : constant(*call.arguments.front().value);
}

StaticCheck::Constant StaticCheck::constant(const Expression& expression) const {
  if (const auto* call = std::get_if<Call>(&expression.what)) return constant_call(*call);
  if (const auto* name = std::get_if<Name>(&expression.what)) {
    if (!is_literal(expression)) return Constant::kNo;
    return name->name.text == "true" ? Constant::kTrue : Constant::kFalse;
  }
  const auto* logic = std::get_if<Logic>(&expression.what);
  if (logic == nullptr) return Constant::kNo;
  // What decides: one `false` of an `and`, one `true` of an `or`.
  const bool is_or = logic->connective == Connective::kOr;
  bool has_variable = false;
  bool has_some = false;
  for (const ExpressionPtr& operand : logic->operands) {
    const Constant value = constant(*operand);
    if (logic->connective == Connective::kNot) {
      return value == Constant::kTrue    ? Constant::kFalse
             : value == Constant::kFalse ? Constant::kTrue
                                         : value;
    }
    if (value == (is_or ? Constant::kTrue : Constant::kFalse)) return value;
    has_variable |= value == Constant::kNo;
    has_some |= value == Constant::kSome;
  }
  if (has_variable) return Constant::kNo;
  if (has_some) return Constant::kSome;
  return is_or ? Constant::kFalse : Constant::kTrue;
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

void StaticCheck::errors_of(const Society& society) {
  check_member(society.what);
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
  for (const Parameter& parameter : assemblage.parameters) {
    if (used.contains(parameter.name.text)) continue;
    sink_
        .warning("unused-parameter", parameter.name.place,
                 fmt::format("parameter `{}` is never used", parameter.name.text))
        .label = "setting it changes nothing";
  }
  for (const Let& let : assemblage.lets) {
    if (used.contains(let.name.text)) continue;
    sink_.warning("unused-let", let.name.place, fmt::format("`{}` is never used", let.name.text)).label =
        "it is never evaluated";
  }
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
  for (const Parameter& parameter : robot.parameters) {
    if (used.contains(parameter.name.text)) continue;
    sink_
        .warning("unused-parameter", parameter.name.place,
                 fmt::format("parameter `{}` is never used", parameter.name.text))
        .label = "setting it changes nothing";
  }
  for (const Let& let : robot.lets) {
    if (used.contains(let.name.text)) continue;
    sink_.warning("unused-let", let.name.place, fmt::format("`{}` is never used", let.name.text)).label =
        "it is never evaluated";
  }
  for (const Let& let : robot.lets) sequence_warnings(*let.value);
  for (const Drive& drive : robot.drives) sequence_warnings(*drive.value);
}

}  // namespace mlab::cdl
