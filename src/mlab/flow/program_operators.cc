// The part of the program builder that resolves the operators: sequences, selects, delays.

#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <fmt/core.h>

#include "mlab/flow/builder_hints.h"
#include "mlab/flow/port_types.h"
#include "mlab/flow/program_builder.h"

namespace mlab::flow {

void ProgramBuilder::link_sequence(std::uint32_t index) {
  const Node& node = *ops_[index].node;
  const TypeInfo* type = ops_[index].type;
  std::vector<StateRefs> states;
  std::vector<std::string> names;
  std::unordered_map<std::string_view, std::uint32_t> places;
  for (const State& state : node.states) {
    if (!places.try_emplace(state.name, static_cast<std::uint32_t>(names.size())).second)
      sink_.error("duplicate-state", state.place, fmt::format("state `{}` is declared twice", state.name));
    names.push_back(state.name);
  }
  int start = -1;
  for (std::size_t i = 0; i < node.states.size(); ++i) {
    const State& state = node.states[i];
    if (state.is_start && start >= 0) {
      text::Diagnostic& d =
          sink_.error("two-start-states", state.place,
                      fmt::format("`{}` has a second start state `{}`", node.name, state.name));
      d.notes.push_back({"the first is here", node.states[static_cast<std::size_t>(start)].place});
    }
    if (state.is_start && start < 0) start = static_cast<int>(i);
    StateRefs refs;
    if (type != nullptr)
      refs.member = resolve(state.member, *type, "", "", node.name + "." + state.name, nullptr);
    for (const Transition& transition : state.transitions) {
      refs.triggers.push_back(resolve(transition.trigger, type_info<bool>(), "", "",
                                      node.name + "." + state.name + "." + transition.target, nullptr));
      const auto target = places.find(transition.target);
      if (target == places.end()) {
        text::Diagnostic& d =
            sink_.error("unknown-state", transition.place,
                        fmt::format("`{}` has no state `{}`", node.name, transition.target));
        if (sink_.error_count() <= text::Diagnostics::kMaxErrors)
          hint(d, did_you_mean(transition.target, names));
      }
      refs.targets.push_back(target == places.end() ? 0 : target->second);
    }
    if (state.transitions.empty() && !state.is_final) {
      text::Diagnostic& d = sink_.warning("no-way-out", state.place,
                                          fmt::format("no transition leaves state `{}`", state.name));
      hint(d, "mark it `final state` if that is meant");
    }
    states.push_back(std::move(refs));
  }
  if (start < 0) {
    text::Diagnostic& d =
        sink_.error("no-start-state", node.place, fmt::format("sequence `{}` has no start state", node.name));
    hint(d, "write `start state` before one of its states");
    start = 0;
  }
  std::vector<bool> reached(states.size(), false);
  std::vector<std::uint32_t> waiting = {static_cast<std::uint32_t>(start)};
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
                    fmt::format("no transition leads to state `{}`", names[i]));
  }
  ops_[index].states = std::move(states);
  ops_[index].start = static_cast<std::uint32_t>(start);
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
                  fmt::format("a selector is an integer or a choice, `{}` is {}", node.selector.text,
                              named->second.ref.type->name));
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
        add_slot({node.name + ".initial", Port::Role::kConstant, type, "", "", 0, -1e300, 1e300, ""},
                 std::move(zeros));
    ops_[index].initial = {Ref::Kind::kSlot, slot, type, "", ""};
  }
}

}  // namespace mlab::flow
