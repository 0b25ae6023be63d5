// The part of the program builder that resolves the operators: sequences, selects, delays.

#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <fmt/core.h>

#include "mlab/flow/builder_hints.h"
#include "mlab/flow/port_types.h"
#include "mlab/flow/program_builder.h"
#include "mlab/flow/type_words.h"

namespace mlab::flow {

void ProgramBuilder::link_sequence(std::uint32_t index) {
  const Node& node = *ops_[index].node;
  StateNames names;
  for (const State& state : node.states) {
    if (!names.places.try_emplace(state.name, static_cast<std::uint32_t>(names.names.size())).second)
      sink_.error("duplicate-state", state.place, fmt::format("state `{}` is declared twice", state.name));
    names.names.push_back(state.name);
  }
  const std::uint32_t start = start_of(node);
  std::vector<StateRefs> states;
  for (const State& state : node.states) states.push_back(link_state(node, ops_[index].type, state, names));
  tell_unreached(node, states, start);
  ops_[index].states = std::move(states);
  ops_[index].start = start;
}

std::uint32_t ProgramBuilder::start_of(const Node& node) {
  const State* start = nullptr;
  for (const State& state : node.states) {
    if (!state.is_start) continue;
    if (start == nullptr) {
      start = &state;
      continue;
    }
    text::Diagnostic& d =
        sink_.error("two-start-states", state.place,
                    fmt::format("`{}` has a second start state `{}`", node.name, state.name));
    d.notes.push_back({"the first is here", start->place});
  }
  if (start != nullptr) return static_cast<std::uint32_t>(start - node.states.data());
  text::Diagnostic& d =
      sink_.error("no-start-state", node.place, fmt::format("sequence `{}` has no start state", node.name));
  hint(d, "write `start state` before one of its states");
  return 0;
}

ProgramBuilder::StateRefs ProgramBuilder::link_state(const Node& node, const TypeInfo* type,
                                                     const State& state, const StateNames& names) {
  StateRefs refs;
  const std::string path = node.name + "." + state.name;
  if (type != nullptr) refs.member = resolve(state.member, *type, "", "", path, nullptr);
  for (const Transition& transition : state.transitions) {
    refs.triggers.push_back(
        resolve(transition.trigger, type_info<bool>(), "", "", path + "." + transition.target, nullptr));
    const auto target = names.places.find(transition.target);
    if (target == names.places.end()) {
      text::Diagnostic& d = sink_.error("unknown-state", transition.place,
                                        fmt::format("`{}` has no state `{}`", node.name, transition.target));
      if (sink_.error_count() <= text::Diagnostics::kMaxErrors)
        hint(d, did_you_mean(transition.target, names.names));
    }
    refs.targets.push_back(target == names.places.end() ? 0 : target->second);
  }
  if (state.transitions.empty() && !state.is_final) {
    text::Diagnostic& d =
        sink_.warning("no-way-out", state.place, fmt::format("no transition leaves state `{}`", state.name));
    hint(d, "mark it `final state` if that is meant");
  }
  return refs;
}

void ProgramBuilder::tell_unreached(const Node& node, const std::vector<StateRefs>& states,
                                    std::uint32_t start) {
  std::vector<bool> reached(states.size(), false);
  std::vector<std::uint32_t> waiting = {start};
  while (!waiting.empty()) {
    const std::uint32_t at = waiting.back();
    waiting.pop_back();
    if (at >= states.size() || reached[at]) continue;
    reached[at] = true;
    waiting.insert(waiting.end(), states[at].targets.begin(), states[at].targets.end());
  }
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!reached[i])
      sink_.warning("unreachable-state", node.states[i].place,
                    fmt::format("no transition leads to state `{}`", node.states[i].name));
  }
}

void ProgramBuilder::link_select(std::uint32_t index) {
  const Node& node = *ops_[index].node;
  const TypeInfo* type = ops_[index].type;
  const auto named =
      node.selector.kind == Source::Kind::kName ? names_.find(node.selector.text) : names_.end();
  if (named == names_.end() || named->second.ref.type == nullptr) {
    sink_.error("unknown-source", node.selector.place,
                fmt::format("unknown node or parameter `{}`", node.selector.text));
  } else {
    const TypeKind kind = named->second.ref.type->kind;
    if (kind != TypeKind::kInteger && kind != TypeKind::kChoice && kind != TypeKind::kBool &&
        kind != TypeKind::kMask) {
      sink_.error("wrong-type", node.selector.place,
                  fmt::format("a selector is a whole number, a truth value or a choice; `{}` is {}",
                              node.selector.text, value_of(*named->second.ref.type)));
    }
    ops_[index].selector = named->second.ref;
  }
  std::unordered_set<std::int64_t> seen;
  bool has_otherwise = false;
  for (const Case& member : node.cases) {
    if (member.values.empty() && std::exchange(has_otherwise, true)) {
      sink_.error("duplicate-case", member.place, "a second `otherwise`");
    }
    for (const std::int64_t value : member.values) {
      if (!seen.insert(value).second)
        sink_.error("duplicate-case", member.place, fmt::format("a second case for {}", value));
    }
    const std::string path = fmt::format(
        "{}.{}", node.name, member.values.empty() ? "otherwise" : std::to_string(member.values.front()));
    ops_[index].cases.push_back(type == nullptr ? Ref{}
                                                : resolve(member.member, *type, "", "", path, nullptr));
  }
}

void ProgramBuilder::link_delay(std::uint32_t index) {
  const Node& node = *ops_[index].node;
  const TypeInfo* type = ops_[index].type;
  if (type == nullptr) return;
  for (const Link& link : node.links) {
    const Ref& into = link.input == "value" ? ops_[index].value : ops_[index].initial;
    if (link.input != "value" && link.input != "initial") {
      sink_.error("unknown-input", link.place, fmt::format("a delay has no input `{}`", link.input)).hints = {
          "its inputs are value, initial"};
      continue;
    }
    if (into.kind != Ref::Kind::kNothing) {
      sink_.error("double-link", link.place, fmt::format("input `{}` is linked twice", link.input));
      continue;
    }
    const Ref ref = resolve(link.source, *type, "", "", node.name + "." + link.input, nullptr);
    (link.input == "value" ? ops_[index].value : ops_[index].initial) = ref;
  }
  if (ops_[index].value.kind == Ref::Kind::kNothing) {
    sink_.error("missing-input", node.place,
                fmt::format("input `value` of delay `{}` is not linked", node.name));
  }
  if (ops_[index].initial.kind == Ref::Kind::kNothing) {
    std::vector<std::byte> zeros(type->size);
    const std::uint32_t slot =
        add_slot({node.name + ".initial", Port::Role::kConstant, type, "", "", 0, -kNoLimit, kNoLimit, ""},
                 std::move(zeros));
    ops_[index].initial = {Ref::Kind::kSlot, slot, type, "", ""};
  }
}

}  // namespace mlab::flow
